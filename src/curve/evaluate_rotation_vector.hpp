// The evaluators of rotation-vector polynomials (LOG_SPLINE, ROTATION_SPLINE, HERMITE, ROTATION_QUINTIC):
// q = base exp(p(x)).
#pragma once

#include "curve/evaluator.hpp"
#include "math/half_angle.hpp"

namespace qtraj {
namespace {

template <class Arithmetic, size_t Degree>
class RotationVectorEvaluator : public EvaluatorDefaults {
 public:
  template <class Value>
  using SegmentOf = RotationVectorSegment<Degree, Value>;

  template <class Real>
  static constexpr bool kOwnLoopWithRates = Degree == 3 && sizeof(Real) == sizeof(double);
  static constexpr size_t kSearched = Degree == 3 ? 128 : 64;

  explicit RotationVectorEvaluator(ExponentRange range) : doublings_(static_cast<int>(range)) {}

  template <class Number>
  struct Partial {
    Number p[3];
    CosSinc<Number> of_unit;  // of |p|; not set with rates
  };
  template <class Number, bool kWithRates>
  using PartialOf = Partial<Number>;

  template <class Mode, class Number>
  QTRAJ_INLINE void start(const SegmentOf<Number>& segment, Number x, Partial<Number>& partial) const {
    horner<Arithmetic>(segment.c, x, partial.p);
    if constexpr (Mode::kWithRates) return;
    const Number y = dot_product<Arithmetic>(partial.p, partial.p);
    cos_sinc<Arithmetic>(y, doublings_, partial.of_unit);
    if (doublings_ > 0) normalize_doubled<Arithmetic>(y, partial.of_unit);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>& segment, Number, const Partial<Number>& partial,
                           Number (&q)[4]) const {
    turn<Arithmetic>(segment.base, partial.of_unit, partial.p, q);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number x, const Partial<Number>& partial,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    const HalfAngleJet<Number> jet = half_angle_jet<Arithmetic>(segment.c, x);
    const Number y = dot_product<Arithmetic>(partial.p, partial.p);
    RateFactors<Number> f;
    rate_factors<Arithmetic>(y, doublings_, wants_alpha, f);
    CosSinc<Number> of_unit = {f.c, f.k};
    if (doublings_ > 0) normalize_doubled<Arithmetic>(y, of_unit);
    turn<Arithmetic>(segment.base, of_unit, partial.p, q);
    weigh_rates<Arithmetic>(jet, partial.p, rate_weights<Arithmetic>(f), wants_alpha, rates);
  }

 private:
  int doublings_;  // |p| <= 2^doublings pi/2
};

// For ExponentRange::any, any |p| below 2^500; Number of double.
template <class Arithmetic, size_t Degree>
struct LongRotationVectorEvaluator : EvaluatorDefaults {
  using EvaluatorDefaults::EvaluatorDefaults;

  template <class Value>
  using SegmentOf = RotationVectorSegment<Degree, Value>;

  template <class Real>
  static constexpr bool kOwnLoopWithRates = Degree == 3 && sizeof(Real) == sizeof(double);
  static constexpr int kWork = 3;
  static constexpr size_t kChunk = 192, kSearched = 64;
  static constexpr bool kSmallRates = false;

  template <class Number>
  struct Partial {
    Number p[3];
  };
  template <class Number, bool kWithRates>
  using PartialOf = Partial<Number>;

  template <class Mode, class Number>
  QTRAJ_INLINE void start(const SegmentOf<Number>& segment, Number x, Partial<Number>& partial) const {
    horner<Arithmetic>(segment.c, x, partial.p);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>& segment, Number, const Partial<Number>& partial,
                           Number (&q)[4]) const {
    turn<Arithmetic>(segment.base, cos_sinc_any<Arithmetic>(dot_product<Arithmetic>(partial.p, partial.p)), partial.p,
                     q);
    newton_normalize<Arithmetic>(q);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number x, const Partial<Number>& partial,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    finish<Mode>(segment, x, partial, q);
    exponential_rates_any<Arithmetic>(half_angle_jet<Arithmetic>(segment.c, x), wants_alpha, rates);
  }
};

}  // namespace
}  // namespace qtraj
