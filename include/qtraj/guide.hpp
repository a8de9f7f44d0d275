// Which segment a time belongs to, without a search over all knots: the span of the knots is cut into as many equal
// buckets as there are segments, and each bucket tells the first segment that a time in it can belong to. A few halving
// steps, the same number for every time, do the rest. Exact for any spacing of the knots; uneven spacing costs steps,
// never more than log2 of the number of segments, rounded up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace qtraj {

struct Guide {
  const uint64_t* first_candidate;  // [segments + 2], one per bucket
  double start;                     // of the knots
  double scale;                     // buckets per second
  int32_t steps;

  // Bucket of a time within the knots. Adding 2^52 rounds to an integer and leaves it in the low bits.
  static constexpr double kShift = 0x1p52;
  uint64_t bucket(double time) const {
    const double shifted = (time - start) * scale + kShift;
    uint64_t bits;
    std::memcpy(&bits, &shifted, sizeof bits);
    return bits & ((uint64_t{1} << 52) - 1);
  }
};

// Fills first_candidate [count + 1] for knots [count], tells scale and steps. A time's bucket may come out one off
// where the caller has set another rounding mode: the candidates allow for it.
void build_guide(const double* knots, size_t count, uint64_t* first_candidate, double& scale, int32_t& steps);

}  // namespace qtraj
