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
  template <class Real>
  static constexpr bool kOwnLoopWithRates = true;
  template <bool kWithRates>
  static constexpr bool kInTwoSteps = true;

  template <class Number>
  struct Partial {
    ArcPair<Number> arcs;  // not set without rates
    PointPair<Number> points;
  };

  template <class Mode, class Number>
  QTRAJ_INLINE void start(const SegmentOf<Number>& segment, Number s, Partial<Number>& partial) const {
    ArcPair<Number> arcs;
    const auto near = is_near(segment);
    if (Mode::kOneSegment && all(near)) {
      points_on_arcs<Arithmetic, true>(segment, s, arcs, partial.points);
    } else if (Mode::kOneSegment) {
      points_on_arcs<Arithmetic, false>(segment, s, arcs, partial.points);
    } else {
      ArcPair<Number> general_arcs;
      PointPair<Number> general;
      clear(arcs, partial.points), clear(general_arcs, general);
      if (any(near)) points_on_arcs<Arithmetic, true>(segment, s, arcs, partial.points);
      if (!all(near)) {
        points_on_arcs<Arithmetic, false>(segment, s, general_arcs, general);
        choose(near, general_arcs, arcs);
        choose(near, general.p, partial.points.p);
        choose(near, general.c, partial.points.c);
        partial.points.closeness = select(near, partial.points.closeness, general.closeness);
      }
    }
    if constexpr (Mode::kWithRates) set(arcs, partial.arcs);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish(const SegmentOf<Number>& segment, Number s, const Partial<Number>& partial,
                           Number (&q)[4]) const {
    const auto near = is_near(segment);
    if (Mode::kOneSegment && all(near)) return between_points<Arithmetic, true>(partial.points, s, q);
    if (Mode::kOneSegment) return between_points<Arithmetic, false>(partial.points, s, q);
    Number general[4];
    clear(q), clear(general);
    if (any(near)) between_points<Arithmetic, true>(partial.points, s, q);
    if (all(near)) return;
    between_points<Arithmetic, false>(partial.points, s, general);
    choose(near, general, q);
  }

  template <class Mode, class Number>
  QTRAJ_INLINE void finish_rates(const SegmentOf<Number>& segment, Number s, const Partial<Number>& partial,
                                 bool wants_alpha, Number (&q)[4], Rates<Number>& rates) const {
    finish<Mode>(segment, s, partial, q);
    const ArcPair<Number>& arcs = partial.arcs;
    const auto near = is_near(segment);
    if (Mode::kOneSegment && all(near))
      return nested_arcs_rates<Arithmetic, true>(segment, arcs, s, wants_alpha, rates);
    if (Mode::kOneSegment) return nested_arcs_rates<Arithmetic, false>(segment, arcs, s, wants_alpha, rates);
    Rates<Number> general;
    clear(rates.omega), clear(rates.alpha), clear(general.omega), clear(general.alpha);
    if (any(near)) nested_arcs_rates<Arithmetic, true>(segment, arcs, s, wants_alpha, rates);
    if (all(near)) return;
    nested_arcs_rates<Arithmetic, false>(segment, arcs, s, wants_alpha, general);
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
  template <class Number>
  QTRAJ_INLINE static void set(const ArcPair<Number>& from, ArcPair<Number>& to) {
    to.keys.c = from.keys.c, to.keys.s = from.keys.s;
    to.controls.c = from.controls.c, to.controls.s = from.controls.s;
  }
};

}  // namespace
}  // namespace qtraj
