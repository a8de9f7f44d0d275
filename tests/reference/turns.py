#!/usr/bin/env python3
"""Writes vectors/turns.txt: curves whose steps turn by more than half a turn, sampled at 60 digits.

    python3 tests/reference/turns.py > tests/reference/vectors/turns.txt

Independent of the library's formulas: angular velocity and acceleration are differentiated numerically from q(t), the
derivatives at the ends of a segment are solved for from the given rates, those of a ROTATION_SPLINE from the continuity
of alpha. What is taken over are the definitions of docs/mathematics.md, section 7: the branch k that a rule chooses, and
the orientation inside a step of whole turns about which HERMITE and ROTATION_QUINTIC are expanded.
"""
import random

from mpmath import acos, cos, diff, findroot, floor, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 60


def product(a, b):
    return [a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]]


def conjugate(a):
    return [a[0], -a[1], -a[2], -a[3]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def norm(a):
    return sqrt(dot(a, a))


def scaled(s, a):
    return [s * x for x in a]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def exponential(r):
    """The unit quaternion of a rotation vector, full angle."""
    angle = norm(r)
    if angle == 0:
        return [mpf(1), mpf(0), mpf(0), mpf(0)]
    return [cos(angle / 2)] + scaled(sin(angle / 2) / angle, r)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def right_jacobian(r):
    """omega_body = J r' as a matrix: 1 - (1 - cos)/|r|^2 [r] + (|r| - sin)/|r|^3 [r]^2."""
    angle = norm(r)
    columns = []
    for k in range(3):
        e = [mpf(i == k) for i in range(3)]
        if angle == 0:
            columns.append(e)
            continue
        once = cross(r, e)
        twice = cross(r, once)
        columns.append(plus(plus(e, scaled(-(1 - cos(angle)) / angle**2, once)),
                            scaled((angle - sin(angle)) / angle**3, twice)))
    return matrix([[columns[j][i] for j in range(3)] for i in range(3)])


def applied(m, v):
    return list(m * matrix(v))


def solved(m, v):
    return list(lu_solve(m, matrix(v)))


def first_derivative(r, omega):
    return solved(right_jacobian(r), omega)


def second_derivative(r, dr, alpha):
    """r'' from alpha = d(J r')/dt = J r'' + (dJ/dt) r'."""
    turning = [diff(lambda s, k=k: applied(right_jacobian(plus(r, scaled(s, dr))), dr)[k], 0) for k in range(3)]
    return solved(right_jacobian(r), plus(alpha, scaled(-1, turning)))


class Step:
    """A step with its turns: axis, whole angle and the sign of its last key."""

    def __init__(self, a, b, turns, fallback):
        relative = product(conjugate(a), b)
        if relative[0] < 0:
            relative = scaled(-1, relative)
        sine = norm(relative[1:])
        self.theta = 2 * acos(min(relative[0], mpf(1)))
        self.axis = scaled(1 / sine, relative[1:]) if sine > mpf(10)**-14 else fallback
        if sine <= mpf(10)**-14:
            self.theta = mpf(0)
        self.turns = turns(self)
        self.r = scaled(self.theta + 2 * pi * self.turns, self.axis)


def hermite(values, firsts):
    """The cubic of u = (t - t_0)/h through values and h times derivatives, as a function of u."""
    (a, b), (da, db) = values, firsts
    def at(u):
        return [x * (1 + 2 * u) * (1 - u)**2 + y * u * u * (3 - 2 * u) + dx * u * (1 - u)**2 + dy * u * u * (u - 1)
                for x, y, dx, dy in zip(a, b, da, db)]
    return at


def quintic(values, firsts, seconds):
    conditions = matrix([[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 2, 0, 0, 0], [1, 1, 1, 1, 1, 1],
                         [0, 1, 2, 3, 4, 5], [0, 0, 2, 6, 12, 20]])
    columns = [list(lu_solve(conditions, matrix([values[0][k], firsts[0][k], seconds[0][k], values[1][k],
                                                 firsts[1][k], seconds[1][k]]))) for k in range(3)]
    return lambda u: [sum(c * u**n for n, c in enumerate(column)) for column in columns]


def base_of(step):
    """How far into a step of whole turns its base lies, 0 of others."""
    if step.turns == 0:
        return mpf(0)
    angle = norm(step.r)
    half = angle / 2
    past = half - 2 * pi * floor(half / (2 * pi) + mpf(1) / 2)
    return half + (pi if abs(past) < pi / 2 else 0)


class Curve:
    def __init__(self, method, rule, keys, turns):
        self.method, self.times = method, [mpf(k[0]) for k in keys]
        units = [scaled(1 / norm([mpf(x) for x in k[1:5]]), [mpf(x) for x in k[1:5]]) for k in keys]
        self.omega = [[mpf(x) for x in k[5:8]] for k in keys]
        self.alpha = [[mpf(x) for x in k[8:11]] for k in keys]
        self.q = [units[0]]
        self.steps = []
        for i in range(len(keys) - 1):
            h = self.times[i + 1] - self.times[i]
            v = plus(scaled(h / 2, plus(self.omega[i], self.omega[i + 1])),
                     scaled(h * h / 12, plus(self.alpha[i], scaled(-1, self.alpha[i + 1]))))
            given_sign = dot(self.q[i], units[i + 1])
            def choose(step):
                if rule == "given":
                    return turns[i]
                if rule == "as_given":
                    return -1 if given_sign < 0 else 0
                return int(floor((dot(v, step.axis) - step.theta) / (2 * pi) + mpf(1) / 2))
            fallback = scaled(1 / norm(v), v) if norm(v) > 0 else None
            step = Step(self.q[i], units[i + 1], choose, fallback)
            self.steps.append(step)
            self.q.append(product(self.q[i], exponential(step.r)))
        self.segments = [None] * len(self.steps)
        if method == "rotation_spline":
            self.solve()
        self.build()

    def h(self, i):
        return self.times[i + 1] - self.times[i]

    def build(self):
        for i, step in enumerate(self.steps):
            h = self.h(i)
            if self.method == "slerp":
                self.segments[i] = (self.q[i], lambda u, r=step.r: scaled(u, r))
                continue
            a = base_of(step) if self.method != "rotation_spline" else mpf(0)
            angle = norm(step.r)
            n = scaled(1 / angle, step.r)
            start, end = scaled(-a, n), scaled(angle - a, n)
            firsts = [first_derivative(start, self.omega[i]), first_derivative(end, self.omega[i + 1])]
            base = product(self.q[i], exponential(scaled(a, n)))
            if self.method == "rotation_quintic":
                seconds = [second_derivative(start, firsts[0], self.alpha[i]),
                           second_derivative(end, firsts[1], self.alpha[i + 1])]
                curve = quintic((start, end), [scaled(h, d) for d in firsts], [scaled(h * h, d) for d in seconds])
            else:
                curve = hermite((start, end), [scaled(h, d) for d in firsts])
            self.segments[i] = (base, curve)

    def alpha_at(self, i, u):
        """alpha of segment i, body frame."""
        base, curve = self.segments[i]
        h = self.h(i)
        def omega(s, k):
            r = curve(s)
            dr = [diff(lambda x, j=j: curve(x)[j], s) / h for j in range(3)]
            return applied(right_jacobian(r), dr)[k]
        return [diff(lambda s, k=k: omega(s, k), u) / h for k in range(3)]

    def solve(self):
        """Body rates at the knots of a ROTATION_SPLINE with ends CHORD: alpha is continuous."""
        n = len(self.steps)
        chords = [scaled(1 / self.h(i), step.r) for i, step in enumerate(self.steps)]
        self.omega = [chords[0]] + [scaled(mpf(1) / 2, plus(chords[i - 1], chords[i])) for i in range(1, n)] + [chords[-1]]
        def jumps(*values):
            for i in range(1, n):
                self.omega[i] = list(values[3 * (i - 1):3 * i])
            self.build()
            rows = []
            for i in range(1, n):
                before, after = self.end_alpha(i - 1), self.start_alpha(i)
                rows += [x - y for x, y in zip(before, after)]
            return rows
        guess = [x for i in range(1, n) for x in self.omega[i]]
        found = findroot(jumps, guess, tol=mpf(10)**-90, maxsteps=60)
        jumps(*list(found))

    # r(0) = 0 there, and the second derivative of the cubic is known
    def end_alpha(self, i):
        return self.from_cubic(i, mpf(1))

    def start_alpha(self, i):
        return self.from_cubic(i, mpf(0))

    def from_cubic(self, i, u):
        h, r_end = self.h(i), self.steps[i].r
        d0, d1 = self.omega[i], first_derivative(r_end, self.omega[i + 1])
        if u == 0:
            second = [(6 * r / h - 4 * x - 2 * y) / h for r, x, y in zip(r_end, d0, d1)]
            return second  # J(0) = 1, and dJ/dt r' = 0 there
        second = [(-6 * r / h + 2 * x + 4 * y) / h for r, x, y in zip(r_end, d0, d1)]
        turning = [diff(lambda s, k=k: applied(right_jacobian(plus(r_end, scaled(s, d1))), d1)[k], 0) for k in range(3)]
        return plus(applied(right_jacobian(r_end), second), turning)

    def sample(self, time):
        t = mpf(time)
        i = max(k for k in range(len(self.steps)) if self.times[k] <= t)
        base, curve = self.segments[i]
        q_at = lambda x: product(base, exponential(curve((x - self.times[i]) / self.h(i))))
        q = q_at(t)
        dq = [diff(lambda x, k=k: q_at(x)[k], t) for k in range(4)]
        ddq = [diff(lambda x, k=k: q_at(x)[k], t, 2) for k in range(4)]
        omega = scaled(2, product(conjugate(q), dq)[1:])
        alpha = scaled(2, product(conjugate(q), ddq)[1:])  # q* q'' = (-|omega|^2/4, alpha/2)
        return q + omega + alpha


def number(x):
    return repr(float(x))


def make_keys(source, count, speed, with_rates):
    keys, t = [], source.uniform(-1, 1)
    for _ in range(count):
        q = [source.gauss(0, 1) for _ in range(4)]
        rates = [source.uniform(-1, 1) * speed for _ in range(3)] + [source.uniform(-1, 1) for _ in range(3)]
        keys.append([t] + q + (rates if with_rates else [0.0] * 6))
        t += source.uniform(0.4, 1.6)
    return keys


def write(method, rule, keys, turns=None):
    if method not in ("hermite", "rotation_quintic"):
        keys = [k[:5] + [0.0] * 6 for k in keys]
    elif method == "hermite":
        keys = [k[:8] + [0.0] * 3 for k in keys]
    curve = Curve(method, rule, keys, turns)
    print("curve", method, rule, len(keys))
    for key in keys:
        print(" ".join(number(x) for x in key))
    print("turns", " ".join(str(step.turns) for step in curve.steps))
    times = []
    for i in range(len(keys) - 1):
        times += [keys[i][0] + u * (keys[i + 1][0] - keys[i][0]) for u in (0.03, 0.31, 0.5, 0.74, 0.97)]
    print("samples", len(times))
    for time in times:
        print(" ".join([number(time)] + [number(x) for x in curve.sample(time)]))


def main():
    source = random.Random(14)
    print("# written by tests/reference/turns.py; rates in the body frame")
    for method in ("slerp", "hermite", "rotation_quintic"):
        for rule, turns in (("as_given", None), ("given", [1, -1, 2, 0])):
            write(method, rule, make_keys(source, 5, 1.0, True), turns)
    for method in ("hermite", "rotation_quintic"):
        for speed in (4.0, 12.0, 25.0):
            write(method, "from_rates", make_keys(source, 5, speed, True))
    # steps of one turn more about nearly one axis, for which a spline exists
    source = random.Random(14)
    for turns in ([1, 1, 1], [0, -1, 0]):
        keys, angle = [], 0.0
        for i in range(4):
            angle += source.uniform(0.5, 1.5)
            tilt = source.uniform(-0.1, 0.1)
            keys.append([0.9 * i + source.uniform(0, 0.2)] + [float(cos(angle / 2)), tilt, float(sin(angle / 2)), 0.05]
                        + [0.0] * 6)
        write("rotation_spline", "given", keys, turns)


main()
