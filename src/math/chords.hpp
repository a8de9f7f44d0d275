// The difference and the sum of two unit quaternions, which the arc between them and the rotation from one to the other
// are made of: formed in double-double they lose nothing to cancellation. Plain arithmetic: the same bits in the core
// and in kernels of either arithmetic.
#pragma once

#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

// b - a, which leads from a to b, and a + b, which leads from -a to b; and their lengths.
template <class Number>
struct ChordsOf {
  Number chord[4], opposite[4];
  Number length, opposite_length;
};

template <class Number>
QTRAJ_INLINE void measure_chords(ChordsOf<Number>& chords) {
  chords.length = square_root(dot_product<Plain>(chords.chord, chords.chord));
  chords.opposite_length = square_root(dot_product<Plain>(chords.opposite, chords.opposite));
}

// From a + a_error to b + b_error.
template <class Number>
QTRAJ_INLINE ChordsOf<Number> chords_between(const Number (&a)[4], const Number (&a_error)[4], const Number (&b)[4],
                                             const Number (&b_error)[4]) {
  ChordsOf<Number> chords;
  for (size_t k = 0; k < 4; ++k) {
    chords.chord[k] = (b[k] - a[k]) + (b_error[k] - a_error[k]);
    chords.opposite[k] = (a[k] + b[k]) + (a_error[k] + b_error[k]);
  }
  measure_chords(chords);
  return chords;
}

// Half the angle between a and b on S^3, rad.
template <class Number>
QTRAJ_INLINE Number half_angle_of(const ChordsOf<Number>& chords) {
  return atan2_of(chords.length, chords.opposite_length);
}

// The arc from a to b (math/arc.hpp) where its middle is well defined: not where is_nearly_opposite.
template <class Number>
struct ArcOf {
  Number half_angle;
  Number m[4], e[4];
};
template <class Number>
QTRAJ_INLINE auto is_nearly_opposite(const ChordsOf<Number>& chords) {
  return chords.opposite_length < Number(1e-6) * chords.length;
}
template <class Number>
QTRAJ_INLINE ArcOf<Number> arc_of(const ChordsOf<Number>& chords) {
  const Number zero(0.0), one(1.0);
  const auto has_direction = zero < chords.length;
  const Number divisor = select(has_direction, chords.length, one);
  ArcOf<Number> arc;
  arc.half_angle = half_angle_of(chords);
  for (size_t k = 0; k < 4; ++k) {
    arc.m[k] = chords.opposite[k] / chords.opposite_length;
    arc.e[k] = select(has_direction, chords.chord[k] / divisor, zero);
  }
  return arc;
}

}  // namespace
}  // namespace qtraj
