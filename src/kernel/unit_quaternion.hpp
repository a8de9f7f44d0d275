// Unit quaternions to twice the digits of double. Plain arithmetic: the same bits in the core and in kernels of either
// arithmetic.
#pragma once

#include "arithmetic.hpp"
#include "qtraj/error_free.hpp"

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

// a / |a| to 1e-30, as value + error; value is the nearest double, a zero keeps its sign. Components below 2^-700 are
// left as the first quotient, below 2 eps off: beneath 2^-900 two_product is not exact, and rounds in two ways.
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
    const ExactOf<Number> product = two_product(quotient, unit.length.value);
    const Number rest = (a[k] - product.value) - product.error - quotient * unit.length.error;
    const Number correction = rest * unit.length.inverse, sum = quotient + correction;
    unit.value[k] = select(least < quotient, sum, select(quotient < -least, sum, quotient));
    unit.error[k] = correction - (unit.value[k] - quotient);
  }
  return unit;
}

}  // namespace
}  // namespace qtraj
