// Knot times: what makes them valid.
#pragma once

#include "base/status.hpp"

namespace qtraj {

// Verdict on knot `index`, all finite and the knots before it valid: time_order where it does not come after the one
// before, or so shortly that 1/h^2 overflows; time_range where the span from the first knot overflows.
Status check_knot(const double* times, size_t index);
// The same for a time after `previous`, which need not come after `first`; all finite.
Status check_time(double first, double previous, double time);

// The shares of the two intervals around inner knot t1: right = (t2 - t1)/(t2 - t0), left = (t1 - t0)/(t2 - t0).
// Splines are written in them rather than in the intervals, whose products can overflow.
struct IntervalShares {
  double left, right;
};
IntervalShares interval_shares(double h_before, double h_after);

}  // namespace qtraj
