#include "diagnostics/rate_mismatch.hpp"

#include <cfloat>

#include "math/so3.hpp"
#include "targets/sampling.hpp"

namespace qtraj {
namespace {

// p at the end of a segment minus p at its start.
template <size_t Degree>
Vector3 change_of_p(const Trajectory& trajectory, size_t segment) {
  const auto& record = segments_of<RotationVectorSegment<Degree>>(trajectory)[segment];
  Vector3 change = Vector3::Zero();
  for (size_t term = 1; term <= Degree; term += 2) change += 2.0 * load(record.c[term]);
  return change;
}

// Rotation vector of a step in the body frame at its first key. Where the segment is one of rotation vectors about an
// orientation of the step itself, both ends of p lie along it, and their difference has its turns; the rotation vectors
// of a LOG_SPLINE start elsewhere, and its steps, like those of all other segments, are the shorter turns.
Vector3 step_of(const Trajectory& trajectory, size_t segment) {
  const bool in_one_chart = trajectory.method == Method{QTRAJ_LOG_SPLINE};
  if (trajectory.kind == SegmentKind::rotation_vector && !in_one_chart)
    return 2.0 * change_of_p<3>(trajectory, segment);
  if (trajectory.kind == SegmentKind::rotation_vector_quintic) return 2.0 * change_of_p<5>(trajectory, segment);
  const auto* keys = keys_of(trajectory);
  const Quaternion from = load(keys[segment]), to = load(keys[segment + 1]);
  return 2.0 * relative_log({from, Quaternion::Zero()}, {to, Quaternion::Zero()});
}

}  // namespace

Outcome rate_mismatch(const Trajectory& trajectory, RateMismatch& worst) {
  worst = {0.0, 0};
  const double* knots = knots_of(trajectory.timeline);
  for (size_t i = 0; i + 1 < trajectory.timeline.key_count; ++i) {
    const double h = knots[i + 1] - knots[i];
    SegmentMotion start, end;
    if (!segment_motion(trajectory, i, 0.0, true, false, start) || !segment_motion(trajectory, i, h, true, false, end))
      return {Status::not_finite, i};
    const Vector3 at_start = load(start.omega), at_end = load(end.omega);
    constexpr double kLimit = 1e150;
    if (std::max(largest_component(at_start), largest_component(at_end)) > kLimit / std::max(h, 1.0))
      return {Status::not_finite, i};
    const Vector3 step = step_of(trajectory, i);
    const Quaternion half = exp_map(Vector3(0.25 * step));
    const Vector3 from_rates = 0.5 * h * (to_body(half, at_start) + to_world(half, at_end));
    const double angle = length(Vector3(from_rates - step));
    if (angle > worst.angle) worst = {angle, i};
  }
  return {};
}

}  // namespace qtraj
