// Vectors with an exponent of their own: inputs of any magnitude, from subnormal numbers to DBL_MAX, whose products
// neither overflow nor underflow.
#pragma once

#include "math/quaternion.hpp"

namespace qtraj {

// The vector value * 2^(600 steps).
template <class Vector>
struct Scaled {
  Vector value;
  int steps;
};

// x * 2^(600 steps). Where that overflows, an infinity, without raising FE_OVERFLOW.
double unscale(double x, int steps);
template <class Vector>
Vector unscale(const Scaled<Vector>& a) {
  if (a.steps == 0) return a.value;
  Vector result;
  for (int k = 0; k < Vector::RowsAtCompileTime; ++k) result[k] = unscale(a.value[k], a.steps);
  return result;
}

// The same vector as a * 2^(600 steps), the largest component of `value` being between 2^-474 and 2^424 for any a != 0.
template <class Vector>
Scaled<Vector> scale(const Vector& a, int steps = 0) {
  const double factor = scale_for(largest_component(a));
  return {factor * a, steps + (factor < 1) - (factor > 1)};
}

// a + b. Terms below 2^-600 of the larger one may be lost.
template <class Vector>
Scaled<Vector> sum(const Scaled<Vector>& a, const Scaled<Vector>& b) {
  const int steps = std::max(a.steps, b.steps);
  return {unscale(Scaled<Vector>{a.value, a.steps - steps}) + unscale(Scaled<Vector>{b.value, b.steps - steps}), steps};
}

}  // namespace qtraj
