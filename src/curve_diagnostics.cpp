#include "qtraj/curve_diagnostics.hpp"

#include <cmath>

#include "curve_pieces.hpp"
#include "golden_section.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {
namespace {

Outcome integrate(const Trajectory& trajectory, Quantity quantity, double& result) {
  double sum = 0;
  const Outcome outcome =
      visit_pieces(trajectory, quantity, 1e-13, [&](const Integrand&, const Interval&, double integral) {
        sum += integral;
        return true;
      });
  if (outcome.status == Status::ok) result = sum;
  return outcome;
}

struct Peak {
  double value, time;
};

// Raises `peak` to the maximum of the curve over a piece.
bool search_piece(const SegmentCurve& curve, const Interval& piece, Peak& peak) {
  constexpr int kSamples = 12;
  double at[kSamples], values[kSamples];
  const double start = knots_of(curve.trajectory)[curve.segment];
  for (int k = 0; k < kSamples; ++k) {
    at[k] = k + 1 < kSamples ? piece.from + piece.width() * k / (kSamples - 1) : piece.to;
    if (!curve.magnitude(at[k], values[k])) return false;
    if (values[k] > peak.value) peak = {values[k], start + at[k]};
  }
  const auto value = [&](double elapsed, double& result) { return curve.magnitude(elapsed, result); };
  for (int k = 0; k < kSamples; ++k) {
    const int before = std::max(k - 1, 0), after = std::min(k + 1, kSamples - 1);
    const bool is_end = k == 0 || k == kSamples - 1;
    const bool is_maximum = values[k] >= values[before] && values[k] >= values[after];
    if ((!is_end && !is_maximum) || values[k] <= 0.25 * peak.value) continue;
    double best = peak.value, best_at = peak.time - start;
    if (!narrow_maximum({at[before], at[after]}, value, best, best_at)) return false;
    if (best > peak.value) peak = {best, start + best_at};
  }
  return true;
}

Outcome find_peak(const Trajectory& trajectory, Quantity quantity, Peak& peak) {
  peak = {0.0, knots_of(trajectory)[0]};
  return visit_pieces(trajectory, quantity, 1e-6, [&](const Integrand& integrand, const Interval& piece, double) {
    return search_piece(integrand.curve, piece, peak);
  });
}

// Whether rates can be turned and subtracted without overflow.
bool is_moderate(const SegmentMotion& motion) {
  constexpr double kLimit = 1e307;
  return largest_component(load(motion.omega)) <= kLimit && largest_component(load(motion.alpha)) <= kLimit;
}

}  // namespace

Outcome energy(const Trajectory& trajectory, double& result) { return integrate(trajectory, Quantity::alpha, result); }

Outcome total_angle(const Trajectory& trajectory, double& result) {
  return integrate(trajectory, Quantity::omega, result);
}

Outcome peak_rates(const Trajectory& trajectory, PeakRates& peaks) {
  Peak omega, alpha;
  Outcome outcome = find_peak(trajectory, Quantity::omega, omega);
  if (outcome.status == Status::ok) outcome = find_peak(trajectory, Quantity::alpha, alpha);
  if (outcome.status == Status::ok) peaks = {omega.value, omega.time, alpha.value, alpha.time};
  return outcome;
}

Outcome knot_jumps(const Trajectory& trajectory, Frame frame, double* omega_jump, double* alpha_jump) {
  const double* knots = knots_of(trajectory);
  const size_t last = trajectory.key_count - 1;
  Outcome outcome;
  for (size_t knot = 0; knot <= last; ++knot) {
    const bool inner = knot > 0 && knot < last;
    double jumps[2][3] = {};
    if (inner || trajectory.closed) {
      const size_t before = knot == 0 ? last - 1 : knot - 1, after = knot == last ? 0 : knot;
      SegmentMotion left, right;
      const bool finite = segment_motion(trajectory, before, knots[before + 1] - knots[before], left) &&
                          segment_motion(trajectory, after, 0.0, right) && is_moderate(left) && is_moderate(right);
      const auto in_frame = [&](const SegmentMotion& motion, const double(&v)[3]) -> Vector3 {
        return frame == Frame::world ? to_world(load(motion.q), load(v)) : load(v);
      };
      if (finite) {
        store(Vector3(in_frame(right, right.omega) - in_frame(left, left.omega)), jumps[0]);
        store(Vector3(in_frame(right, right.alpha) - in_frame(left, left.alpha)), jumps[1]);
      } else {
        for (auto& jump : jumps)
          for (double& component : jump) component = std::nan("");
        if (outcome.status == Status::ok) outcome = {Status::not_finite, knot};
      }
    }
    for (int k = 0; k < 3; ++k) {
      if (omega_jump) omega_jump[3 * knot + static_cast<size_t>(k)] = jumps[0][k];
      if (alpha_jump) alpha_jump[3 * knot + static_cast<size_t>(k)] = jumps[1][k];
    }
  }
  return outcome;
}

}  // namespace qtraj
