// Products, norms and angles of quaternions, row by row.
//
// eps is DBL_EPSILON; bounds are of the absolute error of each component, to which a subnormal result adds its rounding
// error. Faults of a row: not_finite where the input is not finite or the result overflows, zero_norm where a
// quaternion is 0 that must not be.
#pragma once

#include "functions/for_each_row.hpp"
#include "rows/arguments.hpp"

namespace qtraj {

// Hamilton product a b of quaternions as they are, 0 included. Within 2 eps |a| |b|, of the arrays' type.
Outcome multiply(const BinaryRows<4, 4, 4>& rows, size_t count);

// (w, -x, -y, -z), exact, 0 included.
Outcome conjugate(const UnaryRows<4, 4>& rows, size_t count);

// conjugate / |q|^2, each component to 2.5 eps relative; q other than 0.
Outcome inverse(const UnaryRows<4, 4>& rows, size_t count);

// |q|, to 1.5 eps relative; 0 included.
Outcome norm(const UnaryRows<4, 1>& rows, size_t count);

// Dot product in R^4, 0 included. Within 2 eps |a| |b|.
Outcome dot(const BinaryRows<4, 4, 1>& rows, size_t count);

// q v q^-1: world vectors of body vectors, q of any norm but 0. Within 5 eps |v|; in float, half a ulp of float more.
Outcome rotate(const RotateRows& rows, size_t count);

// Angle, rad, in [0, pi], between a and b in R^4, norms of any size but 0: 2 atan2(|a - b|, |a + b|) of the unit
// quaternions (W. Kahan, "How Futile are Mindless Assessments of Roundoff in Floating-Point Computation?" (2006), 12),
// which loses no digits anywhere, and is 0 for a = b and pi for a = -b. To 0.75 eps relative: half a ulp, and what
// rounding of the sums adds to tiny angles, 4e-30 rad.
Outcome distance(const BinaryRows<4, 4, 1>& rows, size_t count);

// Angle, rad, in [0, pi], of the rotation that takes a to b: twice the distance from a to the nearer of b and -b. The
// same bounds.
double rotation_angle(const Quaternion& a, const Quaternion& b);  // finite, not 0
Outcome rotation_angle(const BinaryRows<4, 4, 1>& rows, size_t count);

}  // namespace qtraj
