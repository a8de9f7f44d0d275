// The time axis of a curve from its knots and options: what orientation curves and vector curves share.
#pragma once

#include "curve/knot_lookup.hpp"
#include "methods/options.hpp"

namespace qtraj {

// Bytes of a handle and of the constructor's working space.
struct CurveSize {
  size_t handle, workspace;

  size_t all() const { return handle + workspace; }
};

// Bytes that the knots and their guide take, for each key.
constexpr size_t kKnotBytes = sizeof(double) + Guide::entries(1) * sizeof(uint64_t);

// Says where in the block of a curve its knots and, behind them, their guide lie: `offset` bytes from the timeline.
void place_knots(size_t count, size_t offset, Timeline& timeline);

// Fills the guide and all else of a timeline whose knots are there: of a curve with these options, which may hold each
// key until the next.
void build_timeline(const Options& options, bool holds_keys, Timeline& timeline);

}  // namespace qtraj
