#include "qtraj/quaternion.hpp"

#include <cfloat>

#include "qtraj/error_free.hpp"

namespace qtraj {

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Vector3 rotate(const Quaternion& q, const Vector3& v) {
  // v + 2 w (u x v) + 2 u x (u x v), u the vector part
  const Vector3 u = vector_part(q);
  const Vector3 twice = 2.0 * cross(u, v);
  return v + (q[0] * twice + cross(u, twice));
}

double scale_for(double largest) {
  if (largest < 0x1p-400) return 0x1p600;
  if (largest > 0x1p400) return 0x1p-600;
  return 1.0;
}

Normalized normalize(const Quaternion& q) {
  const double scale = scale_for(largest_component(q));
  const Quaternion scaled = scale * q;

  // |scaled|^2 = square.value + square.error
  Exact square = two_product(scaled[0], scaled[0]);
  for (int k = 1; k < 4; ++k) {
    const Exact product = two_product(scaled[k], scaled[k]);
    const Exact sum = two_sum(square.value, product.value);
    square = {sum.value, square.error + (product.error + sum.error)};
  }
  // |scaled| = norm + norm_error, one Newton step for the second part
  const double norm = std::sqrt(square.value);
  const Exact norm_squared = two_product(norm, norm);
  const double norm_error = ((square.value - norm_squared.value) - norm_squared.error + square.error) / (2.0 * norm);

  Normalized result;
  for (int k = 0; k < 4; ++k) {
    const double value = scaled[k] / norm;
    const Exact product = two_product(value, norm);
    result.unit.value[k] = value;
    result.unit.error[k] = ((scaled[k] - product.value) - product.error - value * norm_error) / norm;
  }
  const bool overflows = scale < 1.0 && norm > DBL_MAX * 0x1p-600;
  result.norm = overflows ? DBL_MAX : norm / scale;
  return result;
}

}  // namespace qtraj
