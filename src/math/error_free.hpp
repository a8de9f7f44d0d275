// Error-free transformations: a rounded result together with its rounding error.
// Source: T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971),
// and D. E. Knuth, "The Art of Computer Programming", vol. 2, 4.2.2.
#pragma once

namespace qtraj {

// A double-double, the unevaluated sum value + error. The functions below return the exact result in this form; error
// is then at most half an ulp of value. Number: double, or a vector of it. Kernels include this header: what they call
// has internal linkage (base/floating.hpp says why).
template <class Number>
struct DoubleDoubleOf {
  Number value, error;
};
using DoubleDouble = DoubleDoubleOf<double>;

template <class Number>
static inline DoubleDoubleOf<Number> two_sum(Number a, Number b) {
  const Number sum = a + b;
  const Number b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// For |a|, |b| < 2^500 and products above 2^-900. Dekker's product, without FMA: every target rounds alike. `split` is
// 2^27 + 1 for double and 2^12 + 1 for float.
template <class Number>
static inline DoubleDoubleOf<Number> two_product(Number a, Number b, Number split = Number(134217729.0)) {
  const Number a_shifted = split * a, b_shifted = split * b;
  const Number a_high = a_shifted - (a_shifted - a), b_high = b_shifted - (b_shifted - b);
  const Number a_low = a - a_high, b_low = b - b_high;
  const Number product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

// a b - c d to 2 eps relative, however much cancels; in the range of two_product.
static inline double difference_of_products(double a, double b, double c, double d) {
  const DoubleDouble first = two_product(a, b), second = two_product(c, d);
  return (first.value - second.value) + (first.error - second.error);
}

}  // namespace qtraj
