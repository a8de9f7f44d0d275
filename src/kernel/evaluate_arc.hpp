// Arcs: q = m cos x + e sin x, |x| <= pi/4.
#pragma once

#include "motion.hpp"
#include "qtraj/segment.hpp"

namespace qtraj {
namespace {

// m c + e s.
template <class Arithmetic, class Real>
void combine(const double (&m)[4], Real c, const double (&e)[4], Real s, Real (&q)[4]) {
  for (int k = 0; k < 4; ++k) q[k] = Arithmetic::multiply_add(static_cast<Real>(e[k]), s, static_cast<Real>(m[k]) * c);
}

template <class Arithmetic>
struct ArcEvaluator {
  using Segment = ArcSegment;

  template <class Real>
  using Working = Real;

  // Arcs between neighbouring keys are at most a quarter turn of S^3. Error 1.5 eps of Real.
  template <class Real>
  static void sample(const Segment& segment, double elapsed, Real (&q)[4]) {
    const Real x = static_cast<Real>(Arithmetic::multiply_add(elapsed, segment.rate, -segment.half_angle));
    const Real y = x * x;
    const Real c = evaluate<Arithmetic, CosArc>(y), s = x * evaluate<Arithmetic, SincArc>(y);
    combine<Arithmetic>(segment.m, c, segment.e, s, q);
  }

  // Per unit of x the body turns by 2 about m* e.
  static double scale(const Segment& segment) { return segment.rate; }

  template <class Real>
  static void sample_rates(const Segment& segment, double, Rates<Real>& rates) {
    Real m[4], e[4];
    load(segment.m, m);
    load(segment.e, e);
    relative_vector_part<Arithmetic>(m, e, rates.omega);
    for (size_t k = 0; k < 3; ++k) {
      rates.omega[k] *= Real(2);
      rates.alpha[k] = 0;
    }
  }
};

}  // namespace
}  // namespace qtraj
