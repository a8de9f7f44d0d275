// The kernels over products (rows/algebra.hpp). Compiled for every target.
#include "rows/algebra.hpp"

#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t multiply(const BinaryRows<4, 4, 4>& rows, size_t first, size_t count) {
  return run_rows<qtraj::multiply<Arithmetic, Number, FloatNumber>, QTRAJ_SCALAR::multiply>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
