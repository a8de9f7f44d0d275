#!/usr/bin/env python3
"""scipy_peers.py libqtraj_bench.so target out.json: SciPy and numpy-quaternion against ours.

Ours through ctypes, in the same process and on the same data; repetitions interleaved, CPU time of this thread. Writes
what report.py reads.
"""
import ctypes
import json
import os
import sys
import time

for variable in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[variable] = "1"  # one thread, as ours; read when numpy is loaded

import numpy as np  # noqa: E402
import quaternion  # noqa: E402, numpy-quaternion
import scipy  # noqa: E402
from scipy.interpolate import CubicSpline  # noqa: E402
from scipy.spatial.transform import Rotation, RotationSpline, Slerp  # noqa: E402

SLERP, LOG_SPLINE, ROTATION_SPLINE, VECTOR_CUBIC = 1, 4, 5, 1003
BODY, SHORTEST = 101, 601
REPETITIONS = 5
LEAST_SECONDS = 0.01  # of one timed repetition


class Library:
    def __init__(self, path, target):
        self.c = ctypes.CDLL(path)
        self.c.qtraj_target.restype = ctypes.c_char_p
        self.c.qtraj_status_text.restype = ctypes.c_char_p
        if not self.c.qtraj_bench_force_kernel(target.encode()):
            sys.exit(f"scipy_peers: this CPU or this build has no kernel {target!r}")

    def call(self, function, *arguments):
        status = getattr(self.c, function)(*arguments)
        if status != 0:
            sys.exit(f"scipy_peers: {function}: {self.c.qtraj_status_text(status).decode()}")

    def create(self, method, times, q):
        handle = ctypes.c_void_p()
        self.call("qtraj_create", method, at(times), at(q), size(times), ctypes.byref(handle), None)
        return handle

    def create_and_destroy(self, method, times, q):
        self.c.qtraj_destroy(self.create(method, times, q))


def at(array):
    return ctypes.c_void_p(array.ctypes.data)


def size(array):
    return ctypes.c_size_t(len(array))


def keys(count):
    """Steps of at most 1 rad, 0.2 to 2 s apart."""
    generator = np.random.default_rng(count)
    times = np.cumsum(generator.uniform(0.2, 2.0, count))
    axes = generator.normal(size=(count, 3))
    axes /= np.linalg.norm(axes, axis=1)[:, None]
    steps = Rotation.from_rotvec(axes * generator.uniform(0.0, 1.0, count)[:, None])
    orientation, rotations = Rotation.identity(), []
    for step in steps:
        orientation = orientation * step
        rotations.append(orientation.as_quat())
    rotations = Rotation.from_quat(np.array(rotations))
    return times, rotations, wxyz(rotations)


def wxyz(rotations):
    return np.ascontiguousarray(np.roll(rotations.as_quat(), 1, axis=1))


class Benchmarks:
    def __init__(self):
        self.all = []  # name, samples, function
        self.arrays = []  # whose addresses functions have

    def add(self, name, samples, ours, **peers):
        for who, function in {"ours": ours, **peers}.items():
            self.all.append((f"{name}/{who}", samples, function))

    def run(self):
        counts = []
        for _, _, function in self.all:
            # a first call for caches and pages, too
            counts.append(max(1, int(LEAST_SECONDS / max(seconds_of(function, 1), 1e-7))))
        runs = []
        for _ in range(REPETITIONS):
            for (name, samples, function), count in zip(self.all, counts):
                runs.append({"name": name, "run_name": name, "run_type": "iteration", "samples": samples,
                             "cpu_time": seconds_of(function, count) / count, "time_unit": "s"})
        return runs


def seconds_of(function, count):
    begin = time.thread_time()
    for _ in range(count):
        function()
    return time.thread_time() - begin


def add_sampling(benchmarks, library, key_count, count):
    times, rotations, q = keys(key_count)
    samples = np.linspace(times[0], times[-1], count)
    out, omega = np.ones((count, 4)), np.ones((count, 3))
    spline, slerp = RotationSpline(times, rotations), Slerp(times, rotations)
    sizes = f"sorted/warm/K:{key_count}/M:{count}"

    def sample(handle):
        return lambda: library.call("qtraj_sample", handle, at(samples), size(samples), at(out), None)

    def sample_rates(handle):
        return lambda: library.call("qtraj_sample_rates", handle, BODY, at(samples), size(samples), at(out), at(omega),
                                    None, None)

    benchmarks.add(f"slerp_f64/{sizes}", count, sample(library.create(SLERP, times, q)), scipy=lambda: slerp(samples))
    for name, method in (("log_spline", LOG_SPLINE), ("rotation_spline", ROTATION_SPLINE)):
        handle = library.create(method, times, q)
        benchmarks.add(f"{name}_f64/{sizes}", count, sample(handle), scipy=lambda: spline(samples))
        benchmarks.add(f"{name}_q_omega_f64/{sizes}", count, sample_rates(handle),
                       scipy=lambda: (spline(samples), spline(samples, 1)))


def add_vectors(benchmarks, library, key_count, count):
    times, _, _ = keys(key_count)
    positions = np.random.default_rng(key_count).uniform(-10.0, 10.0, (key_count, 3))
    options, handle = ctypes.c_void_p(), ctypes.c_void_p()
    library.call("qtraj_options_create", VECTOR_CUBIC, ctypes.byref(options))
    library.call("qtraj_vector_create", options, at(times), at(positions), None, None, size(times), ctypes.c_size_t(3),
                 ctypes.byref(handle), None)
    samples = np.linspace(times[0], times[-1], count)
    out, spline = np.ones((count, 3)), CubicSpline(times, positions, bc_type="natural")
    benchmarks.add(f"vector_cubic_f64/sorted/warm/K:{key_count}/M:{count}", count,
                   lambda: library.call("qtraj_vector_sample", handle, at(samples), size(samples), at(out), None, None,
                                        None),
                   scipy=lambda: spline(samples))


def add_construction(benchmarks, library, key_count):
    times, rotations, q = keys(key_count)
    benchmarks.add(f"create_rotation_spline_f64/sorted/warm/K:{key_count}/M:0", key_count,
                   lambda: library.create_and_destroy(ROTATION_SPLINE, times, q),
                   scipy=lambda: RotationSpline(times, rotations))


def add_mean(benchmarks, library, count):
    generator = np.random.default_rng(count)
    rotations = Rotation.random(random_state=1) * Rotation.from_rotvec(generator.uniform(-0.5, 0.5, (count, 3)))
    q, mean = wxyz(rotations), np.ones(4)
    benchmarks.add(f"mean_eigen_f64/sorted/warm/K:0/M:{count}", count,
                   lambda: library.call("qtraj_mean_eigen", at(q), None, size(q), at(mean), None, None),
                   scipy=rotations.mean)


def add_pairs(benchmarks, library, count):
    a, b = (wxyz(Rotation.random(count, random_state=seed)) for seed in (1, 2))
    fraction = np.random.default_rng(3).uniform(0.0, 1.0, count)
    out = np.ones((count, 4))
    peer_a, peer_b = quaternion.as_quat_array(a), quaternion.as_quat_array(b)
    benchmarks.add(f"slerp_pairs_f64/sorted/warm/K:0/M:{count}", count,
                   lambda: library.call("qtraj_slerp_pairs", at(a), size(a), at(b), size(b), at(fraction),
                                        size(fraction), size(a), SHORTEST, at(out), None),
                   numpy_quaternion=lambda: np.slerp_vectorized(peer_a, peer_b, fraction))


def add_functions(benchmarks, library, count):
    rotations, others = (Rotation.random(count, random_state=seed) for seed in (1, 2))
    a, b, r, m = wxyz(rotations), wxyz(others), rotations.as_rotvec(), np.ascontiguousarray(rotations.as_matrix())
    v, half, exponent, rows = np.random.default_rng(3).uniform(-2.0, 2.0, (count, 3)), 0.5 * r, np.array([0.3]), size(a)
    q_out, v_out, m_out, x_out = (np.ones((count, width)) for width in (4, 3, 9, 1))
    peer_a, peer_b = quaternion.as_quat_array(a), quaternion.as_quat_array(b)
    peer_half = quaternion.from_vector_part(half)
    benchmarks.arrays += [a, b, r, m, v, half, exponent, q_out, v_out, m_out, x_out]

    def add(name, *arguments, **peers):
        benchmarks.add(f"rows_{name}_f64/sorted/warm/K:0/M:{count}", count,
                       lambda: library.call(f"qtraj_{name}", *arguments, None), **peers)

    add("multiply", at(a), rows, at(b), rows, rows, at(q_out), scipy=lambda: rotations * others,
        numpy_quaternion=lambda: peer_a * peer_b)
    add("conjugate", at(a), rows, at(q_out), scipy=rotations.inv, numpy_quaternion=lambda: np.conjugate(peer_a))
    add("inverse", at(a), rows, at(q_out), scipy=rotations.inv, numpy_quaternion=lambda: np.reciprocal(peer_a))
    add("norm", at(a), rows, at(x_out), numpy_quaternion=lambda: np.abs(peer_a))
    add("rotate", at(a), rows, at(v), rows, rows, at(v_out), scipy=lambda: rotations.apply(v))
    add("exp", at(half), rows, at(q_out), numpy_quaternion=lambda: np.exp(peer_half))
    add("log", at(a), rows, at(v_out), numpy_quaternion=lambda: np.log(peer_a))
    add("pow", at(a), at(exponent), ctypes.c_size_t(1), rows, at(q_out), scipy=lambda: rotations**0.3,
        numpy_quaternion=lambda: peer_a**0.3)
    add("q_from_rotation_vector", at(r), rows, at(q_out), scipy=lambda: Rotation.from_rotvec(r),
        numpy_quaternion=lambda: quaternion.from_rotation_vector(r))
    add("rotation_vector_from_q", at(a), rows, at(v_out), scipy=rotations.as_rotvec,
        numpy_quaternion=lambda: quaternion.as_rotation_vector(peer_a))
    add("matrix_from_q", at(a), rows, at(m_out), scipy=rotations.as_matrix,
        numpy_quaternion=lambda: quaternion.as_rotation_matrix(peer_a))
    add("q_from_matrix", at(m), rows, ctypes.c_double(0.0), at(q_out), None, scipy=lambda: Rotation.from_matrix(m),
        numpy_quaternion=lambda: quaternion.from_rotation_matrix(m, nonorthogonal=False))
    add("rotation_angle", at(a), rows, at(b), rows, rows, at(x_out),
        scipy=lambda: (rotations.inv() * others).magnitude(),
        numpy_quaternion=lambda: quaternion.rotation_intrinsic_distance(peer_a, peer_b))


def main(path, target, out_path):
    library, benchmarks = Library(path, target), Benchmarks()
    add_sampling(benchmarks, library, 1000, 10**6)
    add_vectors(benchmarks, library, 1000, 10**6)
    for key_count in (100, 1000, 10000):
        add_construction(benchmarks, library, key_count)
    add_mean(benchmarks, library, 10**6)
    add_pairs(benchmarks, library, 10**6)
    add_functions(benchmarks, library, 10**6)
    context = {"qtraj_target": library.c.qtraj_target().decode(),
               "peers": f"SciPy {scipy.__version__}, NumPy {np.__version__}, "
                        f"numpy-quaternion {quaternion.__version__}"}
    with open(out_path, "w", encoding="utf-8") as file:
        json.dump({"context": context, "benchmarks": benchmarks.run()}, file, indent=1)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
