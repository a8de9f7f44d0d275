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
  QTRAJ_INLINE void sample(const SegmentOf<Number>& segment, Number x, Number (&q)[4]) const {
    Number p[3];
    vector_horner<Arithmetic>(segment.c, x, p);
    turn<Arithmetic>(segment.base, cos_sinc<Arithmetic>(dot<Arithmetic>(p, p), doublings_), p, q);
  }

  template <class Number>
  QTRAJ_INLINE void sample_rates(const SegmentOf<Number>& segment, Number x, bool wants_alpha, Number (&q)[4],
                                 Rates<Number>& rates) const {
    const HalfAngleJet<Number> jet = half_angle_jet<Arithmetic>(segment.c, x);
    const Number y = dot<Arithmetic>(jet.p, jet.p);
    const RateFactors<Number> f = rate_factors<Arithmetic>(y, doublings_, wants_alpha);
    CosSinc<Number> of_unit = {f.c, f.k};
    if (doublings_ > 0) normalize_doubled<Arithmetic>(y, of_unit.c, of_unit.k);
    turn<Arithmetic>(segment.base, of_unit, jet.p, q);
    weigh_rates<Arithmetic>(jet, jet.p, rate_weights<Arithmetic>(f), wants_alpha, rates);
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
  QTRAJ_INLINE void sample(const SegmentOf<Number>& segment, Number x, Number (&q)[4]) const {
    Number p[3];
    vector_horner<Arithmetic>(segment.c, x, p);
    turn<Arithmetic>(segment.base, cos_sinc_any<Arithmetic>(dot<Arithmetic>(p, p)), p, q);
    newton_normalize<Arithmetic>(q);
  }

  template <class Number>
  QTRAJ_INLINE void sample_rates(const SegmentOf<Number>& segment, Number x, bool wants_alpha, Number (&q)[4],
                                 Rates<Number>& rates) const {
    sample(segment, x, q);
    exponential_rates_any<Arithmetic>(half_angle_jet<Arithmetic>(segment.c, x), wants_alpha, rates);
  }
};

}  // namespace
}  // namespace qtraj
