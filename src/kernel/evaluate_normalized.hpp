// Polynomials in R^4, normalised.
#pragma once

#include "arithmetic.hpp"
#include "qtraj/segment.hpp"

namespace qtraj {
namespace {

template <class Arithmetic, size_t Degree>
struct NormalizedEvaluator {
  using Segment = NormalizedSegment<Degree>;

  template <class Real>
  static void sample(const Segment& segment, double elapsed, Real (&q)[4]) {
    Real p[4];
    vector_horner<Arithmetic>(segment.c, static_cast<Real>(position<Arithmetic>(elapsed, segment.scale)), p);
    const Real inverse_norm = Real(1) / square_root(dot<Arithmetic>(p, p));
    for (int k = 0; k < 4; ++k) q[k] = p[k] * inverse_norm;
  }
};

}  // namespace
}  // namespace qtraj
