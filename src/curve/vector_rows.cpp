#include "curve/vector_rows.hpp"

#include <type_traits>

#include "curve/evaluate_vector.hpp"
#include "curve/knot_lookup.hpp"
#include "curve/sample_output.hpp"
#include "math/product.hpp"

namespace qtraj {
namespace {

constexpr double kNaN = __builtin_nan("");

template <class Real>
Status write_fault(Status status, const VectorOutputs<Real>& outputs, size_t dim) {
  for (Real* to : {outputs.value, outputs.first, outputs.second})
    for (size_t c = 0; to && c < dim; ++c) to[c] = static_cast<Real>(kNaN);
  return status;
}

// Writes a number, rounded to Real; false where it overflows.
template <class Real>
bool write_number(double number, Real& to) {
  if (!is_finite(number) || magnitude(number) > largest_of<Real>()) return false;
  to = static_cast<Real>(number);
  return true;
}

// number / scale * rate^times, rounded to Real; false where it overflows. The scale is a power of two.
template <class Real>
bool finish(double number, double scale, double rate, int times, Real& to) {
  if (!is_finite(number)) return false;
  if (scale != 1.0) {
    Product product(number);
    for (product /= scale; times > 0; --times) product *= rate;
    return product.value(number) && write_number(number, to);
  }
  for (; times > 0; --times)
    if (!scaled<double>(number, rate, number)) return false;
  return write_number(number, to);
}

// The numbers of a component.
template <size_t kTerms>
QTRAJ_INLINE VectorComponent<double> component_of(const VectorCurve& curve, const VectorSegment& segment,
                                                  const SegmentPosition<double>& at, size_t c) {
  const auto shape = [&](size_t term) { return term < kTerms ? segment.shape[term * curve.dim + c] : 0.0; };
  const double* const near = at.is_first_half ? segment.left : segment.right;
  return {near[c], segment.right[c] - segment.left[c], shape(0), shape(1), shape(2), shape(3)};
}

// Of a curve of any numbers; false where one that is asked for overflows.
template <size_t kTerms, class Real>
bool evaluate_guarded(const VectorCurve& curve, const VectorSegment& segment, const SegmentPosition<double>& at,
                      const VectorOutputs<Real>& outputs) {
  const double rate = 1.0 / segment.h;
  for (size_t c = 0; c < curve.dim; ++c) {
    const VectorComponent<double> p = component_of<kTerms>(curve, segment, at, c);
    const double scale = scales_of(curve)[c];
    double first, second;
    vector_derivatives<kTerms>(p, at, first, second);
    if ((outputs.value && !finish(vector_value<kTerms>(p, at), scale, 1.0, 0, outputs.value[c])) ||
        (outputs.first && !finish(first, scale, rate, 1, outputs.first[c])) ||
        (outputs.second && !finish(second, scale, rate, 2, outputs.second[c])))
      return false;
  }
  return true;
}

// Of an ordinary curve, into double: nothing can overflow.
template <size_t kTerms>
void evaluate_ordinary(const VectorCurve& curve, const VectorSegment& segment, const SegmentPosition<double>& at,
                       const VectorOutputs<double>& outputs) {
  if (outputs.value)
    for (size_t c = 0; c < curve.dim; ++c)
      outputs.value[c] = vector_value<kTerms>(component_of<kTerms>(curve, segment, at, c), at);
  if (!outputs.first && !outputs.second) return;
  const double rate = 1.0 / segment.h;
  for (size_t c = 0; c < curve.dim; ++c) {
    double first, second;
    vector_derivatives<kTerms>(component_of<kTerms>(curve, segment, at, c), at, first, second);
    if (outputs.first) outputs.first[c] = first * rate;
    if (outputs.second) outputs.second[c] = second * rate * rate;
  }
}

template <class Real>
Status evaluate(const VectorCurve& curve, size_t index, double elapsed, const VectorOutputs<Real>& outputs) {
  const VectorSegment segment = vector_segment(curve, index);
  const SegmentPosition<double> at(elapsed / segment.h);
  return with_terms(curve.terms, [&](auto terms) {
    constexpr size_t kTerms = decltype(terms)::value;
    if constexpr (std::is_same_v<Real, double>) {
      if (curve.is_ordinary) {
        evaluate_ordinary<kTerms>(curve, segment, at, outputs);
        return Status::ok;
      }
    }
    if (evaluate_guarded<kTerms>(curve, segment, at, outputs)) return Status::ok;
    return write_fault(Status::not_finite, outputs, curve.dim);
  });
}

// The derivative by u at an end, in the scale of the component.
double end_slope(const VectorCurve& curve, const VectorSegment& segment, const SegmentPosition<double>& at, size_t c) {
  double first, second;
  with_terms(curve.terms, [&](auto terms) {
    constexpr size_t kTerms = decltype(terms)::value;
    vector_derivatives<kTerms>(component_of<kTerms>(curve, segment, at, c), at, first, second);
  });
  return first;
}

template <class Real>
Status sample_inside(const VectorCurve& curve, double time, size_t& cursor, const VectorOutputs<Real>& outputs) {
  const KnotIndex index = knot_index(curve.timeline);
  cursor = find_segment(index, time, cursor);
  if (is_in_gap(curve.timeline, index.knots, cursor, time)) return write_fault(Status::gap, outputs, curve.dim);
  return evaluate(curve, cursor, time - index.knots[cursor], outputs);
}

// A component on the straight line from an end: end + 2 slope half_elapsed. False where it overflows.
template <class Real>
bool straight_on(double end, double slope, double scale, double rate, double half_elapsed, Real& to) {
  Product product(slope);
  product /= scale;
  product *= rate;
  product *= half_elapsed;
  product *= 0.5;
  double way;  // a quarter of it
  if (!product.value(way)) return false;
  // In quarters, as the way and the sum may overflow; a sum that is small is taken whole: quarters could be subnormal.
  const double key = end / scale, quarter = 0.25 * key + way;
  if (magnitude(quarter) > 0.25 * kLargest) return false;
  return write_number(magnitude(quarter) > 1.0 ? 4.0 * quarter : key + 4.0 * way, to);
}

// The straight line on from an end, or, under HOLD and of a key that stands apart, the end.
template <class Real>
Status go_on_from_end(const VectorCurve& curve, const Place& place, const VectorOutputs<Real>& outputs) {
  const Timeline& timeline = curve.timeline;
  const bool is_after = place.beyond == &timeline.after;
  const bool moves = place.beyond->rule == Extrapolate::constant_rate && !curve.holds_keys;
  // halved first: the difference may overflow
  const double half_elapsed = 0.5 * place.time - 0.5 * place.beyond->knot;

  const VectorSegment segment = vector_segment(curve, is_after ? timeline.key_count - 2 : 0);
  const double* const end = vector_keys_of(curve) + (is_after ? (timeline.key_count - 1) * curve.dim : 0);
  const SegmentPosition<double> at(is_after ? 1.0 : 0.0);
  const double rate = 1.0 / segment.h;
  for (size_t c = 0; c < curve.dim; ++c) {
    const double scale = scales_of(curve)[c], slope = moves ? end_slope(curve, segment, at, c) : 0.0;
    if (!is_finite(slope) ||
        (outputs.value && !straight_on(end[c], slope, scale, rate, half_elapsed, outputs.value[c])) ||
        (outputs.first && !finish(slope, scale, rate, 1, outputs.first[c])))
      return write_fault(Status::not_finite, outputs, curve.dim);
    if (outputs.second) outputs.second[c] = 0;
  }
  return Status::ok;
}

template <class Real>
QTRAJ_NOINLINE Status sample_outside(const VectorCurve& curve, double time, size_t& cursor,
                                     const VectorOutputs<Real>& outputs) {
  const Place place = place_outside(curve.timeline, time);
  if (!place.has_value) return write_fault(Status::time_range, outputs, curve.dim);
  if (place.beyond) return go_on_from_end(curve, place, outputs);
  return sample_inside(curve, place.time, cursor, outputs);
}

template <class Real>
Status sample_at(const VectorCurve& curve, double time, size_t& cursor, const VectorOutputs<Real>& outputs) {
  if (!is_finite(time)) return write_fault(Status::not_finite, outputs, curve.dim);
  if (!is_inside(curve.timeline, time)) return sample_outside(curve, time, cursor, outputs);
  return sample_inside(curve, time, cursor, outputs);
}

template <class Real>
Outcome sample_rows(const VectorCurve& curve, const TimeSource& source, size_t count, size_t& cursor,
                    const VectorOutputs<Real>& outputs) {
  const TimeReader times(source, count);
  Outcome outcome;
  for (size_t i = 0; i < count; ++i) {
    const Status status = sample_at(curve, times[i], cursor, from_row(outputs, i, curve.dim));
    if (status != Status::ok && outcome.status == Status::ok) outcome = {status, i};
  }
  return outcome;
}

}  // namespace

Status sample_vector_at(const VectorCurve& curve, double time, size_t& cursor, const VectorOutputs<double>& outputs) {
  return sample_at(curve, time, cursor, outputs);
}
Status sample_vector_at(const VectorCurve& curve, double time, size_t& cursor, const VectorOutputs<float>& outputs) {
  return sample_at(curve, time, cursor, outputs);
}

Outcome sample_vector_rows(const VectorCurve& curve, const TimeSource& times, size_t count, size_t& cursor,
                           const VectorOutputs<double>& outputs) {
  return sample_rows(curve, times, count, cursor, outputs);
}
Outcome sample_vector_rows(const VectorCurve& curve, const TimeSource& times, size_t count, size_t& cursor,
                           const VectorOutputs<float>& outputs) {
  return sample_rows(curve, times, count, cursor, outputs);
}

void copy_vector_keys(const VectorCurve& curve, double* values) {
  const double *const keys = vector_keys_of(curve), *const scales = scales_of(curve);
  for (size_t i = 0; i < curve.timeline.key_count * curve.dim; ++i) values[i] = keys[i] / scales[i % curve.dim];
}

}  // namespace qtraj
