// The builder: from keyframes and options to a trajectory. It cleans the keyframes (keyframes.hpp), makes the guide of
// the knots (curve/knot_lookup.hpp), and lets the method's own builder (method.hpp) fill the segments.
#pragma once

#include "curve/trajectory.hpp"
#include "methods/keyframes.hpp"
#include "methods/options.hpp"
#include "methods/timeline_builder.hpp"

namespace qtraj {

// The size of a curve through `count` keys of the caller; false where it would exceed PTRDIFF_MAX.
bool trajectory_size(const Options& options, size_t count, CurveSize& size);

// Whether the options are complete and the input has the rates and tangents they need, and no others: ok, value (the
// frame), input_missing or input_unwanted.
Status check_settings(const Options& options, const KeyframeInput& input, Frame rate_frame);

// Builds in 8-byte aligned memory of the sizes above. Settings have been checked; the workspace is free afterwards.
Outcome build_trajectory(const Options& options, const KeyframeInput& input, Frame rate_frame, void* handle,
                         void* workspace, Trajectory** out);

}  // namespace qtraj
