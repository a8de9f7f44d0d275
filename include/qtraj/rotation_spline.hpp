#pragma once

#include "qtraj/method.hpp"
#include "qtraj/rate_equations.hpp"

namespace qtraj {

// ROTATION_SPLINE: q_i exp(r/2), r a cubic per segment with r(0) = 0 and r(h) = R_i = 2 log(q_i* q_{i+1}), the body
// rates w_i at the knots such that alpha is continuous. With A_i = Jr^-1(R_i), r'(h) = A_i w_{i+1}:
//   2 A_{i-1}^-1 w_{i-1}/h_{i-1} + 4 (1/h_{i-1} + 1/h_i) w_i + 2 A_i w_{i+1}/h_i + beta(R_{i-1}, A_{i-1} w_i)
//     = 6 (R_{i-1}/h_{i-1}^2 + R_i/h_i^2),
// equal angular accelerations on both sides of the knot, in the body frame there (the curve of I. G. Kang and F. C.
// Park, "Cubic spline algorithms for orientation interpolation", IJNME 46 (1999), section 3, the rates solved for
// exactly). The solution taken is the one continued from beta = 0; on extreme keys it is not the only one.
//
// no_convergence where that continuation stalls, a segment turns by more than 2^200 rad, or the equations are not met
// to 1e-9; not_finite with the key's index where a given end rate alone is past 2^200 rad over its segment.
Outcome build_rotation_spline(Construction& construction);

}  // namespace qtraj
