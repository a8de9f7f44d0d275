#include "math/so3.hpp"

#include "base/floating.hpp"
#include "math/half_angle.hpp"
#include "math/relative_rotation.hpp"
#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

// C, K, D and E of half_angle.hpp: by polynomials for half angles up to pi/2, where the quotients would cancel, and by
// the quotients beyond.
RateFactors<double> factors_of(const Vector3& r) {
  const double y = 0.25 * dot(r, r);
  if (y <= kPolynomialLimit) return polynomial_factors(y);
  const double angle = std::sqrt(y);
  const SinCos at = sin_cos(angle);
  const double k = at.sin / angle;
  const double d = (k - at.cos) / y;
  return {at.cos, k, d, (3.0 * d - k) / y};
}

}  // namespace

Quaternion exp_map(const Vector3& v) {
  const double angle = length(v);
  if (angle == 0) return quaternion(1.0, v);
  const SinCos at = sin_cos(angle);
  return quaternion(at.cos, (at.sin / angle) * v);
}

Quaternion exp_map_minus_one(const Vector3& v) {
  double vector[3], result[4];
  store(v, vector);
  exponential_minus_one(vector, sin_cos_of<double>, result);
  return load(result);
}

RelativeRotation relative_rotation(const UnitQuaternion& a, const UnitQuaternion& b) {
  double a_value[4], a_error[4], b_value[4], b_error[4];
  store(a.value, a_value), store(a.error, a_error);
  store(b.value, b_value), store(b.error, b_error);
  const RelativeRotationOf<double> rotation = relative_rotation_of(a_value, a_error, b_value, b_error);
  return {load(rotation.sin_part), rotation.angle};
}

Vector3 log_of(const RelativeRotation& rotation) {
  double log[3];
  half_angle_vector({{rotation.sin_part[0], rotation.sin_part[1], rotation.sin_part[2]}, rotation.angle},
                    length(rotation.sin_part), log);
  return load(log);
}

Vector3 relative_log(const UnitQuaternion& a, const UnitQuaternion& b) { return log_of(relative_rotation(a, b)); }

Vector3 unwrap(const RelativeRotation& rotation, const Vector3& previous, double epsilon) {
  const double previous_angle = length(previous);
  const double sine = length(rotation.sin_part);
  if (sine <= 16.0 * epsilon * (1.0 + previous_angle)) {
    if (previous_angle == 0) return previous;
    const double odd = rotation.angle > 0.5 * kPi ? 1.0 : 0.0;
    const double multiple = 2.0 * round_to_integer(0.5 * (previous_angle / kPi - odd)) + odd;
    return (multiple * kPi / previous_angle) * previous;
  }
  const Vector3 axis = rotation.sin_part / sine;
  const double turns = round_to_integer((dot(axis, previous) - rotation.angle) / (2.0 * kPi));
  return (rotation.angle + 2.0 * kPi * turns) * axis;
}

namespace {

Vector3 right_jacobian(const RateFactors<double>& f, const Vector3& r, const Vector3& d) {
  // d is multiplied by the factors first: for r of many turns r x (r x d) could overflow where its multiple does not
  const Vector3 first = cross(r, (0.5 * f.k * f.k) * d);
  const Vector3 second = cross(r, cross(r, (0.25 * (f.k * f.k - f.c * f.d)) * d));
  return d - first + second;
}

Vector3 inverse_right_jacobian(const RateFactors<double>& f, const Vector3& r, const Vector3& w) {
  double rotation[3], rate[3], derivative[3];
  store(r, rotation);
  store(w, rate);
  inverse_jacobian_times(f, rotation, rate, derivative);
  return load(derivative);
}

}  // namespace

Vector3 right_jacobian(const Vector3& r, const Vector3& d) { return right_jacobian(factors_of(r), r, d); }

Vector3 inverse_right_jacobian(const Vector3& r, const Vector3& w) {
  return inverse_right_jacobian(factors_of(r), r, w);
}

TurningFactors turning_factors(const Vector3& r) {
  const TurningFactorsOf<double> turning = turning_factors_of(factors_of(r));
  return {turning.along_once, turning.along_twice, turning.sideways};
}

JacobianAndTurning jacobian_and_turning(const Vector3& r) {
  const RateFactors<double> f = factors_of(r);
  const TurningFactorsOf<double> turning = turning_factors_of(f);
  double jacobian[9];
  jacobian_of(f, turning.sideways, {r[0], r[1], r[2]}, jacobian);
  return {load_matrix(jacobian), {turning.along_once, turning.along_twice, turning.sideways}};
}

}  // namespace qtraj
