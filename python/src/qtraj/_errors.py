"""What can go wrong, as Python says it: one exception for the statuses of the library, and two warnings."""

from __future__ import annotations

__all__ = ["AmbiguousWarning", "Error", "NormWarning"]

# What to do about each status. Texts of what happened come from the library.
REMEDIES = {
    "NULL": "This is a defect of the package: please report it.",
    "HANDLE": "This is a defect of the package: please report it.",
    "TOO_FEW": "A curve takes 2 keys or more, a mean 1 sample or more.",
    "COUNT": "Offsets of series begin at 0 or later and never decrease; arrays of one call have as many rows.",
    "SIZE": "The result would not fit into memory: look for a step or a rate in another unit.",
    "VALUE": "Compare the arguments with the documentation: a tolerance, an angle or a number of seconds is none.",
    "SETTING": "The method does not have this setting: leave it out, or choose another method.",
    "INPUT_MISSING": "The method or a setting needs omega, alpha, turns or tangents: pass them.",
    "INPUT_UNWANTED": "Neither the method nor a setting uses omega, alpha, turns or tangents: leave them out.",
    "BUFFER": "This is a defect of the package: please report it.",
    "OVERLAP": "Give out= an array of its own.",
    "NO_MEMORY": "Free some memory, or sample in parts.",
    "NOT_FINITE": "Mend or leave out this row: NaN, infinity, or a result that overflows.",
    "ZERO_NORM": "Leave this row out: a quaternion of norm 0 is no orientation, and weights may not all be 0.",
    "TIME_ORDER": "Times must increase: sort the keys by time and leave repeated ones out; check_keys() finds them all.",
    "TIME_RANGE": "Stay within the keys, or choose extrapolate='hold', 'constant_rate', 'periodic' or 'nan'.",
    "TIME_SPAN": "Look for a time that was never set, or in another unit.",
    "GAP": "The time lies in an interval longer than longest_gap: there are no data.",
    "NEGATIVE_WEIGHT": "Make the weight 0 or more.",
    "NOT_CLOSED": "Append the first key at the end, set period= or a larger closure=, or choose other ends.",
    "NOT_ROTATION": "The matrix is far from every rotation: look for a scale or a reflection in it, or raise limit=.",
    "RATE_TOO_FAST": "A given rate is too fast for the interval beside its key: degrees, or milliseconds?",
    "NO_CONVERGENCE": "Use another method, or more iterations.",
    "AMBIGUOUS": "More than one answer is equally right: an axis, a way round, a mean. Add a key, or say which.",
    "INTERNAL": "This is a defect of the library: please report it.",
}


class Error(ValueError):
    """The library refused a call, or its data.

    Attributes
    ----------
    status : int
        The number of the C interface, such as 23.
    name : str
        Its name without prefix, such as ``"TIME_ORDER"``.
    index : int or None
        The row, key, series or sample at fault, counted from 0, where there is one.
    """

    def __init__(self, status: int, name: str, index: int | None, what: str) -> None:
        super().__init__(what)
        self.status = status
        self.name = name
        self.index = index

    def __reduce__(self) -> tuple[type[Error], tuple[int, str, int | None, str]]:
        return Error, (self.status, self.name, self.index, str(self))


class AmbiguousWarning(UserWarning):
    """More than one answer is equally right; the result holds one of them."""


class NormWarning(UserWarning):
    """Keys whose norms are far from 1: probably not the quaternions they are taken for."""


def error(status: int, name: str, text: str, index: int | None = None, about: str = "", unit: str = "row") -> Error:
    """The exception for a status of the library: where, what, and what to do."""
    where = f"{about}: " if about else ""
    place = f" ({unit} {index})" if index is not None else ""
    return Error(status, name, index, f"{where}{text}{place}. {REMEDIES.get(name, '')}".rstrip())
