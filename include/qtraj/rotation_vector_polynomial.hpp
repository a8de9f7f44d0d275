// Polynomials in s = 2u - 1 from their ends, and the rotation-vector segments made of them.
#pragma once

#include "qtraj/quaternion.hpp"
#include "qtraj/segment.hpp"

namespace qtraj {

// Value, h times the first and h^2 times the second derivative at both ends of a segment; vectors of any length.
template <class Vector>
struct EndValues {
  Vector value[2];
  Vector rise[2];
  Vector bend[2];
};

// The cubic through values and rises: c[0] + c[1] s + c[2] s^2 + c[3] s^3, s = 2u - 1.
template <class Vector>
void cubic_through(const EndValues<Vector>& ends, Vector (&c)[4]) {
  const Vector half_step = 0.5 * (ends.value[1] - ends.value[0]);
  const Vector mean_rise = 0.25 * (ends.rise[1] + ends.rise[0]), rise_change = 0.25 * (ends.rise[1] - ends.rise[0]);
  c[3] = 0.5 * (mean_rise - half_step);
  c[2] = 0.5 * rise_change;
  c[1] = half_step - c[3];
  c[0] = 0.5 * (ends.value[0] + ends.value[1]) - c[2];
}

// The quintic through values, rises and bends. `half_step` and `middle`, half the difference and half the sum of the
// values, are given: callers know them better than rounded values tell.
template <class Vector>
void quintic_through(const EndValues<Vector>& ends, const Vector& half_step, const Vector& middle, Vector (&c)[6]) {
  const Vector mean_rise = 0.25 * (ends.rise[1] + ends.rise[0]), rise_change = 0.25 * (ends.rise[1] - ends.rise[0]);
  const Vector mean_bend = 0.125 * (ends.bend[1] + ends.bend[0]), bend_change = 0.125 * (ends.bend[1] - ends.bend[0]);
  const Vector excess = mean_rise - half_step;
  c[5] = 0.125 * (bend_change - 3.0 * excess);
  c[4] = 0.125 * (mean_bend - rise_change);
  c[3] = 0.5 * excess - 2.0 * c[5];
  c[2] = 0.5 * rise_change - 2.0 * c[4];
  c[1] = half_step - c[3] - c[5];
  c[0] = middle - c[2] - c[4];
}

// Half-angle vectors p at the ends, in full: p, h p', h^2 p''. Fills the segment and gives a bound of |p| over it.
double set_cubic(const Quaternion& base, double h, const EndValues<Vector3>& p, RotationVectorSegment<3>& segment);
double set_quintic(const Quaternion& base, double h, const EndValues<Vector3>& p, RotationVectorSegment<5>& segment);

// The range of kernels for |p| up to a bound.
ExponentRange range_of(double bound);

}  // namespace qtraj
