// Mean rates between neighbouring samples (diagnostics/samples.hpp), in plain arithmetic and by the core's formulas:
// the same bits in kernels of either arithmetic.
#pragma once

#include "math/relative_rotation.hpp"
#include "rows/clean_keys.hpp"

namespace qtraj {
namespace {

// The unit quaternion of each row, of the inverse rotation for rates in the world frame; false where one is not
// ordinary.
template <class Number>
QTRAJ_INLINE bool load_unit(const MeanRateRows& rows, size_t row, UnitOf<Number>& unit) {
  Number q[4];
  if (!load_own_rows<double>(rows.q_wb, row, q) || has_tiny(q)) return false;
  unit = unit_of(q);
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
  Number from[1], to[1];
  read_numbers<double>(rows.times, row, from);
  read_numbers<double>(rows.times, row + 1, to);
  if (!all(is_bounded(from)) || !all(is_bounded(to))) return false;
  const Number step[] = {to[0] - from[0]};
  if (!all(is_ordinary(step)) || !all(Number(0.0) < step[0])) return false;

  UnitOf<Number> a, b;
  if (!load_unit(rows, row, a) || !load_unit(rows, row + 1, b) || !take_nearer(a, b)) return false;
  // b a* is a* b with the conjugates of b and a in the places of a and b
  const RelativeRotationOf<Number> rotation = rows.frame == Frame::body
                                                  ? relative_rotation_of(a.value, a.error, b.value, b.error)
                                                  : relative_rotation_of(b.value, b.error, a.value, a.error);
  Number rate[3];
  half_angle_vector(rotation, square_root(dot_product<Plain>(rotation.sin_part, rotation.sin_part)), rate);
  for (Number& component : rate) component = two * component / step[0];
  store_rows(rate, static_cast<double*>(rows.omega.data), row);
  if (rows.t_mid.data) store_lanes(half * from[0] + half * to[0], static_cast<double*>(rows.t_mid.data) + row);
  return true;
}

template <class Number>
size_t mean_rates(const MeanRateRows& rows, size_t first, size_t count) {
  return do_rows<Number>(first, count, [&](size_t row) { return mean_rate_rows<Number>(rows, row); });
}

}  // namespace
}  // namespace qtraj
