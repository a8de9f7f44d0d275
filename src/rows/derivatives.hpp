// Derivatives of orientations from rates, and back; functions/derivatives.hpp states the formulas and the bounds. Rates
// and derivatives of 0 are as ordinary as others. Plain arithmetic: the same bits in kernels of either arithmetic.
#pragma once

#include "math/half_angle.hpp"
#include "math/unit_quaternion.hpp"
#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

// A row and its unit quaternion; false where one is not ordinary. (Not inlined: all that is done with rates shares one
// copy.)
template <class Number>
QTRAJ_NOINLINE bool load_unit(const Input<4>& rows, size_t row, Number (&q)[4], UnitOf<Number>& unit) {
  if (!load_own_rows<double>(rows, row, q)) return false;
  unit = unit_of(q);
  return true;
}

// A rate in the body frame is multiplied by q_wb from the left, one in the world frame from the right.
template <class Number>
QTRAJ_INLINE void multiply_in(Frame frame, const Number (&q_wb)[4], const Number (&rate)[4], Number (&product)[4]) {
  const bool is_body = frame == Frame::body;
  const Number(&left)[4] = is_body ? q_wb : rate, (&right)[4] = is_body ? rate : q_wb;
  hamilton_product<Plain>(left, right, product);
}

template <class Number>
QTRAJ_INLINE bool derivative_rows(const RatesToDerivatives& rows, size_t row) {
  const bool has_alpha = rows.alpha.data != nullptr;
  const Number quarter(-0.25), half(0.5);
  Number q[4], omega[3], alpha[3], derivative[4];
  UnitOf<Number> unit;
  if (!load_unit(rows.q_wb, row, q, unit) || !load_bounded_rows<double>(rows.omega, row, omega)) return false;
  if (has_alpha && !load_bounded_rows<double>(rows.alpha, row, alpha)) return false;

  const Number once[4] = {Number(0.0), half * omega[0], half * omega[1], half * omega[2]};
  multiply_in(rows.frame, unit.value, once, derivative);
  store_rows(derivative, static_cast<double*>(rows.derivatives.first.data), row);
  if (!has_alpha) return true;
  const Number twice[4] = {quarter * dot_product<Plain>(omega, omega), half * alpha[0], half * alpha[1],
                           half * alpha[2]};
  multiply_in(rows.frame, unit.value, twice, derivative);
  store_rows(derivative, static_cast<double*>(rows.derivatives.second.data), row);
  return true;
}

template <class Number>
size_t derivatives_from_rates(const RatesToDerivatives& rows, size_t first, size_t count) {
  return do_rows<Number>(first, count, [&](size_t row) { return derivative_rows<Number>(rows, row); });
}

template <class Number>
QTRAJ_INLINE bool rate_rows(const DerivativesToRates& rows, size_t row) {
  const bool has_ddq = rows.ddq.data != nullptr;
  const Number two(2.0);
  Number q[4], dq[4], ddq[4], p[4], second[4], rate[3];
  UnitOf<Number> unit;
  if (!load_unit(rows.q_wb, row, q, unit) || !load_bounded_rows<double>(rows.dq, row, dq)) return false;
  if (has_ddq && !load_bounded_rows<double>(rows.ddq, row, ddq)) return false;
  const Number norm = unit.length.value + unit.length.error;
  const Number back[4] = {unit.value[0], -unit.value[1], -unit.value[2], -unit.value[3]};
  multiply_in(rows.frame, back, dq, p);
  for (Number& component : p) component = component / norm;
  for (size_t k = 0; k < 3; ++k) rate[k] = two * p[k + 1];
  store_rows(rate, static_cast<double*>(rows.rates.first.data), row);
  if (!has_ddq) return true;
  multiply_in(rows.frame, back, ddq, second);
  // the vector part of p^2 is 2 Re p Im p
  for (size_t k = 0; k < 3; ++k) rate[k] = two * (second[k + 1] / norm - (two * p[0]) * p[k + 1]);
  store_rows(rate, static_cast<double*>(rows.rates.second.data), row);
  return true;
}

template <class Number>
size_t rates_from_derivatives(const DerivativesToRates& rows, size_t first, size_t count) {
  return do_rows<Number>(first, count, [&](size_t row) { return rate_rows<Number>(rows, row); });
}

}  // namespace
}  // namespace qtraj
