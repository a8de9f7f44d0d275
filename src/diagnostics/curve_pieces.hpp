// The size of a curve's rates along its segments, and adaptive cuts of the segments into pieces over which it is
// smooth.
#pragma once

#include <cfloat>
#include <cmath>

#include "curve/trajectory.hpp"
#include "diagnostics/golden_section.hpp"
#include "math/quaternion.hpp"
#include "targets/sampling.hpp"

namespace qtraj {

enum class Quantity { omega, alpha };

// |omega| or |alpha| along one segment, as a function of u = 0 ... 1.
struct SegmentCurve {
  const Trajectory& trajectory;
  size_t segment;
  Quantity quantity;

  double h() const {
    const double* knots = knots_of(trajectory);
    return knots[segment + 1] - knots[segment];
  }
  double time(double u) const {
    const double* knots = knots_of(trajectory);
    return u < 1.0 ? knots[segment] + u * h() : knots[segment + 1];
  }

  // False where it overflows.
  bool size(double u, double& value) const {
    SegmentMotion motion;
    const bool is_omega = quantity == Quantity::omega;
    if (!segment_motion(trajectory, segment, u * h(), is_omega, !is_omega, motion)) return false;
    const Vector3 rate = load(is_omega ? motion.omega : motion.alpha);
    const double largest = largest_component(rate);
    if (largest > 0.5 * DBL_MAX) return false;
    value = largest > 0 ? largest * length(Vector3(rate / largest)) : 0.0;
    return true;
  }
};

// What is integrated over u: the size times a factor, or the square of that.
struct Integrand {
  SegmentCurve curve;
  double factor;
  bool squared;
  double rounding = 0;  // rounding error of size times factor

  bool operator()(double u, double& value) const {
    if (!curve.size(u, value)) return false;
    constexpr double kLimit = 1e150;
    if (squared && value > kLimit / std::max(factor, DBL_MIN)) return false;
    value *= factor;
    if (squared) value *= value;
    return true;
  }
  // How much rounding errors can change the integral over a piece.
  double noise(double width, double integral) const {
    if (!squared) return width * rounding;
    return width * rounding * (2.0 * std::sqrt(std::abs(integral) / width) + rounding);
  }
};

// Gauss-Legendre rule of 12 points (Abramowitz and Stegun, table 25.4).
inline Status gauss(const Integrand& integrand, const Interval& piece, double& integral) {
  constexpr double kNodes[] = {0.12523340851146891547, 0.36783149899818019375, 0.58731795428661744730,
                               0.76990267419430468704, 0.90411725637047485668, 0.98156063424671925069};
  constexpr double kWeights[] = {0.24914704581340278500, 0.23349253653835480876, 0.20316742672306592175,
                                 0.16007832854334622633, 0.10693932599531843096, 0.04717533638651182719};
  const double half_width = 0.5 * piece.width();
  double sum = 0;
  for (int k = 0; k < 6; ++k) {
    double left, right;
    if (!integrand(piece.middle() - kNodes[k] * half_width, left)) return Status::not_finite;
    if (!integrand(piece.middle() + kNodes[k] * half_width, right)) return Status::not_finite;
    sum += 0.5 * kWeights[k] * left + 0.5 * kWeights[k] * right;  // the mean: the sum itself could overflow
  }
  integral = piece.width() * sum;
  return Status::ok;
}

// How finely to cut: pieces are halved until their integral changes by less than `tolerance` of the largest part of the
// curve so far.
struct Cutting {
  double tolerance;
  double largest_part;
  int cuts_left;
};

// Passes each final piece with its integral to `leaf`. no_convergence where the cuts run out: a segment of 1e5 turns,
// or a quaternion quintic next to the zero of its norm, where the curve is rounding noise.
template <class Leaf>
Status bisect(const Integrand& integrand, const Interval& piece, double integral, int depth, Cutting& cutting,
              const Leaf& leaf) {
  constexpr int kDeepest = 30;
  const Interval left = {piece.from, piece.middle()}, right = {piece.middle(), piece.to};
  double left_integral, right_integral;
  if (gauss(integrand, left, left_integral) != Status::ok || gauss(integrand, right, right_integral) != Status::ok)
    return Status::not_finite;
  const double finer = left_integral + right_integral;
  cutting.largest_part = std::max(cutting.largest_part, finer);
  const double change = std::abs(integral - finer);
  const bool fine =
      change <= cutting.tolerance * cutting.largest_part || change <= integrand.noise(piece.width(), integral);
  if (fine || depth == kDeepest) return leaf(piece, finer) ? Status::ok : Status::not_finite;
  if (cutting.cuts_left-- == 0) return Status::no_convergence;
  const Status status = bisect(integrand, left, left_integral, depth + 1, cutting, leaf);
  return status != Status::ok ? status : bisect(integrand, right, right_integral, depth + 1, cutting, leaf);
}

// Sets the rounding error of an integrand: 16 eps of the speed, for accelerations over the length of the segment.
inline bool set_rounding(Integrand& integrand) {
  SegmentCurve speeds = integrand.curve;
  speeds.quantity = Quantity::omega;
  double speed = 0, value;
  for (int k = 0; k <= 4; ++k) {
    if (!speeds.size(0.25 * k, value)) return false;
    speed = std::max(speed, value);
  }
  constexpr double kRounding = 16.0 * DBL_EPSILON, kLimit = 1e150;
  const double rate =
      integrand.curve.quantity == Quantity::omega ? integrand.factor : integrand.factor / integrand.curve.h();
  const double size = kRounding * speed;
  integrand.rounding = size > kLimit / std::max(rate, 1e-150) ? kLimit : size * rate;
  return true;
}

// Visits the pieces of every segment. `integrand_of(segment)` makes the integrand; `visit(integrand, piece, integral)`
// gets its pieces in u. not_finite with the segment's index where the curve overflows, no_convergence as in bisect.
template <class IntegrandOf, class Visit>
Outcome visit_pieces(const Trajectory& trajectory, double tolerance, const IntegrandOf& integrand_of,
                     const Visit& visit) {
  const size_t segments = trajectory.key_count - 1;
  constexpr Interval kWhole = {0.0, 1.0};
  constexpr int kCutsPerSegment = 100000;  // a cusp or a spike takes some 60
  Cutting cutting = {tolerance, 0.0, 0};
  double integral;
  for (size_t i = 0; i < segments; ++i) {
    if (gauss(integrand_of(i), kWhole, integral) != Status::ok) return {Status::not_finite, i};
    cutting.largest_part = std::max(cutting.largest_part, integral);
  }
  for (size_t i = 0; i < segments; ++i) {
    Integrand integrand = integrand_of(i);
    const auto leaf = [&](const Interval& piece, double finer) { return visit(integrand, piece, finer); };
    if (!set_rounding(integrand) || gauss(integrand, kWhole, integral) != Status::ok) return {Status::not_finite, i};
    cutting.cuts_left = kCutsPerSegment;
    const Status status = bisect(integrand, kWhole, integral, 0, cutting, leaf);
    if (status != Status::ok) return {status, i};
  }
  return {};
}

}  // namespace qtraj
