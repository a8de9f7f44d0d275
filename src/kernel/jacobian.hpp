// Jr(r) and the factors of beta from those of the half angle. Plain arithmetic: the same bits in the core and in
// kernels of either arithmetic. The formulas are in qtraj/so3.hpp.
#pragma once

#include "half_angle.hpp"

namespace qtraj {
namespace {

// C, K, D and E of the half angle sqrt(y), y <= kPolynomialLimit, in the core's order of operations.
template <class Number>
QTRAJ_INLINE RateFactors<Number> polynomial_factors(Number y) {
  return {tail(CosHalf::kDouble, 0, y), tail(SincHalf::kDouble, 0, y), tail(DHalf::kDouble, 0, y),
          tail(EHalf::kDouble, 0, y)};
}

// The factors of beta.
template <class Number>
struct TurningFactorsOf {
  Number along_once, along_twice, sideways;
};
template <class Number>
QTRAJ_INLINE TurningFactorsOf<Number> turning_factors_of(const RateFactors<Number>& f) {
  return {Number(0.25) * f.k * f.d, Number(0.0625) * (f.c * f.e - f.k * f.d), Number(0.25) * (f.k * f.k - f.c * f.d)};
}

// 1 - (K^2/2) r x + sideways r x r x, with r x r x = r r^T - |r|^2; column after column.
template <class Number>
QTRAJ_INLINE void jacobian_of(const RateFactors<Number>& f, Number sideways, const Number (&r)[3],
                              Number (&jacobian)[9]) {
  const Number once = Number(0.5) * f.k * f.k, square = sideways * dot<Plain>(r, r);
  for (size_t column = 0; column < 3; ++column) {
    const size_t next = (column + 1) % 3, last = (column + 2) % 3;
    jacobian[3 * column + column] = (Number(1.0) + r[column] * (sideways * r[column])) - square;
    jacobian[3 * column + next] = r[column] * (sideways * r[next]) - once * r[last];
    jacobian[3 * column + last] = r[column] * (sideways * r[last]) + once * r[next];
  }
}

}  // namespace
}  // namespace qtraj
