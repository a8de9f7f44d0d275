// The kernels over derivatives and rates (rows/derivatives.hpp, rows/mean_rates.hpp). Compiled for every target.
#include "rows/derivatives.hpp"

#include "rows/mean_rates.hpp"
#include "targets/compiled.hpp"

namespace qtraj {
namespace QTRAJ_TARGET {

size_t derivatives_from_rates(const RatesToDerivatives& rows, size_t first, size_t count) {
  return run_rows<qtraj::derivatives_from_rates<Number>, QTRAJ_SCALAR::derivatives_from_rates>(rows, first, count);
}

size_t rates_from_derivatives(const DerivativesToRates& rows, size_t first, size_t count) {
  return run_rows<qtraj::rates_from_derivatives<Number>, QTRAJ_SCALAR::rates_from_derivatives>(rows, first, count);
}

size_t mean_rates(const MeanRateRows& rows, size_t first, size_t count) {
  return run_rows<qtraj::mean_rates<Number>, QTRAJ_SCALAR::mean_rates>(rows, first, count);
}

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
