#!/usr/bin/env python3
"""scipy_means.py libqtraj.so: the eigen mean is SciPy's Rotation.mean, with and without weights.

Both are the top eigenvector of sum w q q^T. Where its eigenvalue is close to the next, rounding grows by the inverse of
the gap, in both. Fails without SciPy: it is never skipped.
"""
import ctypes
import sys

import numpy
import scipy
from scipy.spatial.transform import Rotation

SETS = 300  # for each spread
TOLERANCE = 4e-15  # rad, times 1 + 1/eigengap


def pointer(array):
    assert array.dtype == numpy.float64 and array.flags.c_contiguous
    return array.ctypes.data_as(ctypes.c_void_p)


def mean_eigen(library, q, weights):
    """Mean, w x y z, and eigengap."""
    mean, eigengap = numpy.empty(4), ctypes.c_double()
    status = library.qtraj_mean_eigen(pointer(q), None if weights is None else pointer(weights),
                                      ctypes.c_size_t(len(q)), pointer(mean), ctypes.byref(eigengap), None)
    if status != 0:
        raise RuntimeError(library.qtraj_status_text(ctypes.c_int32(status)).decode())
    return mean, eigengap.value


def angle_between(a, b):
    apart, together = numpy.linalg.norm(a - b), numpy.linalg.norm(a + b)
    return 4 * numpy.arctan2(min(apart, together), max(apart, together))


def main():
    library, random = ctypes.CDLL(sys.argv[1]), numpy.random.default_rng(1)
    library.qtraj_status_text.restype = ctypes.c_char_p
    print(f"SciPy {scipy.__version__}; largest angle between the means, rad, and the same over 1 + 1/eigengap")
    failed = False
    for spread in (1e-9, 1e-3, 0.1, 0.5, 1.0, 3.0):
        worst, worst_scaled = 0.0, 0.0
        for number in range(SETS):
            count = random.integers(1, 40) if number else 100000
            center = Rotation.random(random_state=int(random.integers(2**31)))
            rotations = center * Rotation.from_rotvec(random.normal(scale=spread, size=(count, 3)))
            weights = random.uniform(0, 3, count) if number % 2 else None
            signs = random.choice([-1.0, 1.0], (count, 1))
            q = numpy.ascontiguousarray(signs * numpy.roll(rotations.as_quat(), 1, axis=1))
            mean, eigengap = mean_eigen(library, q, weights)
            angle = angle_between(mean, numpy.roll(rotations.mean(weights).as_quat(), 1))
            worst, worst_scaled = max(worst, angle), max(worst_scaled, angle / (1 + 1 / eigengap))
        failed |= not worst_scaled <= TOLERANCE
        print(f"spread {spread:5g} rad an axis: {worst:.1e}  {worst_scaled:.1e}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
