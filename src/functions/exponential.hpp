// Exponential, logarithm and power of quaternions and rotation vectors, row by row.
//
// Based on: J. Sola, "Quaternion kinematics for the error-state Kalman filter", arXiv:1711.02508, chapter 1. Half
// angles are never taken from acos but from atan2(|v|, w), in double-double, so that results are rounded once.
//
// eps is DBL_EPSILON; bounds are of the absolute error of each component, unless said. Faults of a row: not_finite
// where the input is not finite, zero_norm where a quaternion is 0.
#pragma once

#include "functions/for_each_row.hpp"

namespace qtraj {

// exp v = (cos |v|, v sin |v| / |v|), v a half-angle vector, rad, of any length. Within 1.5 eps for |v| <= 2^26, the
// vector part to 1.5 eps relative for |v| <= 1; within eps (1.5 + |v|) up to 2^50; beyond, only a unit quaternion is
// promised.
Outcome exp(const UnaryRows<3, 4>& rows, size_t count);

// Half-angle vector, rad, of q / |q|: atan2(|v|, w) v / |v|, v the vector part, length in [0, pi]. To 0.75 eps
// relative. Singular: q > 0 gives 0; q = (-1, 0, 0, 0) and its positive multiples give (pi, 0, 0), ambiguous. Beside
// |w| > 2^400 a vector part below 2^-474 may count as 0.
Outcome log(const UnaryRows<4, 3>& rows, size_t count);

// exp(exponent log(q)): within eps (1.5 + angle / 4), angle = |exponent log(q)| up to 2^26; within eps (1.5 + angle) up
// to 2^50; beyond, only a unit quaternion is promised. Singular: where log is ambiguous the power is about the x axis
// and ambiguous too, except for whole exponents, which need no axis.
Outcome pow(const BinaryRows<4, 1, 4>& rows, size_t count);  // q, exponent

// Rotation vector, rad, of the shorter way: +-2 atan2(|v|, |w|) v / |v|, + where w >= 0, length in [0, pi]. q and -q
// give the same vector, except at half a turn, w = 0, where the vector part gives the axis. To 0.75 eps relative.
Outcome rotation_vector_from_q(const UnaryRows<4, 3>& rows, size_t count);

// exp(r / 2), r a rotation vector, rad, of any length. The bounds of exp at half the length.
Outcome q_from_rotation_vector(const UnaryRows<3, 4>& rows, size_t count);

}  // namespace qtraj
