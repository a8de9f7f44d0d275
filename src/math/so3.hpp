// Exponential and logarithm on S^3 (half angles), and the right Jacobian of SO(3). What kernels share with the core is
// in half_angle.hpp and relative_rotation.hpp.
#pragma once

#include "math/matrix3.hpp"
#include "math/quaternion.hpp"

namespace qtraj {

// exp v = (cos |v|, v sin |v| / |v|), v a half-angle vector, rad.
Quaternion exp_map(const Vector3& v);

// exp v - 1 without cancellation: (-2 sin^2(|v| / 2), v sin |v| / |v|), each component good to a few eps.
Quaternion exp_map_minus_one(const Vector3& v);

// From a to b along the great circle of S^3, both unit: sin_part = Im(a* b), |sin_part| = sin(angle), angle in [0, pi].
// Good to a few eps relative at every angle, because it is computed from the difference and the sum of a and b.
struct RelativeRotation {
  Vector3 sin_part;
  double angle;
};
RelativeRotation relative_rotation(const UnitQuaternion& a, const UnitQuaternion& b);

// Its logarithm, the half-angle vector. Singular: 0 where sin_part is 0 and there is no axis.
Vector3 log_of(const RelativeRotation& rotation);

// log(a* b), the half-angle vector along the arc that the signs give. Singular: 0 for b = a, and for b = -a, where
// there is no axis.
Vector3 relative_log(const UnitQuaternion& a, const UnitQuaternion& b);

// The half-angle vector of the rotation on the branch nearest to `previous`, so that a sequence of logs is continuous.
// Singular: where the rotation is +-1 to rounding, |sin_part| <= 16 epsilon (1 + |previous|), its axis is noise; the
// result is then the nearest multiple of pi of the right parity along `previous` (0 after 0). epsilon is that of the
// type the keys came in.
Vector3 unwrap(const RelativeRotation& rotation, const Vector3& previous, double epsilon);

// Jr(r) d, the right Jacobian: omega_body = Jr(r) r' for the rotation vector r (full angle), rad. Any |r| below 1e15.
//   Jr(r) d = d - (K^2/2) r x d + ((K^2 - C D)/4) r x (r x d),
//   p = r/2, y = |p|^2, C = cos |p|, K = sin |p| / |p|, D = (K - C)/y.
// The same matrix as G. Chirikjian, "Stochastic Models, Information Theory, and Lie Groups", vol. 2 (2012), eq. 10.86,
// with its quotients (1 - cos)/|r|^2 = K^2/2 and (|r| - sin)/|r|^3 = (K^2 - C D)/4, which lose no digits near 0.
Vector3 right_jacobian(const Vector3& r, const Vector3& d);

// Jr^-1(r) w: the derivative of the rotation vector r that belongs to the body rate w. |r| < 2 pi.
//   Jr^-1(r) w = w + (1/2) r x w + (D/(4 K)) r x (r x w), the same book, eq. 10.87, its quotient without cancellation.
Vector3 inverse_right_jacobian(const Vector3& r, const Vector3& w);

// What the change of Jr adds to the body acceleration: alpha_body = Jr(r) r'' + beta(r, r'), beta = (d Jr(r)/dt) r'.
// Quadratic in its second argument. With E = (3 D - K)/y:
//   beta(r, d) = (K D/4)(r.d) r x d + ((C E - K D)/16)(r.d) r x (r x d) + ((K^2 - C D)/4) d x (r x d).
struct TurningFactors {
  double along_once, along_twice, sideways;  // K D/4, (C E - K D)/16, (K^2 - C D)/4
};
TurningFactors turning_factors(const Vector3& r);
inline TurningFactors operator*(double scale, const TurningFactors& f) {
  return {scale * f.along_once, scale * f.along_twice, scale * f.sideways};
}

// Jr(r) as a matrix and the factors of beta, together: they share the polynomials. |r| below 1e150.
struct JacobianAndTurning {
  Matrix3 jacobian;
  TurningFactors turning;
};
JacobianAndTurning jacobian_and_turning(const Vector3& r);

// beta(r, d). Here and below beta = a (r.d) r x d + m x (r x d), m = b (r.d) r + s d, a, b, s being the factors in
// their order.
inline Vector3 turning_acceleration(const TurningFactors& f, const Vector3& r, const Vector3& d) {
  const double along = dot(r, d);
  const Vector3 once = cross(r, d), m = (f.along_twice * along) * r + f.sideways * d;
  return (f.along_once * along) * once + cross(m, once);
}

// The matrix of d beta / d d at (r, d): the product rule term by term, with m x (r x v) = r (m.v) - (m.r) v.
inline Matrix3 turning_jacobian(const TurningFactors& f, const Vector3& r, const Vector3& d) {
  const double along = dot(r, d);
  const Vector3 once = cross(r, d), m = (f.along_twice * along) * r + f.sideways * d;
  const Vector3 by_along = f.along_once * once + f.along_twice * cross(r, once);
  const Vector3 turn = (f.along_once * along) * r - f.sideways * once;
  Matrix3 matrix = outer_product(by_along, r) + outer_product(r, m) + cross_matrix(turn);
  matrix.diagonal().array() -= dot(m, r);
  return matrix;
}

// The same vector in the other frame.
inline Vector3 to_world(const Quaternion& q_wb, const Vector3& v_body) { return rotate(q_wb, v_body); }
inline Vector3 to_body(const Quaternion& q_wb, const Vector3& v_world) { return rotate(conjugate(q_wb), v_world); }

}  // namespace qtraj
