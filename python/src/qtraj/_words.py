"""The words that stand for the constants of the C interface."""

from __future__ import annotations

METHODS = {
    "slerp": 1,
    "nlerp": 2,
    "squad": 3,
    "log_spline": 4,
    "rotation_spline": 5,
    "hermite": 6,
    "rotation_quintic": 7,
    "quaternion_quintic": 8,
    "step": 9,
    "quaternion_hermite": 10,
}
VECTOR_METHODS = {"step": 1001, "linear": 1002, "cubic": 1003, "hermite": 1004, "quintic": 1005}
FRAMES = {"body": 101, "world": 102}
ENDS = {
    "default": 0,
    "chord": 201,
    "natural": 202,
    "not_a_knot": 203,
    "estimated": 204,
    "given": 205,
    "periodic": 206,
}
TANGENTS = {"default": 0, "catmull_rom": 301, "mean_velocity": 302, "given": 303, "rest": 304}
REFERENCES = {"default": 0, "first": 401, "mean": 402, "given": 403}
# "error" and "nan" are one rule of the library: a row of NaN. "error" raises an exception on top of it.
EXTRAPOLATIONS = {"error": 501, "nan": 501, "hold": 502, "constant_rate": 503, "periodic": 504}
PATHS = {"shortest": 601, "as_given": 602}
TURNS = {"default": 0, "shortest": 701, "as_given": 702, "from_rates": 703, "given": 704}
LAYOUTS = {"series_first": 801, "time_first": 802}


def number(name: str, family: dict[str, int], word: object) -> int:
    """The constant that a word stands for; a ValueError that names the right words for any other."""
    try:
        return family[word]  # type: ignore[index]
    except (KeyError, TypeError):
        raise ValueError(f"{name}={word!r}: one of {', '.join(map(repr, family))}") from None

STATUSES = {
    0: "OK",
    1: "NULL",
    2: "HANDLE",
    3: "TOO_FEW",
    4: "COUNT",
    5: "SIZE",
    6: "VALUE",
    7: "SETTING",
    8: "INPUT_MISSING",
    9: "INPUT_UNWANTED",
    10: "BUFFER",
    11: "OVERLAP",
    12: "NO_MEMORY",
    21: "NOT_FINITE",
    22: "ZERO_NORM",
    23: "TIME_ORDER",
    24: "TIME_RANGE",
    25: "TIME_SPAN",
    26: "GAP",
    27: "NEGATIVE_WEIGHT",
    28: "NOT_CLOSED",
    29: "NOT_ROTATION",
    30: "RATE_TOO_FAST",
    31: "NO_CONVERGENCE",
    41: "AMBIGUOUS",
    51: "INTERNAL",
}
