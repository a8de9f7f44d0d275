// Error-free transformations: a rounded result together with its rounding error.
// Source: T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971),
// and D. E. Knuth, "The Art of Computer Programming", vol. 2, 4.2.2.
#pragma once

namespace qtraj {

// value + error is exact; error is at most half an ulp of value.
struct Exact {
  double value, error;
};

inline Exact two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// For |a|, |b| < 2^500 and products above 2^-900. Without fma, so that every target rounds alike.
inline Exact two_product(double a, double b) {
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const double a_shifted = kSplit * a, b_shifted = kSplit * b;
  const double a_high = a_shifted - (a_shifted - a), b_high = b_shifted - (b_shifted - b);
  const double a_low = a - a_high, b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

}  // namespace qtraj
