// Whether the rates of a curve at its keys and its steps from key to key tell the same.
#pragma once

#include "base/status.hpp"
#include "curve/trajectory.hpp"

namespace qtraj {

// Largest angle, rad, between a step and what the rates at its two ends make of it, and the step's index. The step is
// the rotation vector R that the curve makes of it, turns included; the rates make h (R_m* w_0 + R_m w_1)/2 of it, each
// turned into the body frame in the middle of the step (R_m a turn by R/2). For a smooth curve the difference is of
// order h^3. not_finite, with the step's index, where a rate overflows.
struct RateMismatch {
  double angle;
  size_t segment;
};
Outcome rate_mismatch(const Trajectory& trajectory, RateMismatch& worst);

}  // namespace qtraj
