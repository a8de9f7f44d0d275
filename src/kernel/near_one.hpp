// Lengths of quaternions that are unit to the rounding of float, as nearly all are: their inverses by series, without
// division or root. Others are for the callers, who select lane by lane: the row alone tells which it is.
#pragma once

#include "arithmetic.hpp"

namespace qtraj {
namespace {

// |q|^2 = 1 + excess. Where it is near 1 the terms left out of the series are below 2^-57.
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
