#!/usr/bin/env python3
"""scipy_agreement.py libqtraj.so: ROTATION_SPLINE with CHORD ends is SciPy's RotationSpline, where that converges.

Both look for the same curve. SciPy iterates on the rates at most ten times and does not say whether that was enough;
the curve then has jumps of angular acceleration at its knots, so we judge it by these. Its rates are body rates: the
script checks that by differences before it compares. Fails without SciPy: it is never skipped.
"""
import ctypes
import sys

import numpy
import scipy
from scipy.spatial.transform import Rotation, RotationSpline

ROTATION_SPLINE, END_CHORD, FRAME_BODY, FRAME_WORLD = 5, 201, 101, 102
CURVES = 100  # for each size of steps
CONVERGED = 1e-9  # largest jump of alpha at a knot in units of the largest |alpha|, left when SciPy was done
TOLERANCE = {"q": 3e-9, "omega": 3e-9, "alpha": 3e-9}  # rad; relative


def load(path):
    library = ctypes.CDLL(path)
    library.qtraj_status_text.restype = ctypes.c_char_p
    library.qtraj_options_destroy.restype = library.qtraj_destroy.restype = None
    return library


def pointer(array):
    assert array.dtype == numpy.float64 and array.flags.c_contiguous
    return array.ctypes.data_as(ctypes.c_void_p)


class ChordSpline:
    """ROTATION_SPLINE with CHORD ends through the C API; q is w x y z."""

    def __init__(self, library, times, q):
        self.library, self.handle = library, ctypes.c_void_p()
        options = ctypes.c_void_p()
        self.call("qtraj_options_create", ctypes.c_int32(ROTATION_SPLINE), ctypes.byref(options))
        self.call("qtraj_options_set_ends", options, ctypes.c_int32(END_CHORD), ctypes.c_int32(END_CHORD))
        self.call("qtraj_create_with_options", options, pointer(times), pointer(q), ctypes.c_size_t(len(times)),
                  ctypes.byref(self.handle), None)
        library.qtraj_options_destroy(options)

    def __del__(self):
        self.library.qtraj_destroy(self.handle)

    def call(self, name, *arguments):
        status = getattr(self.library, name)(*arguments)
        if status != 0:
            raise RuntimeError(f"{name}: {self.library.qtraj_status_text(ctypes.c_int32(status)).decode()}")

    def sample(self, frame, times):
        q, omega, alpha = (numpy.empty((len(times), width)) for width in (4, 3, 3))
        self.call("qtraj_sample_rates", self.handle, ctypes.c_int32(frame), pointer(times),
                  ctypes.c_size_t(len(times)), pointer(q), pointer(omega), pointer(alpha), None)
        return q, omega, alpha


def random_keys(random, largest_step):
    """Times and q, w x y z, of a walk of rotations of at most largest_step, rad, on uneven knots."""
    count = random.integers(3, 15)
    times = random.uniform(-5, 5) + numpy.cumsum(random.uniform(0.2, 2.0, count))
    rotations = [Rotation.random(random_state=int(random.integers(2**31)))]
    while len(rotations) < count:
        axis = random.normal(size=3)
        step = Rotation.from_rotvec(axis / numpy.linalg.norm(axis) * random.uniform(0, largest_step))
        rotations.append(rotations[-1] * step)
    return times, Rotation.concatenate(rotations)


def wxyz(rotations):
    return numpy.ascontiguousarray(numpy.roll(rotations.as_quat(), 1, axis=1))


def largest_length(vectors):
    return numpy.max(numpy.linalg.norm(vectors, axis=1), initial=0.0)


def alpha_jump(spline, times, largest_alpha):
    """Largest jump of SciPy's alpha at the inner knots, relative. The limit from the left is taken 1e-7 of the interval
    before the knot and 2e-7 before, and extrapolated."""
    knots, intervals = times[1:-1], numpy.diff(times)[:-1]
    left = 2 * spline(knots - 1e-7 * intervals, 2) - spline(knots - 2e-7 * intervals, 2)
    return largest_length(spline(knots, 2) - left) / largest_alpha


def check_frame(spline, time):
    """SciPy's first derivative is the body rate: R(t)^-1 R(t + d) turns by d omega_body."""
    step = 1e-5
    body = (spline(time - step).inv() * spline(time + step)).as_rotvec() / (2 * step)
    world = (spline(time + step) * spline(time - step).inv()).as_rotvec() / (2 * step)
    scale = numpy.linalg.norm(world)
    assert numpy.linalg.norm(spline(time, 1) - body) < 1e-6 * scale, "SciPy's rates are no body rates"
    assert numpy.linalg.norm(body - world) > 1e-3 * scale, "the frames cannot be told apart here"


def differences(spline, ours, times):
    """Largest differences of q, rad, and of the rates in both frames, relative to their largest values."""
    middle = numpy.concatenate([start + (end - start) * numpy.arange(16) / 16 for start, end in zip(times, times[1:])])
    rotations, omega, alpha = spline(middle), spline(middle, 1), spline(middle, 2)
    theirs = wxyz(rotations)
    result = {"q": 0.0, "omega": 0.0, "alpha": 0.0}
    for frame in (FRAME_BODY, FRAME_WORLD):
        q, our_omega, our_alpha = ours.sample(frame, middle)
        apart, together = (numpy.linalg.norm(q + sign * theirs, axis=1) for sign in (-1, 1))
        angle = 4 * numpy.arctan2(numpy.minimum(apart, together), numpy.maximum(apart, together))
        turn = rotations.apply if frame == FRAME_WORLD else lambda vectors: vectors
        result["q"] = max(result["q"], numpy.max(angle))
        result["omega"] = max(result["omega"], largest_length(our_omega - turn(omega)) / largest_length(omega))
        result["alpha"] = max(result["alpha"], largest_length(our_alpha - turn(alpha)) / largest_length(alpha))
    return result


def main():
    library, random = load(sys.argv[1]), numpy.random.default_rng(1)
    print(f"SciPy {scipy.__version__}; largest differences on the curves on which it converged")
    print("steps up to  converged  q, rad    omega     alpha     largest jump of its alpha, of all curves")
    total, failed = 0, False
    for degrees in (10, 30, 60, 90, 120, 150):
        converged, worst, worst_jump = 0, dict.fromkeys(TOLERANCE, 0.0), 0.0
        for _ in range(CURVES):
            times, rotations = random_keys(random, numpy.radians(degrees))
            spline = RotationSpline(times, rotations)
            check_frame(spline, times[0] + 0.4 * (times[1] - times[0]))
            dense = numpy.linspace(times[0], times[-1], 200)
            jump = alpha_jump(spline, times, largest_length(spline(dense, 2)))
            worst_jump = max(worst_jump, jump)
            ours = ChordSpline(library, times, wxyz(rotations))
            if jump > CONVERGED:
                continue
            converged += 1
            for name, value in differences(spline, ours, times).items():
                worst[name] = max(worst[name], value)
                failed |= not value <= TOLERANCE[name]
        total += converged
        print(f"{degrees:7} deg {converged:6}/{CURVES}  {worst['q']:.1e}   {worst['omega']:.1e}   {worst['alpha']:.1e}"
              f"   {worst_jump:.1e}")
    if total < CURVES:
        print(f"SciPy converged on {total} curves only: too few to judge by")
        failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
