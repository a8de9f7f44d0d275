// The lookup of a time: which segment it belongs to. All sampling looks its times up here, one by one by find_segment,
// vectors of scattered times by the same steps (find_segments in find_segments.hpp).
//
// A guide replaces the binary search over all knots: their span is cut into three times as many equal buckets as there
// are segments, and each bucket tells the first segment that a time in it can belong to. A few halving steps without
// branches, the same number for every time, do the rest. The result is exact for any spacing of the knots; uneven
// spacing costs steps, never more than log2 of the number of segments, rounded up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "curve/timeline.hpp"

namespace qtraj {

struct Guide {
  const uint64_t* first_candidate;  // [entries], one per bucket
  double start;                     // of the knots
  double scale;                     // buckets per second
  size_t candidates;                // segments from the first candidate on, the same number for all buckets, at least 1

  // Three buckets per segment: rounding may put a time into either of two neighbours, and these together then span less
  // than one segment of even knots. The three of the last knot are for positions at the end.
  static constexpr size_t entries(size_t knots) { return 3 * knots; }

  // Adding 2^52 to a position rounds it to an integer, as the rounding mode has it, and leaves that integer in the low
  // bits of the mantissa.
  static constexpr double kShift = 0x1p52;
  static constexpr int64_t kBucketBits = (int64_t{1} << 52) - 1;
};

// The position of a time within the knots, in units of a bucket.
static inline double position_of(const Guide& guide, double time) { return (time - guide.start) * guide.scale; }

// The position rounded to one of the two integers beside it.
static inline uint64_t bucket_of(const Guide& guide, double time) {
  const double shifted = position_of(guide, time) + Guide::kShift;
  uint64_t bits;
  std::memcpy(&bits, &shifted, sizeof bits);
  return bits & Guide::kBucketBits;
}

// Fills first_candidate [entries] for knots [count] and sets scale and candidates. They hold in every rounding mode.
void build_guide(const double* knots, size_t count, uint64_t* first_candidate, double& scale, size_t& candidates);

// Knots with their guide.
struct KnotIndex {
  const double* knots;
  size_t segments;
  Guide guide;
};

static inline KnotIndex knot_index(const Timeline& timeline) {
  return {knots_of(timeline),
          timeline.key_count - 1,
          {at_offset<uint64_t>(timeline, timeline.guide_offset), timeline.before.knot, timeline.guide_scale,
           timeline.guide_candidates}};
}

// The segment of a time within the knots: the last one that starts at or before it; at the last knot the last segment.
// The guess, any number, and the segment after it are tried first.
static inline size_t find_segment(const KnotIndex& index, double time, size_t guess) {
  const double* knots = index.knots;
  if (guess < index.segments && knots[guess] <= time) {
    if (time < knots[guess + 1]) return guess;
    if (guess + 1 < index.segments && time < knots[guess + 2]) return guess + 1;
  }
  size_t low = index.guide.first_candidate[bucket_of(index.guide, time)];
  for (size_t left = index.guide.candidates; left > 1; left -= left / 2) {
    const size_t middle = low + left / 2;
    low = knots[middle] <= time ? middle : low;
  }
  return low;
}

}  // namespace qtraj
