#include "functions/even_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/floating.hpp"
#include "math/weighted_mean.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

Status check_ends(double first, double last) {
  if (!is_finite(first) || !is_finite(last)) return Status::not_finite;
  return last < first ? Status::time_order : Status::ok;
}

constexpr RowKernel<EvenTimeRows> kEvenTimeKernels[] = QTRAJ_OF_EACH_TARGET(even_times);

}  // namespace

Status even_times(double first, double last, size_t count, double* times) {
  if (count == 0) return Status::ok;
  const Status status = check_ends(first, last);
  if (status != Status::ok) {
    std::fill_n(times, count, std::numeric_limits<double>::quiet_NaN());
    return status;
  }
  write_even_times(first, last, count, 0, count, times);
  return Status::ok;
}

void write_even_times(double first, double last, size_t count, size_t begin, size_t rows, double* times) {
  if (count == 1) {
    std::fill_n(times, rows, first);
    return;
  }
  const double larger = std::max(std::abs(first), std::abs(last));
  const double scale = larger > 0 ? normalizing_scale(larger) : 1.0, intervals = static_cast<double>(count - 1);
  const size_t done = kEvenTimeKernels[target()]({first, last, scale, count, begin, times}, 0, rows);
  for (size_t k = done; k < rows; ++k) {
    const double steps = static_cast<double>(begin + k);
    times[k] = weighted_mean(scale * first, intervals - steps, scale * last, steps, intervals) / scale;
  }
  if (begin == 0 && rows > 0) times[0] = first;
  if (begin + rows == count && rows > 0) times[rows - 1] = last;
}

void segment_times(const double* knots, size_t count, size_t per_segment, double* times) {
  // each segment writes the knot that it ends with, and the next one writes it again
  for (size_t segment = 0; segment + 1 < count; ++segment)
    even_times(knots[segment], knots[segment + 1], per_segment, times + segment * (per_segment - 1));
}

}  // namespace qtraj
