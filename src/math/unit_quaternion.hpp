// Unit quaternions in double-double, and inverse lengths of nearly unit ones. Plain arithmetic, unless a function has
// it as a parameter: the same bits in the core and in kernels of either arithmetic.
#pragma once

#include "math/arithmetic.hpp"
#include "math/error_free.hpp"

namespace qtraj {
namespace {

// |a| to 1e-30 relative, as value + error, and 1/|a|; the squares of the components neither overflow nor underflow.
template <class Number>
struct PreciseLength {
  Number value, error, inverse;
};
template <class Number>
QTRAJ_INLINE PreciseLength<Number> precise_length_of(const Number (&a)[4]) {
  // |a|^2 = square.value + square.error
  DoubleDoubleOf<Number> square = two_product(a[0], a[0]);
  for (size_t k = 1; k < 4; ++k) {
    const DoubleDoubleOf<Number> product = two_product(a[k], a[k]);
    const DoubleDoubleOf<Number> sum = two_sum(square.value, product.value);
    square = {sum.value, square.error + (product.error + sum.error)};
  }
  // one Newton step gives the error
  const Number length = square_root(square.value), inverse = Number(1.0) / length;
  const DoubleDoubleOf<Number> length_squared = two_product(length, length);
  const Number residual = (square.value - length_squared.value) - length_squared.error + square.error;
  return {length, (Number(0.5) * residual) * inverse, inverse};
}

// a / |a| to 1e-30, as value + error; value is the nearest double, a zero keeps its sign. Components below 2^-700 stay
// the first quotient, less than 2 eps off: below 2^-900 two_product is not exact, and its two forms, with and without
// FMA, would give different bits.
template <class Number>
struct UnitOf {
  Number value[4], error[4];
  PreciseLength<Number> length;
};
template <class Number>
QTRAJ_INLINE UnitOf<Number> unit_of(const Number (&a)[4]) {
  constexpr double kLeastCorrected = 0x1p-700;
  const Number least(kLeastCorrected);
  UnitOf<Number> unit;
  unit.length = precise_length_of(a);
  for (size_t k = 0; k < 4; ++k) {
    const Number quotient = a[k] * unit.length.inverse;
    const DoubleDoubleOf<Number> product = two_product(quotient, unit.length.value);
    const Number residual = (a[k] - product.value) - product.error - quotient * unit.length.error;
    const Number correction = residual * unit.length.inverse, sum = quotient + correction;
    unit.value[k] = select(least < quotient, sum, select(quotient < -least, sum, quotient));
    unit.error[k] = correction - (unit.value[k] - quotient);
  }
  return unit;
}

// ---- Inverse lengths of quaternions that are unit to the rounding of float, as nearly all are: by series, without
// division or square root. Callers compute those of other quaternions and select lane by lane, so that the result of a
// row does not depend on its neighbours in the vector.

// Whether |q|^2 = 1 + excess is so near 1 that the terms left out of the series are below 2^-57.
template <class Number>
QTRAJ_INLINE auto is_near_one(Number excess) {
  return absolute(excess) < Number(0x1p-19);
}
// (1 + excess)^-1
template <class Arithmetic, class Number>
QTRAJ_INLINE Number inverse_near_one(Number excess) {
  const Number one(1.0);
  return Arithmetic::multiply_add(excess, excess - one, one);
}
// (1 + excess)^(-1/2)
template <class Arithmetic, class Number>
QTRAJ_INLINE Number inverse_root_near_one(Number excess) {
  const Number slope = Arithmetic::multiply_add(Number(0.375), excess, Number(-0.5));
  return Arithmetic::multiply_add(slope, excess, Number(1.0));
}

}  // namespace
}  // namespace qtraj
