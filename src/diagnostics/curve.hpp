// Diagnostics of a finished curve, computed from its segments up to their very ends, by the formulas that sample it.
#pragma once

#include "base/status.hpp"
#include "curve/trajectory.hpp"

namespace qtraj {

// Right-hand minus left-hand omega and alpha at each knot, [key_count][3] in `frame`, each may be null. At the ends 0,
// or, of a closed curve, the jump from its end to its start. not_finite with the knot's index where they overflow.
Outcome curve_jumps(const Trajectory& trajectory, Frame frame, double* omega_jump, double* alpha_jump);

// Integrals over the open segments, impulses at knots not counted: |alpha|^2, rad^2/s^3, and |omega|, rad. Adaptive
// bisection with 12-point Gauss rules, until halving a piece changes its integral by less than 1e-13 of the largest
// part, or by no more than the rounding error of the integrand: 1e-9 relative. no_convergence where a segment takes
// more than 1e5 cuts: tens of thousands of turns, or a quaternion quintic whose norm all but vanishes.
Outcome energy(const Trajectory& trajectory, double& result);
Outcome total_angle(const Trajectory& trajectory, double& result);

// Largest |omega| and |alpha| and when they are reached. The pieces of the integrals to 1e-6 are sampled at 12 points;
// every local maximum above a quarter of the largest value so far, and the first and the last interval of each piece,
// are narrowed by golden sections to 1e-9 of the piece, which leaves the value right to rounding.
struct Peak {
  double value, time;
};
Outcome peak_omega(const Trajectory& trajectory, Peak& peak);
Outcome peak_alpha(const Trajectory& trajectory, Peak& peak);

// Smallest norm of a normalised segment before it is normalised, and where; 1 at the first knot for other kinds.
struct LeastNorm {
  double norm, time;
};
LeastNorm least_norm(const Trajectory& trajectory);

}  // namespace qtraj
