#!/usr/bin/env python3
"""Writes vectors/screw.txt: screw motions between two poses, at 60 digits.

    python3 tests/reference/screw.py > tests/reference/vectors/screw.txt

Independent of the library's formulas: poses are 4 x 4 matrices, T(u) = T_a exp(u log(T_a^-1 T_b)) with the exponential
of a twist by its own power series, scaled and squared, and the twist by the closed form of the logarithm: r, the
rotation vector of the shorter turn, and rho = Jl(r)^-1 R_a^T (p_b - p_a). A row is q_a, p_a, q_b, p_b, u, and the
result: q with the sign of the arc from q_a at constant rate, and p.
"""
import random

from mpmath import atan2, cos, cot, mp, mpf, sin, sqrt

mp.dps = 60


def product(a, b):
    return [a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    size = sqrt(dot(a, a))
    return [x / size for x in a]


def conjugate(a):
    return [a[0], -a[1], -a[2], -a[3]]


def rotated(q, v):
    return product(product(q, [mpf(0)] + v), conjugate(q))[1:]


def multiplied(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def exponential(twist):
    """The 4 x 4 matrix exp of [r]x, rho by scaling, series and squaring."""
    r, rho = twist
    halvings = 0
    size = max(abs(x) for x in r) + mpf(10)**-50
    while size > mpf(2)**-20:
        size, halvings = size / 2, halvings + 1
    s = mpf(2)**-halvings
    m = [[mpf(0), -s * r[2], s * r[1], s * rho[0]], [s * r[2], mpf(0), -s * r[0], s * rho[1]],
         [-s * r[1], s * r[0], mpf(0), s * rho[2]], [mpf(0)] * 4]
    identity = [[mpf(i == j) for j in range(4)] for i in range(4)]
    total, term = identity, identity
    for n in range(1, 16):
        term = [[x / n for x in row] for row in multiplied(term, m)]
        total = [[x + y for x, y in zip(a, b)] for a, b in zip(total, term)]
    for _ in range(halvings):
        total = multiplied(total, total)
    return total


def relative_log(a, b):
    """The half-angle vector of the shorter turn, and the sign that b takes for it."""
    relative = product(conjugate(a), b)
    sign = -1 if relative[0] < 0 else 1
    relative = [sign * x for x in relative]
    sine = sqrt(dot(relative[1:], relative[1:]))
    if sine == 0:
        return [mpf(0)] * 3
    return [atan2(sine, relative[0]) / sine * x for x in relative[1:]]


def inverse_left_jacobian(r, v):
    """v - r x v / 2 + (1/t^2 - cot(t/2) / (2 t)) r x (r x v)."""
    angle = sqrt(dot(r, r))
    once = cross(r, v)
    twice = cross(r, once)
    factor = mpf(1) / 12 if angle < mpf(10)**-25 else (1 / angle**2 - cot(angle / 2) / (2 * angle))
    return [x - y / 2 + factor * z for x, y, z in zip(v, once, twice)]


def screw(q_a, p_a, q_b, p_b, u):
    a, b = unit([mpf(x) for x in q_a]), unit([mpf(x) for x in q_b])
    mp.dps = 100  # turns of 1e-12 cancel in the logarithm's factor
    half = relative_log(a, b)
    r = [2 * x for x in half]
    difference = [mpf(x) - mpf(y) for x, y in zip(p_b, p_a)]
    rho = inverse_left_jacobian(r, rotated(conjugate(a), difference))
    motion = exponential(([u * x for x in r], [u * x for x in rho]))
    p = [mpf(x) + y for x, y in zip(p_a, rotated(a, [motion[i][3] for i in range(3)]))]
    angle = sqrt(dot(half, half))
    turn = [cos(u * angle)] + [sin(u * angle) * x / angle if angle else mpf(0) for x in half]
    q = product(a, turn)
    mp.dps = 60
    return q, p


def main():
    random.seed(15)

    def number(scale=1.0):
        return random.uniform(-scale, scale)

    print("# written by tests/reference/screw.py: q_a, p_a, q_b, p_b, u, then q and p")
    fractions = [0.0, 0.25, 0.5, 0.75, 1.0, 1e-9, 1 - 2.0**-40, 0.4999999, 0.5000001,
                 -0.5, 1.5, -3.0, 7.25, 1000.0, -40000.5]
    angles = [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.7, 1.5707963, 2.5, 3.0, 3.1415, 3.14159265]
    for angle in angles:
        for variant in range(4):
            q_a = [number() for _ in range(4)]
            axis = unit([mpf(number()) for _ in range(3)])
            half = mpf(angle) / 2
            size = random.choice([1.0, 1e-3, 250.0])
            turned = product(unit([mpf(x) for x in q_a]), [cos(half)] + [sin(half) * x for x in axis])
            q_b = [float(size * random.choice([-1, 1]) * x) for x in turned]
            if variant == 0:  # exactly the same orientation, or a small turn exactly
                q_a = [1.0, 0.0, 0.0, 0.0]
                q_b = [1.0, float(half * axis[0]), float(half * axis[1]), float(half * axis[2])]
                if angle > 1:
                    q_b = [float(cos(half)), float(sin(half)), 0.0, 0.0]
            far = [1.0, 1e3, 1e-6, 1.0][variant]
            p_a = [number(far) for _ in range(3)]
            near = variant == 3
            p_b = [x + number(1e-6) for x in p_a] if near else [number(far) for _ in range(3)]
            for u in random.sample(fractions, 5):
                q, p = screw(q_a, p_a, q_b, p_b, mpf(u))
                print(*[repr(float(x)) for x in q_a + p_a + q_b + p_b + [u]], *[mp.nstr(x, 25) for x in q + p])


main()
