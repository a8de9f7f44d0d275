// The time axis of a curve: knots, their guide, and what a time between or outside them means. Orientation curves
// (trajectory.hpp) and vector curves (vector_curve.hpp) have one each. Kernels include this header: it holds plain
// data, and functions of internal linkage.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/settings.hpp"
#include "math/error_free.hpp"

namespace qtraj {

struct Timeline {
  // One end of the knots.
  struct Side {
    Extrapolate rule;
    double knot;
    double reach;  // times between the knot and this, 4 ulps of the larger end away, count as the knot
  };

  size_t key_count;
  Side before, after;
  double last_inside;        // segments are sampled up to here: to the last knot, or to just before it where the curve
                             // repeats, or holds each key until the next
  DoubleDouble half_period;  // s, half of what the curve repeats after: the whole may overflow
  double longest_gap;        // s; times inside longer intervals have no value; infinity where no interval is longer
  double guide_scale;
  size_t guide_candidates;
  size_t knots_offset, guide_offset;  // bytes from here: they lie in the block of the curve, so that it can be copied
};

template <class Element, class Record>
static inline const Element* at_offset(const Record& record, size_t bytes) {
  return reinterpret_cast<const Element*>(reinterpret_cast<const char*>(&record) + bytes);
}

// [key_count]
static inline const double* knots_of(const Timeline& timeline) {
  return at_offset<double>(timeline, timeline.knots_offset);
}

// Whether a finite time is sampled as it is.
static inline bool is_inside(const Timeline& timeline, double time) {
  return time >= timeline.before.knot && time <= timeline.last_inside;
}

// Whether a segment is longer than the longest gap: its times have no value, its knots do.
static inline bool is_gap(const Timeline& timeline, const double* knots, size_t segment) {
  return knots[segment + 1] - knots[segment] > timeline.longest_gap;
}
static inline bool is_in_gap(const Timeline& timeline, const double* knots, size_t segment, double time) {
  return is_gap(timeline, knots, segment) && time > knots[segment] && time < knots[segment + 1];
}

// What a finite time that is not inside stands for.
struct Place {
  double time;                   // within the knots, or beyond an end
  bool is_odd_round;             // moved by an odd number of periods
  const Timeline::Side* beyond;  // null where it is within the knots; the last knot itself where each key is held
  bool has_value;                // false beyond an end whose rule is ERROR
};
Place place_outside(const Timeline& timeline, double time);

}  // namespace qtraj
