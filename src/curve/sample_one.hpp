// Sampling one time after the other: each finds its segment and is evaluated there. The vectors of sample_many.hpp
// equal it bit for bit, and leave to it what they cannot do: rows at fault, times outside the knots, small batches.
#pragma once

#include <type_traits>

#include "curve/evaluate_arc.hpp"
#include "curve/evaluate_nested_arcs.hpp"
#include "curve/evaluate_normalized.hpp"
#include "curve/evaluate_rotation_vector.hpp"
#include "curve/extrapolation.hpp"
#include "curve/knot_lookup.hpp"
#include "curve/sample_output.hpp"
#include "curve/series_call.hpp"

namespace qtraj {
namespace {

// ---- Which evaluator ----

// Calls `with` with the evaluator of a trajectory's segments for samples of type Real. Curves of ExponentRange::any are
// not evaluated in float.
template <class Arithmetic, size_t Degree, class Real, class With>
auto with_rotation_vector(ExponentRange range, const With& with) {
  if constexpr (std::is_same_v<Real, double>)
    if (range == ExponentRange::any) return with(LongRotationVectorEvaluator<Arithmetic, Degree>(range));
  return with(RotationVectorEvaluator<Arithmetic, Degree>(range));
}
template <class Arithmetic, class Real, class With>
auto with_evaluator(const Trajectory& trajectory, const With& with) {
  const ExponentRange range = trajectory.range;
  switch (trajectory.kind) {
    case SegmentKind::arc:
      return with(ArcEvaluator<Arithmetic>(range));
    case SegmentKind::nested_arcs:
      return with(NestedArcsEvaluator<Arithmetic>(range));
    case SegmentKind::normalized:
      return with(NormalizedEvaluator<Arithmetic, 1>(range));
    case SegmentKind::normalized_quintic:
      return with(NormalizedEvaluator<Arithmetic, 5>(range));
    case SegmentKind::rotation_vector_quintic:
      return with_rotation_vector<Arithmetic, 5, Real>(range, with);
    case SegmentKind::rotation_vector:
      break;
  }
  return with_rotation_vector<Arithmetic, 3, Real>(range, with);
}

// Calls `with(evaluator, with_rates)`, the latter std::true_type where the outputs of a call ask for rates.
template <class Arithmetic, class Real, class With>
auto with_evaluator_for(const Trajectory& trajectory, const SampleOutputs<Real>& outputs, const With& with) {
  return with_evaluator<Arithmetic, Real>(trajectory, [&](const auto& evaluator) {
    if (outputs.omega || outputs.alpha) return with(evaluator, std::true_type());
    return with(evaluator, std::false_type());
  });
}

// ---- One segment ----

template <class Real>
Status write_fault(Status status, const SampleOutputs<Real>& outputs, size_t i) {
  write_row<true>(nan_row<Real>(), outputs, i);
  return status;
}

// Converts a segment to other numbers: read(k) gives field k. Segments hold nothing but values of one type. The first
// field, the scale of time, is set to 0: it may be past the range of float. The segment is filled in place, because a
// returned struct of vectors would be copied through the stack.
template <class Value, class To, class Read>
void read_segment(const Read& read, To& segment) {
  static_assert(std::is_standard_layout_v<To> && sizeof(To) % sizeof(Value) == 0);
  auto* fields = reinterpret_cast<Value*>(&segment);
  fields[0] = Value(Element<Value>(0));
  each_of<sizeof(To) / sizeof(Value) - 1>([&](size_t k) { fields[1 + k] = read(1 + k); });
}

// Samples a segment up to its very ends and writes the row, NaN where a rate overflows; `negate` changes the sign of q.
template <class Real>
using EvaluateRow = Status(const Trajectory& trajectory, size_t segment, double elapsed, bool negate,
                           const SampleOutputs<Real>& outputs, size_t row);

// One function per kind of evaluator: in a common one, every sample would save and restore the registers that the
// largest kind needs.
template <class Evaluator, class Arithmetic, bool kWithRates, class Real>
QTRAJ_NOINLINE Status evaluate_row(const Trajectory& trajectory, size_t segment, double elapsed, bool negate,
                                   const SampleOutputs<Real>& outputs, size_t i) {
  using Mode = SampleMode<kWithRates, true>;
  const Evaluator evaluator(trajectory.range);
  const auto& record = segments_of<typename Evaluator::template SegmentOf<double>>(trajectory)[segment];
  const double scale = Evaluator::scale(record);
  const Real x = static_cast<Real>(parameter<Arithmetic>(elapsed, scale, Evaluator::offset(record)));
  typename Evaluator::template SegmentOf<Real> converted;
  if constexpr (std::is_same_v<Real, float>) {
    const auto* fields = reinterpret_cast<const double*>(&record);
    read_segment<Real>([&](size_t k) { return static_cast<Real>(fields[k]); }, converted);
  }
  const auto& in_real = [&]() -> const auto& {
    if constexpr (std::is_same_v<Real, float>)
      return converted;
    else
      return record;
  }
  ();

  SampleRow<Real> row;
  typename Evaluator::template PartialOf<Real, kWithRates> partial;
  evaluator.template start<Mode>(in_real, x, partial);
  if constexpr (kWithRates) {
    const RateRequest request = rate_request(outputs);
    Rates<Real> rates;
    evaluator.template finish_rates<Mode>(in_real, x, partial, request.alpha, row.q, rates);
    if (!finish_rates<Arithmetic>(row.q, rates, scale, request, row))
      return write_fault(Status::not_finite, outputs, i);
  } else {
    evaluator.template finish<Mode>(in_real, x, partial, row.q);
  }
  if (negate) each_of<4>([&](size_t k) { row.q[k] = -row.q[k]; });
  write_row<kWithRates>(row, outputs, i);
  return Status::ok;
}

// Samples a row of float in double and rounds it: for curves whose coefficients may be past the range of float.
template <EvaluateRow<double> kEvaluateDouble>
Status round_row(const Trajectory& trajectory, size_t segment, double elapsed, bool negate,
                 const SampleOutputs<float>& outputs, size_t i) {
  SampleRow<double> row;
  const SampleOutputs<double> in_double = {row.q, outputs.omega ? row.omega : nullptr,
                                           outputs.alpha ? row.alpha : nullptr, outputs.frame};
  const Status status = kEvaluateDouble(trajectory, segment, elapsed, negate, in_double, 0);
  if (status != Status::ok) return write_fault(status, outputs, i);
  const auto fits = [](double rate) { return magnitude(rate) <= largest_of<float>(); };
  for (size_t k = 0; k < 3; ++k)
    if ((in_double.omega && !fits(row.omega[k])) || (in_double.alpha && !fits(row.alpha[k])))
      return write_fault(Status::not_finite, outputs, i);
  write_row<true>(row, outputs, i);
  return Status::ok;
}

// The EvaluateRow for a trajectory and the outputs of a call. Float rows of ExponentRange::any use `kEvaluateDouble`.
template <class Arithmetic, class Real, EvaluateRow<double> kEvaluateDouble>
EvaluateRow<Real>* row_evaluator(const Trajectory& trajectory, const SampleOutputs<Real>& outputs) {
  if constexpr (std::is_same_v<Real, float>)
    if (trajectory.range == ExponentRange::any) return round_row<kEvaluateDouble>;
  return with_evaluator_for<Arithmetic>(trajectory, outputs,
                                        [](const auto& evaluator, auto with_rates) -> EvaluateRow<Real>* {
                                          using Evaluator = std::decay_t<decltype(evaluator)>;
                                          return evaluate_row<Evaluator, Arithmetic, decltype(with_rates)::value, Real>;
                                        });
}

// ---- One time ----

template <class Real>
Status sample_inside(const Trajectory& trajectory, double time, bool negate, size_t& cursor,
                     const SampleOutputs<Real>& outputs, size_t i, EvaluateRow<Real>* evaluate) {
  const KnotIndex index = knot_index(trajectory.timeline);
  const size_t segment = find_segment(index, time, cursor);
  cursor = segment;
  if (is_in_gap(trajectory.timeline, index.knots, segment, time)) return write_fault(Status::gap, outputs, i);
  return evaluate(trajectory, segment, time - index.knots[segment], negate, outputs, i);
}

// A finite time that is not inside.
template <class Real>
QTRAJ_NOINLINE Status sample_outside(const Trajectory& trajectory, double time, size_t& cursor,
                                     const SampleOutputs<Real>& outputs, size_t i, EvaluateRow<Real>* evaluate) {
  const Place place = place_outside(trajectory.timeline, time);
  if (!place.has_value) return write_fault(Status::time_range, outputs, i);
  const bool negate = place.is_odd_round && trajectory.negate_on_wrap;
  if (!place.beyond) return sample_inside(trajectory, place.time, negate, cursor, outputs, i, evaluate);
  const GreatCircle& circle = circle_beyond(trajectory, place);
  const RateRequest request = rate_request(outputs);
  SampleRow<Real> row;
  double q[4];
  extrapolate(circle, place.time, q);
  each_of<4>([&](size_t k) { row.q[k] = static_cast<Real>(q[k]); });
  const auto& omega = request.frame == Frame::world ? circle.omega_world : circle.omega_body;
  if (!extrapolated_rates(omega, request, row)) return write_fault(Status::not_finite, outputs, i);
  write_row<true>(row, outputs, i);
  return Status::ok;
}

// Samples and writes row i, NaN where it is at fault.
template <class Real>
QTRAJ_INLINE Status sample_row(const Trajectory& trajectory, double time, size_t& cursor,
                               const SampleOutputs<Real>& outputs, size_t i, EvaluateRow<Real>* evaluate) {
  if (!is_finite(time)) return write_fault(Status::not_finite, outputs, i);
  if (!is_inside(trajectory.timeline, time)) return sample_outside(trajectory, time, cursor, outputs, i, evaluate);
  return sample_inside(trajectory, time, false, cursor, outputs, i, evaluate);
}

// ---- Calls ----

// The outcome of several rows is that of the first one at fault.
inline void keep_first(Status status, size_t i, Outcome& outcome) {
  if (status != Status::ok && outcome.status == Status::ok) outcome = {status, i};
}

// The segment is found before the evaluator is chosen, which is then called directly: one indirect jump per sample.
template <class Arithmetic, class Real, EvaluateRow<double> kEvaluateDouble>
Status sample_one(const Trajectory& trajectory, double time, size_t& cursor, const SampleOutputs<Real>& outputs) {
  if (!is_finite(time)) return write_fault(Status::not_finite, outputs, 0);
  if (!is_inside(trajectory.timeline, time))
    return sample_outside(trajectory, time, cursor, outputs, 0,
                          row_evaluator<Arithmetic, Real, kEvaluateDouble>(trajectory, outputs));
  const KnotIndex index = knot_index(trajectory.timeline);
  const size_t segment = find_segment(index, time, cursor);
  cursor = segment;
  if (is_in_gap(trajectory.timeline, index.knots, segment, time)) return write_fault(Status::gap, outputs, 0);
  const double elapsed = time - index.knots[segment];
  if constexpr (std::is_same_v<Real, float>)
    if (trajectory.range == ExponentRange::any)
      return round_row<kEvaluateDouble>(trajectory, segment, elapsed, false, outputs, 0);
  return with_evaluator_for<Arithmetic>(trajectory, outputs, [&](const auto& evaluator, auto with_rates) {
    using Evaluator = std::decay_t<decltype(evaluator)>;
    return evaluate_row<Evaluator, Arithmetic, decltype(with_rates)::value, Real>(trajectory, segment, elapsed, false,
                                                                                  outputs, 0);
  });
}

template <class Arithmetic, class Real, EvaluateRow<double> kEvaluateDouble>
Outcome sample_one_by_one(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor,
                          const SampleOutputs<Real>& outputs) {
  EvaluateRow<Real>* const evaluate = row_evaluator<Arithmetic, Real, kEvaluateDouble>(trajectory, outputs);
  const TimeReader times(source, count);
  Outcome outcome = {Status::ok, kNoIndex};
  for (size_t i = 0; i < count; ++i)
    keep_first(sample_row(trajectory, times[i], cursor, outputs, i, evaluate), i, outcome);
  return outcome;
}

template <class Arithmetic, class Real, EvaluateRow<double> kEvaluateDouble>
Outcome sample_series_one_by_one(const SeriesCall& call, const SampleOutputs<Real>& outputs) {
  Outcome outcome = {Status::ok, kNoIndex};
  size_t cursor = 0;
  for (SeriesWalk walk(call); walk.left() > 0; walk.step()) {
    const Trajectory& trajectory = walk.trajectory();
    EvaluateRow<Real>* const evaluate = row_evaluator<Arithmetic, Real, kEvaluateDouble>(trajectory, outputs);
    keep_first(sample_row(trajectory, walk.time(), cursor, outputs, walk.row(), evaluate), walk.row(), outcome);
  }
  return outcome;
}

}  // namespace
}  // namespace qtraj
