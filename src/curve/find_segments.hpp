// The lookup of many times at once, in vectors: what knot_lookup.hpp is for one.
#pragma once

#include "curve/knot_lookup.hpp"
#include "simd/transpose.hpp"

namespace qtraj {
namespace {

// find_segment for times within the knots, in whole vectors. Each halving step is done for all times before the next
// step: the gathers of one search depend on each other, and search after search would be bound by their latency.
[[maybe_unused]] QTRAJ_NOINLINE void find_segments(const KnotIndex& index, const double* times, size_t count,
                                                   int64_t* found) {
  const IndexTag tag;
  const Wide<double> start(index.guide.start), scale(index.guide.scale), shift(Guide::kShift);
  const auto* first_candidate = reinterpret_cast<const int64_t*>(index.guide.first_candidate);
  for (size_t i = 0; i < count; i += Wide<double>::kLanes) {
    const Wide<double> shifted = (Wide<double>::load(times + i) - start) * scale + shift;
    const Indices bucket = hn::And(hn::BitCast(tag, shifted.lanes), hn::Set(tag, Guide::kBucketBits));
    hn::StoreU(gather(first_candidate, bucket), tag, found + i);
  }
  for (size_t left = index.guide.candidates; left > 1; left -= left / 2) {
    const Indices half = hn::Set(tag, static_cast<int64_t>(left / 2));
    for (size_t i = 0; i < count; i += Wide<double>::kLanes) {
      const Indices low = hn::LoadU(tag, found + i), middle = hn::Add(low, half);
      const WideMask<double> is_past = gather(index.knots, middle) <= Wide<double>::load(times + i);
      hn::StoreU(hn::IfThenElse(hn::RebindMask(tag, is_past.lanes), middle, low), tag, found + i);
    }
  }
}

}  // namespace
}  // namespace qtraj
