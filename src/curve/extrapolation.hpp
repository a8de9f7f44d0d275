// Times before the first and after the last knot. Plain arithmetic on every target: these times are rare.
#pragma once

#include "curve/trajectory.hpp"

namespace qtraj {

// Writes q [4] at a time beyond the end that `side` belongs to, under HOLD and CONSTANT_RATE.
void extrapolate(const Extrapolation& side, double time, double* q);

// A time moved by whole periods to within the knots, and whether q changes its sign with that.
struct WrappedTime {
  double time;
  bool negate;
};
WrappedTime wrap_time(const Trajectory& trajectory, double time);

}  // namespace qtraj
