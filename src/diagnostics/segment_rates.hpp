// Rates along one segment, per unit of s = 2u - 1 in [-1, 1]: of the size of the rotation, however long or short the
// segment is in time, so that nothing overflows or vanishes. Per second they are (2/h) omega and (2/h)^2 alpha.
#pragma once

#include "curve/trajectory.hpp"
#include "math/eigen.hpp"

namespace qtraj {

struct RatesInSegment {
  Vector3 omega, alpha;  // body frame; alpha only where it is asked for
};

// The evaluators that sample the curve, in plain arithmetic. False where rounding leaves no digits of the rates: a
// normalised polynomial below 1e-9 of its coefficients, arcs whose points are opposite to 1e-9.
bool rates_in_segment(const Trajectory& trajectory, size_t segment, double s, bool with_alpha, RatesInSegment& rates);

inline double duration(const Trajectory& trajectory, size_t segment) {
  const double* knots = knots_of(trajectory.timeline);
  return knots[segment + 1] - knots[segment];
}
inline double time_in_segment(const Trajectory& trajectory, size_t segment, double s) {
  const double* knots = knots_of(trajectory.timeline);
  return s < 1.0 ? knots[segment] + 0.5 * (s + 1.0) * duration(trajectory, segment) : knots[segment + 1];
}

}  // namespace qtraj
