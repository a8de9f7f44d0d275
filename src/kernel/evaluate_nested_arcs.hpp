// Nested arcs, SQUAD: q = slerp(P(u), C(u); f), f = 2u(1 - u), P on the arc between the keys, C on that between the
// controls; the two are any angle theta < pi apart.
#pragma once

#include "evaluate_arc.hpp"
#include "half_angle.hpp"

namespace qtraj {
namespace {

// Half of |P + C| below which they count as opposite. Above it the sum has digits enough for one Newton step to bring
// the result to unit length; below, its direction is noise.
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
QTRAJ_INLINE void slerp_between_near(const Number (&p)[4], const Number (&c)[4], Number d, Number f, Number (&q)[4]) {
  using Real = Element<Number>;
  const Number z = Number(Real(1)) - d;
  const Number h = evaluate<Arithmetic, AcosRatioNear>(z);
  const Number y = (f * f) * ((h * h) * (z * (Number(Real(2)) - z)));  // (f theta)^2
  const Number weight_c = (f * h) * evaluate<Arithmetic, SincArc>(y);
  const Number weight_p = Arithmetic::multiply_add(-d, weight_c, evaluate<Arithmetic, CosArc>(y));
  combine<Arithmetic>(p, weight_p, c, weight_c, q);
  newton_normalize<Arithmetic>(q);
}

// slerp(p, c; f) for f in [0, 1/2] without an arc function of a rounded dot product. With z = cos(theta/2) = |p + c|/2
// and g = G(1 - z) = (theta/2)/sin(theta/2):
//   weight of c = sin(f theta)/sin theta = f g sinc(f theta)/z,  weight of p = cos(f theta) - cos theta (weight of c).
// Opposite p and c: the great circle through p (0, 1, 0, 0), a turn about the body x axis.
template <class Arithmetic, class Number>
QTRAJ_INLINE void slerp_between(const Number (&p)[4], const Number (&c)[4], Number z_squared, Number f,
                                Number (&q)[4]) {
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

// Cosines and sines of both arcs at s. Written field by field: GCC copies a struct of vectors in pieces through memory,
// and the loads that join them again wait for all that went before.
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

// A sum a0 c C + a1 c S + a2 s C + a3 s S over the products of the arcs' cosines and sines, and its derivatives in s.
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

// H = theta/sin theta as a function of d = cos theta, and its first two derivatives: from the polynomial G(1 - d) where
// the closed forms, H' = (d H - 1)/(1 - d^2) and H'' = (H + 3 d H')/(1 - d^2), would cancel, from these elsewhere.
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
  // of half the angle, kept from a quarter turn of S^3, where H is infinite and no great circle is singled out
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

// p = f H v, the half-angle vector from P to q, with its derivatives in s; f = (1 - s^2)/2.
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void exponent_jet(const NestedArcsSegmentOf<Number>& segment, const ArcPair<Number>& arcs, Number s,
                               HalfAngleJet<Number>& jet) {
  using Real = Element<Number>;
  const Number half = Number(Real(0.5)), two = Number(Real(2));
  const auto& m = segment.keys.m;
  const auto& e = segment.keys.e;
  const auto& control_m = segment.controls.m;
  const auto& control_e = segment.controls.e;
  const Jet<Number> d =
      product_sum<Arithmetic>(segment, arcs, dot<Arithmetic>(m, control_m), dot<Arithmetic>(m, control_e),
                              dot<Arithmetic>(e, control_m), dot<Arithmetic>(e, control_e));
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
    jet.ddp[k] = fh.second * v.value + two * fh.first * v.first + fh.value * v.second;
  }
}

// Points on both arcs, and how close they are: d of slerp_between_near, or z_squared of slerp_between.
template <class Number>
struct PointPair {
  Number p[4], c[4], closeness;
};
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void points_on_arcs(const NestedArcsSegmentOf<Number>& segment, Number s, ArcPair<Number>& arcs,
                                 PointPair<Number>& points) {
  using Real = Element<Number>;
  arc_pair<Arithmetic, kNear>(segment, s, arcs);
  combine<Arithmetic>(segment.keys.m, arcs.keys.c, segment.keys.e, arcs.keys.s, points.p);
  combine<Arithmetic>(segment.controls.m, arcs.controls.c, segment.controls.e, arcs.controls.s, points.c);
  if constexpr (kNear) {
    points.closeness = dot<Arithmetic>(points.p, points.c);
  } else {
    Number sum[4];
    for (size_t k = 0; k < 4; ++k) sum[k] = points.p[k] + points.c[k];
    points.closeness = Number(Real(0.25)) * dot<Arithmetic>(sum, sum);
  }
}
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void between_points(const PointPair<Number>& points, Number s, Number (&q)[4]) {
  using Real = Element<Number>;
  const Number f = Arithmetic::multiply_add(Number(Real(-0.5)) * s, s, Number(Real(0.5)));
  if constexpr (kNear)
    slerp_between_near<Arithmetic>(points.p, points.c, points.closeness, f, q);
  else
    slerp_between<Arithmetic>(points.p, points.c, points.closeness, f, q);
}

// With the rotation between the arcs written out, q = P exp(p), p = f H v, v = Im(P* C), H = theta/sin theta, the
// body rates are those of exp p and, turned by it, the constant one of P. v is a sum of four constant vectors times
// products of the arcs' sines and cosines: differentiating the weights of slerp instead would cancel on short arcs.
template <class Arithmetic, bool kNear, class Number>
QTRAJ_INLINE void nested_arcs_rates(const NestedArcsSegmentOf<Number>& segment, const ArcPair<Number>& arcs, Number s,
                                    bool wants_alpha, Rates<Number>& rates) {
  HalfAngleJet<Number> jet;
  exponent_jet<Arithmetic, kNear>(segment, arcs, s, jet);
  Rates<Number> inner;
  exponential_rates<Arithmetic>(jet, wants_alpha, inner);

  // the outer arc's rate seen from behind exp p: turned by its inverse
  Number carried[3];
  relative_vector_part<Arithmetic>(segment.keys.m, segment.keys.e, carried);
  for (Number& component : carried) component = component * (Number(Element<Number>(2)) * segment.keys.half_angle);
  CosSinc<Number> f;
  cos_sinc<Arithmetic>(dot<Arithmetic>(jet.p, jet.p), 0, f);
  const Number inverse[4] = {f.c, -f.k * jet.p[0], -f.k * jet.p[1], -f.k * jet.p[2]};
  rotate_to_world<Arithmetic>(inverse, carried);
  for (size_t k = 0; k < 3; ++k) rates.omega[k] = carried[k] + inner.omega[k];
  if (!wants_alpha) return;
  Number turning[3];
  cross<Arithmetic>(inner.omega, carried, turning);
  for (size_t k = 0; k < 3; ++k) rates.alpha[k] = inner.alpha[k] - turning[k];
}

// Where segments of either kind stand side by side both forms are computed.
template <class Arithmetic>
struct NestedArcsEvaluator : EvaluatorDefaults {
  template <class Value>
  using SegmentOf = NestedArcsSegmentOf<Value>;

  template <bool kWithRates>
  static constexpr bool kInTwoSteps = true;

  template <class Number>
  struct Begun {
    ArcPair<Number> arcs;  // left alone where no rates are asked for
    PointPair<Number> points;
  };

  template <class Task, class Number>
  QTRAJ_INLINE void begin(const SegmentOf<Number>& segment, Number s, Begun<Number>& begun) const {
    ArcPair<Number> arcs;
    const auto near = is_near(segment);
    if (Task::kOneSegment && all(near)) {
      points_on_arcs<Arithmetic, true>(segment, s, arcs, begun.points);
    } else if (Task::kOneSegment) {
      points_on_arcs<Arithmetic, false>(segment, s, arcs, begun.points);
    } else {
      ArcPair<Number> general_arcs;
      PointPair<Number> general;
      clear(arcs, begun.points), clear(general_arcs, general);
      if (any(near)) points_on_arcs<Arithmetic, true>(segment, s, arcs, begun.points);
      if (!all(near)) points_on_arcs<Arithmetic, false>(segment, s, general_arcs, general);
      choose(near, general_arcs, arcs);
      choose(near, general.p, begun.points.p);
      choose(near, general.c, begun.points.c);
      begun.points.closeness = select(near, begun.points.closeness, general.closeness);
    }
    if constexpr (Task::kWithRates) set(arcs, begun.arcs);
  }

  template <class Task, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>& segment, Number s, const Begun<Number>& begun,
                           Number (&q)[4]) const {
    const auto near = is_near(segment);
    if (Task::kOneSegment && all(near)) return between_points<Arithmetic, true>(begun.points, s, q);
    if (Task::kOneSegment) return between_points<Arithmetic, false>(begun.points, s, q);
    Number general[4];
    clear(q), clear(general);
    if (any(near)) between_points<Arithmetic, true>(begun.points, s, q);
    if (!all(near)) between_points<Arithmetic, false>(begun.points, s, general);
    choose(near, general, q);
  }

  template <class Task, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number s, const Begun<Number>& begun,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    finish<Task>(segment, s, begun, q);
    const ArcPair<Number>& arcs = begun.arcs;
    const auto near = is_near(segment);
    if (Task::kOneSegment && all(near))
      return nested_arcs_rates<Arithmetic, true>(segment, arcs, s, wants_alpha, rates);
    if (Task::kOneSegment) return nested_arcs_rates<Arithmetic, false>(segment, arcs, s, wants_alpha, rates);
    Rates<Number> general;
    clear(rates.omega), clear(rates.alpha), clear(general.omega), clear(general.alpha);
    if (any(near)) nested_arcs_rates<Arithmetic, true>(segment, arcs, s, wants_alpha, rates);
    if (!all(near)) nested_arcs_rates<Arithmetic, false>(segment, arcs, s, wants_alpha, general);
    choose(near, general.omega, rates.omega);
    choose(near, general.alpha, rates.alpha);
  }

 private:
  template <class Number>
  QTRAJ_INLINE static auto is_near(const SegmentOf<Number>& segment) {
    return Number(Element<Number>(0.5)) < segment.near;
  }
  template <class Number, size_t Size>
  QTRAJ_INLINE static void clear(Number (&values)[Size]) {
    for (Number& value : values) value = Number(Element<Number>(0));
  }
  template <class Number>
  QTRAJ_INLINE static void clear(ArcPair<Number>& arcs, PointPair<Number>& points) {
    const Number zero(Element<Number>(0));
    clear(points.p), clear(points.c);
    points.closeness = arcs.keys.c = arcs.keys.s = arcs.controls.c = arcs.controls.s = zero;
  }
  // `values` stay where segments are near, and are the general ones elsewhere.
  template <class Mask, class Number, size_t Size>
  QTRAJ_INLINE static void choose(Mask near, const Number (&general)[Size], Number (&values)[Size]) {
    for (size_t k = 0; k < Size; ++k) values[k] = select(near, values[k], general[k]);
  }
  template <class Mask, class Number>
  QTRAJ_INLINE static void choose(Mask near, const ArcPair<Number>& general, ArcPair<Number>& arcs) {
    arcs.keys.c = select(near, arcs.keys.c, general.keys.c);
    arcs.keys.s = select(near, arcs.keys.s, general.keys.s);
    arcs.controls.c = select(near, arcs.controls.c, general.controls.c);
    arcs.controls.s = select(near, arcs.controls.s, general.controls.s);
  }
  template <class Number>
  QTRAJ_INLINE static void set(const ArcPair<Number>& from, ArcPair<Number>& to) {
    to.keys.c = from.keys.c, to.keys.s = from.keys.s;
    to.controls.c = from.controls.c, to.controls.s = from.controls.s;
  }
};

}  // namespace
}  // namespace qtraj
