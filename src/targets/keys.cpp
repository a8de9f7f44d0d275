// The kernels over keys (rows/keys.hpp). Compiled for every target.
#include "rows/keys.hpp"

#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t normalize(const NormalizeRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::normalize<Number>, QTRAJ_SCALAR::normalize>(rows, first, count);
}

size_t make_continuous(const ContinuousRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::make_continuous<Number>, QTRAJ_SCALAR::make_continuous>(rows, first, count);
}

size_t relative_rotations(const RelativeRotationRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::relative_rotations<Number>, QTRAJ_SCALAR::relative_rotations>(rows, first, count);
}

size_t jacobians(const JacobianRecords& records, size_t first, size_t count) {
  return run_rows<qtraj::jacobians<Number>, QTRAJ_SCALAR::jacobians>(records, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
