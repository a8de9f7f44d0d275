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

// Whether a multiple below `count` of the step, added to the start, may overflow.
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

template <class Real, size_t Size>
void write(const Real (&from)[Size], Real* to, size_t row) {
  if (!to) return;
  for (size_t k = 0; k < Size; ++k) to[Size * row + k] = from[k];
}

template <class Real>
struct Row {
  Real q[4], omega[3], alpha[3];
};

template <class Real>
void write_row(const Row<Real>& from, const SampleOutputs<Real>& outputs, size_t row) {
  write(from.q, outputs.q, row);
  write(from.omega, outputs.omega, row);
  write(from.alpha, outputs.alpha, row);
}

template <class Real>
Row<Real> nan_row() {
  constexpr Real kNaN = static_cast<Real>(__builtin_nan(""));
  return {{kNaN, kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}};
}

template <class Real>
constexpr double largest_of() {
  return sizeof(Real) == sizeof(double) ? kLargest : 0x1.fffffep+127;
}

// value * factor, false instead of an overflow of the product or of its rounding to Real.
template <class Real>
bool scaled(double value, double factor, double& product) {
  constexpr double kSafe = 0x1p500;
  if ((magnitude(value) > kSafe || factor > kSafe) && factor > 1 && magnitude(value) > kLargest / factor) return false;
  product = value * factor;
  return magnitude(product) <= largest_of<Real>();
}

// Which rates a call asked for: an overflow of the others is none of its business.
struct Wanted {
  Frame frame;
  bool omega, alpha;
};

// Body rates in units of a segment to rates in time and in the frame asked for; false where one that is wanted
// overflows.
template <class Arithmetic, class Real, class Work>
bool finish_rates(const Real (&q)[4], Rates<Work>& rates, double scale, const Wanted& wanted, Row<Real>& row) {
  if (wanted.frame == Frame::world) {
    const Work attitude[4] = {static_cast<Work>(q[0]), static_cast<Work>(q[1]), static_cast<Work>(q[2]),
                              static_cast<Work>(q[3])};
    rotate_to_world<Arithmetic>(attitude, rates.omega);
    rotate_to_world<Arithmetic>(attitude, rates.alpha);
  }
  for (size_t k = 0; k < 3; ++k) {
    double value;
    if (wanted.omega) {
      if (!scaled<Real>(static_cast<double>(rates.omega[k]), scale, value)) return false;
      row.omega[k] = static_cast<Real>(value);
    }
    if (wanted.alpha) {
      if (!scaled<double>(static_cast<double>(rates.alpha[k]), scale, value)) return false;
      if (!scaled<Real>(value, scale, value)) return false;
      row.alpha[k] = static_cast<Real>(value);
    }
  }
  return true;
}

// Copies the constant rate of an extrapolated turn; false where it is past the range of Real.
template <class Real>
bool extrapolated_rates(const double (&omega)[3], const Wanted& wanted, Row<Real>& row) {
  for (size_t k = 0; k < 3; ++k) {
    row.alpha[k] = 0;
    if (!wanted.omega) continue;
    if (magnitude(omega[k]) > largest_of<Real>()) return false;
    row.omega[k] = static_cast<Real>(omega[k]);
  }
  return true;
}

// Samples one trajectory of one kind, with rates or without.
template <class Evaluator, class Arithmetic, class Real, bool kWithRates>
class Sampler {
 public:
  Sampler(const Trajectory& trajectory, const Wanted& wanted)
      : trajectory_(trajectory),
        wanted_(wanted),
        knots_(reinterpret_cast<const double*>(bytes_of(trajectory) + sizeof(Trajectory))),
        segments_(reinterpret_cast<const Segment*>(bytes_of(trajectory) + trajectory.segments_offset)) {}

  Status sample(double time, size_t& cursor, Row<Real>& row) const {
    if (!is_finite(time)) return Status::not_finite;
    if (time < trajectory_.before.knot || time > trajectory_.after.knot) return sample_outside(time, cursor, row);
    return sample_inside(time, cursor, row);
  }

 private:
  using Segment = typename Evaluator::Segment;
  using Work = typename Evaluator::template Working<Real>;

  Status sample_inside(double time, size_t& cursor, Row<Real>& row) const {
    cursor = find_segment(knots_, trajectory_.key_count - 1, time, cursor);
    const Segment& segment = segments_[cursor];
    const double elapsed = time - knots_[cursor];
    Evaluator::sample(segment, elapsed, row.q);
    if constexpr (kWithRates) {
      Rates<Work> rates;
      Evaluator::sample_rates(segment, elapsed, rates);
      if (!finish_rates<Arithmetic>(row.q, rates, Evaluator::scale(segment), wanted_, row)) return Status::not_finite;
    }
    return Status::ok;
  }

  Status sample_outside(double time, size_t& cursor, Row<Real>& row) const {
    const Extrapolation& side = time < trajectory_.before.knot ? trajectory_.before : trajectory_.after;
    if (side.rule == Extrapolate::error) return Status::time_range;
    if (side.rule == Extrapolate::periodic) {
      const WrappedTime wrapped = wrap_time(trajectory_, time);
      const Status status = sample_inside(wrapped.time, cursor, row);
      if (wrapped.negate)
        for (Real& component : row.q) component = -component;
      return status;
    }
    double q[4];
    extrapolate(side, time, q);
    for (size_t k = 0; k < 4; ++k) row.q[k] = static_cast<Real>(q[k]);
    if constexpr (kWithRates)
      if (!extrapolated_rates(wanted_.frame == Frame::world ? side.omega_world : side.omega_body, wanted_, row))
        return Status::not_finite;
    return Status::ok;
  }

  const Trajectory& trajectory_;
  const Wanted wanted_;
  const double* knots_;
  const Segment* segments_;
};

template <class Evaluator, class Arithmetic, bool kWithRates, class Real>
Outcome sample_rows(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor,
                    const SampleOutputs<Real>& outputs) {
  const Sampler<Evaluator, Arithmetic, Real, kWithRates> sampler(
      trajectory, {outputs.frame, outputs.omega != nullptr, outputs.alpha != nullptr});
  const TimeReader times(source, count);
  Outcome outcome = {Status::ok, kNoIndex};
  for (size_t i = 0; i < count; ++i) {
    Row<Real> row;
    const Status status = sampler.sample(times[i], cursor, row);
    if (status != Status::ok) {
      row = nan_row<Real>();
      if (outcome.status == Status::ok) outcome = {status, i};
    }
    if constexpr (kWithRates)
      write_row(row, outputs, i);
    else
      write(row.q, outputs.q, i);
  }
  return outcome;
}

// Calls `with` with the evaluator of a trajectory's segments.
template <class Arithmetic, size_t Degree, class With>
auto with_rotation_vector(ExponentRange range, const With& with) {
  switch (range) {
    case ExponentRange::quarter_turn:
      return with(RotationVectorEvaluator<Arithmetic, Degree, ExponentRange::quarter_turn>{});
    case ExponentRange::half_turn:
      return with(RotationVectorEvaluator<Arithmetic, Degree, ExponentRange::half_turn>{});
    case ExponentRange::full_turn:
      return with(RotationVectorEvaluator<Arithmetic, Degree, ExponentRange::full_turn>{});
    case ExponentRange::any:
      break;
  }
  return with(RotationVectorEvaluator<Arithmetic, Degree, ExponentRange::any>{});
}
template <class Arithmetic, class With>
auto with_evaluator(const Trajectory& trajectory, const With& with) {
  switch (trajectory.kind) {
    case SegmentKind::arc:
      return with(ArcEvaluator<Arithmetic>{});
    case SegmentKind::nested_arcs:
      return with(NestedArcsEvaluator<Arithmetic>{});
    case SegmentKind::normalized:
      return with(NormalizedEvaluator<Arithmetic, 1, ExponentRange::quarter_turn>{});
    case SegmentKind::normalized_quintic:
      if (trajectory.range == ExponentRange::any) return with(NormalizedEvaluator<Arithmetic, 5, ExponentRange::any>{});
      return with(NormalizedEvaluator<Arithmetic, 5, ExponentRange::quarter_turn>{});
    case SegmentKind::rotation_vector_quintic:
      return with_rotation_vector<Arithmetic, 5>(trajectory.range, with);
    case SegmentKind::rotation_vector:
      break;
  }
  return with_rotation_vector<Arithmetic, 3>(trajectory.range, with);
}

template <class Arithmetic, class Real>
Outcome sample(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor,
               const SampleOutputs<Real>& outputs) {
  return with_evaluator<Arithmetic>(trajectory, [&](auto evaluator) {
    using Evaluator = decltype(evaluator);
    if (outputs.omega || outputs.alpha)
      return sample_rows<Evaluator, Arithmetic, true>(trajectory, times, count, cursor, outputs);
    return sample_rows<Evaluator, Arithmetic, false>(trajectory, times, count, cursor, outputs);
  });
}

}  // namespace
}  // namespace qtraj
