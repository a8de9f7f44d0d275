#!/usr/bin/env python3
"""Writes vectors/vector_curves.txt: vector curves of every method and of all pairs of ends, sampled at 50 digits.

    python3 tests/reference/vector_curves.py > tests/reference/vectors/vector_curves.txt

Independent of the library's formulas: the polynomials of all segments of a curve are solved for at once, in powers of
u = (t - t_i)/h_i, from the conditions that define the curve, and differentiated term by term.

A curve is one line, "curve method start end dim count"; a line for each key, its time, values, and the derivatives that
are given; then "samples n" and a line for each sample: the time, and for each component the value, the first and the
second derivative, and the sum of the magnitudes that the error of the value is measured in: the ends of the segment and
the shape of docs/mathematics.md, section 10. Rows of derivatives at given ends are those of the first and the last key;
a row that no end needs is "nan".
"""
import random

from mpmath import lu_solve, matrix, mp, mpf

mp.dps = 50

COUNTS = [2, 3, 4, 9]
OPEN_ENDS = ["natural", "not_a_knot", "given"]
DIGITS = 19


def derivative_row(u, order, terms):
    """The derivative of the powers 1, u, u^2, ... by u."""
    row = []
    for n in range(terms):
        factor = mpf(1)
        for k in range(order):
            factor *= n - k
        row.append(factor * u**(n - order) if n >= order else mpf(0))
    return row


class System:
    """Linear conditions on the powers of all segments."""

    def __init__(self, steps, terms):
        self.steps, self.terms, self.rows, self.right = steps, terms, [], []

    def add(self, value, *parts):
        """The sum of factor * (d/dt)^order of segments at their u is a value."""
        row = [mpf(0)] * (self.terms * len(self.steps))
        for factor, segment, u, order in parts:
            for n, number in enumerate(derivative_row(mpf(u), order, self.terms)):
                row[self.terms * segment + n] += factor * number / self.steps[segment]**order
        self.rows.append(row)
        self.right.append(value)

    def solve(self):
        flat = list(lu_solve(matrix(self.rows), matrix(self.right)))
        return [flat[self.terms * i:self.terms * (i + 1)] for i in range(len(self.steps))]


def cubic(steps, y, start, end, slopes):
    """The spline through y, as powers of u of each segment."""
    last = len(steps) - 1
    system = System(steps, 4)
    for i in range(last + 1):
        system.add(y[i], (1, i, 0, 0))
        system.add(y[i + 1], (1, i, 1, 0))
    for i in range(last):
        for order in (1, 2):
            system.add(0, (1, i, 1, order), (-1, i + 1, 0, order))
    if start == "periodic":
        for order in (1, 2):
            system.add(0, (1, 0, 0, order), (-1, last, 1, order))
        return system.solve()
    both_without_knots = last == 1 and start == end == "not_a_knot"
    for condition, segment, u, neighbour, slope in ((start, 0, 0, 1, slopes[0]), (end, last, 1, last - 1, slopes[1])):
        if condition == "natural":
            system.add(0, (1, segment, u, 2))
        elif condition == "given":
            system.add(slope, (1, segment, u, 1))
        elif last == 0:  # of two keys, the slope of the line through them
            system.add((y[1] - y[0]) / steps[0], (1, segment, u, 1))
        elif both_without_knots and segment == last:  # the same condition twice: the parabola
            system.add(0, (1, 0, 0, 3))
        else:
            system.add(0, (1, segment, u, 3), (-1, neighbour, 1 - u, 3))
    return system.solve()


def piecewise(steps, y, given):
    """Powers from the values and the given derivatives at both ends of each segment."""
    orders = 1 + len(given)
    segments = []
    for i, h in enumerate(steps):
        system = System([h], 2 * orders)
        for order, rows in enumerate([y] + given):
            system.add(rows[i], (1, 0, 0, order))
            system.add(rows[i + 1], (1, 0, 1, order))
        segments += system.solve()
    return segments


def magnitudes(powers):
    """|left| + |right| + |a| + |b| + |c| + |d| of a segment."""
    def at(u, order):
        return sum(c * d for c, d in zip(powers, derivative_row(mpf(u), order, len(powers))))
    chord = at(1, 0) - at(0, 0)
    a, b = at(0, 1) - chord, chord - at(1, 1)
    total = abs(at(0, 0)) + abs(at(1, 0)) + abs(a) + abs(b)
    if len(powers) == 6:
        total += abs(at(0, 2) / 2 - b + 2 * a) + abs(at(1, 2) / 2 - a + 2 * b)
    return total


def draw(count, dim, size=1.0):
    return [[random.uniform(-size, size) for _ in range(dim)] for _ in range(count)]


def knots_of(kind, count):
    if kind == "even":
        return [0.25 * i - 1 for i in range(count)]
    time = 1.7e9 if kind == "recorded" else random.uniform(-5, 5)
    times = [time]
    while len(times) < count:
        times.append(times[-1] + 10**random.uniform(-1.5, 0.5))
    return times


def sample_times(times):
    result = []
    for i in range(len(times) - 1):
        h = times[i + 1] - times[i]
        result.append(times[i])
        result += [times[i] + h * u for u in ((1e-9, 0.31, 0.77) if len(times) < 4 else (0.57,))]
    return result + [times[-1]]


def text(numbers):
    return " ".join(mp.nstr(x, DIGITS) if isinstance(x, mpf) else repr(x) for x in numbers)


def write(method, start, end, kind, count, dim):
    times, keys = knots_of(kind, count), draw(count, dim)
    if start == "periodic":
        keys[-1] = list(keys[0])
    h = [mpf(b) - mpf(a) for a, b in zip(times, times[1:])]
    nothing = [float("nan")] * dim
    first = draw(count, dim, 3.0) if method in ("hermite", "quintic") else [nothing] * count
    if start == "given":
        first[0] = draw(1, dim, 3.0)[0]
    if end == "given":
        first[-1] = draw(1, dim, 3.0)[0]
    second = draw(count, dim, 9.0) if method == "quintic" else [nothing] * count

    curves = []
    for c in range(dim):
        y, v, a = ([mpf(row[c]) for row in rows] for rows in (keys, first, second))
        curves.append({"step": lambda: [[k] for k in y],
                       "linear": lambda: piecewise(h, y, []),
                       "cubic": lambda: cubic(h, y, start, end, [v[0], v[-1]]),
                       "hermite": lambda: piecewise(h, y, [v]),
                       "quintic": lambda: piecewise(h, y, [v, a])}[method]())
    print("curve", method, start, end, dim, count)
    for i in range(count):
        print(text([times[i]] + keys[i] + first[i] + second[i]))
    samples = sample_times(times)
    print("samples", len(samples))
    for time in samples:
        segment = max(i for i in range(count) if times[i] <= time)
        if method != "step":
            segment = min(segment, count - 2)
        numbers = [time]
        for powers in (segments[segment] for segments in curves):
            u, step = (mpf(time) - mpf(times[segment])), h[min(segment, count - 2)]
            for order in range(3):
                row = derivative_row(u / step, order, len(powers))
                numbers.append(sum(p * d for p, d in zip(powers, row)) / step**order)
            numbers.append(mpf(mp.nstr(magnitudes(powers), 6)))
        print(text(numbers))


def main():
    random.seed(4)
    print("# Written by tests/reference/vector_curves.py, which says what the lines mean.")
    pairs = [(a, b) for a in OPEN_ENDS for b in OPEN_ENDS] + [("periodic", "periodic")]
    kinds = ["even", "ragged", "recorded"]
    number = 0
    for method in ("step", "linear", "hermite", "quintic", "cubic"):
        for start, end in pairs if method == "cubic" else [("default", "default")]:
            for count in COUNTS:
                for kind in kinds[:2] if method == "cubic" else kinds:
                    number += 1
                    write(method, start, end, kind, count, 1 + number % 5)


if __name__ == "__main__":
    main()
