// Which segment a time belongs to, without a search over all knots: the span of the knots is cut into three times
// as many equal buckets as there are segments, and each bucket tells the first segment that a time in it can belong to.
// A few halving steps, the same number for every time, do the rest. DoubleDouble for any spacing of the knots; uneven
// spacing costs steps, never more than log2 of the number of segments, rounded up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "curve/trajectory.hpp"

namespace qtraj {

struct Guide {
  const uint64_t* first_candidate;  // [entries], one per bucket
  double start;                     // of the knots
  double scale;                     // buckets per second
  size_t candidates;                // of each bucket, at least 1; all are segments

  // Three for each segment, so that the two that a time may come out in span less than one segment of even knots; and
  // some for positions at the end.
  static constexpr size_t entries(size_t knots) { return 3 * knots; }

  // Time within the knots in units of a bucket.
  double position(double time) const { return (time - start) * scale; }

  // One of the two integers beside the position, as the rounding mode has it. Adding 2^52 rounds to an integer and
  // leaves it in the low bits.
  static constexpr double kShift = 0x1p52;
  static constexpr int64_t kBucketBits = (int64_t{1} << 52) - 1;
  uint64_t bucket(double time) const {
    const double shifted = position(time) + kShift;
    uint64_t bits;
    std::memcpy(&bits, &shifted, sizeof bits);
    return bits & kBucketBits;
  }
};

// Fills first_candidate [entries] for knots [count], tells scale and candidates. They hold in every rounding mode.
void build_guide(const double* knots, size_t count, uint64_t* first_candidate, double& scale, size_t& candidates);

// Knots of a trajectory with their guide.
struct KnotIndex {
  const double* knots;
  size_t segments;
  Guide guide;
};

static inline KnotIndex knot_index(const Trajectory& trajectory) {
  return {knots_of(trajectory),
          trajectory.key_count - 1,
          {at_offset<uint64_t>(trajectory, trajectory.guide_offset), trajectory.before.knot, trajectory.guide_scale,
           trajectory.guide_candidates}};
}

// Segment of a time within the knots: the one that starts at or last before it; at the last knot the last one.
// Looked for first at the guess, which may be any number, and after it.
static inline size_t find_segment(const KnotIndex& index, double time, size_t guess) {
  const double* knots = index.knots;
  if (guess < index.segments && knots[guess] <= time) {
    if (time < knots[guess + 1]) return guess;
    if (guess + 1 < index.segments && time < knots[guess + 2]) return guess + 1;
  }
  size_t low = index.guide.first_candidate[index.guide.bucket(time)];
  for (size_t left = index.guide.candidates; left > 1; left -= left / 2) {
    const size_t middle = low + left / 2;
    low = knots[middle] <= time ? middle : low;
  }
  return low;
}

}  // namespace qtraj
