// The polynomial in R^4 that NLERP, QUATERNION_QUINTIC and QUATERNION_HERMITE normalise, and its derivatives.
#pragma once

#include "base/status.hpp"
#include "curve/trajectory.hpp"

namespace qtraj {

// Whether the segments of a trajectory are polynomials in R^4.
bool is_unnormalized(const Trajectory& trajectory);

// Whether they go through unit keys, as all do but those of QUATERNION_HERMITE, whose keys are as they were given.
inline bool has_unit_keys(const Trajectory& trajectory) {
  return trajectory.method != Method{QTRAJ_QUATERNION_HERMITE};
}

// Rows to write, [count][4] each: p, p' in 1/s, p'' in 1/s^2; each may be null.
struct UnnormalizedOutputs {
  double* value;
  double* first;
  double* second;
};

// p / |p| is what samplers give at the time. Plain arithmetic on every target. With D the largest of the step
// |q_{i+1} - q_i|, h |q'| and h^2 |q''| at the two keys of the segment (NLERP: the step), h its length:
//   |error of p| <= 2 eps (1 + D),  of p' <= 12 eps D/h,  of p'' <= 120 eps D/h^2,
// the latter two because the highest coefficient c_5 = (h^2 (q''_1 - q''_0)/8 - 3 (h (q'_0 + q'_1)/2 - (q_1 -
// q_0))/2)/8 of rounded data, off by about eps D, stands in p'' with a factor of 80. (Measured on 960 curves: 1.0, 5.4
// and 57.) Beyond the knots p is the unit quaternion of the samplers, and p', p'' its derivatives: 0 under HOLD, those
// of the great circle under CONSTANT_RATE; under PERIODIC the time is wrapped, and p changes its sign with every turn
// where the last key is minus the first. Rows at fault are NaN in every output: not_finite (the time, or a derivative
// that is asked for overflows), time_range.
Outcome sample_unnormalized(const Trajectory& trajectory, const double* times, size_t count,
                            const UnnormalizedOutputs& outputs);

}  // namespace qtraj
