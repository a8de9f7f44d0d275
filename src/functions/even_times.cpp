#include "functions/even_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/floating.hpp"
#include "math/error_free.hpp"

namespace qtraj {
namespace {

Status check_ends(double first, double last) {
  if (!is_finite(first) || !is_finite(last)) return Status::not_finite;
  return last < first ? Status::time_order : Status::ok;
}

// (a weight_a + b weight_b) / divisor, |a| and |b| below 4, weights integers up to the divisor.
double weighted_mean(double a, double weight_a, double b, double weight_b, double divisor) {
  const DoubleDouble part_a = two_product(a, weight_a), part_b = two_product(b, weight_b);
  const DoubleDouble sum = two_sum(part_a.value, part_b.value);
  const double sum_error = sum.error + (part_a.error + part_b.error);
  const double quotient = (sum.value + sum_error) / divisor;
  const DoubleDouble product = two_product(quotient, divisor);
  return quotient + (((sum.value - product.value) - product.error) + sum_error) / divisor;
}

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
  const double larger = std::max(std::abs(first), std::abs(last));
  const double scale = larger > 0 ? normalizing_scale(larger) : 1.0;
  const double intervals = static_cast<double>(count - 1);
  for (size_t k = 0; k < rows; ++k) {
    const size_t i = begin + k;
    const double steps = static_cast<double>(i);
    if (i == 0)
      times[k] = first;
    else if (i + 1 == count)
      times[k] = last;
    else
      times[k] = weighted_mean(scale * first, intervals - steps, scale * last, steps, intervals) / scale;
  }
}

void segment_times(const double* knots, size_t count, size_t per_segment, double* times) {
  // each segment writes the knot that it ends with, and the next one writes it again
  for (size_t segment = 0; segment + 1 < count; ++segment)
    even_times(knots[segment], knots[segment + 1], per_segment, times + segment * (per_segment - 1));
}

}  // namespace qtraj
