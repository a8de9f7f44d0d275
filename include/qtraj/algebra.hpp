// Products, norms and angles of quaternions, row by row.
//
// eps is DBL_EPSILON, bounds are of absolute errors, of each component; where a result is subnormal its rounding comes
// on top. Faults of a row: not_finite where the input is not or the result overflows, zero_norm where a quaternion is 0
// that must not be.
#pragma once

#include "qtraj/rows.hpp"

namespace qtraj {

// Hamilton product a b of quaternions as they are, 0 included. Within 2 eps |a| |b|.
Outcome multiply(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<4>& q_out);

// (w, -x, -y, -z), exact, 0 included.
Outcome conjugate(const Rows<4>& q, size_t count, const OutputRows<4>& q_out);

// conjugate / |q|^2, each component to 2.5 eps relative; q other than 0.
Outcome inverse(const Rows<4>& q, size_t count, const OutputRows<4>& q_out);

// |q|, to 1.5 eps relative; 0 included.
Outcome norm(const Rows<4>& q, size_t count, const OutputRows<1>& norm_out);

// Dot product in R^4, 0 included. Within 2 eps |a| |b|.
Outcome dot(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<1>& dot_out);

// q v q^-1: world vectors of body vectors, q of any norm but 0. Within 5 eps |v|; in float, half a ulp of float more.
Outcome rotate(const Rows<4>& q_wb, const Rows<3>& v_body, size_t count, const OutputRows<3>& v_world_out);

// Angle, rad, in [0, pi], between a and b in R^4, norms of any size but 0: 2 atan2(|a - b|, |a + b|) of the unit
// quaternions (W. Kahan, "How Futile are Mindless Assessments of Roundoff in Floating-Point Computation?" (2006), 12),
// which loses no digits anywhere, and is 0 for a = b and pi for a = -b. To 0.75 eps relative: half a ulp, and what
// inputs that are not unit add to tiny angles, 1e-30.
Outcome distance(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<1>& angle_out);

// Angle, rad, in [0, pi], of the rotation that takes a to b: twice the distance from a to the nearer of b and -b. The
// same bounds.
double rotation_angle(const Quaternion& a, const Quaternion& b);  // finite, not 0
Outcome rotation_angle(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<1>& angle_out);

}  // namespace qtraj
