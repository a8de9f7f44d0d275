// Quaternions of the core: Eigen vectors in the order w x y z of the C API, Hamilton product.
//
// Products and sums of products are written out: their order of summation is part of the results, and Eigen does not
// promise one.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/eigen.hpp"
#include "math/error_free.hpp"

namespace qtraj {

// Euclidean dot product, summed from the left.
template <class Vector>
double dot(const Vector& a, const Vector& b) {
  double sum = a[0] * b[0];
  for (int k = 1; k < Vector::RowsAtCompileTime; ++k) sum += a[k] * b[k];
  return sum;
}

// Euclidean length; components below 1e150 and, for full accuracy, above 1e-150.
template <class Vector>
double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}

inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Two orientations are half a turn apart to rounding where the magnitude of their cosine on S^3 is at most this.
// Neither way from one to the other is then the shorter one in any meaningful sense.
constexpr double kHalfTurnCosine = 4 * 0x1p-52;

inline Quaternion quaternion(double scalar, const Vector3& vector) { return {scalar, vector[0], vector[1], vector[2]}; }
inline Vector3 vector_part(const Quaternion& q) { return {q[1], q[2], q[3]}; }
inline Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }

// Hamilton product a b.
inline Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

// q v q^-1 for unit q: a body vector in the world frame.
Vector3 rotate(const Quaternion& q, const Vector3& v);

// Conversion between vectors and the plain arrays of segments and handles.
template <size_t Size>
Row<Size> load(const double (&from)[Size]) {
  return Row<Size>(from);
}
template <class Vector, size_t Size>
void store(const Vector& from, double (&to)[Size]) {
  static_assert(Vector::RowsAtCompileTime == static_cast<int>(Size));
  for (int k = 0; k < static_cast<int>(Size); ++k) to[k] = from[k];
}

// A power of two that scales a vector with this largest component so that its squares neither overflow nor underflow.
double scale_for(double largest);
// Largest absolute component.
template <class Vector>
double largest_component(const Vector& a) {
  double largest = 0;
  for (int k = 0; k < Vector::RowsAtCompileTime; ++k) largest = std::max(largest, std::abs(a[k]));
  return largest;
}

// q times a power of two, its largest component then in [1, 2). Finite q != 0.
Quaternion scaled_to_one(const Quaternion& q);

// A unit quaternion in double-double, value + error. Differences of neighbouring keys thus keep full relative accuracy
// at every angle, down to steps far below the rounding of the keys.
struct UnitQuaternion {
  Quaternion value, error;
};
struct Normalized {
  UnitQuaternion unit;
  double norm;        // of the input; DBL_MAX where it would overflow
  double norm_error;  // rounding error of norm
};

// q / |q| for finite q != 0 of any magnitude. |value + error| = 1 to 1e-30; value is the nearest double, to 1e-200.
Normalized normalize(const Quaternion& q);

// |a| to 1e-30 relative; the largest component is in the range to which scale_for scales.
DoubleDouble precise_length(const Quaternion& a);

inline Quaternion difference(const UnitQuaternion& a, const UnitQuaternion& b) {
  return (a.value - b.value) + (a.error - b.error);
}
inline Quaternion sum(const UnitQuaternion& a, const UnitQuaternion& b) {
  return (a.value + b.value) + (a.error + b.error);
}
inline UnitQuaternion negate(const UnitQuaternion& q) { return {-q.value, -q.error}; }

}  // namespace qtraj
