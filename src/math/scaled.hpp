// Vectors of any magnitude, from subnormal numbers to DBL_MAX, where products neither overflow nor vanish.
#pragma once

#include "math/quaternion.hpp"

namespace qtraj {

// The vector value * 2^(600 steps).
template <class Vector>
struct Scaled {
  Vector value;
  int steps;
};

// x * 2^(600 steps), an infinity where that overflows; no flag tells of it.
double unscale(double x, int steps);
template <class Vector>
Vector unscale(const Scaled<Vector>& a) {
  if (a.steps == 0) return a.value;
  Vector result;
  for (int k = 0; k < Vector::RowsAtCompileTime; ++k) result[k] = unscale(a.value[k], a.steps);
  return result;
}

// The same vector with the largest component between 2^-474 and 2^424, if it is not 0 and was between 2^-1074 and
// 2^1024.
template <class Vector>
Scaled<Vector> scale(const Vector& a, int steps = 0) {
  const double factor = scale_for(largest_component(a));
  return {factor * a, steps + (factor < 1) - (factor > 1)};
}

// a + b. What is below 2^-600 of the larger one may be lost.
template <class Vector>
Scaled<Vector> sum(const Scaled<Vector>& a, const Scaled<Vector>& b) {
  const int steps = std::max(a.steps, b.steps);
  return {unscale(Scaled<Vector>{a.value, a.steps - steps}) + unscale(Scaled<Vector>{b.value, b.steps - steps}), steps};
}

}  // namespace qtraj
