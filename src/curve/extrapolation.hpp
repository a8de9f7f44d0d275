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

// What a finite time that is not inside (curve/knot_lookup.hpp) stands for: a time within the knots, q negated or not,
// or one beyond an end under any rule but PERIODIC.
struct Place {
  double time;
  bool negate;
  const Extrapolation* beyond;  // null where it is within the knots
};
Place place_outside(const Trajectory& trajectory, double time);

}  // namespace qtraj
