// SQUAD: the half rate at a key and the segment between two keys, in any Number: for the core (methods/squad.cpp, which
// states the formulas) and for kernels. Plain arithmetic: the same bits in both.
#pragma once

#include "base/settings.hpp"
#include "curve/segment.hpp"
#include "math/half_angle.hpp"
#include "math/relative_rotation.hpp"

namespace qtraj {
namespace {

// REST, of one component: the chord rates before and after, and their CATMULL_ROM value.
template <class Number>
QTRAJ_INLINE Number resting_rate(Number before, Number after, Number mean) {
  const Number zero(0.0), size_before = absolute(before), size_after = absolute(after), size = absolute(mean);
  const auto goes_on = ((zero < before) & (zero < after)) | ((before < zero) & (after < zero));
  const Number limit = Number(3.0) * select(size_after < size_before, size_after, size_before);
  return select(goes_on, select(limit < size, select(mean < zero, -limit, limit), mean), zero);
}

// The tangent rule (functions/squad.hpp) from the rates log/h and the lengths h of the segments on both sides.
template <class Number>
QTRAJ_INLINE void rule_half_rate_of(Tangent rule, const Number (&v_before)[3], Number h_before,
                                    const Number (&v_after)[3], Number h_after, Number (&s)[3]) {
  const Number half(0.5);
  Number left = half, right = half;
  if (rule != Tangent::mean_velocity) {
    // shares as of interval_shares (base/times.hpp)
    const Number half_span = half * h_before + half * h_after;
    left = half * h_before / half_span, right = half * h_after / half_span;
  }
  for (size_t k = 0; k < 3; ++k) {
    s[k] = right * v_before[k] + left * v_after[k];
    if (rule == Tangent::rest) s[k] = resting_rate(v_before[k], v_after[k], s[k]);
  }
}

// Between ArcOf and the arcs of a segment.
template <class From, class To>
QTRAJ_INLINE void copy_arc(const From& from, To& to) {
  to.half_angle = from.half_angle;
  for (size_t k = 0; k < 4; ++k) to.m[k] = from.m[k], to.e[k] = from.e[k];
}

// What a segment is made of.
template <class Number>
struct SquadEnds {
  Number from[4], to[4];    // its keys,
  ChordsOf<Number> chords;  // the chords between these,
  ArcOf<Number> outer;      // and the arc
  Number log[3], h;
  Number start_rate[3], end_rate[3];  // half rates
};

// How far a control is from its key: a - q = q (exp((h s - log)/2) - 1) of the segment after it, and b - q = q
// (exp((log
// - h s)/2) - 1) of that before it.
template <class Number, class SinCosFunction>
QTRAJ_INLINE void control_offset(const Number (&q)[4], const Number (&s)[3], const Number (&log)[3], Number h,
                                 bool after, const SinCosFunction& sin_cos, Number (&offset)[4]) {
  Number v[3], factor[4];
  for (size_t k = 0; k < 3; ++k) {
    const Number turned = h * s[k];
    v[k] = Number(0.5) * (after ? turned - log[k] : log[k] - turned);
  }
  exponential_minus_one(v, sin_cos, factor);
  hamilton_product<Plain>(q, factor, offset);
}

// Whether the arcs are close enough for the kernels' near form, as 1 or 0. The cosine of their distance at s in [-1, 1]
// has a second derivative below (x + y)^2, x and y being their half angles: between the ends and the middle it stays
// within an eighth of that of its chords.
template <class Number>
QTRAJ_INLINE Number are_near(const ArcOf<Number>& outer, const ArcOf<Number>& inner, Number cosine_at_start,
                             Number cosine_at_end) {
  const Number angles = outer.half_angle + inner.half_angle;
  const Number least = minimum(minimum(cosine_at_start, dot_product<Plain>(outer.m, inner.m)), cosine_at_end);
  const auto is_near =
      (inner.half_angle <= Number(0.25 * kPi)) & (Number(0.5) <= least - angles * angles / Number(8.0));
  return select(is_near, Number(1.0), Number(0.0));
}

// sin_cos(angle) and arc(chords) are steps that kernels do in ordinary lanes only; in others these are told apart, and
// chords changed so that they can be computed with.
template <class Number, class SinCosFunction, class ArcFunction>
QTRAJ_INLINE void set_squad_segment(const SquadEnds<Number>& ends, const SinCosFunction& sin_cos,
                                    const ArcFunction& arc, NestedArcsSegmentOf<Number>& segment) {
  const Number half(0.5), one(1.0);
  // the difference of the ends of the inner arc is formed from the controls' offsets to their keys: no cancellation
  Number a[4], b[4], sum[4], m_offset[4];
  control_offset(ends.from, ends.start_rate, ends.log, ends.h, true, sin_cos, a);
  control_offset(ends.to, ends.end_rate, ends.log, ends.h, false, sin_cos, b);
  ChordsOf<Number> chords;
  for (size_t k = 0; k < 4; ++k) {
    sum[k] = a[k] + b[k];
    chords.chord[k] = ends.chords.chord[k] + (b[k] - a[k]);
    chords.opposite[k] = ends.chords.opposite[k] + sum[k];
  }
  measure_chords(chords);
  const ArcOf<Number>&outer = ends.outer, inner = arc(chords);

  segment.scale = Number(2.0) / ends.h;
  // controls are unit, so that their dot products with the keys are 1 - |offset|^2/2
  segment.near = are_near(outer, inner, one - half * dot_product<Plain>(a, a), one - half * dot_product<Plain>(b, b));
  copy_arc(outer, segment.keys);
  copy_arc(inner, segment.controls);
  // The sum of the keys is along the outer middle. The sum of the controls' offsets therefore gives the difference of
  // the middles without cancellation on short arcs. On long arcs the inner middle itself is as good.
  const auto is_short = inner.half_angle < half;
  for (size_t k = 0; k < 4; ++k) m_offset[k] = select(is_short, sum[k] / chords.opposite_length, inner.m[k]);
  conjugate_product_vector(outer.m, m_offset, segment.relative[0]);
  conjugate_product_vector(outer.m, inner.e, segment.relative[1]);
  conjugate_product_vector(outer.e, inner.m, segment.relative[2]);
  conjugate_product_vector(outer.e, inner.e, segment.relative[3]);
}

}  // namespace
}  // namespace qtraj
