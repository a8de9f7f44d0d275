// What is known of a function that is analytic around a piece from samples on the piece and a bound over a disc around
// it: a polynomial through the samples with its error, and an integral with its error. L. N. Trefethen, "Approximation
// Theory and Approximation Practice" (2013), theorems 8.2 and 19.3: for a function below M in the ellipse with foci
// -1, 1 and half axes of sum rho the polynomial of degree n through Chebyshev's points is off by at most
// 4 M rho^-n/(rho - 1), and Gauss's rule of n + 1 points by (64/15) M rho^-2n/(1 - rho^-2).
#pragma once

#include <algorithm>
#include <cmath>

#include "diagnostics/rate_bounds.hpp"

namespace qtraj {

constexpr double power(double base, int exponent) {
  double result = 1.0;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

// ---- Maxima: the polynomial of degree 12 ----

constexpr size_t kDegree = 12;

// The error of the polynomial, in units of the bound over a disc.
constexpr double polynomial_error(size_t disc) {
  return 4.0 / (power(kEllipses[disc], kDegree) * (kEllipses[disc] - 1.0));
}

// The polynomial a[0] + a[1] x + ... through samples at Chebyshev's points x = +-cos(k pi/12) and 0.
struct LocalPolynomial {
  double a[kDegree + 1];
};

// cos(k pi/12)
constexpr double kChebyshevPoints[] = {
    1.0, 0x1.ee8dd4748bf15p-1, 0x1.bb67ae8584caap-1, 0x1.6a09e667f3bcdp-1, 0.5, 0x1.0907dc1930690p-2, 0.0};
constexpr size_t kPointPairs = 6;

// Newton's form through (y[k], values[k]) by divided differences, then in powers of y.
template <size_t Count>
void interpolate(const double (&y)[Count], double (&values)[Count]) {
  for (size_t order = 1; order < Count; ++order)
    for (size_t k = Count; k-- > order;) values[k] = (values[k] - values[k - 1]) / (y[k] - y[k - order]);
  for (size_t first = Count - 1; first-- > 0;)
    for (size_t k = first; k + 1 < Count; ++k) values[k] -= y[first] * values[k + 1];
}

// sample(x, value) sets the value at x in [-1, 1] of the piece, or is false.
template <class Sample>
bool polynomial_through(const Sample& sample, LocalPolynomial& polynomial) {
  // even and odd part are polynomials in y = x^2, the odd one times x
  double y[kPointPairs + 1], odd_y[kPointPairs], even[kPointPairs + 1], odd[kPointPairs];
  for (size_t k = 0; k < kPointPairs; ++k) {
    const double x = kChebyshevPoints[k];
    double left, right;
    if (!sample(-x, left) || !sample(x, right)) return false;
    y[k] = odd_y[k] = x * x;
    even[k] = 0.5 * (left + right);
    odd[k] = 0.5 * (right - left) / x;
  }
  y[kPointPairs] = 0.0;
  if (!sample(0.0, even[kPointPairs])) return false;
  interpolate(y, even);
  interpolate(odd_y, odd);
  for (size_t k = 0; k <= kPointPairs; ++k) polynomial.a[2 * k] = even[k];
  for (size_t k = 0; k < kPointPairs; ++k) polynomial.a[2 * k + 1] = odd[k];
  return true;
}

// A bound of the polynomial over |x - middle| <= half_width: the parabola's maximum, reached at `at`, and the lengths
// of the other terms of the polynomial about the middle. It is off by the third power of the width.
struct PolynomialMaximum {
  double bound, at;
};
inline PolynomialMaximum maximum_over(const LocalPolynomial& polynomial, const Piece& part) {
  double b[kDegree + 1];
  std::copy(polynomial.a, polynomial.a + kDegree + 1, b);
  for (size_t last = 0; last < kDegree; ++last)
    for (size_t term = kDegree; term-- > last;) b[term] += part.middle * b[term + 1];
  double rest = 0;
  for (size_t term = kDegree; term > 2; --term) rest = (rest + std::abs(b[term])) * part.half_width;
  rest *= part.half_width * part.half_width;

  const double slope = b[1] * part.half_width, bend = b[2] * part.half_width * part.half_width;
  double x = slope < 0 ? -1.0 : 1.0;
  if (bend < 0 && std::abs(slope) < -2.0 * bend) x = -0.5 * slope / bend;
  return {b[0] + x * (slope + x * bend) + rest, part.middle + x * part.half_width};
}

// ---- Integrals: Gauss-Legendre rule of 12 points (Abramowitz and Stegun, table 25.4) ----

// The error of the rule over [-1, 1], in units of the bound over a disc.
constexpr double gauss_error(size_t disc) {
  const double rho = kEllipses[disc];
  return (64.0 / 15.0) / (power(rho, 22) * (1.0 - 1.0 / (rho * rho)));
}

// The integral over [-1, 1]; sample as above.
template <class Sample>
bool gauss(const Sample& sample, double& integral) {
  constexpr double kNodes[] = {0.12523340851146891547, 0.36783149899818019375, 0.58731795428661744730,
                               0.76990267419430468704, 0.90411725637047485668, 0.98156063424671925069};
  constexpr double kWeights[] = {0.24914704581340278500, 0.23349253653835480876, 0.20316742672306592175,
                                 0.16007832854334622633, 0.10693932599531843096, 0.04717533638651182719};
  integral = 0;
  for (size_t k = 0; k < 6; ++k) {
    double left, right;
    if (!sample(-kNodes[k], left) || !sample(kNodes[k], right)) return false;
    integral += kWeights[k] * (left + right);
  }
  return true;
}

}  // namespace qtraj
