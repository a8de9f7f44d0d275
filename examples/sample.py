#!/usr/bin/env python3
"""An attitude recording sampled from Python, by ctypes alone.

    sample.py RECORDING.csv METHOD STEP [LIBRARY]

METHOD is slerp, nlerp, squad, log_spline or rotation_spline, STEP in seconds. LIBRARY is the path of libqtraj.so.0
where the system does not find it by itself. Prints t,qw,qx,qy,qz.
"""

import csv
import ctypes
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
    library.qtraj_start_time.argtypes = library.qtraj_end_time.argtypes = [c_void_p]
    library.qtraj_start_time.restype = library.qtraj_end_time.restype = c_double
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

    def span(self):
        return self._library.qtraj_start_time(self._handle), self._library.qtraj_end_time(self._handle)

    def sample(self, start, step, count):
        rows, bad = (c_double * 4 * count)(), c_size_t()
        # a row at fault would be NaN, the others are right; here any fault is an exception
        status = self._library.qtraj_sample_uniform(
            self._handle, start, step, count, ctypes.cast(rows, POINTER(c_double)), byref(bad))
        self._check(status, f"sample {bad.value}")
        return [tuple(row) for row in rows]


def main():
    if len(sys.argv) not in (4, 5) or sys.argv[2] not in METHODS:
        sys.exit(__doc__)
    path, method, step = sys.argv[1], sys.argv[2], float(sys.argv[3])
    library = load(sys.argv[4] if len(sys.argv) == 5 else "libqtraj.so.0")

    times, keys = [], []
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            times.append(float(row["t"]))
            # SPICE's convention: the conjugate takes body vectors to inertial ones
            keys.append((float(row["qw"]), -float(row["qx"]), -float(row["qy"]), -float(row["qz"])))

    attitude = Trajectory(library, method, times, keys)
    start, end = attitude.span()
    count = int((end - start) / step) + 1
    while start + (count - 1) * step > end:  # by rounding
        count -= 1
    print("t,qw,qx,qy,qz")
    for i, q in enumerate(attitude.sample(start, step, count)):
        print(f"{start + i * step:.1f}," + ",".join(f"{component:.6f}" for component in q))


if __name__ == "__main__":
    main()

# Prints, in this folder:
#
#   $ python3 sample.py data/juno_spinner.csv log_spline 20
#   t,qw,qx,qy,qz
#   0.0,0.686393,0.131173,0.708486,0.098514
#   20.0,-0.401530,0.570598,-0.439717,0.565544
#   40.0,-0.319731,-0.652223,-0.306951,-0.614946
#   60.0,0.693499,0.024991,0.720012,-0.004003
#   80.0,-0.313545,0.629406,-0.350535,0.618597
