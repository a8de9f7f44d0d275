"""What calls with several results return."""

from __future__ import annotations

from collections import namedtuple

Motion = namedtuple("Motion", "q omega alpha")
PoseMotion = namedtuple("PoseMotion", "q omega alpha position velocity acceleration")
Pose = namedtuple("Pose", "q position")
VectorMotion = namedtuple("VectorMotion", "value first second")
Samples = namedtuple("Samples", "times values")
Unnormalized = namedtuple("Unnormalized", "p dp ddp")
Jumps = namedtuple("Jumps", "omega alpha")
PeakRates = namedtuple("PeakRates", "omega omega_time alpha alpha_time")
RateBounds = namedtuple("RateBounds", "omega alpha")
RateMismatch = namedtuple("RateMismatch", "angle step")
Diagnostics = namedtuple(
    "Diagnostics", "sign_flips worst_norm_error least_dot iterations residual least_norm least_norm_time"
)
EstimatedRates = namedtuple("EstimatedRates", "times omega")
KeyframeErrors = namedtuple("KeyframeErrors", "angle index")
Controls = namedtuple("Controls", "a b")
KeyReport = namedtuple(
    "KeyReport",
    "status faults sign_changes first_sign_change worst_norm_error worst_norm_index largest_angle largest_angle_index "
    "longest_interval longest_interval_index shortest_interval shortest_interval_index",
)
Batch = namedtuple("Batch", "q omega alpha status offsets times")
