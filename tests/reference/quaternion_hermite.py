#!/usr/bin/env python3
"""Writes vectors/quaternion_hermite.txt: curves of QUATERNION_HERMITE and their rates, at 60 digits.

    python3 tests/reference/quaternion_hermite.py > tests/reference/vectors/quaternion_hermite.txt

Independent of the library's formulas: the cubic is evaluated as the glTF 2.0 specification writes it (appendix C.5),
in powers of u = (t - t_i)/h, and normalised; angular velocity and acceleration are differentiated numerically from q(t).
"""
import random
import struct

from mpmath import cos, diff, mp, mpf, sin, sqrt

mp.dps = 60


def product(a, b):
    return [a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]]


def norm(a):
    return sqrt(sum(x * x for x in a))


def cubic(v0, b0, a1, v1, h, u):
    """Value of the spline between two keys: v values, b0 the out-tangent of the first, a1 the in-tangent of the next."""
    return [(2 * u**3 - 3 * u**2 + 1) * p + h * (u**3 - 2 * u**2 + u) * m + (-2 * u**3 + 3 * u**2) * q
            + h * (u**3 - u**2) * n for p, m, n, q in zip(v0, b0, a1, v1)]


def size(v0, b0, a1, v1, h):
    """The sum of the norms of the coefficients in s = 2u - 1, by differences of values at s = -1, -1/3, 1/3, 1."""
    values = [cubic(v0, b0, a1, v1, h, mpf(k) / 3) for k in range(4)]
    third = [9 * (d - 3 * c + 3 * b - a) / 16 for a, b, c, d in zip(*values)]
    second = [9 * (d - c - b + a) / 16 for a, b, c, d in zip(*values)]
    first = [(d - a) / 2 - z for a, b, c, d, z in zip(*values, third)]
    zeroth = [(d + a) / 2 - y for a, b, c, d, y in zip(*values, second)]
    return sum(norm(c) for c in (zeroth, first, second, third))


def unit(p):
    length = norm(p)
    return [x / length for x in p]


def omega_body(q, t):
    """2 q* q'."""
    at = q(t)
    derivative = [diff(lambda x, k=k: q(x)[k], t) for k in range(4)]
    conjugate = [at[0], -at[1], -at[2], -at[3]]
    return [2 * x for x in product(conjugate, derivative)[1:]]


def signed(keys, rule):
    """Keys and tangents as numbers of 60 digits; by `shortest` with the sign that is nearer to the key before."""
    result = []
    for key in keys:
        v, a, b = ([mpf(x) for x in key[n:n + 4]] for n in (1, 5, 9))
        if rule == "shortest" and result and sum(x * y for x, y in zip(v, result[-1][1])) < 0:
            v, a, b = ([-x for x in row] for row in (v, a, b))
        result.append((mpf(key[0]), v, a, b))
    return result


def write_curve(rule, keys):
    rows = []
    of_curve = signed(keys, rule)
    for (t0, v0, _, b0), (t1, v1, a1, _) in zip(of_curve, of_curve[1:]):
        h = t1 - t0
        coefficients = size(v0, b0, a1, v1, h)
        for u in (1e-9, 0.125, 0.3, 0.5, 0.71, 0.96, 1 - 1e-9):
            t = float(t0) + u * float(h)
            if not float(t0) < t < float(t1):
                continue
            at = (mpf(t) - t0) / h
            q = lambda x: unit(cubic(v0, b0, a1, v1, h, x))
            omega = [x / h for x in omega_body(q, at)]
            alpha = [diff(lambda x, k=k: omega_body(q, x)[k], at) / h**2 for k in range(3)]
            rows.append([t] + q(at) + omega + alpha + [coefficients / norm(cubic(v0, b0, a1, v1, h, at))])
    print(f"curve {rule} {len(keys)}")
    for key in keys:
        print(*[repr(x) for x in key])
    print(f"samples {len(rows)}")
    for row in rows:
        print(*[repr(float(x)) for x in row])


def turned(generator, q, largest):
    axis = [generator.gauss(0, 1) for _ in range(3)]
    length = sum(x * x for x in axis)**0.5
    half = generator.uniform(0.2, 1) * largest / 2
    return [float(x) for x in product([cos(half)] + [sin(half) * x / length for x in axis], q)]


def to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def walk(generator, count, start, intervals, step, tangent, norms=(1, 1), flips=0.0, scale=1.0, single=False, both=True):
    """Keys a step apart, tangents of random direction with norms up to `tangent` an interval, in key norms."""
    q, t, keys = [1.0, 0.0, 0.0, 0.0], start, []
    for _ in range(count):
        q = turned(generator, q, step)
        h = generator.uniform(*intervals)
        factor = generator.uniform(*norms) * (-1 if generator.random() < flips else 1)
        sides = [[generator.uniform(-1, 1) * tangent * factor / h for _ in range(4)] for _ in range(2)]
        if not both:
            sides[1] = sides[0]
        key = [scale * x for x in [factor * x for x in q] + sides[0] + sides[1]]
        keys.append([t] + ([to_float(x) for x in key] if single else key))
        t += h
    return keys


def main():
    g = random.Random(20250117)
    print("# 60-digit values by tests/reference/quaternion_hermite.py, rounded to double.")
    print("# curve RULE K; K keys t w x y z, in-tangent, out-tangent; samples N; N rows t w x y z omega alpha (body frame),")
    print("# and S/|p|, the sum of the norms of the coefficients in s over the norm there")
    write_curve("as_given", walk(g, 6, 0.0, (0.5, 2), 1.5, 0.5))
    write_curve("as_given", walk(g, 6, -3.0, (1e-3, 10), 1.5, 0.5))
    write_curve("as_given", walk(g, 6, 1.7e9, (0.004, 0.006), 0.02, 0.01))
    write_curve("as_given", walk(g, 6, 0.0, (1, 2), 1e-8, 1e-8))
    write_curve("as_given", walk(g, 6, 0.0, (0.5, 2), 1.0, 0.5, norms=(0.5, 4)))
    write_curve("as_given", walk(g, 6, 0.0, (0.03, 0.05), 0.4, 0.4, single=True, both=False))
    write_curve("as_given", walk(g, 6, 0.0, (0.5, 2), 0.5, 3.0))
    write_curve("as_given", walk(g, 6, 0.0, (0.5, 2), 1.0, 1.0, flips=0.3))
    write_curve("shortest", walk(g, 8, 0.0, (0.5, 2), 1.0, 0.5, flips=0.5))
    write_curve("as_given", walk(g, 5, 0.0, (0.5, 2), 1.0, 0.5, scale=2.0**700))
    write_curve("shortest", walk(g, 5, 0.0, (0.5, 2), 1.0, 0.5, norms=(0.5, 2), flips=0.5, scale=2.0**-900))
    write_curve("as_given", walk(g, 5, 0.0, (1, 1), 1.0, 0.0, both=False))


main()
