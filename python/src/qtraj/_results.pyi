from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

_Reals = NDArray[np.floating[Any]]
_Whole = NDArray[np.integer[Any]]


class Motion(NamedTuple):
    q: _Reals
    omega: _Reals
    alpha: _Reals


class PoseMotion(NamedTuple):
    q: _Reals
    omega: _Reals
    alpha: _Reals
    position: _Reals
    velocity: _Reals
    acceleration: _Reals


class Pose(NamedTuple):
    q: _Reals
    position: _Reals


class VectorMotion(NamedTuple):
    value: _Reals
    first: _Reals
    second: _Reals


class Samples(NamedTuple):
    times: _Reals
    values: _Reals


class Unnormalized(NamedTuple):
    p: _Reals
    dp: _Reals
    ddp: _Reals


class Jumps(NamedTuple):
    omega: _Reals
    alpha: _Reals


class PeakRates(NamedTuple):
    omega: float
    omega_time: float
    alpha: float
    alpha_time: float


class RateBounds(NamedTuple):
    omega: float
    alpha: float


class RateMismatch(NamedTuple):
    angle: float
    step: int


class Diagnostics(NamedTuple):
    sign_flips: int
    worst_norm_error: float
    least_dot: float
    iterations: int
    residual: float
    least_norm: float
    least_norm_time: float


class EstimatedRates(NamedTuple):
    times: _Reals
    omega: _Reals


class KeyframeErrors(NamedTuple):
    angle: _Reals
    sample: _Whole


class Controls(NamedTuple):
    a: _Reals
    b: _Reals


class KeyReport(NamedTuple):
    status: _Whole
    faults: int
    sign_changes: int
    first_sign_change: int | None
    worst_norm_error: float
    worst_norm_index: int | None
    largest_angle: float
    largest_angle_index: int | None
    longest_interval: float
    longest_interval_index: int | None
    shortest_interval: float
    shortest_interval_index: int | None


class Batch(NamedTuple):
    q: _Reals
    omega: _Reals | None
    alpha: _Reals | None
    status: _Whole
    offsets: _Whole
    times: _Reals
