#include "qtraj/guide.hpp"

namespace qtraj {

void build_guide(const double* knots, size_t count, uint64_t* first_candidate, double& scale, int32_t& steps) {
  const size_t segments = count - 1;
  // halves: the span may be as large as DBL_MAX
  scale = 0.5 * static_cast<double>(segments) / (0.5 * knots[segments] - 0.5 * knots[0]);
  const Guide guide = {first_candidate, knots[0], scale, 0};

  // before: first knot in bucket - 1 or later; behind: first knot past bucket + 1
  size_t before = 0, behind = 0, most_candidates = 1;
  for (size_t bucket = 0; bucket <= segments + 1; ++bucket) {
    while (before < segments && guide.bucket(knots[before]) + 1 < bucket) ++before;
    while (behind < segments && guide.bucket(knots[behind]) <= bucket + 1) ++behind;
    const size_t first = before > 0 ? before - 1 : 0;
    first_candidate[bucket] = first;
    if (behind - first > most_candidates) most_candidates = behind - first;
  }
  steps = 0;
  while ((size_t{1} << steps) < most_candidates) ++steps;
}

}  // namespace qtraj
