// The evaluator of arcs (SLERP): q = m cos x + e sin x, |x| <= pi/4.
#pragma once

#include "curve/evaluator.hpp"

namespace qtraj {
namespace {

// q = m c + e s.
template <class Arithmetic, class Number>
QTRAJ_INLINE void combine(const Number (&m)[4], Number c, const Number (&e)[4], Number s, Number (&q)[4]) {
  for (size_t k = 0; k < 4; ++k) q[k] = Arithmetic::multiply_add(e[k], s, m[k] * c);
}

template <class Arithmetic>
struct ArcEvaluator : EvaluatorDefaults {
  using EvaluatorDefaults::EvaluatorDefaults;

  template <class Value>
  using SegmentOf = ArcSegmentOf<Value>;

  static constexpr int kWork = 1;
  static constexpr bool kHasOffset = true;
  static double scale(const ArcSegment& segment) { return segment.rate; }
  static double offset(const ArcSegment& segment) { return segment.half_angle; }

  template <class Number>
  struct Partial {
    Number c, s;
  };
  template <class Number, bool kWithRates>
  using PartialOf = Partial<Number>;

  // |x| <= pi/4, because arcs between neighbouring keys are at most a quarter turn of S^3. Error 1.5 eps.
  template <class Mode, class Number>
  QTRAJ_INLINE void start(const ArcSegmentOf<Number>&, Number x, Partial<Number>& partial) const {
    const Number y = x * x;
    partial.c = evaluate<Arithmetic, CosArc>(y);
    partial.s = x * evaluate<Arithmetic, SincArc>(y);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish(const ArcSegmentOf<Number>& segment, Number, const Partial<Number>& partial,
                           Number (&q)[4]) const {
    combine<Arithmetic>(segment.m, partial.c, segment.e, partial.s, q);
  }

  // The body rate per unit of x is constant, 2 Im(m* e).
  template <class Mode, class Number>
  QTRAJ_INLINE void finish_rates(const ArcSegmentOf<Number>& segment, Number x, const Partial<Number>& partial, bool,
                                 Number (&q)[4], Rates<Number>& rates) const {
    using Real = Element<Number>;
    finish<Mode>(segment, x, partial, q);
    relative_vector_part<Arithmetic>(segment.m, segment.e, rates.omega);
    for (size_t k = 0; k < 3; ++k) {
      rates.omega[k] = Number(Real(2)) * rates.omega[k];
      rates.alpha[k] = Number(Real(0));
    }
  }
};

}  // namespace
}  // namespace qtraj
