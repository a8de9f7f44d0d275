// Seconds of time stamps that count nanoseconds.
#pragma once

#include <cstddef>
#include <cstdint>

namespace qtraj {

// seconds [count]: the double nearest to (ns - origin) / 10^9, ties to even: one rounding, of the exact difference,
// also where that passes the range of int64_t. So a stamp within 104 days of the origin, 2^53 ns, is known to 0.5 ulp
// of the small difference, not of the large stamp: stamps since 1970 have an ulp of 2.4e-7 s.
void seconds_from_ns(const int64_t* ns, size_t count, int64_t origin, double* seconds);

}  // namespace qtraj
