// The kernels over rotation matrices (rows/matrices.hpp). Compiled for every target.
#include "rows/matrices.hpp"

#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t matrix_from_q(const UnaryRows<4, 9>& rows, size_t first, size_t count) {
  return run_rows<qtraj::matrix_from_q<Arithmetic, Number>, QTRAJ_SCALAR::matrix_from_q>(rows, first, count);
}

size_t q_from_matrix(const MatrixRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::q_from_matrix<Arithmetic, Number>, QTRAJ_SCALAR::q_from_matrix>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
