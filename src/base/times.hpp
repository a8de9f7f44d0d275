// Knot times: which ones are valid, and the relative lengths of neighbouring intervals.
#pragma once

#include <cmath>

#include "base/status.hpp"

namespace qtraj {

// Checks knot `index`; all times are finite, and the knots before it valid. time_order: the knot does not come after
// the one before it, or so soon after it that 1/h^2 overflows. time_span: the span from the first knot overflows.
inline Status check_knot(const double* times, size_t index);
// The same check of a time that follows `previous`; `previous` may lie before `first`. All times are finite.
Status check_time(double first, double previous, double time);

// Makes knot `last` the first once more, a period after it. time_order where that does not come after the knot before
// it, time_span where it overflows.
Status set_closing_time(double* times, size_t last, double period);

// Whether a finite time comes after the one before by a step that is nowhere near the limits of check_time, as nearly
// all do.
inline bool is_common_step(double previous, double time) {
  if (!(std::abs(time) < 0x1p500)) return false;
  const double step = time - previous;
  return 0x1p-500 < step && step < 0x1p500;
}

inline Status check_knot(const double* times, size_t index) {
  if (index == 0 || is_common_step(times[index - 1], times[index])) return Status::ok;
  return check_time(times[0], times[index - 1], times[index]);
}

// How far beyond the first or the last time another still counts as it: 4 units in the last place of the larger one. An
// even grid of rounded times may end there.
double end_reach(double first, double last);
// The first and the last time that count as within these two, which are finite.
struct TimeSpan {
  double first, last;
};
TimeSpan reached_span(double first, double last);

// Relative lengths of the two intervals around an inner knot t1:
//   left = (t1 - t0)/(t2 - t0),  right = (t2 - t1)/(t2 - t0).
// The equations of splines use these shares, because products of the intervals themselves can overflow.
struct IntervalShares {
  double left, right;
};
IntervalShares interval_shares(double h_before, double h_after);

}  // namespace qtraj
