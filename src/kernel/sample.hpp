// Sampling one time after the other: each finds its segment and is evaluated there. The reference that vector kernels
// of the same arithmetic equal bit for bit, and what they fall back on for rows at fault, times outside the knots and
// small batches.
#pragma once

#include <type_traits>

#include "evaluate_arc.hpp"
#include "evaluate_nested_arcs.hpp"
#include "evaluate_normalized.hpp"
#include "evaluate_rotation_vector.hpp"
#include "qtraj/extrapolation.hpp"
#include "rows.hpp"

namespace qtraj {
namespace {

// Segments of a trajectory as rows of numbers.
template <class Segment>
const Segment* segments_of(const Trajectory& trajectory) {
  return reinterpret_cast<const Segment*>(reinterpret_cast<const char*>(&trajectory) + trajectory.segments_offset);
}

// A segment's fields as other numbers: `read` makes each from its place in the row. Segments hold nothing but values of
// one type. The first field, the scale of time, is left out: it may be past the range of float. Written in place: a
// copy of vectors goes through memory.
template <class Value, class To, class Read>
void read_segment(const Read& read, To& segment) {
  static_assert(std::is_standard_layout_v<To> && sizeof(To) % sizeof(Value) == 0);
  auto* fields = reinterpret_cast<Value*>(&segment);
  fields[0] = Value(Element<Value>(0));
  each_of<sizeof(To) / sizeof(Value) - 1>([&](size_t k) { fields[1 + k] = read(1 + k); });
}

// Samples one trajectory of one kind, with rates or without.
template <class Evaluator, class Arithmetic, class Real, bool kWithRates>
class Sampler {
 public:
  using Segment = typename Evaluator::template SegmentOf<double>;
  using Work = typename Evaluator::template Working<Real>;

  Sampler(const Evaluator& evaluator, const Trajectory& trajectory, const Wanted& wanted)
      : evaluator_(evaluator), trajectory_(trajectory), wanted_(wanted) {}

  QTRAJ_INLINE Status sample(double time, size_t& cursor, Row<Real>& row) const {
    if (!is_finite(time)) return Status::not_finite;
    bool negate = false;
    if (time < trajectory_.before.knot || time > trajectory_.after.knot) {
      const Extrapolation& side = time < trajectory_.before.knot ? trajectory_.before : trajectory_.after;
      if (side.rule == Extrapolate::error) return Status::time_range;
      if (side.rule != Extrapolate::periodic) return sample_outside(side, time, row);
      const WrappedTime wrapped = wrap_time(trajectory_, time);
      time = wrapped.time;
      negate = wrapped.negate;
    }
    const KnotIndex index = knot_index(trajectory_);
    cursor = find_segment(index, time, cursor);
    const Status status = sample_segment(cursor, time - index.knots[cursor], row);
    if (negate) each_of<4>([&](size_t k) { row.q[k] = -row.q[k]; });
    return status;
  }

  // In a given segment, up to its very ends.
  QTRAJ_INLINE Status sample_segment(size_t segment, double elapsed, Row<Real>& row) const {
    const Segment& record = segments_of<Segment>(trajectory_)[segment];
    const double scale = Evaluator::scale(record);
    const Work x = static_cast<Work>(parameter<Arithmetic>(elapsed, scale, Evaluator::offset(record)));
    if constexpr (std::is_same_v<Work, double>) {
      return evaluate_at(record, x, scale, row);
    } else {
      const auto* fields = reinterpret_cast<const double*>(&record);
      typename Evaluator::template SegmentOf<Work> work;
      read_segment<Work>([&](size_t k) { return static_cast<Work>(fields[k]); }, work);
      return evaluate_at(work, x, scale, row);
    }
  }

 private:
  QTRAJ_INLINE Status evaluate_at(const typename Evaluator::template SegmentOf<Work>& segment, Work x, double scale,
                                  Row<Real>& row) const {
    using Task = EvaluatorTask<kWithRates, true>;
    typename Evaluator::template Begun<Work> begun;
    evaluator_.template begin<Task>(segment, x, begun);
    Work q[4];
    bool safe = true;
    if constexpr (kWithRates) {
      Rates<Work> rates;
      evaluator_.template finish_rates<Task>(segment, x, begun, wanted_.alpha, q, rates);
      safe = finish_rates<Arithmetic>(q, rates, scale, wanted_, row);
    } else {
      evaluator_.template finish<Task>(segment, x, begun, q);
    }
    each_of<4>([&](size_t k) { row.q[k] = static_cast<Real>(q[k]); });
    return safe ? Status::ok : Status::not_finite;
  }

  Status sample_outside(const Extrapolation& side, double time, Row<Real>& row) const {
    double q[4];
    extrapolate(side, time, q);
    each_of<4>([&](size_t k) { row.q[k] = static_cast<Real>(q[k]); });
    if constexpr (kWithRates)
      if (!extrapolated_rates(wanted_.frame == Frame::world ? side.omega_world : side.omega_body, wanted_, row))
        return Status::not_finite;
    return Status::ok;
  }

  const Evaluator evaluator_;
  const Trajectory& trajectory_;
  const Wanted wanted_;
};

// Calls `with` with the evaluator of a trajectory's segments.
template <class Arithmetic, size_t Degree, class With>
auto with_rotation_vector(ExponentRange range, const With& with) {
  if (range == ExponentRange::any) return with(LongRotationVectorEvaluator<Arithmetic, Degree>{});
  return with(RotationVectorEvaluator<Arithmetic, Degree>(static_cast<int>(range)));
}
template <class Arithmetic, class With>
auto with_evaluator(const Trajectory& trajectory, const With& with) {
  switch (trajectory.kind) {
    case SegmentKind::arc:
      return with(ArcEvaluator<Arithmetic>{});
    case SegmentKind::nested_arcs:
      return with(NestedArcsEvaluator<Arithmetic>{});
    case SegmentKind::normalized:
      return with(NormalizedEvaluator<Arithmetic, 1, false>{});
    case SegmentKind::normalized_quintic:
      if (trajectory.range == ExponentRange::any) return with(NormalizedEvaluator<Arithmetic, 5, true>{});
      return with(NormalizedEvaluator<Arithmetic, 5, false>{});
    case SegmentKind::rotation_vector_quintic:
      return with_rotation_vector<Arithmetic, 5>(trajectory.range, with);
    case SegmentKind::rotation_vector:
      break;
  }
  return with_rotation_vector<Arithmetic, 3>(trajectory.range, with);
}

template <class Real>
Wanted wanted_of(const SampleOutputs<Real>& outputs) {
  return {outputs.frame, outputs.omega != nullptr, outputs.alpha != nullptr};
}

// Calls `with(evaluator, with_rates)`, the latter std::true_type where the outputs of a call ask for rates.
template <class Arithmetic, class Real, class With>
auto with_evaluator_for(const Trajectory& trajectory, const SampleOutputs<Real>& outputs, const With& with) {
  return with_evaluator<Arithmetic>(trajectory, [&](const auto& evaluator) {
    if (outputs.omega || outputs.alpha) return with(evaluator, std::true_type());
    return with(evaluator, std::false_type());
  });
}

// Samples and writes one row, NaN where it is at fault. A function by itself for each kind of sampler: in one for all,
// every sample would pay for the registers that the largest needs.
template <class Arithmetic, bool kWithRates, class Evaluator, class Real>
__attribute__((noinline)) Status sample_row(Evaluator evaluator, const Trajectory& trajectory, double time,
                                            size_t& cursor, const SampleOutputs<Real>& outputs, size_t i) {
  const Sampler<Evaluator, Arithmetic, Real, kWithRates> sampler(evaluator, trajectory, wanted_of(outputs));
  Row<Real> row;
  const Status status = sampler.sample(time, cursor, row);
  if (status == Status::ok)
    write_row<kWithRates>(row, outputs, i);
  else
    write_row<kWithRates>(nan_row<Real>(), outputs, i);
  return status;
}

// Of several rows, the outcome is that of the first at fault.
inline void keep_first(Status status, size_t i, Outcome& outcome) {
  if (status != Status::ok && outcome.status == Status::ok) outcome = {status, i};
}

template <class Arithmetic, class Real>
Status sample_at(const Trajectory& trajectory, double time, size_t& cursor, const SampleOutputs<Real>& outputs) {
  return with_evaluator_for<Arithmetic>(trajectory, outputs, [&](const auto& evaluator, auto with_rates) {
    return sample_row<Arithmetic, decltype(with_rates)::value>(evaluator, trajectory, time, cursor, outputs, 0);
  });
}

template <class Arithmetic, class Real>
Outcome sample(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor,
               const SampleOutputs<Real>& outputs) {
  return with_evaluator_for<Arithmetic>(trajectory, outputs, [&](const auto& evaluator, auto with_rates) {
    constexpr bool kWithRates = decltype(with_rates)::value;
    const TimeReader times(source, count);
    Outcome outcome = {Status::ok, kNoIndex};
    for (size_t i = 0; i < count; ++i)
      keep_first(sample_row<Arithmetic, kWithRates>(evaluator, trajectory, times[i], cursor, outputs, i), i, outcome);
    return outcome;
  });
}

}  // namespace
}  // namespace qtraj
