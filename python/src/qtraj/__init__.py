"""Smooth orientation trajectories through quaternion keyframes.

Quaternions are rows ``w x y z``, Hamilton's, from body to world: ``q`` turns vectors of the body into those of the world;
``q`` and ``-q`` are one orientation. Radians and seconds.

>>> import qtraj
>>> curve = qtraj.Trajectory([0, 1, 3], [[1, 0, 0, 0], [0.6, 0, 0, 0.8], [0, 0.6, 0, 0.8]])
>>> curve(1.0).round(3) + 0
array([0.6, 0. , 0. , 0.8])
>>> curve([0, 1], 1, frame="body").shape
(2, 3)
"""

from __future__ import annotations

from ._batch import sample_batch
from ._core import (
    Poses,
    Trajectory,
    VectorCurve,
    batch_mean_eigen,
    check_keys,
    columns_from_rows,
    cubic_spline,
    estimate_energy,
    estimate_jumps,
    estimate_omega,
    even_times,
    keyframe_errors,
    library_version,
    make_continuous,
    mean_eigen,
    mean_karcher,
    moments,
    rows_from_columns,
    sample_many,
    seconds_from_ns,
    squad_controls,
    status_name,
    status_text,
    target,
)
from ._errors import AmbiguousWarning, Error, NormWarning
from ._functions import (
    angle,
    conjugate,
    derivatives_from_rates,
    distance,
    dot,
    exp,
    inverse,
    log,
    matrix_from_q,
    mean_from_moments,
    multiply,
    nlerp,
    nlerp_between,
    norm,
    normalize,
    power,
    q_from_matrix,
    q_from_rotation_vector,
    rates_from_derivatives,
    rotate,
    rotation_vector_from_q,
    screw,
    slerp,
    slerp_between,
    squad_segment,
    wxyz_from_xyzw,
    xyzw_from_wxyz,
)

from ._tables import resample

__version__ = library_version()

__all__ = [
    "AmbiguousWarning",
    "Error",
    "NormWarning",
    "Poses",
    "Trajectory",
    "VectorCurve",
    "angle",
    "batch_mean_eigen",
    "check_keys",
    "columns_from_rows",
    "conjugate",
    "cubic_spline",
    "derivatives_from_rates",
    "distance",
    "dot",
    "estimate_energy",
    "estimate_jumps",
    "estimate_omega",
    "even_times",
    "exp",
    "inverse",
    "keyframe_errors",
    "library_version",
    "log",
    "make_continuous",
    "matrix_from_q",
    "mean_eigen",
    "mean_from_moments",
    "mean_karcher",
    "moments",
    "multiply",
    "nlerp",
    "nlerp_between",
    "norm",
    "normalize",
    "power",
    "q_from_matrix",
    "q_from_rotation_vector",
    "rates_from_derivatives",
    "resample",
    "rotate",
    "rotation_vector_from_q",
    "rows_from_columns",
    "sample_batch",
    "sample_many",
    "screw",
    "seconds_from_ns",
    "slerp",
    "slerp_between",
    "squad_controls",
    "squad_segment",
    "status_name",
    "status_text",
    "target",
    "wxyz_from_xyzw",
    "xyzw_from_wxyz",
]
