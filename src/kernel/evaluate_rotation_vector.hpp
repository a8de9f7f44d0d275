// Rotation-vector polynomials: q = base exp(p(s)).
#pragma once

#include "arithmetic.hpp"
#include "qtraj/elementary.hpp"
#include "qtraj/segment.hpp"

namespace qtraj {
namespace {

// C = cos |p| and K = sin |p| / |p| as functions of y = |p|^2.
template <class Real>
struct CosSinc {
  Real c, k;
};

// For |p| <= 2^Doublings pi/2: the polynomials at a fraction of the angle, then cos 2x = 1 - 2 sin^2 x and
// sinc 2x = cos x sinc x. No square root, no division, no branch.
template <class Arithmetic, int Doublings, class Real>
CosSinc<Real> cos_sinc(Real y) {
  constexpr Real kFraction = Real(1) / Real(1 << (2 * Doublings));
  Real z = y * kFraction;
  CosSinc<Real> f = {evaluate<Arithmetic, CosHalf>(z), evaluate<Arithmetic, SincHalf>(z)};
  for (int step = 0; step < Doublings; ++step) {
    const Real k = f.c * f.k;
    f.c = Arithmetic::multiply_add(Real(-2) * z * f.k, f.k, Real(1));
    f.k = k;
    z *= Real(4);
  }
  return f;
}

// For any |p| below 2^500.
template <class Arithmetic>
CosSinc<double> cos_sinc_any(double y) {
  constexpr double kPolynomialLimit = 2.4674;  // (pi/2)^2
  if (y <= kPolynomialLimit) return cos_sinc<Arithmetic, 0>(y);
  const double angle = square_root(y);
  const SinCos at = sin_cos(angle);
  return {at.cos, at.sin / angle};
}

// base (c, k p), the Hamilton product.
template <class Arithmetic, class Real>
void rotate_base(const double (&base)[4], const CosSinc<Real>& f, const Real (&p)[3], Real (&q)[4]) {
  const Real w = static_cast<Real>(base[0]), x = static_cast<Real>(base[1]), y = static_cast<Real>(base[2]),
             z = static_cast<Real>(base[3]);
  const Real vx = f.k * p[0], vy = f.k * p[1], vz = f.k * p[2];
  const auto add = [](Real a, Real b, Real c) { return Arithmetic::multiply_add(a, b, c); };
  q[0] = add(-z, vz, add(-y, vy, add(-x, vx, w * f.c)));
  q[1] = add(-z, vy, add(y, vz, add(x, f.c, w * vx)));
  q[2] = add(-x, vz, add(z, vx, add(y, f.c, w * vy)));
  q[3] = add(-y, vx, add(x, vy, add(z, f.c, w * vz)));
}

template <class Arithmetic, size_t Degree, ExponentRange Range>
struct RotationVectorEvaluator {
  using Segment = RotationVectorSegment<Degree>;

  template <class Real>
  static void sample(const Segment& segment, double elapsed, Real (&q)[4]) {
    if constexpr (Range == ExponentRange::any) {
      double exact[4];
      sample_any(segment, elapsed, exact);
      for (int k = 0; k < 4; ++k) q[k] = static_cast<Real>(exact[k]);
    } else {
      Real p[3];
      vector_horner<Arithmetic>(segment.c, static_cast<Real>(position<Arithmetic>(elapsed, segment.scale)), p);
      rotate_base<Arithmetic>(segment.base, cos_sinc<Arithmetic, static_cast<int>(Range)>(dot<Arithmetic>(p, p)), p, q);
      // each doubling doubles the error of the norm
      if constexpr (Range != ExponentRange::quarter_turn) newton_normalize<Arithmetic>(q);
    }
  }

 private:
  // In double for float samples too: coefficients may be past the range of float.
  static void sample_any(const Segment& segment, double elapsed, double (&q)[4]) {
    double p[3];
    vector_horner<Arithmetic>(segment.c, position<Arithmetic>(elapsed, segment.scale), p);
    rotate_base<Arithmetic>(segment.base, cos_sinc_any<Arithmetic>(dot<Arithmetic>(p, p)), p, q);
  }
};

}  // namespace
}  // namespace qtraj
