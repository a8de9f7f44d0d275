// The kernel over segments of HERMITE; methods/hermite.cpp states the formulas.
#pragma once

#include "math/end_values.hpp"
#include "math/half_angle.hpp"
#include "math/relative_rotation.hpp"
#include "rows/segments.hpp"

namespace qtraj {
namespace {

// h omega at keys, in the body frame. Where it is extreme it is 0 instead, and `is_extreme` holds.
template <class Number, class Condition>
QTRAJ_INLINE void load_scaled_omega(const HermiteRows& rows, size_t key, size_t lanes, const Number (&q)[4], Number h,
                                    Number (&omega)[3], Condition& is_extreme) {
  constexpr double kExtreme = 0x1p200, kFast = 0x1p20;
  load_padded(rows.omega, key, lanes, omega);
  const auto is_large = (Number(kExtreme) < largest_magnitude(omega)) | (Number(kExtreme) < h);
  for (Number& component : omega) component = h * select(is_large, Number(0.0), component);
  is_extreme = is_extreme | is_large | (Number(kFast) < largest_magnitude(omega));
  const Number to_body[] = {q[0], -q[1], -q[2], -q[3]};
  if (rows.is_world) rotate_to_world<Plain>(to_body, omega);
}

// Whether the rates may say that a step makes whole turns (turns_from_rates and contradicts in methods/turns.cpp): not
// where, along its axis, they turn it by less than half a turn more or less than its own angle; nor, of a step that
// hardly turns, where they turn it by less than half a turn about any axis.
template <class Number>
QTRAJ_INLINE auto may_turn(const HermiteRows& rows, const RelativeRotationOf<Number>& rotation, Number sine,
                           const Number (&start)[3], const Number (&end)[3]) {
  constexpr double kHalfTurn = 3.1415, kHardly = 1e-6;  // the first less than pi, for rounding
  const double noise = 16.0 * rows.epsilon;
  Number turn[3];
  for (size_t k = 0; k < 3; ++k) turn[k] = Number(0.5) * (start[k] + end[k]);
  const Number angle = Number(2.0) * rotation.angle;
  const Number excess = absolute(dot_product<Plain>(turn, rotation.sin_part) - angle * sine);
  const auto turns_on = (Number(noise) < sine) & (Number(kHalfTurn) * sine <= excess);
  const auto turns_off = (sine <= Number(maximum(noise, kHardly))) & (Number(9.0) <= dot_product<Plain>(turn, turn));
  return turns_on | turns_off;
}

// Sets the cubic with p = 0, p' = start at its start and p = log, p' = end at its end. Returns the square of its bound
// (methods/polynomials.cpp).
template <class Number>
QTRAJ_INLINE Number set_hermite_cubic(const Number (&start)[3], const Number (&log)[3], const Number (&end)[3],
                                      RotationVectorSegment<3, Number>& segment) {
  const Number third(1.0 / 3.0);
  Number inner0[3], inner1[3];
  for (size_t k = 0; k < 3; ++k) {
    Number component[4];
    const EndValues<Number> p = {{Number(0.0), log[k]}, {start[k], end[k]}, {}};
    cubic_through(p, component);
    for (size_t term = 0; term < 4; ++term) segment.c[term][k] = component[term];
    inner0[k] = third * start[k];
    inner1[k] = log[k] - third * end[k];
  }
  return maximum(dot_product<Plain>(log, log),
                 maximum(dot_product<Plain>(inner0, inner0), dot_product<Plain>(inner1, inner1)));
}

template <class Number>
QTRAJ_INLINE size_t hermite_rows(const HermiteRows& rows, size_t row, size_t lanes, Number& largest_square) {
  const Number zero(0.0), half(0.5), two(2.0);
  SegmentEnds<Number> ends;
  load_ends(rows.keys, row, lanes, ends);
  const ChordsOf<Number> chords = chords_of(ends);
  // keys less than half a turn apart, whatever the rounding
  auto is_special = Number(1 - 0x1p-40) * chords.opposite_length < chords.length;
  Number start[3], end[3];
  load_scaled_omega(rows, row, lanes, ends.from, ends.h, start, is_special);
  load_scaled_omega(rows, row + 1, lanes, ends.to, ends.h, end, is_special);
  const RelativeRotationOf<Number> rotation = rotation_along(ends.from, chords, half_angle_of(chords));
  const Number sine = square_root(dot_product<Plain>(rotation.sin_part, rotation.sin_part));
  if (rows.turns_from_rates) is_special = is_special | may_turn(rows, rotation, sine, start, end);

  Number log[3], r[3], derivative[3];
  half_angle_vector(rotation, sine, log);
  for (size_t k = 0; k < 3; ++k) r[k] = two * log[k];
  const Number y = Number(0.25) * dot_product<Plain>(r, r);
  const auto is_long = Number(kPolynomialLimit) < y;
  is_special = is_special | is_long;
  inverse_jacobian_times(polynomial_factors(select(is_long, zero, y)), r, end, derivative);
  const auto is_still = largest_magnitude(r) <= zero;
  for (size_t k = 0; k < 3; ++k) {
    start[k] = half * start[k];
    derivative[k] = half * select(is_still, end[k], derivative[k]);
  }
  RotationVectorSegment<3, Number> segment;
  const Number square = set_hermite_cubic(start, log, derivative, segment);
  segment.scale = two / ends.h;
  for (size_t k = 0; k < 4; ++k) segment.base[k] = ends.from[k];

  const size_t done = lanes_before(is_special, lanes);
  largest_square = maximum(largest_square, select(lanes_of(first_lanes(done), Number()), square, zero));
  store_fields(fields_of<Number>(segment), &rows.segments[row].scale, kFieldsOf<RotationVectorSegment<3>>, done);
  return done;
}

template <class Number>
size_t hermite(const HermiteRows& rows, size_t first, size_t count) {
  Number largest_square(0.0);
  const size_t done = do_segments<Number>(
      first, count, [&](size_t row, size_t lanes) { return hermite_rows(rows, row, lanes, largest_square); });
  *rows.bound = maximum(*rows.bound, square_root(largest_lane(largest_square)));
  return done;
}

}  // namespace
}  // namespace qtraj
