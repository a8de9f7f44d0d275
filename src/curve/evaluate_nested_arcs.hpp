// The evaluator of nested arcs (SQUAD).
#pragma once

#include "curve/nested_arcs_rates.hpp"

namespace qtraj {
namespace {

// A segment is evaluated in the near form or in the general one (NestedArcsSegmentOf::near). Where lanes have segments
// of both kinds, both forms are computed and one is selected lane by lane.
template <class Arithmetic>
struct NestedArcsEvaluator : EvaluatorDefaults {
  using EvaluatorDefaults::EvaluatorDefaults;

  template <class Value>
  using SegmentOf = NestedArcsSegmentOf<Value>;

  static constexpr int kWork = 3;
  static constexpr size_t kChunk = 128, kSearched = 48;
  template <class Real>
  static constexpr bool kOwnLoopWithRates = true;

  template <bool kWithRates>
  static constexpr bool kInTwoSteps = true;

  // Points on both arcs, or with rates, whose formulas need more of them, the arcs' cosines and sines.
  template <class Number, bool kWithRates>
  using PartialOf = std::conditional_t<kWithRates, ArcPair<Number>, PointPair<Number>>;

  template <class Mode, class Number>
  QTRAJ_INLINE void start(const SegmentOf<Number>& segment, Number s, ArcPair<Number>& arcs) const {
    const auto near = is_near(segment);
    if (Mode::kOneSegment && all(near)) return arc_pair<Arithmetic, true>(segment, s, arcs);
    if (Mode::kOneSegment) return arc_pair<Arithmetic, false>(segment, s, arcs);
    ArcPair<Number> general;
    clear(arcs), clear(general);
    if (any(near)) arc_pair<Arithmetic, true>(segment, s, arcs);
    if (all(near)) return;
    arc_pair<Arithmetic, false>(segment, s, general);
    choose(near, general, arcs);
  }
  template <class Mode, class Number>
  QTRAJ_INLINE void start(const SegmentOf<Number>& segment, Number s, PointPair<Number>& points) const {
    const auto near = is_near(segment);
    if (Mode::kOneSegment && all(near)) return points_on_arcs<Arithmetic, true>(segment, s, points);
    if (Mode::kOneSegment) return points_on_arcs<Arithmetic, false>(segment, s, points);
    PointPair<Number> general;
    clear(points), clear(general);
    if (any(near)) points_on_arcs<Arithmetic, true>(segment, s, points);
    if (all(near)) return;
    points_on_arcs<Arithmetic, false>(segment, s, general);
    choose(near, general.p, points.p);
    choose(near, general.c, points.c);
    points.closeness = select(near, points.closeness, general.closeness);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>& segment, Number s, const PointPair<Number>& points,
                           Number (&q)[4]) const {
    const auto near = is_near(segment);
    if (Mode::kOneSegment && all(near)) return between_points<Arithmetic, true>(points, s, q);
    if (Mode::kOneSegment) return between_points<Arithmetic, false>(points, s, q);
    Number general[4];
    clear(q), clear(general);
    if (any(near)) between_points<Arithmetic, true>(points, s, q);
    if (all(near)) return;
    between_points<Arithmetic, false>(points, s, general);
    choose(near, general, q);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number s, const ArcPair<Number>& arcs,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    const auto near = is_near(segment);
    if (Mode::kOneSegment && all(near))
      return nested_arcs_motion<Arithmetic, true>(segment, arcs, s, wants_alpha, q, rates);
    if (Mode::kOneSegment) return nested_arcs_motion<Arithmetic, false>(segment, arcs, s, wants_alpha, q, rates);
    Number general_q[4];
    Rates<Number> general;
    clear(q), clear(rates.omega), clear(rates.alpha);
    if (any(near)) nested_arcs_motion<Arithmetic, true>(segment, arcs, s, wants_alpha, q, rates);
    if (all(near)) return;
    clear(general.alpha);
    nested_arcs_motion<Arithmetic, false>(segment, arcs, s, wants_alpha, general_q, general);
    choose(near, general_q, q);
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
  QTRAJ_INLINE static void clear(PointPair<Number>& points) {
    clear(points.p), clear(points.c);
    points.closeness = Number(Element<Number>(0));
  }
  template <class Number>
  QTRAJ_INLINE static void clear(ArcPair<Number>& arcs) {
    arcs.keys.c = arcs.keys.s = arcs.controls.c = arcs.controls.s = Number(Element<Number>(0));
  }
  // `values` keep the lanes whose segments are near and get the general ones in all others.
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
};

}  // namespace
}  // namespace qtraj
