// Polynomials in R^4, normalised.
#pragma once

#include <type_traits>

#include "evaluator.hpp"

namespace qtraj {
namespace {

// Square of the norm below which the polynomial counts as 0: its direction is nobody's intent, and 2/N could overflow.
template <class Real>
constexpr Real zero_norm_squared() {
  return sizeof(Real) == sizeof(double) ? static_cast<Real>(0x1p-1000) : static_cast<Real>(0x1p-120);
}

// AlwaysDouble: float samples are worked out in double, as coefficients may be past the range of float.
template <class Arithmetic, size_t Degree, bool AlwaysDouble>
struct NormalizedEvaluator : EvaluatorDefaults {
  template <class Value>
  using SegmentOf = NormalizedSegment<Degree, Value>;
  template <class Real>
  using Working = std::conditional_t<AlwaysDouble, double, Real>;

  static constexpr bool kSmallRates = false;  // the polynomial may come close to 0

  template <class Number>
  struct Begun {
    Number p[4], norm_squared;
  };

  template <class Task, class Number>
  QTRAJ_INLINE void begin(const SegmentOf<Number>& segment, Number x, Begun<Number>& begun) const {
    vector_horner<Arithmetic>(segment.c, x, begun.p);
    begun.norm_squared = dot<Arithmetic>(begun.p, begun.p);
  }

  // The identity where the polynomial passes through 0.
  template <class Task, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>&, Number, const Begun<Number>& begun, Number (&q)[4]) const {
    using Real = Element<Number>;
    const Number zero = Number(Real(0)), one = Number(Real(1));
    const auto is_zero = begun.norm_squared < Number(zero_norm_squared<Real>());
    const Number inverse_norm = one / square_root(select(is_zero, one, begun.norm_squared));
    for (size_t k = 0; k < 4; ++k) q[k] = select(is_zero, k == 0 ? one : zero, begun.p[k] * inverse_norm);
  }

  // With N = |p|^2: omega_body = (2/N) Im(p* p'), alpha_body = (2/N) Im(p* p'') - omega_body N'/N; 0 where p is.
  template <class Task, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number x, const Begun<Number>& begun,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    using Real = Element<Number>;
    finish<Task>(segment, x, begun, q);
    const Number zero = Number(Real(0)), one = Number(Real(1)), two = Number(Real(2));
    const auto& p = begun.p;
    Number dp[4];
    first_derivative<Arithmetic>(segment.c, x, dp);
    relative_vector_part<Arithmetic>(p, dp, rates.omega);
    const auto is_zero = begun.norm_squared < Number(zero_norm_squared<Real>());
    const Number twice_inverse = select(is_zero, zero, two / select(is_zero, one, begun.norm_squared));
    for (Number& component : rates.omega) component = twice_inverse * component;
    if (!wants_alpha) return;
    Number ddp[4], bend[3];
    second_derivative<Arithmetic>(segment.c, x, ddp);
    relative_vector_part<Arithmetic>(p, ddp, bend);
    const Number norm_change = twice_inverse * dot<Arithmetic>(p, dp);  // N'/N
    for (size_t k = 0; k < 3; ++k)
      rates.alpha[k] = Arithmetic::multiply_add(-norm_change, rates.omega[k], twice_inverse * bend[k]);
  }
};

}  // namespace
}  // namespace qtraj
