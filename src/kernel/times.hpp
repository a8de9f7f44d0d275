// Times to sample, and the segments they belong to.
#pragma once

#include "kernel.hpp"
#include "qtraj/floating.hpp"
#include "qtraj/guide.hpp"

namespace qtraj {
namespace {

constexpr double kLargest = 0x1.fffffffffffffp+1023;

inline double magnitude(double value) { return value < 0 ? -value : value; }

// Whether a multiple below `count` of the step, added to the start, may overflow.
inline bool may_overflow(const TimeSource& times, size_t count) {
  return magnitude(times.start) > 0.25 * kLargest ||
         magnitude(times.step) > 0.25 * kLargest / static_cast<double>(count | 1);
}

// start + i step, or infinity instead of an overflow, which would raise FE_OVERFLOW.
inline double uniform_time_guarded(const TimeSource& times, double i) {
  constexpr double kInfinity = __builtin_inf();
  constexpr double kReduced = 0x1p-64;  // more than i has digits
  if (magnitude(i * (kReduced * times.step)) > kReduced * kLargest) return kInfinity;
  const double offset = i * times.step;
  if (magnitude(0.5 * times.start + 0.5 * offset) > 0.5 * kLargest) return kInfinity;
  return times.start + offset;
}

class TimeReader {
 public:
  TimeReader(const TimeSource& times, size_t count)
      : times_(times),
        finite_(is_finite(times.start) && is_finite(times.step)),
        guarded_(finite_ && !times.array && may_overflow(times, count)) {}

  double operator[](size_t i) const {
    if (times_.array) return times_.array[i];
    if (!finite_) return __builtin_nan("");
    const double row = static_cast<double>(i);
    return guarded_ ? uniform_time_guarded(times_, row) : times_.start + row * times_.step;
  }

  // Whether times are start + i step without a second thought.
  bool is_plain_uniform() const { return !times_.array && finite_ && !guarded_; }
  const TimeSource& source() const { return times_; }

 private:
  const TimeSource& times_;
  bool finite_, guarded_;
};

// Knots of a trajectory with their guide.
struct KnotIndex {
  const double* knots;
  size_t segments;
  Guide guide;
};

inline KnotIndex knot_index(const Trajectory& trajectory) {
  const char* block = reinterpret_cast<const char*>(&trajectory);
  return {reinterpret_cast<const double*>(block + sizeof(Trajectory)),
          trajectory.key_count - 1,
          {reinterpret_cast<const uint64_t*>(block + trajectory.guide_offset), trajectory.before.knot,
           trajectory.guide_scale, trajectory.guide_candidates}};
}

// Segment of a time within the knots: the one that starts at or last before it; at the last knot the last one.
// Looked for first at the guess, which may be any number, and after it.
inline size_t find_segment(const KnotIndex& index, double time, size_t guess) {
  const double* knots = index.knots;
  if (guess < index.segments && knots[guess] <= time) {
    if (time < knots[guess + 1]) return guess;
    if (guess + 1 < index.segments && time < knots[guess + 2]) return guess + 1;
  }
  size_t low = index.guide.first_candidate[index.guide.bucket(time)];
  for (size_t left = index.guide.candidates; left > 1; left -= left / 2) {
    const size_t middle = low + left / 2;
    low = knots[middle] <= time ? middle : low;
  }
  return low;
}

}  // namespace
}  // namespace qtraj
