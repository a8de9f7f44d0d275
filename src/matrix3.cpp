#include "qtraj/matrix3.hpp"

namespace qtraj {

bool invert(const Matrix3& matrix, Matrix3& inverse) {
  const Vector3 a = matrix.col(0), b = matrix.col(1), c = matrix.col(2);
  const Vector3 bc = cross(b, c);
  const double determinant = dot(a, bc);
  const double largest = std::max({largest_component(a), largest_component(b), largest_component(c)});
  if (!(std::abs(determinant) > 1e-12 * largest * largest * largest)) return false;
  const double scale = 1.0 / determinant;
  inverse.row(0) = scale * bc;
  inverse.row(1) = scale * cross(c, a);
  inverse.row(2) = scale * cross(a, b);
  return true;
}

}  // namespace qtraj
