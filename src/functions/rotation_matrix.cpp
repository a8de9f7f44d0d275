#include "functions/rotation_matrix.hpp"

#include "math/matrix3.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

using Elements = Row<9>;  // row-major

Elements matrix_of(const Quaternion& unit) {
  const double w = unit[0], x = unit[1], y = unit[2], z = unit[3];
  Elements m;
  m << 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y),  //
      2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x),   //
      2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y);
  return m;
}

Matrix3 from_elements(const Elements& elements) {
  Matrix3 matrix;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) matrix(row, column) = elements[3 * row + column];
  return matrix;
}

// M^T M - I, the distance of M from orthogonality.
Matrix3 defect(const Matrix3& m) {
  Matrix3 result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      result(row, column) = dot(Vector3(m.col(row)), Vector3(m.col(column))) - (row == column ? 1.0 : 0.0);
  return result;
}

double sum_of_squares(const Matrix3& m) {
  double sum = 0;
  for (int column = 0; column < 3; ++column) sum += dot(Vector3(m.col(column)), Vector3(m.col(column)));
  return sum;
}

// The rotation nearest to m; false where m is farther than kLargestMatrixLimit from all of them, though perhaps not
// wherever it is.
bool nearest_rotation(const Matrix3& m, Matrix3& nearest) {
  // Singular values from 1/2 to 3/2 make a defect of up to 5/2 of the distance, and one that is no larger keeps them
  // below 3/2, where the iteration converges: in 7 steps from the ends, in 3 from a distance of 1e-3. What has not
  // converged then has a singular value below 1/2.
  constexpr double kNear = 1.25, kDone = 1e-9;
  constexpr int kSteps = 8;
  for (int column = 0; column < 3; ++column)
    if (largest_component(Vector3(m.col(column))) > 2.0) return false;
  if (dot(Vector3(m.col(0)), cross(m.col(1), m.col(2))) < 0) return false;

  nearest = m;
  for (int step = 0; step < kSteps; ++step) {
    const Matrix3 off = defect(nearest);
    const double size = sum_of_squares(off);
    if (size > kNear * kNear) return false;
    const Matrix3 excess = product(nearest, off);
    nearest -= 0.5 * excess;
    if (size <= kDone * kDone) return true;
  }
  return false;
}

// A multiple of the quaternion of a rotation, of either sign, by its largest component, whose index is `largest`.
Quaternion from_largest(const Matrix3& m, int largest) {
  const double trace = m(0, 0) + m(1, 1) + m(2, 2);
  if (largest == 0) return {1.0 + trace, m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
  const int i = largest - 1, j = (i + 1) % 3, k = (i + 2) % 3;
  Quaternion q;
  q[0] = m(k, j) - m(j, k);
  q[1 + i] = 1.0 + m(i, i) - m(j, j) - m(k, k);
  q[1 + j] = m(i, j) + m(j, i);
  q[1 + k] = m(i, k) + m(k, i);
  return q;
}

Quaternion quaternion_of(const Matrix3& rotation) {
  // the squares of the components, but for a common factor and a common constant
  const double squares[] = {rotation(0, 0) + rotation(1, 1) + rotation(2, 2), rotation(0, 0), rotation(1, 1),
                            rotation(2, 2)};
  int largest = 0;
  for (int k = 1; k < 4; ++k)
    if (squares[k] > squares[largest]) largest = k;
  const Quaternion unit = normalize(from_largest(rotation, largest)).unit.value;
  return unit[0] < 0 ? Quaternion(-unit) : unit;
}

constexpr RowKernel<UnaryRows<4, 9>> kMatrixKernels[] = QTRAJ_OF_EACH_TARGET(matrix_from_q);
constexpr RowKernel<MatrixRows> kFromMatrixKernels[] = QTRAJ_OF_EACH_TARGET(q_from_matrix);

}  // namespace

Outcome matrix_from_q(const UnaryRows<4, 9>& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kMatrixKernels[target()](rows, row, count); };
  return for_each_row(count, rows.out, kernel, [&](size_t row, Elements& elements) {
    const Status status = check_key(rows.in, row);
    if (status == Status::ok) elements = matrix_of(normalize(row_of(rows.in, row)).unit.value);
    return status;
  });
}

Outcome q_from_matrix(const MatrixRows& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kFromMatrixKernels[target()](rows, row, count); };
  return for_each_row(count, rows.q, kernel, [&](size_t row, Quaternion& q) {
    if (rows.distance.data) write_nan(rows.distance, row);
    if (!is_finite(rows.matrix, row)) return Status::not_finite;
    const Matrix3 m = from_elements(row_of(rows.matrix, row));
    Matrix3 nearest;
    if (!nearest_rotation(m, nearest)) return Status::not_rotation;
    const double distance = std::sqrt(sum_of_squares(m - nearest));
    if (distance > kLargestMatrixLimit) return Status::not_rotation;
    if (rows.distance.data) write_row(rows.distance, row, Row<1>(distance));
    if (distance > rows.limit) return Status::not_rotation;
    q = quaternion_of(nearest);
    return Status::ok;
  });
}

}  // namespace qtraj
