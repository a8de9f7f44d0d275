// The moments of weighted orientations about a base orientation m on S^3: what one pass over the samples gives
// (rows/logs.hpp).
//
// Notation of all Karcher files: r_i the half-angle vector, rad, from m to q_i or -q_i, whichever is nearer; its length
// d_i <= pi/2 is half the rotation angle; w_i the weight, W the sum of weights, f = sum w d^2.
#pragma once

#include "math/matrix3.hpp"
#include "means/weighted_orientations.hpp"

namespace qtraj {

// r of one orientation, with the cosine and the sine of d. Error of r below 1e-15 rad.
//
// Singular: at d = pi/2 r and -r are both right. The first component of r that is not 0 is then positive, so that the
// sign of the orientation does not matter.
struct NearestLog {
  Vector3 log;
  double angle, cosine, sine;
};
NearestLog nearest_log(const Quaternion& base, const Quaternion& unit);

struct LogMoments {
  double weight;    // W
  double squares;   // f
  double farthest;  // largest d of a sample that has weight
  Vector3 logs;     // sum w r, the steepest descent of f/2
  // That of f/2 in the tangent space at m, body axes: sum w [u u^T + d cot d (I - u u^T)], u = r/d. On the unit sphere
  // S^3 d^2/2 has the second derivative 1 along r and d cot d, in [0, 1], across: positive definite but for samples at
  // pi/2.
  Matrix3 hessian;

  double root_mean_square() const { return std::sqrt(squares / weight); }
};

// The pass over the samples; those of weight 0 are left out. Beyond the errors of r each sum is good to 8 eps of its
// terms, and the Hessian to 8 eps of W. Bits are of two kinds, fused and plain (math/arithmetic.hpp).
LogMoments log_moments(const WeightedOrientations& samples, const Quaternion& base);

}  // namespace qtraj
