// Diagnostics of a finished curve, computed from its segments up to their very ends, by the formulas that sample it.
#pragma once

#include "base/status.hpp"
#include "curve/trajectory.hpp"

namespace qtraj {

// Right-hand minus left-hand omega and alpha at each knot, [key_count][3] in `frame`, each may be null. At the ends 0,
// or, of a closed curve, the jump from its end to its start. not_finite with the knot's index where they overflow.
Outcome curve_jumps(const Trajectory& trajectory, Frame frame, double* omega_jump, double* alpha_jump);

// Integrals over the open segments, impulses at knots not counted: |alpha|^2, rad^2/s^3, and |omega|, rad. Proven to
// 1e-9 relative, but for rounding errors of alpha below 1e-12 of the largest |omega|/h. no_convergence where that takes
// more pieces than the call may have (budget.hpp), tens of thousands of turns for instance, or where rounding leaves
// too few digits: a quaternion quintic whose norm all but vanishes, SQUAD's arcs all but opposite. not_finite where the
// integral overflows.
Outcome energy(const Trajectory& trajectory, double& result);
Outcome total_angle(const Trajectory& trajectory, double& result);

// Largest |omega| and |alpha| and when they are reached: the value of a sample, which the curve is proven to exceed
// nowhere by more than 1e-10 relative, or by 1e-6 where rounding errors are as large; and a bound above the largest
// value, within 1e-6 of it. Accelerations below 1e-12 of the largest |omega|/h are rounding errors, and proven to be
// that. Statuses as above.
struct Peak {
  double value, bound, time;
};
Outcome peak_omega(const Trajectory& trajectory, Peak& peak);
Outcome peak_alpha(const Trajectory& trajectory, Peak& peak);

// Smallest norm of a normalised segment before it is normalised, and where; 1 at the first knot for other kinds.
struct LeastNorm {
  double norm, time;
};
LeastNorm least_norm(const Trajectory& trajectory);

}  // namespace qtraj
