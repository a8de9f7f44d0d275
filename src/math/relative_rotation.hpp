// The rotation between two unit quaternions, good to a few eps relative at every angle (math/so3.hpp states it
// exactly). Plain arithmetic: the same bits in the core and in kernels of either arithmetic.
#pragma once

#include "math/chords.hpp"

namespace qtraj {
namespace {

template <class Number>
struct RelativeRotationOf {
  Number sin_part[3], angle;
};

// Im(a* b).
template <class Number>
QTRAJ_INLINE void conjugate_product_vector(const Number (&a)[4], const Number (&b)[4], Number (&vector)[3]) {
  vector[0] = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
  vector[1] = a[0] * b[2] + a[1] * b[3] - a[2] * b[0] - a[3] * b[1];
  vector[2] = a[0] * b[3] - a[1] * b[2] + a[2] * b[1] - a[3] * b[0];
}

// The rotation from a along the chords to b.
template <class Number>
QTRAJ_INLINE RelativeRotationOf<Number> rotation_along(const Number (&a)[4], const ChordsOf<Number>& chords,
                                                       Number half_angle) {
  // Im(a* b) = Im(a* (b - a)) = Im(a* (b + a)): the shorter of the two loses nothing to cancellation
  const auto is_long = chords.opposite_length < chords.length;
  Number c[4];
  for (size_t k = 0; k < 4; ++k) c[k] = select(is_long, chords.opposite[k], chords.chord[k]);
  RelativeRotationOf<Number> rotation;
  conjugate_product_vector(a, c, rotation.sin_part);
  rotation.angle = Number(2.0) * half_angle;
  return rotation;
}

// The half-angle vector of a rotation; 0 where sin_part is.
template <class Number>
QTRAJ_INLINE void half_angle_vector(const RelativeRotationOf<Number>& rotation, Number sine, Number (&log)[3]) {
  const auto has_axis = Number(0.0) < sine;
  const Number factor = rotation.angle / select(has_axis, sine, Number(1.0));
  for (size_t k = 0; k < 3; ++k) log[k] = select(has_axis, factor * rotation.sin_part[k], rotation.sin_part[k]);
}

// The rotation from a + a_error to b + b_error.
template <class Number>
QTRAJ_INLINE RelativeRotationOf<Number> relative_rotation_of(const Number (&a)[4], const Number (&a_error)[4],
                                                             const Number (&b)[4], const Number (&b_error)[4]) {
  const ChordsOf<Number> chords = chords_between(a, a_error, b, b_error);
  return rotation_along(a, chords, half_angle_of(chords));
}

}  // namespace
}  // namespace qtraj
