// Rotation-vector polynomials: q = base exp(p(x)).
#pragma once

#include "evaluator.hpp"
#include "half_angle.hpp"

namespace qtraj {
namespace {

template <class Arithmetic, size_t Degree>
class RotationVectorEvaluator : public EvaluatorDefaults {
 public:
  template <class Value>
  using SegmentOf = RotationVectorSegment<Degree, Value>;

  // |p| <= 2^doublings pi/2.
  explicit RotationVectorEvaluator(int doublings) : doublings_(doublings) {}

  template <class Number>
  struct Begun {
    Number p[3];
    CosSinc<Number> of_unit;  // of |p|; left alone where rates are asked for
  };

  template <class Task, class Number>
  QTRAJ_INLINE void begin(const SegmentOf<Number>& segment, Number x, Begun<Number>& begun) const {
    vector_horner<Arithmetic>(segment.c, x, begun.p);
    if constexpr (Task::kWithRates) return;
    const Number y = dot<Arithmetic>(begun.p, begun.p);
    cos_sinc<Arithmetic>(y, doublings_, begun.of_unit);
    if (doublings_ > 0) normalize_doubled<Arithmetic>(y, begun.of_unit);
  }

  template <class Task, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>& segment, Number, const Begun<Number>& begun, Number (&q)[4]) const {
    turn<Arithmetic>(segment.base, begun.of_unit, begun.p, q);
  }

  template <class Task, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number x, const Begun<Number>& begun,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    const HalfAngleJet<Number> jet = half_angle_jet<Arithmetic>(segment.c, x);
    const Number y = dot<Arithmetic>(begun.p, begun.p);
    RateFactors<Number> f;
    rate_factors<Arithmetic>(y, doublings_, wants_alpha, f);
    CosSinc<Number> of_unit = {f.c, f.k};
    if (doublings_ > 0) normalize_doubled<Arithmetic>(y, of_unit);
    turn<Arithmetic>(segment.base, of_unit, begun.p, q);
    weigh_rates<Arithmetic>(jet, begun.p, rate_weights<Arithmetic>(f), wants_alpha, rates);
  }

 private:
  int doublings_;
};

// Any |p| below 2^500, in double for float samples too: coefficients may be past the range of float.
template <class Arithmetic, size_t Degree>
struct LongRotationVectorEvaluator : EvaluatorDefaults {
  template <class Value>
  using SegmentOf = RotationVectorSegment<Degree, Value>;
  template <class Real>
  using Working = double;

  static constexpr bool kSmallRates = false;

  template <class Number>
  struct Begun {
    Number p[3];
  };

  template <class Task, class Number>
  QTRAJ_INLINE void begin(const SegmentOf<Number>& segment, Number x, Begun<Number>& begun) const {
    vector_horner<Arithmetic>(segment.c, x, begun.p);
  }

  template <class Task, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>& segment, Number, const Begun<Number>& begun, Number (&q)[4]) const {
    turn<Arithmetic>(segment.base, cos_sinc_any<Arithmetic>(dot<Arithmetic>(begun.p, begun.p)), begun.p, q);
    newton_normalize<Arithmetic>(q);
  }

  template <class Task, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number x, const Begun<Number>& begun,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    finish<Task>(segment, x, begun, q);
    exponential_rates_any<Arithmetic>(half_angle_jet<Arithmetic>(segment.c, x), wants_alpha, rates);
  }
};

}  // namespace
}  // namespace qtraj
