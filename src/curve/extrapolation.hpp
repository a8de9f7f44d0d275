// Orientations before the first and after the last knot, under HOLD and CONSTANT_RATE. Plain arithmetic on every
// target: these times are rare.
#pragma once

#include "curve/trajectory.hpp"

namespace qtraj {

// The great circle that goes on beyond the end that a place (curve/timeline.hpp) is at.
const GreatCircle& circle_beyond(const Trajectory& trajectory, const Place& place);

// Writes q [4] of the circle at a time.
void extrapolate(const GreatCircle& circle, double time, double* q);

}  // namespace qtraj
