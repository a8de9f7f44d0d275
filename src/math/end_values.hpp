// Cubics from values and derivatives at both ends, in s = 2u - 1.
#pragma once

namespace qtraj {

// Value, h times the first and h^2 times the second derivative at both ends of a segment; vectors of any length, or
// their components in a kernel.
template <class Vector>
struct EndValues {
  Vector value[2];
  Vector first[2];
  Vector second[2];
};

// The cubic through values and first derivatives: c[0] + c[1] s + c[2] s^2 + c[3] s^3, s = 2u - 1.
template <class Vector>
static inline void cubic_through(const EndValues<Vector>& ends, Vector (&c)[4]) {
  const Vector half_step = 0.5 * (ends.value[1] - ends.value[0]);
  const Vector first_mean = 0.25 * (ends.first[1] + ends.first[0]),
               first_change = 0.25 * (ends.first[1] - ends.first[0]);
  c[3] = 0.5 * (first_mean - half_step);
  c[2] = 0.5 * first_change;
  c[1] = half_step - c[3];
  c[0] = 0.5 * (ends.value[0] + ends.value[1]) - c[2];
}

}  // namespace qtraj
