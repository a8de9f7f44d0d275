#include "qtraj/curve_diagnostics.hpp"

#include <cfloat>
#include <cmath>

#include "curve_pieces.hpp"
#include "golden_section.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {
namespace {

double shortest_step(const Trajectory& trajectory) {
  const double* knots = knots_of(trajectory);
  double shortest = DBL_MAX;
  for (size_t i = 0; i + 1 < trajectory.key_count; ++i) shortest = std::min(shortest, knots[i + 1] - knots[i]);
  return shortest;
}

// Sum of the integrals of (size sqrt(h))^2 or of size h over u.
Outcome integrate(const Trajectory& trajectory, Quantity quantity, double& result) {
  const bool squared = quantity == Quantity::alpha;
  // over very short segments squares pass the range of double that their integral is still in
  const double scale = shortest_step(trajectory) < 1e-50 ? 0x1p-40 : 1.0;
  const auto integrand_of = [&](size_t segment) {
    const SegmentCurve curve = {trajectory, segment, quantity};
    return Integrand{curve, squared ? scale * std::sqrt(curve.h()) : curve.h(), squared};
  };
  double sum = 0;
  const Outcome outcome =
      visit_pieces(trajectory, 1e-13, integrand_of, [&](const Integrand&, const Interval&, double integral) {
        sum += integral;
        return true;
      });
  if (outcome.status != Status::ok) return outcome;
  if (squared && sum > DBL_MAX * scale * scale) return {Status::not_finite, kNoIndex};
  result = squared ? sum / (scale * scale) : sum;
  return {};
}

struct Peak {
  double value, time;
};

// Raises `peak` to the maximum of the curve over a piece.
bool search_piece(const SegmentCurve& curve, const Interval& piece, Peak& peak) {
  constexpr int kSamples = 12;
  double at[kSamples], values[kSamples];
  for (int k = 0; k < kSamples; ++k) {
    at[k] = k + 1 < kSamples ? piece.from + piece.width() * k / (kSamples - 1) : piece.to;
    if (!curve.size(at[k], values[k])) return false;
    if (values[k] > peak.value) peak = {values[k], curve.time(at[k])};
  }
  const auto size = [&](double u, double& result) { return curve.size(u, result); };
  for (int k = 0; k < kSamples; ++k) {
    const int before = std::max(k - 1, 0), after = std::min(k + 1, kSamples - 1);
    const bool is_end = k == 0 || k == kSamples - 1;
    const bool is_maximum = values[k] >= values[before] && values[k] >= values[after];
    if ((!is_end && !is_maximum) || values[k] <= 0.25 * peak.value) continue;
    double best = peak.value, best_at = 0;
    if (!narrow_maximum({at[before], at[after]}, size, best, best_at)) return false;
    if (best > peak.value) peak = {best, curve.time(best_at)};
  }
  return true;
}

Outcome find_peak(const Trajectory& trajectory, Quantity quantity, Peak& peak) {
  peak = {0.0, knots_of(trajectory)[0]};
  const auto integrand_of = [&](size_t segment) { return Integrand{{trajectory, segment, quantity}, 1.0, false}; };
  return visit_pieces(trajectory, 1e-6, integrand_of, [&](const Integrand& integrand, const Interval& piece, double) {
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
