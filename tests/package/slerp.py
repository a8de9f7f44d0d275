"""slerp.py libqtraj.so.0: the C API from Python by ctypes alone."""

import ctypes
import math
import sys

library = ctypes.CDLL(sys.argv[1])
library.qtraj_version.restype = ctypes.c_char_p
library.qtraj_destroy.argtypes = [ctypes.c_void_p]
doubles = ctypes.POINTER(ctypes.c_double)
size_out = ctypes.POINTER(ctypes.c_size_t)
library.qtraj_create.argtypes = [
    ctypes.c_int32, doubles, doubles, ctypes.c_size_t, ctypes.POINTER(ctypes.c_void_p), size_out]
library.qtraj_sample.argtypes = [ctypes.c_void_p, doubles, ctypes.c_size_t, doubles, size_out]

SLERP = 1
TIME_ORDER = 23
half = math.sqrt(0.5)
keys = (ctypes.c_double * 12)(1, 0, 0, 0, half, 0, 0, half, 0, 0, 0, 1)
trajectory = ctypes.c_void_p()
bad_index = ctypes.c_size_t()


def create(*times):
    return library.qtraj_create(
        SLERP, (ctypes.c_double * 3)(*times), keys, 3, ctypes.byref(trajectory), ctypes.byref(bad_index))


assert create(0.0, 1.0, 1.0) == TIME_ORDER
assert trajectory.value is None and bad_index.value == 2

assert create(0.0, 1.0, 3.0) == 0
q = (ctypes.c_double * 8)()
assert library.qtraj_sample(trajectory, (ctypes.c_double * 2)(0.5, 2.0), 2, q, None) == 0
library.qtraj_destroy(trajectory)

eighth = math.pi / 8
expected = [math.cos(eighth), 0, 0, math.sin(eighth), math.sin(eighth), 0, 0, math.cos(eighth)]
assert all(abs(a - b) <= 1e-15 for a, b in zip(q, expected)), list(q)
print("qtraj", library.qtraj_version().decode())
