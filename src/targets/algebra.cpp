// The kernels over quaternions as they are (rows/algebra.hpp). Compiled for every target.
#include "rows/algebra.hpp"

#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t multiply(const BinaryRows<4, 4, 4>& rows, size_t first, size_t count) {
  return run_rows<qtraj::multiply<Arithmetic, Number, FloatNumber>, QTRAJ_SCALAR::multiply>(rows, first, count);
}

size_t dot(const BinaryRows<4, 4, 1>& rows, size_t first, size_t count) {
  return run_rows<qtraj::dot<Number>, QTRAJ_SCALAR::dot>(rows, first, count);
}

size_t conjugate(const UnaryRows<4, 4>& rows, size_t first, size_t count) {
  return run_rows<qtraj::conjugate<Number>, QTRAJ_SCALAR::conjugate>(rows, first, count);
}

size_t inverse(const UnaryRows<4, 4>& rows, size_t first, size_t count) {
  return run_rows<qtraj::inverse<Arithmetic, Number>, QTRAJ_SCALAR::inverse>(rows, first, count);
}

size_t norm(const UnaryRows<4, 1>& rows, size_t first, size_t count) {
  return run_rows<qtraj::norm<Arithmetic, Number>, QTRAJ_SCALAR::norm>(rows, first, count);
}

size_t rotate(const RotateRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::rotate<Arithmetic, Number>, QTRAJ_SCALAR::rotate>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
