// Kernels over the segments of a curve under construction. They do what the builders in methods/ do for one segment, in
// the same plain arithmetic and so with the same bits; what is singular, or rare, is left to those.
//
// Vectors of two lanes gain little: these targets leave all segments to the core.
#pragma once

#include "math/chords.hpp"
#include "rows/padded_rows.hpp"

namespace qtraj {
namespace {

// Calls operation(row, lanes) as do_padded does, where vectors are wide enough to pay. Where there are enough segments,
// the last vector is a whole one that does some of them again.
template <class Number, class Operation>
QTRAJ_INLINE size_t do_segments(size_t first, size_t count, const Operation& operation) {
  constexpr size_t kLanes = kLanesOf<Number>;
  if constexpr (kLanes < 4) return 0;
  return do_padded<Number>(first, count, [&](size_t row, size_t lanes) {
    const size_t again = lanes < kLanes && count - first >= kLanes ? kLanes - lanes : 0;
    return operation(row - again, lanes + again) - again;
  });
}

// Keys at both ends of segments, and the lengths of these.
template <class Number>
struct SegmentEnds {
  Number from[4], from_error[4], to[4], to_error[4];
  Number h;
};
template <class Number>
QTRAJ_INLINE void load_ends(const KeyArrays& keys, size_t row, size_t lanes, SegmentEnds<Number>& ends) {
  double copy[kLanesOf<Number> * 4];  // one for all: stack
  const auto load = [&](const double(&from)[4], Number(&to)[4]) {
    convert_rows(padded<Number, 4>(from, lanes, copy), 0, to);
  };
  load(keys.q[row], ends.from);
  load(keys.q_error[row], ends.from_error);
  load(keys.q[row + 1], ends.to);
  load(keys.q_error[row + 1], ends.to_error);
  ends.h = load_padded(keys.times + row + 1, lanes, Number()) - load_padded(keys.times + row, lanes, Number());
}
template <class Number>
QTRAJ_INLINE ChordsOf<Number> chords_of(const SegmentEnds<Number>& ends) {
  return chords_between(ends.from, ends.from_error, ends.to, ends.to_error);
}

// Whether the ends of an arc are so nearly opposite that it is left to the core; the chords can be computed with
// nevertheless.
template <class Number>
QTRAJ_INLINE auto is_special_arc(ChordsOf<Number>& chords) {
  const auto is_special = is_nearly_opposite(chords);
  chords.opposite_length = select(is_special, Number(1.0), chords.opposite_length);
  return is_special;
}

template <class Number>
QTRAJ_INLINE Number largest_magnitude(const Number (&v)[3]) {
  return maximum(maximum(absolute(v[0]), absolute(v[1])), absolute(v[2]));
}

template <class Number>
QTRAJ_INLINE size_t arc_rows(const ArcRows& rows, size_t row, size_t lanes) {
  SegmentEnds<Number> ends;
  load_ends(rows.keys, row, lanes, ends);
  ChordsOf<Number> chords = chords_of(ends);
  const auto is_special = is_special_arc(chords);
  const ArcOf<Number> arc = arc_of(chords);

  ArcSegmentOf<Number> segment;
  segment.rate = Number(2.0) * arc.half_angle / ends.h;
  segment.half_angle = arc.half_angle;
  for (size_t k = 0; k < 4; ++k) segment.m[k] = arc.m[k], segment.e[k] = arc.e[k];
  const auto is_still = (segment.rate <= Number(0.0)) & (Number(0.0) < arc.half_angle);
  const size_t done = lanes_before(is_special | is_still, lanes);
  store_fields(fields_of<Number>(segment), &rows.segments[row].rate, kFieldsOf<ArcSegment>, done);
  return done;
}

template <class Number>
size_t arcs(const ArcRows& rows, size_t first, size_t count) {
  return do_segments<Number>(first, count,
                             [&](size_t row, size_t lanes) { return arc_rows<Number>(rows, row, lanes); });
}

}  // namespace
}  // namespace qtraj
