// The kernels of SQUAD's three passes.
#pragma once

#include "rows/segments.hpp"
#include "rows/squad_segment.hpp"

namespace qtraj {
namespace {

template <class Number>
QTRAJ_INLINE size_t squad_chord_rows(const SquadRows& rows, size_t row, size_t lanes) {
  SegmentEnds<Number> ends;
  load_ends(rows.keys, row, lanes, ends);
  ChordsOf<Number> chords = chords_of(ends);
  const auto is_special = is_special_arc(chords);
  ArcOf<Number> arc = arc_of(chords);
  const RelativeRotationOf<Number> rotation = rotation_along(ends.from, chords, arc.half_angle);
  Number log[3];
  half_angle_vector(rotation, square_root(dot_product<Plain>(rotation.sin_part, rotation.sin_part)), log);

  const size_t done = lanes_before(is_special, lanes);
  store_fields(fields_of<Number>(arc), &rows.segments[row].keys.half_angle, kFieldsOf<NestedArcsSegment>, done);
  store_padded(log, rows.log[row], done);
  return done;
}

// Whether a half rate makes a control wrap, or nearly, and is to be shortened (limited_half_rate in
// functions/squad.cpp).
template <class Number>
QTRAJ_INLINE auto is_limited(const Number (&s)[3], const Number (&log)[3], Number h) {
  const Number x[] = {h * s[0], h * s[1], h * s[2]};
  const Number room = Number(kPi * kPi) - dot_product<Plain>(log, log);
  return (Number(7.99) < largest_magnitude(x)) |
         (room < dot_product<Plain>(x, x) - Number(2.0) * dot_product<Plain>(x, log));
}

// Half rates by the rule, of keys between two segments.
template <class Number>
QTRAJ_INLINE size_t squad_half_rate_rows(const SquadRows& rows, size_t key, size_t lanes) {
  constexpr double kShort = 0x1p-200, kLong = 0x1p200;
  const double* times = rows.keys.times + key;
  const double last_h = times[0] - times[-1];
  if (last_h < kShort || kLong < last_h) return 0;
  const Number given_h = load_padded(times + 1, lanes, Number()) - load_padded(times, lanes, Number());
  const auto is_extreme_length = (given_h < Number(kShort)) | (Number(kLong) < given_h);
  const Number h = select(is_extreme_length, Number(1.0), given_h), h_before = preceded_by(last_h, h);

  Number log[3], log_before[3], v[3], v_before[3], s[3];
  load_padded(rows.log[key], lanes, log);
  for (size_t k = 0; k < 3; ++k) {
    const double last_log = rows.log[key - 1][k];
    v[k] = log[k] / h;
    log_before[k] = preceded_by(last_log, log[k]);
    v_before[k] = preceded_by(last_log / last_h, v[k]);
  }
  rule_half_rate_of(rows.rule, v_before, h_before, v, h, s);
  const size_t done =
      lanes_before(is_extreme_length | is_limited(s, log_before, h_before) | is_limited(s, log, h), lanes);
  store_padded(s, rows.half_rate[key], done);
  return done;
}

template <class Number>
QTRAJ_INLINE size_t squad_segment_rows(const SquadRows& rows, size_t row, size_t lanes) {
  SquadEnds<Number> ends;
  {
    SegmentEnds<Number> keys;
    load_ends(rows.keys, row, lanes, keys);
    for (size_t k = 0; k < 4; ++k) ends.from[k] = keys.from[k], ends.to[k] = keys.to[k];
    ends.chords = chords_of(keys);
    ends.h = keys.h;
  }
  load_fields(&rows.segments[row].keys.half_angle, kFieldsOf<NestedArcsSegment>, lanes, fields_of<Number>(ends.outer));
  double copy[kLanesOf<Number> * 3];  // one for all: stack
  const auto load = [&](const double(&from)[3], Number(&to)[3]) {
    convert_rows(padded<Number, 3>(from, lanes, copy), 0, to);
  };
  load(rows.log[row], ends.log);
  load(rows.half_rate[row], ends.start_rate);
  load(rows.half_rate[row + 1], ends.end_rate);

  auto is_special = is_nearly_opposite(ends.chords);
  NestedArcsSegmentOf<Number> segment;
  set_squad_segment(
      ends,
      [&](Number angle) {
        is_special = is_special | (Number(kNoQuarter) < angle);
        return sin_cos_unreduced(angle);
      },
      [&](ChordsOf<Number>& chords) {
        is_special = is_special | is_special_arc(chords);
        return arc_of(chords);
      },
      segment);
  const size_t done = lanes_before(is_special, lanes);
  store_fields(fields_of<Number>(segment), &rows.segments[row].scale, kFieldsOf<NestedArcsSegment>, done);
  return done;
}

template <class Number>
size_t squad_chords(const SquadRows& rows, size_t first, size_t count) {
  return do_segments<Number>(first, count,
                             [&](size_t row, size_t lanes) { return squad_chord_rows<Number>(rows, row, lanes); });
}
template <class Number>
size_t squad_half_rates(const SquadRows& rows, size_t first, size_t count) {
  return do_segments<Number>(first, count,
                             [&](size_t key, size_t lanes) { return squad_half_rate_rows<Number>(rows, key, lanes); });
}
template <class Number>
size_t squad_segments(const SquadRows& rows, size_t first, size_t count) {
  return do_segments<Number>(first, count,
                             [&](size_t row, size_t lanes) { return squad_segment_rows<Number>(rows, row, lanes); });
}

}  // namespace
}  // namespace qtraj
