// The kernels over times (rows/times.hpp). Compiled for every target.
#include "rows/times.hpp"

#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t even_times(const EvenTimeRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::even_times<Number>, QTRAJ_SCALAR::even_times>(rows, first, count);
}

size_t seconds_from_ns(const NanosecondRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::seconds_from_ns<Number>, QTRAJ_SCALAR::seconds_from_ns>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
