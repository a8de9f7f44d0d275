#include "curve/knot_lookup.hpp"

#include <algorithm>

namespace qtraj {
namespace {

// The first bucket at or after a position.
size_t bucket_from(double position) {
  const auto whole = static_cast<int64_t>(std::max(position, 0.0));
  return static_cast<size_t>(whole + (static_cast<double>(whole) < position ? 1 : 0));
}

}  // namespace

void build_guide(const double* knots, size_t count, uint64_t* first_candidate, double& scale, size_t& candidates) {
  const size_t segments = count - 1, entries = Guide::entries(count);
  // halved first: the span may be as large as DBL_MAX
  const double half_span = 0.5 * knots[segments] - 0.5 * knots[0];
  scale = 1.5 * static_cast<double>(segments) / half_span;
  const Guide guide = {first_candidate, knots[0], scale, 0};

  // The times of a bucket have positions within kReach of it: 1, and a rounding error of a few eps of the position.
  // Segments that end further before a bucket, or start further after it, are no candidates. The counting has no branch
  // that depends on the distance of the knots, because it would be mispredicted.
  constexpr double kReach = 1 + 0x1p-10;
  std::fill_n(first_candidate, entries, 0);
  for (size_t i = 1; i < segments; ++i) ++first_candidate[bucket_from(position_of(guide, knots[i]) + kReach)];
  for (size_t bucket = 1; bucket < entries; ++bucket) first_candidate[bucket] += first_candidate[bucket - 1];

  // a segment is the last candidate of the first bucket that it is a candidate of
  candidates = 1;
  for (size_t i = 1; i < segments; ++i) {
    const size_t first = first_candidate[bucket_from(position_of(guide, knots[i]) - kReach)];
    candidates = std::max(candidates, i + 1 - first);
  }
  // every bucket has this number of candidates, also near the end
  for (size_t bucket = entries; bucket-- > 0 && first_candidate[bucket] > segments - candidates;)
    first_candidate[bucket] = segments - candidates;
}

}  // namespace qtraj
