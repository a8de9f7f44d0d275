#include "diagnostics/least_norm.hpp"

#include <cfloat>

#include "diagnostics/golden_section.hpp"
#include "math/quaternion.hpp"

namespace qtraj {
namespace {

template <size_t Degree>
double norm_at(const NormalizedSegment<Degree>& segment, double s) {
  Quaternion p = load(segment.c[Degree]);
  for (size_t term = Degree; term-- > 0;) p = s * p + load(segment.c[term]);
  return length(p);
}

template <size_t Degree>
LeastNorm least_norm_of(const Trajectory& trajectory) {
  const double* knots = knots_of(trajectory);
  const auto* segments = segments_of<NormalizedSegment<Degree>>(trajectory);
  // |p|^2 has at most `Degree` minima in a segment; samples this close tell them apart
  constexpr int kIntervals = 32;
  LeastNorm least = {norm_at(segments[0], -1.0), knots[0]};
  for (size_t i = 0; i + 1 < trajectory.key_count; ++i) {
    const auto position = [](int k) { return -1.0 + 2.0 * k / kIntervals; };
    const auto negated = [&](double s, double& value) {
      value = -norm_at(segments[i], s);
      return true;
    };
    double best = -least.norm, best_s = -2.0;
    for (int k = 0; k <= kIntervals; ++k) {
      const double value = -norm_at(segments[i], position(k));
      if (value > best) {
        best = value;
        best_s = position(k);
      }
      const Interval around = {position(std::max(k - 1, 0)), position(std::min(k + 1, kIntervals))};
      if (value >= -norm_at(segments[i], around.from) && value >= -norm_at(segments[i], around.to)) {
        double refined = best, refined_s = best_s;
        narrow_maximum(around, negated, refined, refined_s);
        // what rounding finds beside a sample is no minimum
        if (refined > best + 4.0 * DBL_EPSILON) {
          best = refined;
          best_s = refined_s;
        }
      }
    }
    const double h = knots[i + 1] - knots[i];
    if (best_s >= -1.0) least = {-best, knots[i] + 0.5 * (best_s + 1.0) * h};
  }
  return least;
}

}  // namespace

LeastNorm least_norm(const Trajectory& trajectory) {
  if (trajectory.kind == SegmentKind::normalized) return least_norm_of<1>(trajectory);
  if (trajectory.kind == SegmentKind::normalized_quintic) return least_norm_of<5>(trajectory);
  return {1.0, knots_of(trajectory)[0]};
}

}  // namespace qtraj
