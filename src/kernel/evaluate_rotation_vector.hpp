// Rotation-vector polynomials: q = base exp(p(s)).
#pragma once

#include <type_traits>

#include "half_angle.hpp"

namespace qtraj {
namespace {

template <class Arithmetic, size_t Degree, ExponentRange Range>
struct RotationVectorEvaluator {
  using Segment = RotationVectorSegment<Degree>;
  // Past the last range in double for float samples too: coefficients may be past the range of float.
  template <class Real>
  using Working = std::conditional_t<Range == ExponentRange::any, double, Real>;

  template <class Real>
  static void sample(const Segment& segment, double elapsed, Real (&q)[4]) {
    using Work = Working<Real>;
    Work base[4], p[3], turned[4];
    load(segment.base, base);
    vector_horner<Arithmetic>(segment.c, static_cast<Work>(position<Arithmetic>(elapsed, segment.scale)), p);
    const Work y = dot<Arithmetic>(p, p);
    if constexpr (Range == ExponentRange::any)
      turn<Arithmetic>(base, cos_sinc_any<Arithmetic>(y), p, turned);
    else
      turn<Arithmetic>(base, cos_sinc<Arithmetic, static_cast<int>(Range)>(y), p, turned);
    // each doubling doubles the error of the norm
    if constexpr (Range != ExponentRange::quarter_turn) newton_normalize<Arithmetic>(turned);
    for (size_t k = 0; k < 4; ++k) q[k] = static_cast<Real>(turned[k]);
  }

  static double scale(const Segment& segment) { return segment.scale; }

  template <class Work>
  static void sample_rates(const Segment& segment, double elapsed, Rates<Work>& rates) {
    HalfAngleJet<Work> jet;
    polynomial_jet<Arithmetic>(segment.c, static_cast<Work>(position<Arithmetic>(elapsed, segment.scale)), jet.p,
                               jet.dp, jet.ddp);
    if constexpr (Range == ExponentRange::any)
      exponential_rates_any<Arithmetic>(jet, rates);
    else
      exponential_rates<Arithmetic, static_cast<int>(Range)>(jet, rates);
  }
};

}  // namespace
}  // namespace qtraj
