// Kernels over keys: normalisation, continuity of signs, and what constructors need of all
// keyframes. Plain arithmetic: the same bits in the core and in kernels of either arithmetic.
#pragma once

#include "math/half_angle.hpp"
#include "math/relative_rotation.hpp"
#include "math/unit_quaternion.hpp"
#include "math/vector_algebra.hpp"
#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

template <class Number>
size_t normalize(const NormalizeRows& rows, size_t first, size_t count) {
  return do_rows<Number>(rows.q.is_float, first, count, [&](size_t row, auto real) {
    using Real = decltype(real);
    Number a[4];
    if (!load_own_rows<Real>(rows.q, row, a)) return false;
    store_rows(unit_of(a).value, static_cast<Real*>(rows.q_out.data), row);
    return true;
  });
}

// ---- Keys made continuous in sign, a vector of them at once: a key is negated where the number of opposed neighbours
// up to it is odd.

// Loads keys `row`, `row` + 1, ... and the key before each: that before the first one is done and written, the others
// are as given. False where one is not ordinary.
template <class Real, class Number>
QTRAJ_INLINE bool load_neighbours(const ContinuousRows& rows, size_t row, Number (&previous)[4], Number (&q)[4]) {
  if (!load_own_rows<Real>(rows.q, row, q)) return false;
  double window[kLanesOf<Number>][4], before[4];
  if (!load_own_rows<Real>(written(rows.q_out), row - 1, before)) return false;
  std::memcpy(window[0], before, sizeof before);
  double given[4];
  for (size_t lane = 1; lane < kLanesOf<Number>; ++lane) {
    convert_rows(static_cast<const Real*>(rows.q.data), row + lane - 1, given);
    std::memcpy(window[lane], given, sizeof given);
  }
  convert_rows(window[0], 0, previous);
  return true;
}

template <class Real, class Number>
QTRAJ_INLINE bool continue_rows(const ContinuousRows& rows, size_t row) {
  Number previous[4], q[4];
  if (!load_neighbours<Real>(rows, row, previous, q)) return false;
  // where the cosine is above 2^-40 in magnitude it has the sign of the exact dot product, because the rounding error
  // is below 4 eps of the lengths
  const Number cosine = dot_product<Plain>(previous, q), zero(0.0);
  const Number least = Number(0x1p-80) * dot_product<Plain>(previous, previous) * dot_product<Plain>(q, q);
  if (!all(least < cosine * cosine)) return false;

  const unsigned flipped = parities(lane_bits(cosine < zero)) & ((1u << kLanesOf<Number>)-1);
  const auto is_flipped = lanes_of(flipped, Number());
  for (Number& component : q) component = select(is_flipped, -component, component);
  *rows.flips += static_cast<size_t>(__builtin_popcount(flipped));
  store_rows(q, static_cast<Real*>(rows.q_out.data), row);
  return true;
}

template <class Number>
size_t make_continuous(const ContinuousRows& rows, size_t first, size_t count) {
  return do_rows<Number>(rows.q.is_float, first, count,
                         [&](size_t row, auto real) { return continue_rows<decltype(real), Number>(rows, row); });
}

// ---- What constructors need of all keyframes.

template <class Number>
size_t relative_rotations(const RelativeRotationRows& rows, size_t first, size_t count) {
  return do_rows<Number>(false, first, count, [&](size_t row, auto) {
    Number a[4], a_error[4], b[4], b_error[4];
    read_numbers<double>(rows.a, row, a);
    read_numbers<double>(rows.a_error, row, a_error);
    read_numbers<double>(rows.b, row, b);
    read_numbers<double>(rows.b_error, row, b_error);
    const RelativeRotationOf<Number> rotation = relative_rotation_of(a, a_error, b, b_error);
    const Number numbers[] = {rotation.sin_part[0], rotation.sin_part[1], rotation.sin_part[2], rotation.angle};
    store_rows(numbers, rows.rotation[0], row);
    return true;
  });
}

// Loads and stores numbers of records that are `stride` doubles apart, one record per lane.
template <class Number, size_t Width>
QTRAJ_INLINE void load_strided(const double* from, size_t stride, Number (&to)[Width]) {
  double lanes[Width][kLanesOf<Number>];
  for (size_t lane = 0; lane < kLanesOf<Number>; ++lane)
    for (size_t k = 0; k < Width; ++k) lanes[k][lane] = from[lane * stride + k];
  for (size_t k = 0; k < Width; ++k) to[k] = load_lanes(lanes[k], Number());
}
template <class Number, size_t Width>
QTRAJ_INLINE void store_strided(const Number (&from)[Width], double* to, size_t stride) {
  double lanes[Width][kLanesOf<Number>];
  for (size_t k = 0; k < Width; ++k) store_lanes(from[k], lanes[k]);
  for (size_t lane = 0; lane < kLanesOf<Number>; ++lane)
    for (size_t k = 0; k < Width; ++k) to[lane * stride + k] = lanes[k][lane];
}

template <class Number>
QTRAJ_INLINE bool jacobian_rows(const JacobianRecords& records, size_t row) {
  const size_t at = row * records.stride;
  Number r[3], jacobian[9];
  load_strided(records.r + at, records.stride, r);
  const Number y = Number(0.25) * dot_product<Plain>(r, r);
  if (!all(y <= Number(kPolynomialLimit))) return false;
  const RateFactors<Number> factors = polynomial_factors(y);
  const TurningFactorsOf<Number> turning = turning_factors_of(factors);
  jacobian_of(factors, turning.sideways, r, jacobian);
  store_strided(jacobian, records.jacobian + at, records.stride);
  const Number numbers[] = {turning.along_once, turning.along_twice, turning.sideways};
  store_strided(numbers, records.turning + at, records.stride);
  return true;
}

template <class Number>
size_t jacobians(const JacobianRecords& records, size_t first, size_t count) {
  return do_rows<Number>(false, first, count, [&](size_t row, auto) { return jacobian_rows<Number>(records, row); });
}

}  // namespace
}  // namespace qtraj
