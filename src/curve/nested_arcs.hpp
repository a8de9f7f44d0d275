// Orientations on nested arcs (SQUAD): q = slerp(P(u), C(u); f), f = 2u(1 - u), P on the arc between the keys, C on
// that between the controls; the two are any angle theta < pi apart. nested_arcs_rates.hpp has the rates, and
// evaluate_nested_arcs.hpp makes an evaluator of both.
#pragma once

#include "curve/evaluate_arc.hpp"

namespace qtraj {
namespace {

// P and C count as opposite where |P + C|/2 is below this. Above it the sum has digits enough for one Newton step to
// bring the result to unit length; below it its direction is noise.
template <class Real>
constexpr Real opposite_limit() {
  return sizeof(Real) == sizeof(double) ? static_cast<Real>(0x1p-26) : static_cast<Real>(0x1p-12);
}

// Cosine and sine on the arc between the keys, |x| <= pi/4, and on the one between the controls, |x| <= pi/2.
template <class Number>
struct CosSin {
  Number c, s;
};
template <class Arithmetic, class Number>
QTRAJ_INLINE void on_keys_arc(Number x, CosSin<Number>& at) {
  const Number y = x * x;
  at.c = evaluate<Arithmetic, CosArc>(y);
  at.s = x * evaluate<Arithmetic, SincArc>(y);
}
template <class Arithmetic, class Number>
QTRAJ_INLINE void on_controls_arc(Number x, CosSin<Number>& at) {
  const Number y = x * x;
  at.c = evaluate<Arithmetic, CosHalf>(y);
  at.s = x * evaluate<Arithmetic, SincHalf>(y);
}

// slerp(p, c; f) for f in [0, 1/2] of p and c at most pi/3 apart, theta, by d = cos theta and H = theta/sin theta:
//   weight of c = sin(f theta)/sin theta = f H sinc(f theta),  weight of p = cos(f theta) - d (weight of c).
template <class Arithmetic, class Number>
QTRAJ_INLINE void slerp_points_near(const Number (&p)[4], const Number (&c)[4], Number d, Number f, Number (&q)[4]) {
  using Real = Element<Number>;
  const Number z = Number(Real(1)) - d;
  const Number h = evaluate<Arithmetic, AcosRatioNear>(z);
  const Number y = (f * f) * ((h * h) * (z * (Number(Real(2)) - z)));  // (f theta)^2
  const Number weight_c = (f * h) * evaluate<Arithmetic, SincArc>(y);
  const Number weight_p = Arithmetic::multiply_add(-d, weight_c, evaluate<Arithmetic, CosArc>(y));
  combine<Arithmetic>(p, weight_p, c, weight_c, q);
  newton_normalize<Arithmetic>(q);
}

// |(p + c)/2|^2
template <class Arithmetic, class Number>
QTRAJ_INLINE Number half_sum_squared(const Number (&p)[4], const Number (&c)[4]) {
  using Real = Element<Number>;
  const Number sum[4] = {p[0] + c[0], p[1] + c[1], p[2] + c[2], p[3] + c[3]};
  return Number(Real(0.25)) * dot_product<Arithmetic>(sum, sum);
}

// slerp(p, c; f) for f in [0, 1/2] without an arc function of a rounded dot product. With z = cos(theta/2) = |p + c|/2
// and g = G(1 - z) = (theta/2)/sin(theta/2):
//   weight of c = sin(f theta)/sin theta = f g sinc(f theta)/z,  weight of p = cos(f theta) - cos theta (weight of c).
// Singular: for opposite p and c the great circle through p (0, 1, 0, 0) is taken, a turn about the body x axis.
template <class Arithmetic, class Number>
QTRAJ_INLINE void slerp_points(const Number (&p)[4], const Number (&c)[4], Number z_squared, Number f, Number (&q)[4]) {
  using Real = Element<Number>;
  const Number zero = Number(Real(0)), one = Number(Real(1)), limit = Number(opposite_limit<Real>());
  const auto opposite = z_squared < limit * limit;
  const Number aside[4] = {-p[1], p[0], p[3], -p[2]};
  const Number z = square_root(select(opposite, limit * limit, z_squared));

  const Number g = evaluate<Arithmetic, AcosRatio>(select(z < one, one - z, zero));
  const Number sine_squared = select(z_squared < one, one - z_squared, zero);  // of theta/2
  const Number y = f * f * (Number(Real(4)) * g * g * sine_squared);           // (f theta)^2
  const Number cosine = evaluate<Arithmetic, CosHalf>(y), sinc = evaluate<Arithmetic, SincHalf>(y);
  const Number weight_c = select(opposite, f * Number(Real(2)) * g * sinc, f * g * sinc / z);
  const Number minus_cosine = Arithmetic::multiply_add(Number(Real(-2)), z_squared, one);  // of theta
  const Number weight_p = select(opposite, cosine, Arithmetic::multiply_add(minus_cosine, weight_c, cosine));
  for (size_t k = 0; k < 4; ++k)
    q[k] = Arithmetic::multiply_add(weight_c, select(opposite, aside[k], c[k]), weight_p * p[k]);
  newton_normalize<Arithmetic>(q);
}

// Cosines and sines of both arcs at s. Fields are written one by one: GCC copies a struct of vectors in pieces through
// the stack, and store forwarding fails for the vector loads that join the pieces again.
template <class Number>
struct ArcPair {
  CosSin<Number> keys, controls;
};
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void arc_pair(const NestedArcsSegmentOf<Number>& segment, Number s, ArcPair<Number>& arcs) {
  on_keys_arc<Arithmetic>(s * segment.keys.half_angle, arcs.keys);
  if constexpr (kNear)
    on_keys_arc<Arithmetic>(s * segment.controls.half_angle, arcs.controls);
  else
    on_controls_arc<Arithmetic>(s * segment.controls.half_angle, arcs.controls);
}

// Points on both arcs, and how close they are: d of slerp_points_near, or z_squared of slerp_points.
template <class Number>
struct PointPair {
  Number p[4], c[4], closeness;
};
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void points_at(const NestedArcsSegmentOf<Number>& segment, const ArcPair<Number>& arcs,
                            PointPair<Number>& points) {
  combine<Arithmetic>(segment.keys.m, arcs.keys.c, segment.keys.e, arcs.keys.s, points.p);
  combine<Arithmetic>(segment.controls.m, arcs.controls.c, segment.controls.e, arcs.controls.s, points.c);
  if constexpr (kNear) {
    points.closeness = dot_product<Arithmetic>(points.p, points.c);
  } else {
    points.closeness = half_sum_squared<Arithmetic>(points.p, points.c);
  }
}
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void points_on_arcs(const NestedArcsSegmentOf<Number>& segment, Number s, PointPair<Number>& points) {
  ArcPair<Number> arcs;
  arc_pair<Arithmetic, kNear>(segment, s, arcs);
  points_at<Arithmetic, kNear>(segment, arcs, points);
}
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void between_points(const PointPair<Number>& points, Number s, Number (&q)[4]) {
  using Real = Element<Number>;
  const Number f = Arithmetic::multiply_add(Number(Real(-0.5)) * s, s, Number(Real(0.5)));
  if constexpr (kNear)
    slerp_points_near<Arithmetic>(points.p, points.c, points.closeness, f, q);
  else
    slerp_points<Arithmetic>(points.p, points.c, points.closeness, f, q);
}

}  // namespace
}  // namespace qtraj
