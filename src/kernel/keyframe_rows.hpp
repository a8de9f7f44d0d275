// What constructors need of all keyframes, many at once. Plain arithmetic: the same bits in the core and in kernels of
// either arithmetic.
#pragma once

#include "array_rows.hpp"
#include "jacobian.hpp"
#include "relative_rotation.hpp"
#include "unit_quaternion.hpp"

namespace qtraj {
namespace {

// Whether a component is so small, but not 0, that the error of a product with it may not be exact. Vectors find that
// error by a fused step where there is one, single rows never: the two then differ.
template <class Number>
QTRAJ_INLINE bool has_tiny(const Number (&q)[4]) {
  const Number zero(0.0), least(0x1p-440);
  const auto is_tiny = [&](Number component) {
    const Number magnitude = absolute(component);
    return (zero < magnitude) & (magnitude < least);
  };
  return any((is_tiny(q[0]) | is_tiny(q[1])) | (is_tiny(q[2]) | is_tiny(q[3])));
}

template <class Real, class Number>
QTRAJ_INLINE bool unit_key_rows(const UnitKeyArrays& arrays, size_t row, Number& worst_norm_error) {
  Number q[4];
  if (!load_rows<Real>({arrays.q, false}, row, q) || has_tiny(q)) return false;
  const UnitOf<Number> unit = unit_of(q);
  store_rows(unit.value, arrays.unit[0], row);
  store_rows(unit.error, arrays.unit_error[0], row);
  worst_norm_error = maximum(worst_norm_error, absolute(unit.length.value - Number(1.0)));
  return true;
}

template <class Vector>
size_t unit_keys(const UnitKeyArrays& arrays, size_t first, size_t count, double& worst_norm_error) {
  return do_rows_for_largest<Vector>(
      arrays.single, first, count, worst_norm_error,
      [&](size_t row, auto& worst, auto real) { return unit_key_rows<decltype(real)>(arrays, row, worst); });
}

template <class Number>
QTRAJ_INLINE bool relative_rotation_rows(const RelativeRotationArrays& arrays, size_t row) {
  Number a[4], a_error[4], b[4], b_error[4];
  read_numbers<double>(arrays.a, row, a);
  read_numbers<double>(arrays.a_error, row, a_error);
  convert_rows(arrays.b, row, b);
  convert_rows(arrays.b_error, row, b_error);
  const RelativeRotationOf<Number> rotation = relative_rotation_of(a, a_error, b, b_error);
  const Number numbers[] = {rotation.sin_part[0], rotation.sin_part[1], rotation.sin_part[2], rotation.angle};
  store_rows(numbers, arrays.rotation[0], row);
  return true;
}

template <class Vector>
size_t relative_rotations(const RelativeRotationArrays& arrays, size_t first, size_t count) {
  return do_rows<Vector>(false, first, count, [&](size_t row, auto number, auto) {
    return relative_rotation_rows<decltype(number)>(arrays, row);
  });
}

// Between records and vectors that hold the same number of several records.
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
  const Number y = Number(0.25) * dot<Plain>(r, r);
  if (!all(y <= Number(kPolynomialLimit))) return false;
  const RateFactors<Number> factors = polynomial_factors(y);
  const TurningFactorsOf<Number> turning = turning_factors_of(factors);
  jacobian_of(factors, turning.sideways, r, jacobian);
  store_strided(jacobian, records.jacobian + at, records.stride);
  const Number numbers[] = {turning.along_once, turning.along_twice, turning.sideways};
  store_strided(numbers, records.turning + at, records.stride);
  return true;
}

template <class Vector>
size_t jacobians(const JacobianRecords& records, size_t first, size_t count) {
  return do_rows<Vector>(false, first, count,
                         [&](size_t row, auto number, auto) { return jacobian_rows<decltype(number)>(records, row); });
}

}  // namespace
}  // namespace qtraj
