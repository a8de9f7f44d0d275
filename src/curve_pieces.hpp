// The magnitude of a curve's rates along its segments, and segments cut into pieces over which it is smooth enough.
#pragma once

#include <cfloat>
#include <cmath>

#include "golden_section.hpp"
#include "kernel/kernel.hpp"
#include "qtraj/quaternion.hpp"
#include "qtraj/trajectory.hpp"

namespace qtraj {

// Length of a vector of any magnitude.
inline double magnitude_of(const double (&v)[3]) {
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

// Gauss-Legendre rule of 12 points (Abramowitz and Stegun, table 25.4).
inline bool gauss(const Integrand& integrand, const Interval& piece, double& integral) {
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

// Halves a piece until its integral stays, and gives each final piece with its integral to `leaf`. `pieces_left` bounds
// the work where the curve itself is rounding: a quaternion quintic next to the zero of its norm.
template <class Leaf>
bool bisect(const Integrand& integrand, const Interval& piece, double integral, double tolerance, int depth,
            int& pieces_left, const Leaf& leaf) {
  constexpr int kDeepest = 30;
  const Interval left = {piece.from, piece.middle()}, right = {piece.middle(), piece.to};
  double left_integral, right_integral;
  if (!gauss(integrand, left, left_integral) || !gauss(integrand, right, right_integral)) return false;
  const double finer = left_integral + right_integral;
  const double change = std::abs(integral - finer);
  const bool fine = change <= tolerance || change <= integrand.noise(piece.width(), integral);
  if (fine || depth == kDeepest || pieces_left == 0) return leaf(piece, finer);
  --pieces_left;
  return bisect(integrand, left, left_integral, tolerance, depth + 1, pieces_left, leaf) &&
         bisect(integrand, right, right_integral, tolerance, depth + 1, pieces_left, leaf);
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
    const auto leaf = [&](const Interval& piece, double finer) { return visit(integrand, piece, finer); };
    int pieces_left = 1000;  // a cusp or a spike takes some 60
    if (!bisect(integrand, {0.0, integrand.curve.h()}, integral, tolerance * largest, 0, pieces_left, leaf))
      return {Status::not_finite, i};
  }
  return {};
}

}  // namespace qtraj
