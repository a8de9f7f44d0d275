#include "base/times.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace qtraj {

Status check_time(double first, double previous, double time) {
  if (!(time > previous)) return Status::time_order;
  // halved first, so that the difference cannot overflow
  if (0.5 * time - 0.5 * std::min(first, previous) > 0.5 * DBL_MAX) return Status::time_span;
  // The least step whose square, rounded, is not below 2^-1024, the reciprocal of DBL_MAX. That is a subnormal number,
  // which a processor told to treat these as 0 could not be compared with.
  constexpr double kLeastStep = 0x1.ffffffffffffep-513;
  if (time - previous < kLeastStep) return Status::time_order;
  // Curves are evaluated in (t - t_i) 2/h, which is subnormal from 2^1023 s on: 0 where such numbers are taken as 0.
  if (2.0 / (time - previous) == 0) return Status::time_span;
  return Status::ok;
}

Status set_closing_time(double* times, size_t last, double period) {
  if (0.5 * times[0] + 0.5 * period > 0.5 * DBL_MAX) return Status::time_span;
  times[last] = times[0] + period;
  return check_knot(times, last);
}

double end_reach(double first, double last) {
  const double larger = std::max(std::abs(first), std::abs(last));
  return 4.0 * (larger - std::nextafter(larger, 0.0));
}

TimeSpan reached_span(double first, double last) {
  const double reach = end_reach(first, last);
  return {std::max(first, reach - DBL_MAX) - reach, std::min(last, DBL_MAX - reach) + reach};
}

IntervalShares interval_shares(double h_before, double h_after) {
  // halved first: for a span near DBL_MAX the sum of the two intervals may round up to infinity
  const double half_span = 0.5 * h_before + 0.5 * h_after;
  return {0.5 * h_before / half_span, 0.5 * h_after / half_span};
}

}  // namespace qtraj
