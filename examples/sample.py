#!/usr/bin/env python3
"""An attitude recording sampled from Python, by ctypes alone.

    sample.py RECORDING.csv METHOD STEP [--conjugate] [LIBRARY]

METHOD is rotation_spline, the first to try, or slerp, nlerp, squad, log_spline; STEP in seconds. The recording has the
columns t, qw, qx, qy and qz. --conjugate: they go from world to body, as those of SPICE do, not from body to world.
LIBRARY is the path of libqtraj.so.0 where the system does not find it by itself. Prints t,qw,qx,qy,qz.
"""

import csv
import ctypes
import math
import sys
from ctypes import POINTER, byref, c_char_p, c_double, c_int32, c_size_t, c_void_p

# values never change their meaning
METHODS = {"slerp": 1, "nlerp": 2, "squad": 3, "log_spline": 4, "rotation_spline": 5}


def load(path):
    """The library, its functions told what they take: ctypes would pass a double as an int."""
    library = ctypes.CDLL(path)
    doubles = POINTER(c_double)
    index = POINTER(c_size_t)
    library.qtraj_status_text.restype = c_char_p
    library.qtraj_create.argtypes = [c_int32, doubles, doubles, c_size_t, POINTER(c_void_p), index]
    library.qtraj_sample_uniform.argtypes = [c_void_p, c_double, c_double, c_size_t, doubles, index]
    library.qtraj_uniform_count.argtypes = [c_void_p, c_double, c_double, index]
    library.qtraj_start_time.argtypes = [c_void_p]
    library.qtraj_start_time.restype = c_double
    library.qtraj_destroy.argtypes = [c_void_p]
    library.qtraj_destroy.restype = None
    return library


class Trajectory:
    """Orientations (w, x, y, z) at any time between the first key and the last."""

    def __init__(self, library, method, times, keys):
        self._library, self._handle = library, c_void_p()
        bad = c_size_t()
        status = library.qtraj_create(
            METHODS[method],
            (c_double * len(times))(*times),
            (c_double * (4 * len(keys)))(*(component for q in keys for component in q)),
            len(times), byref(self._handle), byref(bad))
        self._check(status, f"key {bad.value}")

    def __del__(self):
        self._library.qtraj_destroy(self._handle)

    def _check(self, status, where):
        if status:
            raise ValueError(f"{where}: {self._library.qtraj_status_text(status).decode()}")

    def start(self):
        return self._library.qtraj_start_time(self._handle)

    def sample(self, start, step):
        """From start up to the last key."""
        count, bad = c_size_t(), c_size_t()
        self._check(self._library.qtraj_uniform_count(self._handle, start, step, byref(count)), "step")
        rows = (c_double * 4 * count.value)()
        # a row at fault would be NaN, the others are right; here any fault is an exception
        status = self._library.qtraj_sample_uniform(
            self._handle, start, step, count.value, ctypes.cast(rows, POINTER(c_double)), byref(bad))
        self._check(status, f"sample {bad.value}")
        return [tuple(row) for row in rows]


def read(path):
    """Times and keys, by the names of the columns; ends the program where these are no quaternions."""
    with open(path, newline="") as file:
        rows = csv.DictReader(file)
        missing = {"t", "qw", "qx", "qy", "qz"} - set(rows.fieldnames or ())
        if missing:
            sys.exit(f"{path}: the heading has no column {', '.join(sorted(missing))}")
        rows = [[float(row[name]) for name in ("t", "qw", "qx", "qy", "qz")] for row in rows]
    for i, row in enumerate(rows):
        norm = math.hypot(*row[1:])
        if abs(norm - 1) > 0.01:
            sys.exit(f"{path}: key {i} has norm {norm:.3g}: positions, angles, other columns, a faulty row?")
    return [row[0] for row in rows], [row[1:] for row in rows]


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--conjugate"]
    if len(arguments) not in (3, 4) or arguments[1] not in METHODS:
        sys.exit(__doc__)
    path, method, step = arguments[0], arguments[1], float(arguments[2])
    library = load(arguments[3] if len(arguments) == 4 else "libqtraj.so.0")

    times, keys = read(path)
    if "--conjugate" in sys.argv:
        keys = [(w, -x, -y, -z) for w, x, y, z in keys]
    attitude = Trajectory(library, method, times, keys)
    start = attitude.start()
    print("t,qw,qx,qy,qz")
    for i, q in enumerate(attitude.sample(start, step)):
        print(f"{start + i * step:.9f}," + ",".join(f"{component:.9f}" for component in q))


if __name__ == "__main__":
    main()

# Prints, in this folder:
#
#   $ python3 sample.py data/juno_spinner.csv rotation_spline 20 --conjugate
#   t,qw,qx,qy,qz
#   0.000000000,0.686393426,0.131173112,0.708486190,0.098513947
#   20.000000000,-0.401530405,0.570597853,-0.439717364,0.565544042
#   40.000000000,-0.319730801,-0.652223489,-0.306950551,-0.614945603
#   60.000000000,0.693497734,0.024987236,0.720014262,-0.003999099
#   80.000000000,-0.313544706,0.629405940,-0.350535433,0.618597438
