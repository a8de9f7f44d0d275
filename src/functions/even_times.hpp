// Evenly spaced times, both ends included.
#pragma once

#include "base/status.hpp"

namespace qtraj {

// times [count], s: t_i = first + i (last - first) / (count - 1), formed in double-double as
//   (first (count - 1 - i) + last i) / (count - 1).
// The ends are exact, and a single time is `first`; t_i is within 0.51 ulp, 0.75 ulp where it is subnormal, plus 1e-31
// of the larger of |first| and |last|. That is far below the distance of two times: they never decrease, never pass
// `last`, and a time whose exact value is a decimal literal rounds like that literal, so that even_times(0, 1, 11) has
// 0.1, 0.2, 0.3. Where first = last all times are equal to it. not_finite, and time_order where last < first: all times
// are NaN.
Status even_times(double first, double last, size_t count, double* times);
// Of these `count` times the `rows` from `begin` on; first and last are finite and in order.
void write_even_times(double first, double last, size_t count, size_t begin, size_t rows, double* times);

// per_segment of them in each segment of strictly increasing knots [count], those that two segments share once: times
// [(count - 1) (per_segment - 1) + 1], which never decrease and hold every knot as it is. count, per_segment >= 2.
void segment_times(const double* knots, size_t count, size_t per_segment, double* times);

}  // namespace qtraj
