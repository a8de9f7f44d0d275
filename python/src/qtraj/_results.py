"""What calls with several results return; _results.pyi has the types."""

from __future__ import annotations

from collections import namedtuple

Motion = namedtuple("Motion", "q omega alpha")
Motion.__doc__ = "Orientations ``w x y z``, angular velocities, rad/s, and angular accelerations, rad/s^2."

PoseMotion = namedtuple("PoseMotion", "q omega alpha position velocity acceleration")
PoseMotion.__doc__ = "Poses and their rates: of orientations in the frame that was asked for, of positions in their own."

Pose = namedtuple("Pose", "q position")
Pose.__doc__ = "Orientations ``w x y z`` and positions."

VectorMotion = namedtuple("VectorMotion", "value first second")
VectorMotion.__doc__ = "Values and their first and second derivatives."

Samples = namedtuple("Samples", "times values")
Samples.__doc__ = "Times, s, and samples at them."

Unnormalized = namedtuple("Unnormalized", "p dp ddp")
Unnormalized.__doc__ = "The curve in R^4 before it is normalised, and its derivatives."

Jumps = namedtuple("Jumps", "omega alpha")
Jumps.__doc__ = "Right-hand minus left-hand rates at each key, rad/s and rad/s^2."

PeakRates = namedtuple("PeakRates", "omega omega_time alpha alpha_time")
PeakRates.__doc__ = "Greatest lengths of the rates, rad/s and rad/s^2, and their times, s."

RateBounds = namedtuple("RateBounds", "omega alpha")
RateBounds.__doc__ = "Bounds of the rates, rad/s and rad/s^2."

RateMismatch = namedtuple("RateMismatch", "angle step")
RateMismatch.__doc__ = "Largest angle, rad, between a step and its rates, and the index of the step."

Diagnostics = namedtuple(
    "Diagnostics",
    "sign_flips worst_norm_error least_dot iterations residual least_norm least_norm_time",
)
Diagnostics.__doc__ = "What construction found."

EstimatedRates = namedtuple("EstimatedRates", "times omega")
EstimatedRates.__doc__ = "Middles of intervals, s, and mean angular velocities, rad/s."

KeyframeErrors = namedtuple("KeyframeErrors", "angle sample")
KeyframeErrors.__doc__ = "Angles, rad, to the nearest samples, and the indices of these."

Controls = namedtuple("Controls", "a b")
Controls.__doc__ = "Inner controls of SQUAD."

KeyReport = namedtuple(
    "KeyReport",
    "status faults sign_changes first_sign_change worst_norm_error worst_norm_index largest_angle "
    "largest_angle_index longest_interval longest_interval_index shortest_interval "
    "shortest_interval_index",
)
KeyReport.__doc__ = "Faults of a recording, and what is suspicious in it: s, rad."

Batch = namedtuple("Batch", "q omega alpha status offsets times")
Batch.__doc__ = "Samples of many series, and the status of each series."
