// Times at a fixed step for each of many series of keys: how many lie within its keys, and which they are.
#pragma once

#include "base/series.hpp"
#include "functions/for_each_row.hpp"

namespace qtraj {

// Row i of a series is its first key time + (double)i step, rounded twice.
struct StepSeries {
  Series keys;              // checked
  const double* key_times;  // s, indexed by the offsets; of each series the first and the last are read
  Input<1> step;            // s, one for all or one for each
};

// Offsets [keys.count + 1] from 0 on: of each series the rows that lie within its keys, those next to the last one
// counting as it (reached_span). A series at fault has none: too_few below 2 keys, not_finite, value (a step that is
// not above 0), time_order, time_span, and size past 2^53 rows or where the rows of all would be more than `most_rows`.
Outcome step_offsets(const StepSeries& series, size_t most_rows, int64_t* offsets, int32_t* statuses);

// The times of `rows`, indexed by their offsets, how many there be. A series at fault, in its keys or its step as
// above, is NaN; not_finite for a time that overflows, which is NaN, the others are right.
Outcome step_times(const StepSeries& series, const Series& rows, double* times, int32_t* statuses);

}  // namespace qtraj
