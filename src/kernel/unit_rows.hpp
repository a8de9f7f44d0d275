// Unit quaternions to twice the digits of double, and what is made of them row by row. Plain arithmetic: the same bits
// in the core and in kernels of either arithmetic.
#pragma once

#include "array_rows.hpp"
#include "motion.hpp"

namespace qtraj {
namespace {

// |a| to 1e-30 relative, as value + error, and 1/|a|; components whose squares neither overflow nor vanish.
template <class Number>
struct PreciseLength {
  Number value, error, inverse;
};
template <class Number>
QTRAJ_INLINE PreciseLength<Number> precise_length_of(const Number (&a)[4]) {
  // |a|^2 = square.value + square.error
  ExactOf<Number> square = two_product(a[0], a[0]);
  for (size_t k = 1; k < 4; ++k) {
    const ExactOf<Number> product = two_product(a[k], a[k]);
    const ExactOf<Number> sum = two_sum(square.value, product.value);
    square = {sum.value, square.error + (product.error + sum.error)};
  }
  // one Newton step for the second part
  const Number length = square_root(square.value), inverse = Number(1.0) / length;
  const ExactOf<Number> length_squared = two_product(length, length);
  const Number rest = (square.value - length_squared.value) - length_squared.error + square.error;
  return {length, (Number(0.5) * rest) * inverse, inverse};
}

// a / |a| to 1e-30, as value + error; value is the nearest double, and a zero keeps its sign.
template <class Number>
struct UnitOf {
  Number value[4], error[4];
  PreciseLength<Number> length;
};
template <class Number>
QTRAJ_INLINE UnitOf<Number> unit_of(const Number (&a)[4]) {
  const Number zero(0.0);
  UnitOf<Number> unit;
  unit.length = precise_length_of(a);
  for (size_t k = 0; k < 4; ++k) {
    const Number quotient = a[k] * unit.length.inverse;
    const ExactOf<Number> product = two_product(quotient, unit.length.value);
    const Number rest = (a[k] - product.value) - product.error - quotient * unit.length.error;
    const Number correction = rest * unit.length.inverse, sum = quotient + correction;
    unit.value[k] = select(quotient < zero, sum, select(zero < quotient, sum, quotient));
    unit.error[k] = correction - (unit.value[k] - quotient);
  }
  return unit;
}

template <class Real, class Number>
QTRAJ_INLINE bool normalize_rows(const KeyArrays& arrays, size_t row) {
  Number a[4];
  if (!load_rows<Real>({arrays.q, false}, row, a)) return false;
  store_rows(unit_of(a).value, static_cast<Real*>(arrays.q_out), row);
  return true;
}
template <class Vector>
size_t normalize(const KeyArrays& arrays, size_t first, size_t count) {
  return do_rows<Vector>(first, count, [&](size_t row, auto number) {
    using Number = decltype(number);
    return arrays.single ? normalize_rows<float, Number>(arrays, row) : normalize_rows<double, Number>(arrays, row);
  });
}

template <class Real, class Number>
QTRAJ_INLINE bool rotate_rows(const RotateArrays& arrays, size_t row) {
  Number a[4], v[3];
  if (!load_rows<Real>(arrays.q, row, a) || !load_rows<Real>(arrays.v, row, v)) return false;
  rotate_to_world<Plain>(unit_of(a).value, v);
  store_rows(v, static_cast<Real*>(arrays.v_world), row);
  return true;
}
template <class Vector>
size_t rotate(const RotateArrays& arrays, size_t first, size_t count) {
  return do_rows<Vector>(first, count, [&](size_t row, auto number) {
    using Number = decltype(number);
    return arrays.single ? rotate_rows<float, Number>(arrays, row) : rotate_rows<double, Number>(arrays, row);
  });
}

}  // namespace
}  // namespace qtraj
