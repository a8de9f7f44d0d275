#include "diagnostics/curve.hpp"

#include <cfloat>
#include <cmath>

#include "curve/unnormalized.hpp"
#include "diagnostics/golden_section.hpp"
#include "math/so3.hpp"
#include "targets/sampling.hpp"

namespace qtraj {
namespace {

// The jump of a rate at a knot, right minus left, in a frame; false where it could overflow on the way.
bool jump(const SegmentMotion& left, const Vector3& left_rate, const SegmentMotion& right, const Vector3& right_rate,
          Frame frame, double* out) {
  constexpr double kLimit = 1e307;
  if (largest_component(left_rate) > kLimit || largest_component(right_rate) > kLimit) return false;
  const auto in_frame = [&](const SegmentMotion& motion, const Vector3& rate) -> Vector3 {
    return frame == Frame::world ? to_world(load(motion.q), rate) : rate;
  };
  const Vector3 difference = in_frame(right, right_rate) - in_frame(left, left_rate);
  for (int k = 0; k < 3; ++k) out[k] = difference[k];
  return true;
}

// The jumps between two segments; outputs may be null.
bool jumps_between(const Trajectory& trajectory, size_t before, size_t after, Frame frame, double* omega_jump,
                   double* alpha_jump) {
  const double* knots = knots_of(trajectory.timeline);
  const bool omega = omega_jump != nullptr, alpha = alpha_jump != nullptr;
  SegmentMotion left, right;
  return segment_motion(trajectory, before, knots[before + 1] - knots[before], omega, alpha, left) &&
         segment_motion(trajectory, after, 0.0, omega, alpha, right) &&
         (!omega || jump(left, load(left.omega), right, load(right.omega), frame, omega_jump)) &&
         (!alpha || jump(left, load(left.alpha), right, load(right.alpha), frame, alpha_jump));
}

void fill(double* row, double value) {
  for (int k = 0; row && k < 3; ++k) row[k] = value;
}

}  // namespace

Outcome curve_jumps(const Trajectory& trajectory, Frame frame, double* omega_jump, double* alpha_jump) {
  const size_t last = trajectory.timeline.key_count - 1;
  Outcome outcome;
  for (size_t knot = 0; knot <= last; ++knot) {
    double* omega_row = omega_jump ? omega_jump + 3 * knot : nullptr;
    double* alpha_row = alpha_jump ? alpha_jump + 3 * knot : nullptr;
    fill(omega_row, 0.0);
    fill(alpha_row, 0.0);
    const bool inner = knot > 0 && knot < last;
    if (!inner && !trajectory.closed) continue;
    const size_t before = knot == 0 ? last - 1 : knot - 1, after = knot == last ? 0 : knot;
    if (jumps_between(trajectory, before, after, frame, omega_row, alpha_row)) continue;
    fill(omega_row, std::nan(""));
    fill(alpha_row, std::nan(""));
    if (outcome.status == Status::ok) outcome = {Status::not_finite, knot};
  }
  return outcome;
}

namespace {

// |P| at s. Where P goes through unit keys its norm at the ends is 1, which large coefficients that cancel would miss.
template <size_t Degree>
double norm_at(const NormalizedSegment<Degree>& segment, double s, bool unit_keys) {
  if (unit_keys && (s <= -1.0 || s >= 1.0)) return 1.0;
  Quaternion p = load(segment.c[Degree]);
  for (size_t term = Degree; term-- > 0;) p = s * p + load(segment.c[term]);
  return length(p);
}

template <size_t Degree>
LeastNorm least_norm_of(const Trajectory& trajectory) {
  const double* knots = knots_of(trajectory.timeline);
  const auto* segments = segments_of<NormalizedSegment<Degree>>(trajectory);
  // |p|^2 has at most `Degree` minima in a segment; samples this close tell them apart
  constexpr int kIntervals = 32;
  const bool unit_keys = has_unit_keys(trajectory);
  LeastNorm least = {norm_at(segments[0], -1.0, unit_keys), knots[0]};
  for (size_t i = 0; i + 1 < trajectory.timeline.key_count; ++i) {
    const auto position = [](int k) { return -1.0 + 2.0 * k / kIntervals; };
    const auto norm = [&](double s) { return norm_at(segments[i], s, unit_keys); };
    const auto negated = [&](double s, double& value) {
      value = -norm(s);
      return true;
    };
    const double rounding = 4.0 * DBL_EPSILON * std::max(norm(-1.0), norm(1.0));
    double best = -least.norm, best_s = -2.0;
    for (int k = 0; k <= kIntervals; ++k) {
      const double value = -norm(position(k));
      if (value > best) {
        best = value;
        best_s = position(k);
      }
      const Interval around = {position(std::max(k - 1, 0)), position(std::min(k + 1, kIntervals))};
      if (value >= -norm(around.from) && value >= -norm(around.to)) {
        double refined = best, refined_s = best_s;
        narrow_maximum(around, negated, refined, refined_s);
        // a minimum beside a sample that is lower by rounding errors only does not count
        if (refined > best + rounding) {
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
  return {1.0, knots_of(trajectory.timeline)[0]};
}

}  // namespace qtraj
