// The handle: one block of memory, this header first, then knots, their guide, keys and segments, found by offsets so
// that the block can be copied. Immutable once built. Vector files include this header: plain data, and functions
// defined elsewhere.
#pragma once

#include <cstddef>
#include <cstdint>

#include "qtraj/segment.hpp"
#include "qtraj/settings.hpp"
#include "qtraj/status.hpp"

namespace qtraj {

struct KeyframeInput;
struct Options;

// What a time beyond one end of the knots means: the great circle m cos x + e sin x, x = rate (t - knot), with the end
// key as m and rate 0 for HOLD.
struct Extrapolation {
  Extrapolate rule;
  double knot;
  double far_time;  // times past it count as it: there the arc, or the difference t - knot, has no digits left
  double rate;      // rad/s on S^3: half the angular speed
  double m[4], e[4];
  double omega_body[3], omega_world[3];
};

struct Trajectory {
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
  bool closed;          // PERIODIC, at its ends or beyond them
  bool negate_on_wrap;  // PERIODIC extrapolation: the last key is minus the first
  bool on_heap;
  double guide_scale;
  size_t guide_candidates;
  size_t guide_offset, keys_offset, segments_offset;  // bytes from here; knots follow this header
};

// Bytes of a handle and of the constructor's working space; false where they would exceed PTRDIFF_MAX.
struct TrajectorySize {
  size_t handle, workspace;
};
bool trajectory_size(const Options& options, size_t count, TrajectorySize& size);

// Whether the options are complete and the input has the rates they need, and no others: ok or option.
Status check_settings(const Options& options, const KeyframeInput& input, Frame rate_frame);

// Builds in 8-byte aligned memory of the sizes above, settings checked; the workspace is free again afterwards.
Outcome build_trajectory(const Options& options, const KeyframeInput& input, Frame rate_frame, void* handle,
                         void* workspace, Trajectory** out);

const double* knots_of(const Trajectory& trajectory);      // [key_count]
const double (*keys_of(const Trajectory& trajectory))[4];  // [key_count][4]

}  // namespace qtraj
