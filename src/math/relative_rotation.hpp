// The rotation between two unit quaternions, good to a few eps relative at every angle (math/so3.hpp states it
// exactly). Plain arithmetic: the same bits in the core and in kernels of either arithmetic.
#pragma once

#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

template <class Number>
struct RelativeRotationOf {
  Number sin_part[3], angle;
};

// The rotation from a + a_error to b + b_error.
template <class Number>
QTRAJ_INLINE RelativeRotationOf<Number> relative_rotation_of(const Number (&a)[4], const Number (&a_error)[4],
                                                             const Number (&b)[4], const Number (&b_error)[4]) {
  Number chord[4], opposite_chord[4], shorter[4];
  for (size_t k = 0; k < 4; ++k) {
    chord[k] = (b[k] - a[k]) + (b_error[k] - a_error[k]);
    opposite_chord[k] = (a[k] + b[k]) + (a_error[k] + b_error[k]);
  }
  const Number chord_length = square_root(dot_product<Plain>(chord, chord));
  const Number opposite_length = square_root(dot_product<Plain>(opposite_chord, opposite_chord));
  // Im(a* b) = Im(a* (b - a)) = Im(a* (b + a)): the shorter of the two loses nothing to cancellation
  const auto is_long = opposite_length < chord_length;
  for (size_t k = 0; k < 4; ++k) shorter[k] = select(is_long, opposite_chord[k], chord[k]);
  const Number(&c)[4] = shorter;
  return {{a[0] * c[1] - a[1] * c[0] - a[2] * c[3] + a[3] * c[2], a[0] * c[2] + a[1] * c[3] - a[2] * c[0] - a[3] * c[1],
           a[0] * c[3] - a[1] * c[2] + a[2] * c[1] - a[3] * c[0]},
          Number(2.0) * atan2_of(chord_length, opposite_length)};
}

}  // namespace
}  // namespace qtraj
