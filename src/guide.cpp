#include "qtraj/guide.hpp"

#include <algorithm>

namespace qtraj {

void build_guide(const double* knots, size_t count, uint64_t* first_candidate, double& scale, size_t& candidates) {
  const size_t segments = count - 1, entries = Guide::entries(count);
  // halves: the span may be as large as DBL_MAX
  const double half_span = 0.5 * knots[segments] - 0.5 * knots[0];
  scale = 1.5 * static_cast<double>(segments) / half_span;
  const Guide guide = {first_candidate, knots[0], scale, 0};

  // a bucket's times lie within 1 of it, and what rounding does to a position, a few eps of it
  constexpr double kReach = 1 + 0x1p-10;
  size_t first = 0, past = 0;  // segments
  candidates = 1;
  for (size_t bucket = 0; bucket < entries; ++bucket) {
    const double middle = static_cast<double>(bucket);
    while (first + 1 < segments && guide.position(knots[first + 1]) <= middle - kReach) ++first;
    while (past < segments && guide.position(knots[past]) <= middle + kReach) ++past;
    first_candidate[bucket] = first;
    candidates = std::max(candidates, past - first);
  }
  // so many from each first one on
  for (size_t bucket = 0; bucket < entries; ++bucket)
    first_candidate[bucket] = std::min<uint64_t>(first_candidate[bucket], segments - candidates);
}

}  // namespace qtraj
