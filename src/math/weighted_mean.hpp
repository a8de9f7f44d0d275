// The mean of two numbers by integer weights, formed in double-double and rounded once. Plain arithmetic: the same bits
// in the core and in kernels of either arithmetic.
#pragma once

#include "math/arithmetic.hpp"
#include "math/error_free.hpp"

namespace qtraj {
namespace {

// (a weight_a + b weight_b) / divisor, |a| and |b| below 4, weights integers up to the divisor.
template <class Number>
QTRAJ_INLINE Number weighted_mean(Number a, Number weight_a, Number b, Number weight_b, Number divisor) {
  const DoubleDoubleOf<Number> part_a = two_product(a, weight_a), part_b = two_product(b, weight_b);
  const DoubleDoubleOf<Number> sum = two_sum(part_a.value, part_b.value);
  const Number sum_error = sum.error + (part_a.error + part_b.error);
  const Number quotient = (sum.value + sum_error) / divisor;
  const DoubleDoubleOf<Number> product = two_product(quotient, divisor);
  return quotient + (((sum.value - product.value) - product.error) + sum_error) / divisor;
}

}  // namespace
}  // namespace qtraj
