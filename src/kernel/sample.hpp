// Sampling: each time finds its segment and is evaluated there.
#pragma once

#include "evaluate_arc.hpp"
#include "evaluate_nested_arcs.hpp"
#include "evaluate_normalized.hpp"
#include "evaluate_rotation_vector.hpp"
#include "kernel.hpp"
#include "qtraj/extrapolation.hpp"
#include "qtraj/floating.hpp"

namespace qtraj {
namespace {

// ---- Times ----

constexpr double kLargest = 0x1.fffffffffffffp+1023;

double magnitude(double value) { return value < 0 ? -value : value; }

// False where no multiple below `count` of the step, added to the start, can overflow.
bool may_overflow(const TimeSource& times, size_t count) {
  return magnitude(times.start) > 0.25 * kLargest ||
         magnitude(times.step) > 0.25 * kLargest / static_cast<double>(count | 1);
}

// start + i step, or infinity instead of an overflow, which would raise FE_OVERFLOW.
double uniform_time_guarded(const TimeSource& times, double i) {
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

 private:
  const TimeSource& times_;
  bool finite_, guarded_;
};

// ---- Segments ----

// Segment of a time within the knots: the one that starts at or last before it; at the last knot the last one.
size_t find_segment(const double* knots, size_t segments, double time, size_t guess) {
  if (guess < segments && knots[guess] <= time) {
    if (time < knots[guess + 1]) return guess;
    if (guess + 1 < segments && time < knots[guess + 2]) return guess + 1;
  }
  size_t low = 0, count = segments;  // the answer is in [low, low + count)
  while (count > 1) {
    const size_t half = count / 2;
    if (knots[low + half] <= time) low += half;
    count -= half;
  }
  return low;
}

const char* bytes_of(const Trajectory& trajectory) { return reinterpret_cast<const char*>(&trajectory); }

// ---- Rows ----

template <class Real>
void write(const Real (&from)[4], Real* to) {
  for (int k = 0; k < 4; ++k) to[k] = from[k];
}

template <class Real>
void write_nan(Real* to) {
  for (int k = 0; k < 4; ++k) to[k] = static_cast<Real>(__builtin_nan(""));
}

// A time outside the knots: leaves q, or a time inside to sample, or a fault.
enum class Outside { fault, done, inside };
template <class Real>
Outside resolve_outside(const Trajectory& trajectory, double& time, bool& negate, Real* q_out) {
  const Extrapolation& side = time < trajectory.before.knot ? trajectory.before : trajectory.after;
  switch (side.rule) {
    case Extrapolate::hold:
    case Extrapolate::constant_rate: {
      double q[4];
      extrapolate(side, time, q);
      for (int k = 0; k < 4; ++k) q_out[k] = static_cast<Real>(q[k]);
      return Outside::done;
    }
    case Extrapolate::periodic: {
      const WrappedTime wrapped = wrap_time(trajectory, time);
      time = wrapped.time;
      negate = wrapped.negate;
      return Outside::inside;
    }
    case Extrapolate::error:
      break;
  }
  return Outside::fault;
}

template <class Evaluator, class Real>
Outcome sample_rows(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor, Real* q_out) {
  const auto* knots = reinterpret_cast<const double*>(bytes_of(trajectory) + sizeof(Trajectory));
  const auto* segments =
      reinterpret_cast<const typename Evaluator::Segment*>(bytes_of(trajectory) + trajectory.segments_offset);
  const size_t segment_count = trajectory.key_count - 1;
  const TimeReader times(source, count);
  Outcome outcome = {Status::ok, kNoIndex};
  const auto fault = [&outcome](Status status, size_t row, Real* out) {
    write_nan(out);
    if (outcome.status == Status::ok) outcome = {status, row};
  };

  for (size_t row = 0; row < count; ++row, q_out += 4) {
    double time = times[row];
    bool negate = false;
    if (!is_finite(time)) {
      fault(Status::not_finite, row, q_out);
      continue;
    }
    if (time < trajectory.before.knot || time > trajectory.after.knot) {
      const Outside outside = resolve_outside(trajectory, time, negate, q_out);
      if (outside == Outside::fault) fault(Status::time_range, row, q_out);
      if (outside != Outside::inside) continue;
    }
    cursor = find_segment(knots, segment_count, time, cursor);
    Real q[4];
    Evaluator::sample(segments[cursor], time - knots[cursor], q);
    if (negate)
      for (Real& component : q) component = -component;
    write(q, q_out);
  }
  return outcome;
}

template <class Arithmetic, class Real>
Outcome sample(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor, Real* q_out) {
  const auto with = [&](auto evaluator) {
    return sample_rows<decltype(evaluator)>(trajectory, times, count, cursor, q_out);
  };
  switch (trajectory.kind) {
    case SegmentKind::arc:
      return with(ArcEvaluator<Arithmetic>{});
    case SegmentKind::nested_arcs:
      return with(NestedArcsEvaluator<Arithmetic>{});
    case SegmentKind::normalized:
      return with(NormalizedEvaluator<Arithmetic, 1>{});
    case SegmentKind::rotation_vector:
      break;
  }
  switch (trajectory.range) {
    case ExponentRange::quarter_turn:
      return with(RotationVectorEvaluator<Arithmetic, 3, ExponentRange::quarter_turn>{});
    case ExponentRange::half_turn:
      return with(RotationVectorEvaluator<Arithmetic, 3, ExponentRange::half_turn>{});
    case ExponentRange::full_turn:
      return with(RotationVectorEvaluator<Arithmetic, 3, ExponentRange::full_turn>{});
    case ExponentRange::any:
      break;
  }
  return with(RotationVectorEvaluator<Arithmetic, 3, ExponentRange::any>{});
}

}  // namespace
}  // namespace qtraj
