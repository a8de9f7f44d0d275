// The handle: one block of memory, this record first, then knots, their guide, keys and segments, found by offsets so
// that the block can be copied. Immutable once built (methods/build.hpp). Kernels include this header: it holds plain
// data, and functions of internal linkage.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/settings.hpp"
#include "curve/segment.hpp"
#include "curve/timeline.hpp"

namespace qtraj {

// What the curve does beyond one end: the great circle m cos x + e sin x, x = rate (t - knot), with the end key as m
// and rate 0 for HOLD.
struct GreatCircle {
  double knot;
  double far_time;  // later times are clamped to it: there the arc, or the difference t - knot, has no digits left
  double rate;      // rad/s on S^3: half the angular speed
  double m[4], e[4];
  double omega_body[3], omega_world[3];

  double angle(double time) const {
    const bool past_far = time > knot ? time > far_time : time < far_time;
    return rate * ((past_far ? far_time : time) - knot);
  }
};

struct Trajectory {
  static constexpr uint64_t kTag = 0x7672636a61727471;  // "qtrajcrv"
  uint64_t tag;  // kTag from the end of construction until the handle is destroyed
  Timeline timeline;
  Method method;
  SegmentKind kind;
  ExponentRange range;
  int32_t iterations;
  double residual;
  size_t sign_flips;
  double worst_norm_error;
  double least_dot;
  GreatCircle before, after;
  bool closed;          // PERIODIC, at its ends or beyond them
  bool negate_on_wrap;  // PERIODIC extrapolation: the last key is minus the first
  bool on_heap;
  size_t keys_offset, segments_offset;  // bytes from here
};

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
