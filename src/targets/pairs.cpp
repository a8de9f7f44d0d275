// The kernels slerp and nlerp of pairs (rows/pairs.hpp), and fractions of times (rows/fractions.hpp). Compiled for
// every target.
#include "rows/pairs.hpp"

#include "rows/fractions.hpp"
#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t slerp(const PairRows& pairs, size_t first, size_t count) {
  return run_rows<blend_pairs<SlerpBlend, Arithmetic, Number>, QTRAJ_SCALAR::slerp>(pairs, first, count);
}

size_t nlerp(const PairRows& pairs, size_t first, size_t count) {
  return run_rows<blend_pairs<NlerpBlend, Arithmetic, Number>, QTRAJ_SCALAR::nlerp>(pairs, first, count);
}

size_t fractions(const FractionRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::fractions<Number>, QTRAJ_SCALAR::fractions>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
