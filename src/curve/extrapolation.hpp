// Times before the first and after the last knot. Plain arithmetic on every target: these times are rare.
#pragma once

#include "curve/trajectory.hpp"

namespace qtraj {

// q [4] at a time beyond the end that `side` belongs to, under HOLD and CONSTANT_RATE.
void extrapolate(const Extrapolation& side, double time, double* q);

// Time moved by whole periods into the knots, and whether the sign of q changes on the way there.
struct WrappedTime {
  double time;
  bool negate;
};
WrappedTime wrap_time(const Trajectory& trajectory, double time);

}  // namespace qtraj
