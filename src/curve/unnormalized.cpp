#include "curve/unnormalized.hpp"

#include "curve/evaluator.hpp"
#include "curve/extrapolation.hpp"
#include "curve/knot_lookup.hpp"
#include "curve/sample_output.hpp"
#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

// Value and derivatives at a time, those that are not asked for 0.
struct Point {
  double value[4], first[4], second[4];
};

// Multiplies a derivative by a factor; false where it overflows.
bool scale(double (&derivative)[4], double factor) {
  for (double& component : derivative) {
    double product;
    if (!scaled<double>(component, magnitude(factor), product)) return false;
    component = factor < 0 ? -product : product;
  }
  return true;
}

// Multiplies by the factor of time once and twice; false where a derivative that is asked for overflows.
bool scale_to_time(Point& point, double factor, const UnnormalizedOutputs& outputs) {
  if (outputs.first && !scale(point.first, factor)) return false;
  if (!outputs.second) return true;
  const bool once_fits = scale(point.second, factor);
  return once_fits && scale(point.second, factor);
}

template <size_t Degree>
bool evaluate(const NormalizedSegment<Degree>& segment, double elapsed, const UnnormalizedOutputs& outputs,
              Point& point) {
  const double x = parameter<Plain>(elapsed, segment.scale, 1.0);
  horner<Plain>(segment.c, x, point.value);
  first_derivative<Plain>(segment.c, x, point.first);
  second_derivative<Plain>(segment.c, x, point.second);
  return scale_to_time(point, segment.scale, outputs);
}

Status evaluate_inside(const Trajectory& trajectory, double time, size_t& cursor, const UnnormalizedOutputs& outputs,
                       Point& point) {
  const KnotIndex index = knot_index(trajectory.timeline);
  cursor = find_segment(index, time, cursor);
  if (is_in_gap(trajectory.timeline, index.knots, cursor, time)) return Status::gap;
  const double elapsed = time - index.knots[cursor];
  const bool fits = trajectory.kind == SegmentKind::normalized
                        ? evaluate(segments_of<NormalizedSegment<1>>(trajectory)[cursor], elapsed, outputs, point)
                        : evaluate(segments_of<NormalizedSegment<5>>(trajectory)[cursor], elapsed, outputs, point);
  return fits ? Status::ok : Status::not_finite;
}

// HOLD and CONSTANT_RATE.
bool evaluate_circle(const GreatCircle& circle, double time, const UnnormalizedOutputs& outputs, Point& point) {
  extrapolate(circle, time, point.value);
  if (circle.rate == 0) return true;
  const SinCos at = sin_cos(circle.angle(time));
  for (size_t k = 0; k < 4; ++k) {
    point.first[k] = circle.e[k] * at.cos - circle.m[k] * at.sin;
    point.second[k] = -point.value[k];
  }
  return scale_to_time(point, circle.rate, outputs);
}

// not_finite, time_range, gap or ok.
Status evaluate_at(const Trajectory& trajectory, double time, size_t& cursor, const UnnormalizedOutputs& outputs,
                   Point& point) {
  if (is_inside(trajectory.timeline, time)) return evaluate_inside(trajectory, time, cursor, outputs, point);
  const Place place = place_outside(trajectory.timeline, time);
  if (!place.has_value) return Status::time_range;
  if (place.beyond) {
    const bool fits = evaluate_circle(circle_beyond(trajectory, place), place.time, outputs, point);
    return fits ? Status::ok : Status::not_finite;
  }
  const Status status = evaluate_inside(trajectory, place.time, cursor, outputs, point);
  if (place.is_odd_round && trajectory.negate_on_wrap)
    for (double(*array)[4] : {&point.value, &point.first, &point.second})
      for (double& component : *array) component = -component;
  return status;
}

}  // namespace

bool is_unnormalized(const Trajectory& trajectory) {
  return trajectory.kind == SegmentKind::normalized || trajectory.kind == SegmentKind::normalized_quintic;
}

Outcome sample_unnormalized(const Trajectory& trajectory, const double* times, size_t count,
                            const UnnormalizedOutputs& outputs) {
  constexpr double kNaN = __builtin_nan("");
  constexpr Point kFault = {{kNaN, kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN, kNaN}};
  Outcome outcome;
  size_t cursor = 0;
  for (size_t row = 0; row < count; ++row) {
    Point point = {};
    const double time = times[row];  // once: it decides an index
    const Status status = is_finite(time) ? evaluate_at(trajectory, time, cursor, outputs, point) : Status::not_finite;
    if (status != Status::ok) point = kFault;
    if (status != Status::ok && outcome.status == Status::ok) outcome = {status, row};
    write(point.value, outputs.value, row);
    write(point.first, outputs.first, row);
    write(point.second, outputs.second, row);
  }
  return outcome;
}

}  // namespace qtraj
