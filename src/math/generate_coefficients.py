#!/usr/bin/env python3
"""Writes coefficients.hpp: the polynomials of the sampling kernels, in double and in float.

Each polynomial is a weighted minimax fit (Remez exchange on a dense grid, in mpmath). Coefficients are rounded one by
one from c0 upwards, and the rest is fitted anew after each, so that it makes up for the rounding. c0 is the rounded
value at 0, which therefore is exact. The error of the rounded polynomial is measured on another grid, and the
generator fails if it exceeds a quarter of the unit roundoff by more than the rounding of c0 explains.

Usage: generate_coefficients.py [--check]
  --check  write nothing; exit with 1 if coefficients.hpp differs from what would be written
"""

import sys
from pathlib import Path
from typing import Callable, NamedTuple

from mpmath import acos, atan, cos, lu_solve, matrix, mp, mpf, pi, sin, sqrt, tan

mp.dps = 60

HEADER = Path(__file__).with_name("coefficients.hpp")
COLUMN_LIMIT = 120
FIT_POINTS = 600
CHECK_POINTS = 3001

DOUBLE, FLOAT = 53, 24  # formats by their bits
MEMBERS = {DOUBLE: "double kDouble", FLOAT: "float kFloat"}

# arguments reach the ends of the intervals only up to rounding
MARGIN = mpf("1.0001")
ARC = (pi / 4 * MARGIN) ** 2
HALF = (pi / 2 * MARGIN) ** 2
NEAR = MARGIN / 2
TANGENT = (tan(pi / 8) * MARGIN) ** 2
# the middle of angles past pi/2, as their square: C and K are there within 6e-18 of doubles
FAR = mpf("6.197265625")
FAR_REACH = FAR - (pi / 2) ** 2 / MARGIN


def c(y):
    return cos(sqrt(y))


def k(y):
    return sin(sqrt(y)) / sqrt(y)


def d(y):
    return (k(y) - c(y)) / y


def e(y):
    return (3 * d(y) - k(y)) / y


def acos_ratio(z):
    return acos(1 - z) / sqrt(z * (2 - z))


def atan_ratio(a):
    return atan(sqrt(a)) / sqrt(a)


class Polynomial(NamedTuple):
    name: str
    formula: str
    variable: str
    function: Callable
    at_zero: mpf
    end: mpf  # of the interval, which begins at 0
    terms: dict  # number of coefficients in each format
    relative: bool = True
    is_centred: bool = False  # the interval begins at -end

    @property
    def begin(self):
        return -self.end if self.is_centred else mpf(0)


POLYNOMIALS = [
    Polynomial("CosArc", "cos(sqrt y)", "y", c, mpf(1), ARC, {DOUBLE: 8, FLOAT: 5}),
    Polynomial("SincArc", "sin(sqrt y) / sqrt y", "y", k, mpf(1), ARC, {DOUBLE: 7, FLOAT: 4}),
    # absolute error: C has a zero at the end of the interval
    Polynomial("CosHalf", "C = cos(sqrt y)", "y", c, mpf(1), HALF, {DOUBLE: 9, FLOAT: 6}, relative=False),
    Polynomial("SincHalf", "K = sin(sqrt y) / sqrt y", "y", k, mpf(1), HALF, {DOUBLE: 9, FLOAT: 5}),
    # absolute errors: C has a zero just before the interval, K one within
    Polynomial("CosFar", f"C = cos(sqrt({FAR} + t))", "t", lambda t: c(FAR + t), c(FAR), FAR_REACH,
               {DOUBLE: 12, FLOAT: 7}, relative=False, is_centred=True),
    Polynomial("SincFar", f"K = sin(sqrt({FAR} + t)) / sqrt({FAR} + t)", "t", lambda t: k(FAR + t), k(FAR), FAR_REACH,
               {DOUBLE: 12, FLOAT: 7}, relative=False, is_centred=True),
    Polynomial("DHalf", "D = (K - C) / y", "y", d, mpf(1) / 3, HALF, {DOUBLE: 9, FLOAT: 5}),
    Polynomial("EHalf", "E = (3 D - K) / y", "y", e, mpf(1) / 15, HALF, {DOUBLE: 8, FLOAT: 5}),
    Polynomial("AcosRatio", "acos(1 - z) / sqrt(z (2 - z))", "z", acos_ratio, mpf(1), mpf(1), {DOUBLE: 22, FLOAT: 10}),
    # two terms more than its value needs: the second derivative is used too
    Polynomial("AcosRatioNear", "acos(1 - z) / sqrt(z (2 - z))", "z", acos_ratio, mpf(1), NEAR, {DOUBLE: 17, FLOAT: 9}),
    Polynomial("AtanRatio", "atan(sqrt a) / sqrt a", "a", atan_ratio, mpf(1), TANGENT, {DOUBLE: 12, FLOAT: 6}),
]


def horner(coefficients, x):
    value = mpf(0)
    for coefficient in reversed(coefficients):
        value = value * x + coefficient
    return value


def rounded(value, bits):
    with mp.workprec(bits):
        return +value


def alternating_extrema(errors, count):
    """Indices of `count` errors of alternating sign, the largest one among them and none smaller than needed."""
    extrema = [0]
    for i in range(1, len(errors)):
        if (errors[i] > 0) != (errors[extrema[-1]] > 0):
            extrema.append(i)
        elif abs(errors[i]) > abs(errors[extrema[-1]]):
            extrema[-1] = i
    while len(extrema) > count:
        sizes = [abs(errors[i]) for i in extrema]
        if len(extrema) == count + 1:
            extrema.pop(0 if sizes[0] < sizes[-1] else -1)
            continue
        least = sizes.index(min(sizes))
        if least in (0, len(extrema) - 1):
            extrema.pop(least)
        else:  # with its smaller neighbour, as the signs must go on alternating
            first = least - 1 if sizes[least - 1] < sizes[least + 1] else least
            del extrema[first : first + 2]
    return extrema


def minimax(points, target, weight, count):
    """The `count` coefficients p that make the largest weight |p - target| on the points smallest: Remez exchange."""
    reference = [(2 * i + 1) * len(points) // (2 * count + 2) for i in range(count + 1)]
    for _ in range(50):
        rows = [[weight[i] * points[i] ** k for k in range(count)] + [(-1) ** n] for n, i in enumerate(reference)]
        *coefficients, level = lu_solve(matrix(rows), matrix([weight[i] * target[i] for i in reference]))
        errors = [w * (horner(coefficients, x) - t) for x, t, w in zip(points, target, weight)]
        if max(map(abs, errors)) <= abs(level) * mpf("1.001"):
            return coefficients
        reference = alternating_extrema(errors, count + 1)
    raise RuntimeError("the exchange does not converge")


def fit(polynomial, bits):
    count = polynomial.terms[bits]
    # dense at both ends, as the extrema of the error are; 0 is left out, where c0 is the value
    span = polynomial.end - polynomial.begin
    points = [polynomial.begin + span * (1 - cos(pi * i / FIT_POINTS)) / 2 for i in range(1, FIT_POINTS + 1)]
    points = [x for x in points if abs(x) > span * mpf("1e-20")]
    values = [polynomial.function(x) for x in points]
    weight = [1 / value if polynomial.relative else mpf(1) for value in values]

    coefficients = [rounded(polynomial.at_zero, bits)]
    # no other coefficient can make up for c0 near 0: its rounding fades out over the interval instead
    off = coefficients[0] - polynomial.at_zero
    fading = 2 if polynomial.is_centred else 1
    target = [value + off * (1 - (x / polynomial.end) ** fading) ** 2 for x, value in zip(points, values)]
    while len(coefficients) < count:
        # what is left is x times a polynomial with one coefficient less
        target = [(t - coefficients[-1]) / x for x, t in zip(points, target)]
        weight = [w * abs(x) for x, w in zip(points, weight)]
        free = minimax(points, target, weight, count - len(coefficients))
        coefficients.append(rounded(free[0], bits))
    return coefficients


def checked_error(polynomial, coefficients, bits):
    worst = mpf(0)
    for i in range(1, CHECK_POINTS + 1):
        x = polynomial.begin + (polynomial.end - polynomial.begin) * i / CHECK_POINTS
        value = polynomial.function(x)
        worst = max(worst, abs((horner(coefficients, x) - value) / (value if polynomial.relative else 1)))
    bound = mpf(2) ** -(bits + 2) + abs(coefficients[0] / polynomial.at_zero - 1)
    if worst > bound:
        raise RuntimeError(f"{polynomial.name}, {bits} bits: error {float(worst):.2g} above {float(bound):.2g}")
    return worst


def literal(value, bits):
    """The exact value in hexadecimal, with all digits of the format."""
    digits, exponent = float(value).hex().split("p")
    return f"{digits}p{exponent}" if bits == DOUBLE else f"{digits.removesuffix('0000000')}p{exponent}f"


def array(declaration, literals):
    """The lines of an array, laid out as clang-format does: one line, or as few as possible with even columns."""
    line = f"  {declaration} = {{{', '.join(literals)}}};"
    if len(line) <= COLUMN_LIMIT:
        return [line]
    for height in range(1, len(literals) + 1):
        columns = -(-len(literals) // height)
        rows = [literals[i : i + columns] for i in range(0, len(literals), columns)]
        widths = [max(map(len, literals[i::columns])) + 2 for i in range(columns)]
        lines = ["".join(f"{x + ',':{width}}" for x, width in zip(row, widths)).rstrip() for row in rows]
        if max(map(len, lines)) + 6 <= COLUMN_LIMIT:
            return [f"  {declaration} = {{", *(" " * 6 + line for line in lines), "  };"]


def struct(polynomial):
    errors, members = [], []
    for bits in polynomial.terms:
        coefficients = fit(polynomial, bits)
        errors.append(f"{float(checked_error(polynomial, coefficients, bits)):.1e}")
        members += array(f"static constexpr {MEMBERS[bits]}[]", [literal(c, bits) for c in coefficients])
    error = f"{'relative' if polynomial.relative else 'absolute'} error {' (float '.join(errors)}"
    interval = f"{float(polynomial.begin):.4g} <= {polynomial.variable} <= {float(polynomial.end):.4g}"
    comment = f"// {polynomial.formula}, {interval}: {error}{')' * (len(errors) - 1)}"
    return "\n".join([comment, f"struct {polynomial.name} {{", *members, "};"])


def header():
    structs = "\n\n".join(map(struct, POLYNOMIALS))
    return f"""\
// Written by generate_coefficients.py: do not edit.
//
// Polynomials c0 + c1 x + ..., c0 first. The errors are those of the rounded coefficients in exact arithmetic.
#pragma once

namespace qtraj {{
// in each translation unit its own: no symbol compiled for one CPU may be shared with code for another
namespace {{

{structs}

}}  // namespace
}}  // namespace qtraj
"""


def main():
    text = header()
    if "--check" not in sys.argv[1:]:
        HEADER.write_text(text)
    elif HEADER.read_text() != text:
        sys.exit(f"{HEADER.name} is not what {Path(__file__).name} writes")


if __name__ == "__main__":
    main()
