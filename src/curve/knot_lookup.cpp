#include "curve/knot_lookup.hpp"

#include <algorithm>

namespace qtraj {
namespace {

// The first bucket after a position that is above -1. Truncation is the same in every rounding mode.
size_t bucket_after(double position) { return static_cast<size_t>(static_cast<int64_t>(position + 1.0)); }

// Fills buckets from the first to the last. Some are written ahead of need, so that knots at ordinary distances take no
// branch that depends on these: it would be mispredicted.
struct BucketFiller {
  uint64_t* next;
  uint64_t* const end;

  void fill_to(uint64_t* past, uint64_t candidate) {
    constexpr ptrdiff_t kAhead = 8;
    uint64_t* at = next;
    if (end - at >= kAhead) {
      for (ptrdiff_t k = 0; k < kAhead; ++k) at[k] = candidate;
      at += kAhead;
    }
    for (; at < past; ++at) *at = candidate;
    next = past;
  }
};

}  // namespace

void build_guide(const double* knots, size_t count, uint64_t* first_candidate, double& scale, size_t& candidates) {
  const size_t segments = count - 1, entries = Guide::entries(count);
  // halved first: the span may be as large as DBL_MAX
  const double half_span = 0.5 * knots[segments] - 0.5 * knots[0];
  scale = 1.5 * static_cast<double>(segments) / half_span;
  const Guide guide = {first_candidate, knots[0], scale, 0};

  // The times of a bucket have positions within kReach of it: 1, and a rounding error of a few eps of the position.
  // Segments that end further before a bucket, or start further after it, are no candidates. A segment is the last
  // candidate of the first bucket that it is a candidate of; of the buckets from there on those are filled that the
  // segments before it end in.
  constexpr double kReach = 1 + 0x1p-10;
  size_t most = 1;
  BucketFiller filler = {first_candidate, first_candidate + entries};
  for (size_t i = 1; i < segments; ++i) {
    const double position = position_of(guide, knots[i]);
    filler.fill_to(first_candidate + bucket_after(position + kReach), i - 1);
    most = std::max(most, i + 1 - first_candidate[bucket_after(std::max(position - kReach, -1.0))]);
  }
  filler.fill_to(first_candidate + entries, segments - 1);
  candidates = most;
  // every bucket has this number of candidates, also near the end
  for (size_t bucket = entries; bucket-- > 0 && first_candidate[bucket] > segments - candidates;)
    first_candidate[bucket] = segments - candidates;
}

}  // namespace qtraj
