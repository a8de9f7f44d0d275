// Times at even distances, both ends included.
#pragma once

#include "base/status.hpp"

namespace qtraj {

// times [count], s: t_i = first + i (last - first) / (count - 1), formed as (first (count - 1 - i) + last i) /
// (count - 1) to twice the digits of double. The ends are exact, and one time alone is `first`; t_i is within 0.51 ulp,
// 0.75 ulp where it is subnormal, plus 1e-31 of the larger of |first| and |last|. That is far below the distance of two
// times, so that they never decrease and never pass `last`, and what is exactly a decimal literal rounds like it:
// even_times(0, 1, 11) has 0.1, 0.2, 0.3.
// first = last: all are it. not_finite, and time_order where last < first: all are NaN.
Status even_times(double first, double last, size_t count, double* times);

}  // namespace qtraj
