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
  for (size_t k = 1; k < sizeof(To) / sizeof(Value); ++k) fields[k] = read(k);
}

// Samples one trajectory of one kind, with rates or without.
template <class Evaluator, class Arithmetic, class Real, bool kWithRates>
class Sampler {
 public:
  using Segment = typename Evaluator::template SegmentOf<double>;
  using Work = typename Evaluator::template Working<Real>;

  Sampler(const Evaluator& evaluator, const Trajectory& trajectory, const Wanted& wanted)
      : evaluator_(evaluator),
        trajectory_(trajectory),
        wanted_(wanted),
        index_(knot_index(trajectory)),
        segments_(segments_of<Segment>(trajectory)) {}

  Status sample(double time, size_t& cursor, Row<Real>& row) const {
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
    cursor = find_segment(index_, time, cursor);
    const Status status = sample_segment(cursor, time - index_.knots[cursor], row);
    if (negate)
      for (Real& component : row.q) component = -component;
    return status;
  }

  // In a given segment, up to its very ends.
  Status sample_segment(size_t segment, double elapsed, Row<Real>& row) const {
    const Segment& record = segments_[segment];
    const double scale = Evaluator::scale(record);
    const Work x = static_cast<Work>(parameter<Arithmetic>(elapsed, scale, Evaluator::offset(record)));
    const auto& fields = as_work(record);
    using Task = EvaluatorTask<kWithRates, true>;
    typename Evaluator::template Begun<Work> begun;
    evaluator_.template begin<Task>(fields, x, begun);
    Work q[4];
    bool safe = true;
    if constexpr (kWithRates) {
      Rates<Work> rates;
      evaluator_.template finish_rates<Task>(fields, x, begun, wanted_.alpha, q, rates);
      safe = finish_rates<Arithmetic>(q, rates, scale, wanted_, row);
    } else {
      evaluator_.template finish<Task>(fields, x, begun, q);
    }
    for (size_t k = 0; k < 4; ++k) row.q[k] = static_cast<Real>(q[k]);
    return safe ? Status::ok : Status::not_finite;
  }

 private:
  static decltype(auto) as_work(const Segment& segment) {
    if constexpr (std::is_same_v<Work, double>) {
      return (segment);
    } else {
      const auto* fields = reinterpret_cast<const double*>(&segment);
      typename Evaluator::template SegmentOf<Work> work;
      read_segment<Work>([&](size_t k) { return static_cast<Work>(fields[k]); }, work);
      return work;
    }
  }

  Status sample_outside(const Extrapolation& side, double time, Row<Real>& row) const {
    double q[4];
    extrapolate(side, time, q);
    for (size_t k = 0; k < 4; ++k) row.q[k] = static_cast<Real>(q[k]);
    if constexpr (kWithRates)
      if (!extrapolated_rates(wanted_.frame == Frame::world ? side.omega_world : side.omega_body, wanted_, row))
        return Status::not_finite;
    return Status::ok;
  }

  const Evaluator evaluator_;
  const Trajectory& trajectory_;
  const Wanted wanted_;
  const KnotIndex index_;
  const Segment* segments_;
};

// Samples and writes one row, NaN where it is at fault.
template <class Sampler, class Real>
void sample_row(const Sampler& sampler, double time, size_t i, size_t& cursor, const SampleOutputs<Real>& outputs,
                Outcome& outcome) {
  Row<Real> row;
  const Status status = sampler.sample(time, cursor, row);
  if (status != Status::ok) {
    row = nan_row<Real>();
    if (outcome.status == Status::ok) outcome = {status, i};
  }
  write_row(row, outputs, i);
}

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

// Calls `with` with the sampler that the outputs of a call need.
template <class Arithmetic, class Real, class With>
auto with_sampler(const Trajectory& trajectory, const SampleOutputs<Real>& outputs, const With& with) {
  return with_evaluator<Arithmetic>(trajectory, [&](const auto& evaluator) {
    using Evaluator = std::decay_t<decltype(evaluator)>;
    const Wanted wanted = wanted_of(outputs);
    if (wanted.omega || wanted.alpha)
      return with(Sampler<Evaluator, Arithmetic, Real, true>(evaluator, trajectory, wanted));
    return with(Sampler<Evaluator, Arithmetic, Real, false>(evaluator, trajectory, wanted));
  });
}

template <class Arithmetic, class Real>
Status sample_at(const Trajectory& trajectory, double time, size_t& cursor, const SampleOutputs<Real>& outputs) {
  return with_sampler<Arithmetic>(trajectory, outputs, [&](const auto& sampler) {
    Outcome outcome = {Status::ok, kNoIndex};
    sample_row(sampler, time, 0, cursor, outputs, outcome);
    return outcome.status;
  });
}

template <class Arithmetic, class Real>
Outcome sample(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor,
               const SampleOutputs<Real>& outputs) {
  return with_sampler<Arithmetic>(trajectory, outputs, [&](const auto& sampler) {
    const TimeReader times(source, count);
    Outcome outcome = {Status::ok, kNoIndex};
    for (size_t i = 0; i < count; ++i) sample_row(sampler, times[i], i, cursor, outputs, outcome);
    return outcome;
  });
}

}  // namespace
}  // namespace qtraj
