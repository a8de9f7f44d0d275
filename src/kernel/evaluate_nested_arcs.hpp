// Nested arcs, SQUAD: q = slerp(P(u), C(u); f), f = 2u(1 - u), P on the arc between the keys, C on that between the
// controls; the two are any angle theta < pi apart.
#pragma once

#include "arithmetic.hpp"
#include "evaluate_arc.hpp"
#include "qtraj/segment.hpp"

namespace qtraj {
namespace {

// Half of |P + C| below which they count as opposite. Above it the sum has digits enough for one Newton step to bring
// the result to unit length; below, its direction is noise.
template <class Real>
constexpr Real opposite_limit();
template <>
constexpr double opposite_limit<double>() {
  return 0x1p-26;
}
template <>
constexpr float opposite_limit<float>() {
  return 0x1p-12f;
}

template <class Arithmetic, class Real>
void sample_arc(const NestedArcsSegment::Arc& arc, Real s, Real (&q)[4]) {
  const Real x = s * static_cast<Real>(arc.half_angle);
  const Real y = x * x;
  combine<Arithmetic>(arc.m, evaluate<Arithmetic, CosHalf>(y), arc.e, x * evaluate<Arithmetic, SincHalf>(y), q);
}

// slerp(p, c; f) for f in [0, 1/2] without an arc function of a rounded dot product. With z = cos(theta/2) = |p + c|/2
// and g = G(1 - z) = (theta/2)/sin(theta/2):
//   weight of c = sin(f theta)/sin theta = f g sinc(f theta)/z,  weight of p = cos(f theta) - cos theta (weight of c).
// Opposite p and c: the great circle through p (0, 1, 0, 0), a turn about the body x axis.
template <class Arithmetic, class Real>
void slerp_between(const Real (&p)[4], const Real (&c)[4], Real f, Real (&q)[4]) {
  Real sum[4];
  for (int k = 0; k < 4; ++k) sum[k] = p[k] + c[k];
  const Real z_squared = Real(0.25) * dot<Arithmetic>(sum, sum);
  const bool opposite = z_squared < opposite_limit<Real>() * opposite_limit<Real>();
  const Real aside[4] = {-p[1], p[0], p[3], -p[2]};
  const Real z = opposite ? opposite_limit<Real>() : square_root(z_squared);

  const Real g = evaluate<Arithmetic, AcosRatio>(z < Real(1) ? Real(1) - z : Real(0));
  const Real sine_squared = z_squared < Real(1) ? Real(1) - z_squared : Real(0);  // of theta/2
  const Real y = f * f * (Real(4) * g * g * sine_squared);                        // (f theta)^2
  const Real cosine = evaluate<Arithmetic, CosHalf>(y), sinc = evaluate<Arithmetic, SincHalf>(y);
  const Real weight_c = opposite ? f * Real(2) * g * sinc : f * g * sinc / z;
  const Real weight_p =
      opposite ? cosine
               : Arithmetic::multiply_add(Arithmetic::multiply_add(Real(-2), z_squared, Real(1)), weight_c, cosine);
  for (int k = 0; k < 4; ++k) q[k] = Arithmetic::multiply_add(weight_c, opposite ? aside[k] : c[k], weight_p * p[k]);
  newton_normalize<Arithmetic>(q);
}

template <class Arithmetic>
struct NestedArcsEvaluator {
  using Segment = NestedArcsSegment;

  template <class Real>
  static void sample(const Segment& segment, double elapsed, Real (&q)[4]) {
    const Real s = static_cast<Real>(position<Arithmetic>(elapsed, segment.scale));
    Real p[4], c[4];
    sample_arc<Arithmetic>(segment.keys, s, p);
    sample_arc<Arithmetic>(segment.controls, s, c);
    slerp_between<Arithmetic>(p, c, Arithmetic::multiply_add(Real(-0.5) * s, s, Real(0.5)), q);
  }
};

}  // namespace
}  // namespace qtraj
