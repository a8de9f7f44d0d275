#include "qtraj/matrix3.hpp"

namespace qtraj {

bool invert(const Matrix3& matrix, Matrix3& inverse) {
  const Vector3 a = matrix.col(0), b = matrix.col(1), c = matrix.col(2);
  const Vector3 bc = cross(b, c);
  const double determinant = dot(a, bc);
  const double largest = std::max({largest_component(a), largest_component(b), largest_component(c)});
  if (!(std::abs(determinant) > 1e-12 * largest * largest * largest)) return false;
  inverse.row(0) = bc / determinant;
  inverse.row(1) = cross(c, a) / determinant;
  inverse.row(2) = cross(a, b) / determinant;
  return true;
}

}  // namespace qtraj
