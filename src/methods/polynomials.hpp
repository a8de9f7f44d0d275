// Polynomials in s = 2u - 1 from values and derivatives at their ends, and the rotation-vector segments made of them.
#pragma once

#include "curve/segment.hpp"
#include "math/end_values.hpp"
#include "math/quaternion.hpp"

namespace qtraj {

// The quintic through values and both derivatives. `half_step` and `middle` are half the difference and half the sum of
// the values, which callers know more accurately than the rounded values tell.
template <class Vector>
void quintic_through(const EndValues<Vector>& ends, const Vector& half_step, const Vector& middle, Vector (&c)[6]) {
  const Vector first_mean = 0.25 * (ends.first[1] + ends.first[0]),
               first_change = 0.25 * (ends.first[1] - ends.first[0]);
  const Vector second_mean = 0.125 * (ends.second[1] + ends.second[0]),
               second_change = 0.125 * (ends.second[1] - ends.second[0]);
  const Vector excess = first_mean - half_step;
  c[5] = 0.125 * (second_change - 3.0 * excess);
  c[4] = 0.125 * (second_mean - first_change);
  c[3] = 0.5 * excess - 2.0 * c[5];
  c[2] = 0.5 * first_change - 2.0 * c[4];
  c[1] = half_step - c[3] - c[5];
  c[0] = middle - c[2] - c[4];
}

// Fills a segment from the half-angle vector p at its ends, given as p, h p', h^2 p'', and returns a bound of |p| over
// it.
double set_cubic(const Quaternion& base, double h, const EndValues<Vector3>& p, RotationVectorSegment<3>& segment);
double set_quintic(const Quaternion& base, double h, const EndValues<Vector3>& p, RotationVectorSegment<5>& segment);

// The ExponentRange for |p| up to a bound.
ExponentRange range_of(double bound);

}  // namespace qtraj
