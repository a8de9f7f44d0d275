#!/usr/bin/env python3
"""Writes vectors/unnormalized.txt: the curve in R^4 before it is normalised, and its derivatives, at 60 digits.

    python3 tests/reference/unnormalized.py > tests/reference/vectors/unnormalized.txt

Independent of the library's formulas: the quintic is solved for as a polynomial in t - t_i from its twelve conditions
at the two keys, where q' = (0, omega/2) q and q'' = (-|omega|^2/4, alpha/2) q, omega and alpha in the world frame.
"""
import random

from mpmath import lu_solve, matrix, mp, mpf, sqrt

mp.dps = 60


def product(a, b):
    return [a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def norm(a):
    return sqrt(dot(a, a))


def continuous_units(keys):
    """Unit keys of exact doubles, each of the sign that is nearer to the one before."""
    units = []
    for key in keys:
        q = [mpf(x) for x in key[1:5]]
        q = [x / norm(q) for x in q]
        if units and dot(units[-1], q) < 0:
            q = [-x for x in q]
        units.append(q)
    return units


def derivatives(key, unit):
    """q' and q'' of a key with world rates."""
    omega, alpha = [mpf(x) for x in key[5:8]], [mpf(x) for x in key[8:11]]
    return (product([mpf(0)] + [x / 2 for x in omega], unit),
            product([-dot(omega, omega) / 4] + [x / 2 for x in alpha], unit))


def polynomial(method, keys, units, i):
    """Coefficients of a segment in u = (t - t_i)/h, one list a component; and h, and the size D of its data: the largest
    of the step, h |q'| and h^2 |q''|."""
    h = mpf(keys[i + 1][0]) - mpf(keys[i][0])
    a, b = units[i], units[i + 1]
    step = norm([y - x for x, y in zip(a, b)])
    if method == "nlerp":
        return [[x, y - x] for x, y in zip(a, b)], h, step
    (da, dda), (db, ddb) = derivatives(keys[i], a), derivatives(keys[i + 1], b)
    size = max([step] + [h * norm(d) for d in (da, db)] + [h * h * norm(d) for d in (dda, ddb)])
    conditions = matrix([[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 2, 0, 0, 0], [1, 1, 1, 1, 1, 1],
                         [0, 1, 2, 3, 4, 5], [0, 0, 2, 6, 12, 20]])
    return [list(lu_solve(conditions, matrix([a[k], h * da[k], h * h * dda[k], b[k], h * db[k], h * h * ddb[k]])))
            for k in range(4)], h, size


def at(coefficients, u, order):
    total = mpf(0)
    for power in range(len(coefficients) - 1, order - 1, -1):
        factor = 1
        for k in range(order):
            factor *= power - k
        total = total * u + factor * coefficients[power]
    return total


def write_curve(method, keys, times):
    print(f"curve {method} {len(keys)} {len(times)}")
    for key in keys:
        print(*[repr(x) for x in key])
    units = continuous_units(keys)
    segments = [polynomial(method, keys, units, i) for i in range(len(keys) - 1)]
    for t in times:
        i = max(k for k in range(len(segments)) if keys[k][0] <= t)
        coefficients, h, size = segments[i]
        u = (mpf(t) - mpf(keys[i][0])) / h
        row = [at(c, u, order) / h**order for order in range(3) for c in coefficients]
        print(repr(t), *[repr(float(x)) for x in row], repr(float(h)), repr(float(size)))


def turned(generator, q, largest):
    axis = [generator.gauss(0, 1) for _ in range(3)]
    length = sum(x * x for x in axis)**0.5
    half = generator.uniform(0.2, 1) * largest / 2
    sine = float(mp.sin(half)) / length
    return [float(x) for x in product([mp.cos(half)] + [sine * x for x in axis], q)]


def random_curve(generator, method, count, start, intervals, step, rate):
    """Keys with turns up to `step`, intervals in a range, norms and signs as they come, and turns of `rate` rad an
    interval given as rates."""
    q, t, keys = [1.0, 0.0, 0.0, 0.0], start, []
    for _ in range(count):
        q = turned(generator, q, step)
        scale = generator.choice([-1, 1]) * generator.uniform(0.8, 1.2)
        h = generator.uniform(*intervals)
        key = [t] + [scale * x for x in q]
        if method == "quintic":
            key += [generator.uniform(-1, 1) * rate / h for _ in range(3)]
            key += [generator.uniform(-1, 1) * rate / h**2 for _ in range(3)]
        keys.append(key)
        t += h
    times = [key[0] for key in keys]
    for a, b in zip(keys, keys[1:]):
        times += [a[0] + u * (b[0] - a[0]) for u in (1e-9, 0.1, 0.5, generator.uniform(0, 1), 1 - 1e-9)]
    return keys, sorted(t for t in times if keys[0][0] <= t <= keys[-1][0])


def main():
    generator = random.Random(20240611)
    print("# 60-digit values by tests/reference/unnormalized.py, rounded to double.")
    print("# curve METHOD K N; K keys t w x y z, of a quintic with world omega and alpha; N samples t p p' p'' h D,")
    print("# h the length of the segment, D the largest of its step, h |q'| and h^2 |q''|")
    for method in ("nlerp", "quintic"):
        for start, intervals, step, rate in ((0.0, (0.5, 2), 1.5, 1.0), (-3.0, (1e-3, 10), 3.0, 3.0),
                                             (1.7e9, (0.004, 0.006), 0.02, 0.02), (0.0, (1, 1), 1e-8, 1e-8),
                                             (5.0, (0.1, 1), 0.5, 30.0), (-1e-4, (1e-6, 1e-5), 3.14, 0.0)):
            write_curve(method, *random_curve(generator, method, 6, start, intervals, step, rate))


main()
