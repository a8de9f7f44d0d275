// Rates of nested arcs.
#pragma once

#include "curve/nested_arcs.hpp"
#include "math/half_angle.hpp"

namespace qtraj {
namespace {

// The sum a0 c C + a1 c S + a2 s C + a3 s S over products of the arcs' cosines and sines, and its first two derivatives
// in s.
template <class Number>
struct Jet {
  Number value, first, second;
};
template <class Arithmetic, class Number>
QTRAJ_INLINE Jet<Number> product_sum(const NestedArcsSegmentOf<Number>& segment, const ArcPair<Number>& arcs, Number a0,
                                     Number a1, Number a2, Number a3) {
  const auto sum = [&](Number b0, Number b1, Number b2, Number b3) {
    const auto add = [](Number a, Number b, Number c) { return Arithmetic::multiply_add(a, b, c); };
    return add(arcs.keys.c, add(b1, arcs.controls.s, b0 * arcs.controls.c),
               arcs.keys.s * add(b3, arcs.controls.s, b2 * arcs.controls.c));
  };
  const Number x = segment.keys.half_angle, y = segment.controls.half_angle;
  const Number squares = x * x + y * y, twice = Number(Element<Number>(2)) * x * y;
  return {sum(a0, a1, a2, a3), sum(y * a1 + x * a2, x * a3 - y * a0, y * a3 - x * a0, -(y * a2 + x * a1)),
          sum(twice * a3 - squares * a0, -(twice * a2 + squares * a1), -(twice * a1 + squares * a2),
              twice * a0 - squares * a3)};
}

// H = theta/sin theta as a function of d = cos theta, and its first two derivatives. They come from the closed forms
// H' = (d H - 1)/(1 - d^2) and H'' = (H + 3 d H')/(1 - d^2), and near d = 1, where these would cancel, from the
// polynomial G(1 - d).
template <class Arithmetic, class Polynomial, class Number>
QTRAJ_INLINE Jet<Number> angle_over_sine_near_one(Number d) {
  using Real = Element<Number>;
  constexpr const auto& kCoefficients = coefficients<Number>(Polynomial{});
  constexpr size_t kTerms = sizeof kCoefficients / sizeof kCoefficients[0];
  const Number z = Number(Real(1)) - d;
  Number value = Number(Real(0)), first = value, half_second = value;
  for (size_t term = kTerms; term-- > 0;) {
    half_second = Arithmetic::multiply_add(half_second, z, first);
    first = Arithmetic::multiply_add(first, z, value);
    value = Arithmetic::multiply_add(value, z, Number(kCoefficients[term]));
  }
  return {value, -first, Number(Real(2)) * half_second};
}
template <class Arithmetic, class Number>
QTRAJ_INLINE Jet<Number> angle_over_sine_by_quotients(Number d) {
  using Real = Element<Number>;
  const Number one = Number(Real(1));
  // cos^2(theta/2), kept away from 0: at theta = pi H is infinite and no great circle is singled out
  const Number limit = Number(opposite_limit<Real>() * opposite_limit<Real>());
  const Number half_sum = Number(Real(0.5)) * (one + d);
  const Number cosine_squared = select(limit < half_sum, half_sum, limit);
  const Number cosine = square_root(cosine_squared);
  const Number h = evaluate<Arithmetic, AcosRatio>(one - cosine) / cosine;
  const Number inverse = one / (Number(Real(4)) * cosine_squared * (one - cosine_squared));
  const Number first = (d * h - one) * inverse;
  return {h, first, (h + Number(Real(3)) * d * first) * inverse};
}
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE Jet<Number> angle_over_sine(Number d) {
  using Real = Element<Number>;
  if constexpr (kNear) return angle_over_sine_near_one<Arithmetic, AcosRatioNear>(d);
  const auto is_near = Number(Real(0.7)) <= d;
  const Jet<Number> near = angle_over_sine_near_one<Arithmetic, AcosRatio>(d);
  const Jet<Number> far = angle_over_sine_by_quotients<Arithmetic>(select(is_near, Number(Real(0)), d));
  return {select(is_near, near.value, far.value), select(is_near, near.first, far.first),
          select(is_near, near.second, far.second)};
}

// p = f H v, the half-angle vector from P to q, with its derivatives in s; f = (1 - s^2)/2. The second one is set where
// alpha is wanted.
template <class Arithmetic, bool kNear, bool kWantsAlpha, class Number>
QTRAJ_INLINE void exponent_jet(const NestedArcsSegmentOf<Number>& segment, const ArcPair<Number>& arcs, const Number& s,
                               HalfAngleJet<Number>& jet) {
  using Real = Element<Number>;
  const Number half = Number(Real(0.5)), two = Number(Real(2));
  const auto& m = segment.keys.m;
  const auto& e = segment.keys.e;
  const auto& control_m = segment.controls.m;
  const auto& control_e = segment.controls.e;
  const Jet<Number> d = product_sum<Arithmetic>(
      segment, arcs, dot_product<Arithmetic>(m, control_m), dot_product<Arithmetic>(m, control_e),
      dot_product<Arithmetic>(e, control_m), dot_product<Arithmetic>(e, control_e));
  const Jet<Number> of_d = angle_over_sine<Arithmetic, kNear>(d.value);
  const Jet<Number> h = {of_d.value, of_d.first * d.first, of_d.second * d.first * d.first + of_d.first * d.second};
  const Jet<Number> f = {half - half * s * s, -s, Number(Real(-1))};
  const Jet<Number> fh = {f.value * h.value, f.first * h.value + f.value * h.first,
                          f.second * h.value + two * f.first * h.first + f.value * h.second};
  for (size_t k = 0; k < 3; ++k) {
    const Jet<Number> v = product_sum<Arithmetic>(segment, arcs, segment.relative[0][k], segment.relative[1][k],
                                                  segment.relative[2][k], segment.relative[3][k]);
    jet.p[k] = fh.value * v.value;
    jet.dp[k] = fh.first * v.value + fh.value * v.first;
    if constexpr (kWantsAlpha) jet.ddp[k] = fh.second * v.value + two * fh.first * v.first + fh.value * v.second;
  }
}

// q = P exp(p), p = f H v, v = Im(P* C), H = theta/sin theta. The body rate of q is that of exp p plus the constant
// rate of P, seen in the frame after exp p. v is a sum of four constant vectors times products of the arcs' sines and
// cosines; differentiating the weights of slerp instead would cancel on short arcs.
template <class Arithmetic, bool kNear, bool kWantsAlpha, class Number>
QTRAJ_INLINE void nested_arcs_rates(const NestedArcsSegmentOf<Number>& segment, const ArcPair<Number>& arcs,
                                    const Number& s, Rates<Number>& rates) {
  HalfAngleJet<Number> jet;
  exponent_jet<Arithmetic, kNear, kWantsAlpha>(segment, arcs, s, jet);
  exponential_rates<Arithmetic>(jet, kWantsAlpha, rates);

  // the outer arc's rate in the frame after exp p: rotated by exp(-p)
  Number carried[3];
  relative_vector_part<Arithmetic>(segment.keys.m, segment.keys.e, carried);
  for (Number& component : carried) component = component * (Number(Element<Number>(2)) * segment.keys.half_angle);
  CosSinc<Number> f;
  cos_sinc<Arithmetic>(dot_product<Arithmetic>(jet.p, jet.p), 0, f);
  const Number inverse[4] = {f.c, -f.k * jet.p[0], -f.k * jet.p[1], -f.k * jet.p[2]};
  rotate_to_world<Arithmetic>(inverse, carried);
  if constexpr (kWantsAlpha) {
    Number turning[3];
    cross_product<Arithmetic>(rates.omega, carried, turning);
    for (size_t k = 0; k < 3; ++k) rates.alpha[k] = rates.alpha[k] - turning[k];
  }
  for (size_t k = 0; k < 3; ++k) rates.omega[k] = carried[k] + rates.omega[k];
}

// The orientation at cosines and sines of both arcs.
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void nested_arcs_orientation(const NestedArcsSegmentOf<Number>& segment, const ArcPair<Number>& arcs,
                                          const Number& s, Number (&q)[4]) {
  PointPair<Number> points;
  points_at<Arithmetic, kNear>(segment, arcs, points);
  between_points<Arithmetic, kNear>(points, s, q);
}

// Orientation and rates.
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void nested_arcs_motion(const NestedArcsSegmentOf<Number>& segment, const ArcPair<Number>& arcs,
                                     const Number& s, bool wants_alpha, Number (&q)[4], Rates<Number>& rates) {
  nested_arcs_orientation<Arithmetic, kNear>(segment, arcs, s, q);
  if (wants_alpha)
    nested_arcs_rates<Arithmetic, kNear, true>(segment, arcs, s, rates);
  else
    nested_arcs_rates<Arithmetic, kNear, false>(segment, arcs, s, rates);
}

}  // namespace
}  // namespace qtraj
