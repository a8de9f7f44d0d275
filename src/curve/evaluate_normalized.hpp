// The evaluator of normalised polynomials in R^4 (NLERP, QUATERNION_QUINTIC, QUATERNION_HERMITE): q = p(x)/|p(x)|.
#pragma once

#include "curve/evaluator.hpp"

namespace qtraj {
namespace {

// The squared norm N below which the polynomial counts as 0: its direction is meaningless there, and 2/N could
// overflow.
template <class Real>
constexpr Real zero_norm_squared() {
  return sizeof(Real) == sizeof(double) ? static_cast<Real>(0x1p-1000) : static_cast<Real>(0x1p-120);
}

template <class Arithmetic, size_t Degree>
struct NormalizedEvaluator : EvaluatorDefaults {
  using EvaluatorDefaults::EvaluatorDefaults;

  template <class Value>
  using SegmentOf = NormalizedSegment<Degree, Value>;
  static constexpr int kWork = Degree == 1 ? 1 : 2;
  static constexpr size_t kSearched = Degree == 1 ? 128 : 64;
  static constexpr bool kSmallRates = false;  // the polynomial may come close to 0

  template <class Number>
  struct Partial {
    Number p[4], norm_squared;
  };
  template <class Number, bool kWithRates>
  using PartialOf = Partial<Number>;

  template <class Mode, class Number>
  QTRAJ_INLINE void start(const SegmentOf<Number>& segment, Number x, Partial<Number>& partial) const {
    horner<Arithmetic>(segment.c, x, partial.p);
    partial.norm_squared = dot_product<Arithmetic>(partial.p, partial.p);
  }

  // Singular: the identity where the polynomial passes through 0.
  template <class Mode, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>&, Number, const Partial<Number>& partial, Number (&q)[4]) const {
    using Real = Element<Number>;
    const Number zero = Number(Real(0)), one = Number(Real(1));
    const auto is_zero = partial.norm_squared < Number(zero_norm_squared<Real>());
    const Number inverse_norm = one / square_root(select(is_zero, one, partial.norm_squared));
    for (size_t k = 0; k < 4; ++k) q[k] = select(is_zero, k == 0 ? one : zero, partial.p[k] * inverse_norm);
  }

  // With N = |p|^2: omega_body = (2/N) Im(p* p'), alpha_body = (2/N) Im(p* p'') - omega_body N'/N; both 0 where p is 0.
  template <class Mode, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number x, const Partial<Number>& partial,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    using Real = Element<Number>;
    finish<Mode>(segment, x, partial, q);
    const Number zero = Number(Real(0)), one = Number(Real(1)), two = Number(Real(2));
    const auto& p = partial.p;
    Number dp[4];
    first_derivative<Arithmetic>(segment.c, x, dp);
    relative_vector_part<Arithmetic>(p, dp, rates.omega);
    const auto is_zero = partial.norm_squared < Number(zero_norm_squared<Real>());
    const Number twice_inverse = select(is_zero, zero, two / select(is_zero, one, partial.norm_squared));
    for (Number& component : rates.omega) component = twice_inverse * component;
    if (!wants_alpha) return;
    const Number norm_change = twice_inverse * dot_product<Arithmetic>(p, dp);  // N'/N
    // p'' is +0: where alpha vanishes, the signs of its zeros are not those of the keys
    if constexpr (Degree == 1) {
      for (size_t k = 0; k < 3; ++k) rates.alpha[k] = Arithmetic::multiply_add(-norm_change, rates.omega[k], zero);
      return;
    }
    Number ddp[4], relative[3];
    second_derivative<Arithmetic>(segment.c, x, ddp);
    relative_vector_part<Arithmetic>(p, ddp, relative);
    for (size_t k = 0; k < 3; ++k)
      rates.alpha[k] = Arithmetic::multiply_add(-norm_change, rates.omega[k], twice_inverse * relative[k]);
  }
};

}  // namespace
}  // namespace qtraj
