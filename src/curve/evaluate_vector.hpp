// A component of a vector curve within a segment, from its ends and its shape. With u in [0, 1] along the segment,
// v = 1 - u and w = u v,
//   p = line(u) + w (v a + u b) + w^2 (v c + u d),
// line being the chord from end to end: Hermite's form, in which the ends are exact and equal ends with a shape of 0
// make a constant. It is the cubic, with c and d the quintic, whose derivatives at the ends, per unit of u, are
//   p'(0) = chord + a,  p'(1) = chord - b,  p''(0) = 2 (c + b - 2 a),  p''(1) = 2 (d + a - 2 b).
//
// Plain arithmetic on every target, never fused: a value has the same bits from every kernel. The error of p is below
// 4 eps (|left| + |right| + |a| + |b| + |c| + |d|).
//
// Number: double, or a vector of it.
#pragma once

#include <type_traits>

#include "math/arithmetic.hpp"

namespace qtraj {
namespace {

// Where in a segment: at u, and how far from the nearer end.
template <class Number>
struct SegmentPosition {
  Number u, v, step;
  decltype(Number() <= Number()) is_first_half;

  explicit SegmentPosition(Number fraction)
      : u(fraction), v(Number(1.0) - fraction), step(v), is_first_half(u <= Number(0.5)) {
    step = select(is_first_half, u, -v);
  }
};

// The nearer end, the chord and the shape of a component.
template <class Number>
struct VectorComponent {
  Number near, chord, a, b, c, d;
};

// kTerms: as VectorCurve::terms.
template <size_t kTerms, class Number>
QTRAJ_INLINE Number vector_value(const VectorComponent<Number>& p, const SegmentPosition<Number>& at) {
  Number from_near = at.step * p.chord;
  if constexpr (kTerms > 0) {
    const Number w = at.u * at.v;
    Number bow = at.v * p.a + at.u * p.b;
    if constexpr (kTerms > 2) bow = bow + w * (at.v * p.c + at.u * p.d);
    from_near = from_near + w * bow;
  }
  return p.near + from_near;
}

// First and second derivative. w' = v - u, w'' = -2.
template <size_t kTerms, class Number>
QTRAJ_INLINE void vector_derivatives(const VectorComponent<Number>& p, const SegmentPosition<Number>& at, Number& first,
                                     Number& second) {
  first = p.chord;
  second = Number(0.0);
  if constexpr (kTerms > 0) {
    const Number two(2.0), w = at.u * at.v, dw = at.v - at.u;
    const Number bow = at.v * p.a + at.u * p.b, change = p.b - p.a;
    first = first + (dw * bow + w * change);
    second = two * (dw * change - bow);
    if constexpr (kTerms > 2) {
      const Number outer = at.v * p.c + at.u * p.d, outer_change = p.d - p.c;
      first = first + w * (two * dw * outer + w * outer_change);
      second = second + (two * (dw * dw - two * w) * outer + Number(4.0) * (w * dw) * outer_change);
    }
  }
}

// Calls `with` with the terms of a curve as a constant.
template <class With>
QTRAJ_INLINE auto with_terms(size_t terms, const With& with) {
  if (terms == 0) return with(std::integral_constant<size_t, 0>());
  if (terms == 2) return with(std::integral_constant<size_t, 2>());
  return with(std::integral_constant<size_t, 4>());
}

}  // namespace
}  // namespace qtraj
