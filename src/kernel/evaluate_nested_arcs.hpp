// Nested arcs, SQUAD: q = slerp(P(u), C(u); f), f = 2u(1 - u), P on the arc between the keys, C on that between the
// controls; the two are any angle theta < pi apart.
#pragma once

#include "arithmetic.hpp"
#include "evaluate_arc.hpp"
#include "half_angle.hpp"
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

// Sines and cosines of both arcs at s, and the rates of their angles in s.
template <class Real>
struct ArcPair {
  Real c, s, keys_rate;  // of the arc between the keys
  Real control_c, control_s, controls_rate;
};
template <class Arithmetic, class Real>
ArcPair<Real> arc_pair(const NestedArcsSegment& segment, Real s) {
  const auto sine_of = [](Real x) { return x * evaluate<Arithmetic, SincHalf>(x * x); };
  const Real keys_rate = static_cast<Real>(segment.keys.half_angle);
  const Real controls_rate = static_cast<Real>(segment.controls.half_angle);
  const Real x = s * keys_rate, control_x = s * controls_rate;
  return {evaluate<Arithmetic, CosHalf>(x * x),
          sine_of(x),
          keys_rate,
          evaluate<Arithmetic, CosHalf>(control_x * control_x),
          sine_of(control_x),
          controls_rate};
}

// A sum a0 c C + a1 c S + a2 s C + a3 s S over the products of the arcs' cosines and sines, and its derivatives in s.
template <class Real>
struct Jet {
  Real value, first, second;
};
template <class Arithmetic, class Real>
Jet<Real> product_sum(const ArcPair<Real>& arcs, Real a0, Real a1, Real a2, Real a3) {
  const auto sum = [&](Real b0, Real b1, Real b2, Real b3) {
    const auto add = [](Real a, Real b, Real c) { return Arithmetic::multiply_add(a, b, c); };
    return add(arcs.c, add(b1, arcs.control_s, b0 * arcs.control_c),
               arcs.s * add(b3, arcs.control_s, b2 * arcs.control_c));
  };
  const Real x = arcs.keys_rate, y = arcs.controls_rate, squares = x * x + y * y, twice = Real(2) * x * y;
  return {sum(a0, a1, a2, a3), sum(y * a1 + x * a2, x * a3 - y * a0, y * a3 - x * a0, -(y * a2 + x * a1)),
          sum(twice * a3 - squares * a0, -(twice * a2 + squares * a1), -(twice * a1 + squares * a2),
              twice * a0 - squares * a3)};
}

// H = theta/sin theta as a function of d = cos theta, and its first two derivatives: from the polynomial G(1 - d) where
// the closed forms, H' = (d H - 1)/(1 - d^2) and H'' = (H + 3 d H')/(1 - d^2), would cancel, from these elsewhere.
template <class Arithmetic, class Real>
Jet<Real> angle_over_sine(Real d) {
  const Real z = Real(1) - d;
  if (z <= Real(0.3)) {
    const auto& c = coefficients<Real>(AcosRatio{});
    constexpr size_t kTerms = sizeof c / sizeof c[0];
    Real value = 0, first = 0, half_second = 0;
    for (size_t term = kTerms; term-- > 0;) {
      half_second = Arithmetic::multiply_add(half_second, z, first);
      first = Arithmetic::multiply_add(first, z, value);
      value = Arithmetic::multiply_add(value, z, c[term]);
    }
    return {value, -first, Real(2) * half_second};
  }
  // half the angle, kept from a quarter turn of S^3, where H is infinite and no great circle is singled out
  constexpr Real kLimit = opposite_limit<Real>() * opposite_limit<Real>();
  const Real cosine_squared = Real(0.5) * (Real(1) + d) > kLimit ? Real(0.5) * (Real(1) + d) : kLimit;
  const Real cosine = square_root(cosine_squared);
  const Real h = evaluate<Arithmetic, AcosRatio>(Real(1) - cosine) / cosine;
  const Real inverse = Real(1) / (Real(4) * cosine_squared * (Real(1) - cosine_squared));
  const Real first = (d * h - Real(1)) * inverse;
  return {h, first, (h + Real(3) * d * first) * inverse};
}

// p = f H v, the half-angle vector from P to q, with its derivatives in s; f = (1 - s^2)/2.
template <class Arithmetic, class Real>
void exponent_jet(const NestedArcsSegment& segment, const ArcPair<Real>& arcs, Real s, HalfAngleJet<Real>& jet) {
  Real m[4], e[4], control_m[4], control_e[4];
  load(segment.keys.m, m);
  load(segment.keys.e, e);
  load(segment.controls.m, control_m);
  load(segment.controls.e, control_e);
  const Jet<Real> d = product_sum<Arithmetic>(arcs, dot<Arithmetic>(m, control_m), dot<Arithmetic>(m, control_e),
                                              dot<Arithmetic>(e, control_m), dot<Arithmetic>(e, control_e));
  const Jet<Real> of_d = angle_over_sine<Arithmetic>(d.value);
  const Jet<Real> h = {of_d.value, of_d.first * d.first, of_d.second * d.first * d.first + of_d.first * d.second};
  const Jet<Real> f = {Real(0.5) - Real(0.5) * s * s, -s, Real(-1)};
  const Jet<Real> fh = {f.value * h.value, f.first * h.value + f.value * h.first,
                        f.second * h.value + Real(2) * f.first * h.first + f.value * h.second};
  for (size_t k = 0; k < 3; ++k) {
    const Jet<Real> v = product_sum<Arithmetic>(
        arcs, static_cast<Real>(segment.relative[0][k]), static_cast<Real>(segment.relative[1][k]),
        static_cast<Real>(segment.relative[2][k]), static_cast<Real>(segment.relative[3][k]));
    jet.p[k] = fh.value * v.value;
    jet.dp[k] = fh.first * v.value + fh.value * v.first;
    jet.ddp[k] = fh.second * v.value + Real(2) * fh.first * v.first + fh.value * v.second;
  }
}

template <class Arithmetic>
struct NestedArcsEvaluator {
  using Segment = NestedArcsSegment;
  template <class Real>
  using Working = Real;

  template <class Real>
  static void sample(const Segment& segment, double elapsed, Real (&q)[4]) {
    const Real s = static_cast<Real>(position<Arithmetic>(elapsed, segment.scale));
    Real p[4], c[4];
    sample_arc<Arithmetic>(segment.keys, s, p);
    sample_arc<Arithmetic>(segment.controls, s, c);
    slerp_between<Arithmetic>(p, c, Arithmetic::multiply_add(Real(-0.5) * s, s, Real(0.5)), q);
  }

  static double scale(const Segment& segment) { return segment.scale; }

  // With the rotation between the arcs written out, q = P exp(p), p = f H v, v = Im(P* C), H = theta/sin theta, the
  // body rates are those of exp p and, turned by it, the constant one of P. v is a sum of four constant vectors times
  // products of the arcs' sines and cosines: differentiating the weights of slerp instead would cancel on short arcs.
  template <class Real>
  static void sample_rates(const Segment& segment, double elapsed, Rates<Real>& rates) {
    const Real s = static_cast<Real>(position<Arithmetic>(elapsed, segment.scale));
    const ArcPair<Real> arcs = arc_pair<Arithmetic>(segment, s);
    HalfAngleJet<Real> jet;
    exponent_jet<Arithmetic>(segment, arcs, s, jet);
    Rates<Real> inner;
    exponential_rates<Arithmetic, 0>(jet, inner);

    // the outer arc's rate seen from behind exp p: turned by its inverse
    Real m[4], e[4], carried[3], turning[3];
    load(segment.keys.m, m);
    load(segment.keys.e, e);
    relative_vector_part<Arithmetic>(m, e, carried);
    for (Real& component : carried) component *= Real(2) * arcs.keys_rate;
    const CosSinc<Real> f = cos_sinc<Arithmetic, 0>(dot<Arithmetic>(jet.p, jet.p));
    const Real inverse[4] = {f.c, -f.k * jet.p[0], -f.k * jet.p[1], -f.k * jet.p[2]};
    rotate_to_world<Arithmetic>(inverse, carried);
    cross<Arithmetic>(inner.omega, carried, turning);
    for (size_t k = 0; k < 3; ++k) {
      rates.omega[k] = carried[k] + inner.omega[k];
      rates.alpha[k] = inner.alpha[k] - turning[k];
    }
  }
};

}  // namespace
}  // namespace qtraj
