#include "qtraj/curve_diagnostics.hpp"

#include <cfloat>
#include <cmath>

#include "kernel/kernel.hpp"
#include "qtraj/quaternion.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {
namespace {

// Length of a vector of any magnitude.
double magnitude_of(const double (&v)[3]) {
  const Vector3 vector = load(v);
  const double largest = largest_component(vector);
  return largest > 0 ? largest * length(Vector3(vector / largest)) : 0.0;
}

// The speed or the size of the acceleration along one segment.
enum class Quantity { omega, alpha };
struct SegmentCurve {
  const Trajectory& trajectory;
  size_t segment;
  Quantity quantity;

  double h() const {
    const double* knots = knots_of(trajectory);
    return knots[segment + 1] - knots[segment];
  }
  bool magnitude(double elapsed, double& value) const {
    SegmentMotion motion;
    if (!segment_motion(trajectory, segment, elapsed, motion)) return false;
    value = magnitude_of(quantity == Quantity::omega ? motion.omega : motion.alpha);
    return true;
  }
};

// ---- Adaptive integration ----

// |omega| or |alpha|^2 over one segment.
struct Integrand {
  SegmentCurve curve;
  double rounding;  // of the magnitude

  bool operator()(double elapsed, double& value) const {
    if (!curve.magnitude(elapsed, value)) return false;
    if (curve.quantity == Quantity::omega) return true;
    if (value > 1e150) return false;
    value *= value;
    return true;
  }
  // What rounding can change of the integral over a piece.
  double noise(double width, double integral) const {
    if (curve.quantity == Quantity::omega) return width * rounding;
    return width * rounding * (2.0 * std::sqrt(std::abs(integral) / width) + rounding);
  }
};

struct Piece {
  double from, to;
  double width() const { return to - from; }
  double middle() const { return from + 0.5 * (to - from); }
};

// Gauss-Legendre rule of 12 points (Abramowitz and Stegun, table 25.4).
bool gauss(const Integrand& integrand, const Piece& piece, double& integral) {
  constexpr double kNodes[] = {0.12523340851146891547, 0.36783149899818019375, 0.58731795428661744730,
                               0.76990267419430468704, 0.90411725637047485668, 0.98156063424671925069};
  constexpr double kWeights[] = {0.24914704581340278500, 0.23349253653835480876, 0.20316742672306592175,
                                 0.16007832854334622633, 0.10693932599531843096, 0.04717533638651182719};
  const double half_width = 0.5 * piece.width();
  double sum = 0;
  for (int k = 0; k < 6; ++k) {
    double left, right;
    if (!integrand(piece.middle() - kNodes[k] * half_width, left)) return false;
    if (!integrand(piece.middle() + kNodes[k] * half_width, right)) return false;
    sum += kWeights[k] * (left + right);
  }
  integral = half_width * sum;
  return true;
}

// Halves a piece until its integral stays, and gives each final piece with its integral to `leaf`.
template <class Leaf>
bool bisect(const Integrand& integrand, const Piece& piece, double integral, double tolerance, int depth,
            const Leaf& leaf) {
  constexpr int kDeepest = 30;
  const Piece left = {piece.from, piece.middle()}, right = {piece.middle(), piece.to};
  double left_integral, right_integral;
  if (!gauss(integrand, left, left_integral) || !gauss(integrand, right, right_integral)) return false;
  const double finer = left_integral + right_integral;
  const double change = std::abs(integral - finer);
  if (change <= tolerance || change <= integrand.noise(piece.width(), integral) || depth == kDeepest)
    return leaf(piece, finer);
  return bisect(integrand, left, left_integral, tolerance, depth + 1, leaf) &&
         bisect(integrand, right, right_integral, tolerance, depth + 1, leaf);
}

// Visits the pieces of every segment, found to a tolerance relative to the largest segment's integral.
template <class Visit>
Outcome visit_pieces(const Trajectory& trajectory, Quantity quantity, double tolerance, const Visit& visit) {
  const size_t segments = trajectory.key_count - 1;
  const auto integrand_of = [&](size_t segment, Integrand& integrand, double& integral) {
    integrand.curve.segment = segment;
    const double h = integrand.curve.h();
    double speed = 0, value;
    const SegmentCurve speeds = {trajectory, segment, Quantity::omega};
    for (int k = 0; k <= 4; ++k) {
      if (!speeds.magnitude(0.25 * k * h, value)) return false;
      speed = std::max(speed, value);
    }
    constexpr double kRounding = 16.0 * DBL_EPSILON;
    integrand.rounding = kRounding * (quantity == Quantity::omega ? speed : speed / h);
    return gauss(integrand, {0.0, h}, integral);
  };

  double largest = 0, integral;
  Integrand integrand = {{trajectory, 0, quantity}, 0};
  for (size_t i = 0; i < segments; ++i) {
    if (!integrand_of(i, integrand, integral)) return {Status::not_finite, i};
    largest = std::max(largest, integral);
  }
  for (size_t i = 0; i < segments; ++i) {
    integrand_of(i, integrand, integral);
    const auto leaf = [&](const Piece& piece, double finer) { return visit(integrand, piece, finer); };
    if (!bisect(integrand, {0.0, integrand.curve.h()}, integral, tolerance * largest, 0, leaf))
      return {Status::not_finite, i};
  }
  return {};
}

Outcome integrate(const Trajectory& trajectory, Quantity quantity, double& result) {
  double sum = 0;
  const Outcome outcome =
      visit_pieces(trajectory, quantity, 1e-13, [&](const Integrand&, const Piece&, double integral) {
        sum += integral;
        return true;
      });
  if (outcome.status == Status::ok) result = sum;
  return outcome;
}

// ---- Maxima ----

struct Peak {
  double value, time;
};

// Golden sections to 1e-9 of the interval; `value(x, y)` is false where the curve overflows.
template <class Value>
bool narrow_maximum(Piece interval, const Value& value, double& best, double& best_at) {
  constexpr double kGolden = 0.6180339887498949;
  double a = interval.to - kGolden * interval.width(), b = interval.from + kGolden * interval.width(), at_a, at_b;
  if (!value(a, at_a) || !value(b, at_b)) return false;
  for (int section = 0; section < 43; ++section) {
    if (at_a > at_b) {
      interval.to = b;
      b = a;
      at_b = at_a;
      a = interval.to - kGolden * interval.width();
      if (!value(a, at_a)) return false;
    } else {
      interval.from = a;
      a = b;
      at_a = at_b;
      b = interval.from + kGolden * interval.width();
      if (!value(b, at_b)) return false;
    }
    const bool first = at_a > at_b;
    if ((first ? at_a : at_b) > best) {
      best = first ? at_a : at_b;
      best_at = first ? a : b;
    }
  }
  return true;
}

// Raises `peak` to the maximum of the curve over a piece.
bool search_piece(const SegmentCurve& curve, const Piece& piece, Peak& peak) {
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
  return visit_pieces(trajectory, quantity, 1e-6, [&](const Integrand& integrand, const Piece& piece, double) {
    return search_piece(integrand.curve, piece, peak);
  });
}

// Whether rates can be turned and subtracted without overflow.
bool is_moderate(const SegmentMotion& motion) {
  constexpr double kLimit = 1e307;
  return largest_component(load(motion.omega)) <= kLimit && largest_component(load(motion.alpha)) <= kLimit;
}

// ---- Norms ----

template <size_t Degree>
double norm_at(const NormalizedSegment<Degree>& segment, double s) {
  Quaternion p = load(segment.c[Degree]);
  for (size_t term = Degree; term-- > 0;) p = s * p + load(segment.c[term]);
  return length(p);
}

template <size_t Degree>
LeastNorm least_norm_of(const Trajectory& trajectory) {
  const double* knots = knots_of(trajectory);
  const auto* segments = reinterpret_cast<const NormalizedSegment<Degree>*>(reinterpret_cast<const char*>(&trajectory) +
                                                                            trajectory.segments_offset);
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
      const Piece around = {position(std::max(k - 1, 0)), position(std::min(k + 1, kIntervals))};
      if (value >= -norm_at(segments[i], around.from) && value >= -norm_at(segments[i], around.to))
        narrow_maximum(around, negated, best, best_s);
    }
    const double h = knots[i + 1] - knots[i];
    if (best_s >= -1.0) least = {-best, knots[i] + 0.5 * (best_s + 1.0) * h};
  }
  return least;
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

LeastNorm least_norm(const Trajectory& trajectory) {
  if (trajectory.kind == SegmentKind::normalized) return least_norm_of<1>(trajectory);
  if (trajectory.kind == SegmentKind::normalized_quintic) return least_norm_of<5>(trajectory);
  return {1.0, knots_of(trajectory)[0]};
}

}  // namespace qtraj
