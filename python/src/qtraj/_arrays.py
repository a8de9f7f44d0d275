"""Arrays that callers pass, checked by shape and type before the library sees them."""

from __future__ import annotations

from typing import Any

import numpy as np

REAL = (np.dtype(np.float64), np.dtype(np.float32))


def reals(name: str, value: Any, dtype: type | None = None) -> np.ndarray:
    """The real numbers of an array or of what NumPy makes one of: contiguous, aligned, in the machine's byte order.

    float32 stays float32 where dtype is None; all other numbers become float64. TypeError for what are no real numbers,
    or have more digits than float64.
    """
    if type(value) is np.ndarray and value.dtype in (REAL if dtype is None else (dtype,)) and value.flags.carray:
        return value
    if hasattr(value, "filled") and hasattr(value, "mask"):  # numpy.ma, which need not be loaded
        if np.any(value.mask):
            raise TypeError(f"{name} has masked elements: fill them, or leave them out by compressed()")
        value = value.data
    if not hasattr(value, "__array__") and hasattr(value, "__dlpack__"):
        value = np.from_dlpack(value)
    try:
        array = np.asarray(value)
    except ValueError as ragged:
        raise TypeError(f"{name} is no array: {ragged}") from None
    kind = array.dtype.kind
    if kind == "M" or kind == "m":
        raise TypeError(f"{name} is of type {array.dtype}: make seconds of it, by seconds_from_ns() for instance")
    if kind not in "fiub" or (kind == "f" and array.dtype.itemsize > 8):
        raise TypeError(f"{name} is of type {array.dtype}: real numbers that float64 holds are needed")
    if dtype is None:
        dtype = np.float32 if array.dtype == np.float32 else np.float64
    return np.require(array, dtype, ("C", "A"))


def rows(name: str, value: Any, width: int, dtype: type | None = None, shape: tuple | None = None) -> np.ndarray:
    """Real numbers whose last axis has the given length; with a shape of exactly (*shape, width)."""
    array = reals(name, value, dtype)
    if array.ndim == 0 or array.shape[-1] != width:
        hint = ""
        if array.ndim == 2 and array.shape[0] == width:
            hint = f"; each row is one of {count(width)} numbers: pass {name}.T"
        raise TypeError(f"{name} has the shape {array.shape}, not (..., {width}){hint}")
    if shape is not None and array.shape != (*shape, width):
        raise TypeError(f"{name} has the shape {array.shape}, not {(*shape, width)}")
    return array


def count(width: int) -> str:
    return {3: "three", 4: "four"}.get(width, str(width))


def quaternions(
    name: str, value: Any, dtype: type | None = None, shape: tuple | None = None, scalar_first: bool = True
) -> np.ndarray:
    """Rows w x y z of an array, or of a SciPy Rotation; rows x y z w where the scalar is not first."""
    if type(value) is not np.ndarray and hasattr(value, "as_quat"):
        value, scalar_first = value.as_quat(), False
    array = rows(name, value, 4, dtype, shape)
    return array if scalar_first else np.roll(array, 1, axis=-1)


def output(name: str, out: Any, shape: tuple, dtype: np.dtype) -> np.ndarray:
    """The array that a caller gave for a result: it must be exactly what the result needs."""
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{name} is of type {type(out).__name__}, not a NumPy array")
    if out.shape != shape or out.dtype != dtype or not out.flags.carray:
        raise TypeError(
            f"{name} has the shape {out.shape} and type {out.dtype}; {shape} and {np.dtype(dtype)} are needed, "
            "contiguous and writeable"
        )
    return out
