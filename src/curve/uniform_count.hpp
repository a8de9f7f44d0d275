// How many samples at a fixed rate a trajectory has.
#pragma once

#include "base/status.hpp"
#include "base/times.hpp"
#include "curve/timeline.hpp"

namespace qtraj {

// The number of rows start + (double)i step, rounded twice, from i = 0 on, that lie within the knots; those next to an
// end count as it. not_finite; value where step is 0; time_range where start is outside; size past 2^53 rows.
Status uniform_count(const Timeline& timeline, double start, double step, size_t& count);
// The same where `span` is from the first to the last time that counts as within the knots (reached_span).
Status uniform_count(const TimeSpan& span, double start, double step, size_t& count);

}  // namespace qtraj
