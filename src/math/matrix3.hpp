// 3 x 3 matrices whose products have a fixed order of summation.
#pragma once

#include "math/quaternion.hpp"

namespace qtraj {

inline Vector3 product(const Matrix3& a, const Vector3& v) {
  Vector3 result;
  for (int row = 0; row < 3; ++row) result[row] = a(row, 0) * v[0] + a(row, 1) * v[1] + a(row, 2) * v[2];
  return result;
}

inline Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 result;
  for (int column = 0; column < 3; ++column) result.col(column) = product(a, Vector3(b.col(column)));
  return result;
}

// The matrix of the cross product with v: cross_matrix(v) a = v x a.
inline Matrix3 cross_matrix(const Vector3& v) {
  Matrix3 matrix;
  matrix << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return matrix;
}

// a b^T.
inline Matrix3 outer_product(const Vector3& a, const Vector3& b) {
  Matrix3 matrix;
  for (int column = 0; column < 3; ++column) matrix.col(column) = b[column] * a;
  return matrix;
}

// Conversion between matrices and plain arrays, column by column.
inline Matrix3 load_matrix(const double (&from)[9]) { return Matrix3(from); }
inline void store_matrix(const Matrix3& from, double (&to)[9]) {
  for (int k = 0; k < 9; ++k) to[k] = from.data()[k];
}

// The inverse by cofactors; false where the matrix is singular or close to it: |determinant| <= 1e-12 (largest
// component)^3.
inline bool invert(const Matrix3& matrix, Matrix3& inverse) {
  const Vector3 a = matrix.col(0), b = matrix.col(1), c = matrix.col(2);
  const Vector3 bc = cross(b, c);
  const double determinant = dot(a, bc);
  const double largest = matrix.cwiseAbs().maxCoeff();
  if (!(std::abs(determinant) > 1e-12 * largest * largest * largest)) return false;
  const double scale = 1.0 / determinant;
  inverse.row(0) = scale * bc;
  inverse.row(1) = scale * cross(c, a);
  inverse.row(2) = scale * cross(a, b);
  return true;
}

}  // namespace qtraj
