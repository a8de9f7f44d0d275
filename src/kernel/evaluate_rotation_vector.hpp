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
    // each doubling doubles the error of the norm
    if (doublings_ > 0) newton_normalize<Arithmetic>(q);
  }

  template <class Number>
  QTRAJ_INLINE void sample_rates(const SegmentOf<Number>& segment, Number x, bool wants_alpha,
                                 Rates<Number>& rates) const {
    exponential_rates<Arithmetic>(half_angle_jet<Arithmetic>(segment.c, x), doublings_, wants_alpha, rates);
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

  template <class Number>
  QTRAJ_INLINE void sample(const SegmentOf<Number>& segment, Number x, Number (&q)[4]) const {
    Number p[3];
    vector_horner<Arithmetic>(segment.c, x, p);
    turn<Arithmetic>(segment.base, cos_sinc_any<Arithmetic>(dot<Arithmetic>(p, p)), p, q);
    newton_normalize<Arithmetic>(q);
  }

  template <class Number>
  QTRAJ_INLINE void sample_rates(const SegmentOf<Number>& segment, Number x, bool wants_alpha,
                                 Rates<Number>& rates) const {
    exponential_rates_any<Arithmetic>(half_angle_jet<Arithmetic>(segment.c, x), wants_alpha, rates);
  }
};

}  // namespace
}  // namespace qtraj
