#include "diagnostics/segment_rates.hpp"

#include "curve/sample_one.hpp"
#include "math/quaternion.hpp"

namespace qtraj {
namespace {

// ---- Whether rounding leaves digits

template <class Segment, class Partial>
bool has_digits(const Segment&, const Partial&) {
  return true;
}
// The polynomial is computed to an eps of its coefficients.
template <size_t Degree>
bool has_digits(const NormalizedSegment<Degree>& segment,
                const typename NormalizedEvaluator<Plain, Degree>::template Partial<double>& partial) {
  double squares = 0;
  for (const auto& c : segment.c) squares += dot_product<Plain>(c, c);
  return partial.norm_squared > 0x1p-60 * squares;
}
// The cosine of half the angle between the arcs' points comes from a sum that is right to an eps.
bool has_digits(const NestedArcsSegment& segment, const PointPair<double>& points) {
  return segment.near > 0.5 || points.closeness > 0x1p-60;
}

// ---- The parameter of an evaluator, x = s times this

template <class Segment>
double range_of_parameter(const Segment&) {
  return 1.0;
}
double range_of_parameter(const ArcSegment& segment) { return segment.half_angle; }

template <class Evaluator>
bool evaluate(const Evaluator& evaluator, const typename Evaluator::template SegmentOf<double>& segment, double s,
              bool with_alpha, RatesInSegment& result) {
  using Mode = SampleMode<true, true>;
  const double range = range_of_parameter(segment), x = s * range;
  // what is looked at for digits belongs to the value
  typename Evaluator::template PartialOf<double, false> of_value;
  typename Evaluator::template PartialOf<double, true> partial;
  evaluator.template start<SampleMode<false, true>>(segment, x, of_value);
  if (!has_digits(segment, of_value)) return false;
  evaluator.template start<Mode>(segment, x, partial);
  double q[4];
  Rates<double> rates;
  evaluator.template finish_rates<Mode>(segment, x, partial, with_alpha, q, rates);
  result.omega = range * load(rates.omega);
  if (with_alpha) result.alpha = (range * range) * load(rates.alpha);
  return true;
}

}  // namespace

bool rates_in_segment(const Trajectory& trajectory, size_t segment, double s, bool with_alpha, RatesInSegment& rates) {
  return with_evaluator<Plain, double>(trajectory, [&](const auto& evaluator) {
    using Evaluator = std::decay_t<decltype(evaluator)>;
    const auto& record = segments_of<typename Evaluator::template SegmentOf<double>>(trajectory)[segment];
    return evaluate(evaluator, record, s, with_alpha, rates);
  });
}

}  // namespace qtraj
