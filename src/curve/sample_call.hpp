// The arguments of a sampling call: times, and arrays to write to.
#pragma once

#include "base/floating.hpp"
#include "base/settings.hpp"
#include "base/status.hpp"
#include "curve/trajectory.hpp"

namespace qtraj {

// Times to sample: an array, or start + (double)i step where `array` is null.
struct TimeSource {
  const double* array;
  double start, step;
};

// Rows to write: q [count][4], omega and alpha [count][3] in `frame`; each may be null.
template <class Real>
struct SampleOutputs {
  Real* q;
  Real* omega;
  Real* alpha;
  Frame frame;
};

// Samples at the times. Every row is written, one at fault with NaN; the outcome is that of the first row at fault.
// `cursor`, a segment index or any other number, says which segment to try first, and receives one that was used.
template <class Real>
using SampleFunction = Outcome(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor,
                               const SampleOutputs<Real>& outputs);
// One sample.
template <class Real>
using SampleAtFunction = Status(const Trajectory& trajectory, double time, size_t& cursor,
                                const SampleOutputs<Real>& outputs);

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
  constexpr double kReduced = 0x1p-64;  // i is below 2^64
  if (magnitude(i * (kReduced * times.step)) > kReduced * kLargest) return kInfinity;
  const double offset = i * times.step;
  if (magnitude(0.5 * times.start + 0.5 * offset) > 0.5 * kLargest) return kInfinity;
  return times.start + offset;
}

// A caller's time, read from memory once: were another thread to write it meanwhile, what is looked up is still what
// was compared with the knots.
inline double read_once(const double& time) { return *const_cast<const volatile double*>(&time); }

class TimeReader {
 public:
  TimeReader(const TimeSource& times, size_t count)
      : times_(times),
        finite_(is_finite(times.start) && is_finite(times.step)),
        guarded_(finite_ && !times.array && may_overflow(times, count)) {}

  double operator[](size_t i) const {
    if (times_.array) return read_once(times_.array[i]);
    if (!finite_) return __builtin_nan("");
    const double row = static_cast<double>(i);
    return guarded_ ? uniform_time_guarded(times_, row) : times_.start + row * times_.step;
  }

  // Whether times are start + i step and none can overflow.
  bool is_plain_uniform() const { return !times_.array && finite_ && !guarded_; }
  const TimeSource& source() const { return times_; }

 private:
  const TimeSource& times_;
  bool finite_, guarded_;
};

// The outputs from a row on.
template <class Real>
SampleOutputs<Real> from_row(const SampleOutputs<Real>& outputs, size_t row) {
  const auto at = [&](Real* to, size_t width) { return to ? to + width * row : nullptr; };
  return {at(outputs.q, 4), at(outputs.omega, 3), at(outputs.alpha, 3), outputs.frame};
}

// Which rates a call asks for. An overflow of a rate that it does not ask for is no fault.
struct RateRequest {
  Frame frame;
  bool omega, alpha;

  bool any() const { return omega || alpha; }
};
template <class Real>
RateRequest rate_request(const SampleOutputs<Real>& outputs) {
  return {outputs.frame, outputs.omega != nullptr, outputs.alpha != nullptr};
}

}  // namespace
}  // namespace qtraj
