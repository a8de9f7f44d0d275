// Mean rates between neighbouring samples (diagnostics/samples.hpp), in plain arithmetic and by the core's formulas:
// the same bits in kernels of either arithmetic.
#pragma once

#include "math/relative_rotation.hpp"
#include "rows/clean_keys.hpp"
#include "rows/derivatives.hpp"

namespace qtraj {
namespace {

// The unit quaternion of each row, of the inverse rotation for rates in the world frame; false where one is not
// ordinary.
template <class Number>
QTRAJ_INLINE bool load_turn(const MeanRateRows& rows, size_t row, UnitOf<Number>& unit) {
  Number q[4];
  if (!load_unit(rows.q_wb, row, q, unit) || has_tiny(q)) return false;
  if (rows.frame == Frame::body) return true;
  for (size_t k = 1; k < 4; ++k) unit.value[k] = -unit.value[k], unit.error[k] = -unit.error[k];
  return true;
}

// b with the sign that makes it the nearer to a. Where the cosine is above 2^-40 in magnitude it has the sign of the
// exact one.
template <class Number>
QTRAJ_INLINE bool take_nearer(const UnitOf<Number>& a, UnitOf<Number>& b) {
  const Number cosine = dot_product<Plain>(a.value, b.value);
  if (any(absolute(cosine) < Number(0x1p-40))) return false;
  const auto is_opposed = cosine < Number(0.0);
  for (size_t k = 0; k < 4; ++k) {
    b.value[k] = select(is_opposed, -b.value[k], b.value[k]);
    b.error[k] = select(is_opposed, -b.error[k], b.error[k]);
  }
  return true;
}

template <class Number>
QTRAJ_INLINE bool mean_rate_rows(const MeanRateRows& rows, size_t row) {
  const Number half(0.5), two(2.0);
  Number time[1], next_time[1];
  read_numbers<double>(rows.times, row, time);
  read_numbers<double>(rows.times, row + 1, next_time);
  if (!all(is_bounded(time)) || !all(is_bounded(next_time))) return false;
  const Number step[] = {next_time[0] - time[0]};
  if (!all(is_ordinary(step)) || !all(Number(0.0) < step[0])) return false;

  UnitOf<Number> a, b;
  if (!load_turn(rows, row, a) || !load_turn(rows, row + 1, b) || !take_nearer(a, b)) return false;
  // b a* is a* b with the conjugates of b and a in the places of a and b
  const bool is_body = rows.frame == Frame::body;
  const UnitOf<Number>&from = is_body ? a : b, &to = is_body ? b : a;
  const RelativeRotationOf<Number> rotation = relative_rotation_of(from.value, from.error, to.value, to.error);
  Number rate[3];
  half_angle_vector(rotation, square_root(dot_product<Plain>(rotation.sin_part, rotation.sin_part)), rate);
  for (Number& component : rate) component = two * component / step[0];
  store_rows(rate, static_cast<double*>(rows.omega.data), row);
  if (rows.t_mid.data) store_lanes(half * time[0] + half * next_time[0], static_cast<double*>(rows.t_mid.data) + row);
  return true;
}

template <class Number>
size_t mean_rates(const MeanRateRows& rows, size_t first, size_t count) {
  return do_rows<Number>(first, count, [&](size_t row) { return mean_rate_rows<Number>(rows, row); });
}

}  // namespace
}  // namespace qtraj
