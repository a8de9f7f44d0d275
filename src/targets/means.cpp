// The kernels of means: sums over samples (rows/means.hpp, rows/logs.hpp). Compiled for every target.
#include "rows/logs.hpp"
#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t raise_to_weights(const WeightRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::raise_to_weights<Number>, QTRAJ_SCALAR::raise_to_weights>(rows, first, count);
}

size_t add_scatter(const ScatterRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::add_scatter<Number>, QTRAJ_SCALAR::add_scatter>(rows, first, count);
}

size_t add_logs(const LogRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::add_logs<Arithmetic, Number>, QTRAJ_SCALAR::add_logs>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
