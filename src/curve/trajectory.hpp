// The handle: one block of memory, this record first, then knots, their guide, keys and segments, found by offsets so
// that the block can be copied. Immutable once built (methods/build.hpp). Kernels include this header: it holds plain
// data, and functions of internal linkage.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/settings.hpp"
#include "curve/segment.hpp"
#include "math/error_free.hpp"

namespace qtraj {

// What a time beyond one end of the knots means: the great circle m cos x + e sin x, x = rate (t - knot), with the end
// key as m and rate 0 for HOLD.
struct Extrapolation {
  Extrapolate rule;
  double knot;
  double reach;     // times between the knot and this, 4 ulps of the larger end away, count as the knot
  double far_time;  // later times are clamped to it: there the arc, or the difference t - knot, has no digits left
  double rate;      // rad/s on S^3: half the angular speed
  double m[4], e[4];
  double omega_body[3], omega_world[3];
};

struct Trajectory {
  static constexpr uint64_t kTag = 0x7672636a61727471;  // "qtrajcrv"
  uint64_t tag;  // kTag from the end of construction until the handle is destroyed
  Method method;
  SegmentKind kind;
  ExponentRange range;
  int32_t iterations;
  double residual;
  size_t key_count;
  size_t sign_flips;
  double worst_norm_error;
  double least_dot;
  Extrapolation before, after;
  double last_inside;        // segments are sampled up to here: to the last knot, a repeated curve to just before it
  DoubleDouble half_period;  // s, half of what the curve repeats after: the whole may overflow
  double longest_gap;        // s; times inside longer intervals have no value; infinity where no interval is longer
  bool closed;               // PERIODIC, at its ends or beyond them
  bool negate_on_wrap;       // PERIODIC extrapolation: the last key is minus the first
  bool on_heap;
  double guide_scale;
  size_t guide_candidates;
  size_t guide_offset, keys_offset, segments_offset;  // bytes from here; knots follow this record
};

template <class Element>
static inline const Element* at_offset(const Trajectory& trajectory, size_t bytes) {
  return reinterpret_cast<const Element*>(reinterpret_cast<const char*>(&trajectory) + bytes);
}

// [key_count]
static inline const double* knots_of(const Trajectory& trajectory) {
  return at_offset<double>(trajectory, sizeof(Trajectory));
}
// [key_count][4]
static inline const double (*keys_of(const Trajectory& trajectory))[4] {
  return at_offset<double[4]>(trajectory, trajectory.keys_offset);
}
// [key_count - 1], records of the kind of the trajectory
template <class Segment>
static inline const Segment* segments_of(const Trajectory& trajectory) {
  return at_offset<Segment>(trajectory, trajectory.segments_offset);
}

}  // namespace qtraj
