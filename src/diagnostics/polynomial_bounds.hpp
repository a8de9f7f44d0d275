// Bounds of polynomials with vector coefficients, their derivatives and their moments, over discs in the complex plane.
#pragma once

#include <algorithm>

#include "diagnostics/rate_bounds.hpp"
#include "math/quaternion.hpp"
#include "math/vector_algebra.hpp"

namespace qtraj {
namespace {

// Past this a segment turns so often, or cancels so much, that samples have no digits: no bound is needed, and the
// squares of bounds do not overflow.
constexpr double kLargestCoefficient = 0x1p100;

// The length of a vector, or a bound of it where its squares would underflow.
template <class Vector>
double length_bound(const Vector& a) {
  const double largest = largest_component(a);
  return largest > 0x1p-400 ? length(a) : 2.0 * largest;
}

// The polynomial about another point: its coefficients there, in the parameter s - middle.
template <size_t Terms, size_t Size>
struct ShiftedPolynomial {
  double c[Terms][Size];
  double size[Terms];  // lengths of the coefficients

  ShiftedPolynomial(const double (&from)[Terms][Size], double middle) {
    for (size_t term = 0; term < Terms; ++term)
      for (size_t k = 0; k < Size; ++k) c[term][k] = from[term][k];
    for (size_t last = 0; last + 1 < Terms; ++last)
      for (size_t term = Terms - 1; term-- > last;)
        for (size_t k = 0; k < Size; ++k) c[term][k] += middle * c[term + 1][k];
    for (size_t term = 0; term < Terms; ++term) size[term] = length_bound(load(c[term]));
  }
};

// Bounds over a disc around the middle: of the distance to the value there, and of both derivatives.
struct PolynomialBounds {
  double change, first, second;
};
template <size_t Terms>
PolynomialBounds polynomial_bounds(const double (&size)[Terms], double radius) {
  PolynomialBounds bounds = {0, 0, 0};
  for (size_t term = Terms; term-- > 1;) {
    const double degree = static_cast<double>(term);
    bounds.change = (bounds.change + size[term]) * radius;
    bounds.first = bounds.first * radius + degree * size[term];
    if (term > 1) bounds.second = bounds.second * radius + degree * (degree - 1.0) * size[term];
  }
  return bounds;
}

// The same sums for |s| <= 1, from the coefficients in s: what rounding errors are measured by. kNoBound where
// a coefficient is past `largest`.
struct PolynomialSums {
  double value, first, second;
};
template <size_t Terms, size_t Size>
PolynomialSums polynomial_sums(const double (&c)[Terms][Size], double largest = kLargestCoefficient) {
  double size[Terms];
  for (size_t term = 0; term < Terms; ++term) size[term] = largest_component(load(c[term]));
  if (*std::max_element(size, size + Terms) > largest) return {kNoBound, kNoBound, kNoBound};
  const PolynomialBounds bounds = polynomial_bounds(size, 1.0);
  return {size[0] + bounds.change, bounds.first, bounds.second};
}

// What moments are made of: a x b of vectors, Im(a* b) of quaternions.
inline void moment_of(const double (&a)[3], const double (&b)[3], double (&product)[3]) {
  cross_product<Plain>(a, b, product);
}
inline void moment_of(const double (&a)[4], const double (&b)[4], double (&product)[3]) {
  relative_vector_part<Plain>(a, b, product);
}

// Bounds of the moment p x p' = sum (k - j) c_j x c_k s^(j + k - 1), j < k, and of its derivative p x p'' over a disc,
// of quaternions of Im(P* P'). They are 0 to rounding, which products of bounds would not be, of a turn about one axis,
// and of quaternions that change their norm alone.
struct Moments {
  double first, second;
};
template <size_t Terms, size_t Size>
class MomentBound {
 public:
  explicit MomentBound(const double (&c)[Terms][Size]) {
    for (size_t j = 0; j < Terms; ++j)
      for (size_t k = j + 1; k < Terms; ++k) {
        double product[3];
        moment_of(c[j], c[k], product);
        size_[j + k - 1] += static_cast<double>(k - j) * length_bound(load(product));
      }
  }
  Moments operator()(double radius) const {
    Moments sum = {0, 0};
    for (size_t power = kPowers; power-- > 0;) {
      sum.first = sum.first * radius + size_[power];
      if (power > 0) sum.second = sum.second * radius + static_cast<double>(power) * size_[power];
    }
    return sum;
  }

 private:
  static constexpr size_t kPowers = 2 * Terms - 3;
  double size_[kPowers] = {};
};

}  // namespace
}  // namespace qtraj
