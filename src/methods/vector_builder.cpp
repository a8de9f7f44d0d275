#include "methods/vector_builder.hpp"

#include <algorithm>

#include "base/times.hpp"
#include "curve/sample_output.hpp"
#include "math/cubic_spline.hpp"
#include "methods/method.hpp"

namespace qtraj {
namespace {

constexpr Method kCubic = Method{QTRAJ_VECTOR_CUBIC};

class VectorBuilder {
 public:
  VectorBuilder(const Options& options, const VectorInput& input, VectorCurve& curve, double* workspace)
      : options_(options),
        input_(input),
        curve_(curve),
        count_(curve.timeline.key_count),
        dim_(input.dim),
        times_(at<double>(sizeof(VectorCurve))),
        scales_(at<double>(curve.scales_offset)),
        keys_(at<double>(curve.keys_offset)),
        shapes_(at<double>(curve.shapes_offset)),
        slopes_(workspace) {}

  Outcome build() {
    Outcome outcome = copy_times();
    if (outcome.status != Status::ok) return outcome;
    for (size_t c = 0; c < dim_; ++c) copy_component(c);
    if ((options_.closed() || options_.wraps()) && !close()) return {Status::not_closed, input_.count - 1};
    if (curve_.method == kCubic) outcome = solve_slopes();
    for (size_t i = 0; i + 1 < count_ && outcome.status == Status::ok; ++i) outcome = set_shape(i);
    if (outcome.status != Status::ok) return in_input(outcome);
    build_timeline(options_, curve_.holds_keys, curve_.timeline);
    curve_.is_ordinary = is_ordinary();
    return {};
  }

 private:
  template <class Element>
  Element* at(size_t offset) {
    return reinterpret_cast<Element*>(reinterpret_cast<char*>(&curve_) + offset);
  }
  double step(size_t segment) const { return times_[segment + 1] - times_[segment]; }
  double& key(size_t row, size_t c) { return keys_[row * dim_ + c]; }

  // A key that was added to close the curve has the derivatives of the first; all else about it is a matter of the last
  // key before it.
  Outcome in_input(const Outcome& outcome) const {
    if (outcome.index == kNoIndex || outcome.index < input_.count) return outcome;
    const bool is_of_first = outcome.status == Status::rate_too_fast && curve_.method != kCubic;
    return {outcome.status, is_of_first ? 0 : input_.count - 1};
  }

  // ---- Times and keys ----

  bool is_finite_row(size_t row) const {
    bool finite = is_finite(input_.times[row]);
    const bool at_each = curve_.method != kCubic;
    for (size_t c = 0; c < dim_ && finite; ++c) {
      const size_t i = row * dim_ + c;
      finite = input_.values.is_finite_at(i) && (!input_.first.data || !at_each || input_.first.is_finite_at(i)) &&
               (!input_.second.data || input_.second.is_finite_at(i));
    }
    return finite;
  }

  // The rates at given ends are data of the first and the last key.
  bool is_finite_end(size_t row) const {
    const bool is_first = row == 0, is_last = row + 1 == input_.count;
    if (curve_.method != kCubic || (!is_first && !is_last)) return true;
    const EndSetting& end = is_first ? options_.start : options_.end;
    if (end.condition != End::given) return true;
    for (size_t c = 0; c < dim_; ++c)
      if (!input_.first.is_finite_at((is_first ? 0 : dim_) + c)) return false;
    return true;
  }

  Outcome copy_times() {
    for (size_t i = 0; i < input_.count; ++i) {
      if (!is_finite_row(i) || !is_finite_end(i)) return {Status::not_finite, i};
      times_[i] = input_.times[i];
      const Status status = check_knot(times_, i);
      if (status != Status::ok) return {status, i};
    }
    if (options_.period == 0) return {};
    const Status status = set_closing_time(times_, count_ - 1, options_.period);
    return status == Status::ok ? Outcome{} : Outcome{status, input_.count - 1};
  }

  // Copies a component, scaled to a largest value of 1 to 4 where it is of extreme size. Small keys between which given
  // derivatives lead far away are not of small size.
  void copy_component(size_t c) {
    double largest = 0;
    for (size_t i = 0; i < input_.count; ++i) largest = std::max(largest, magnitude(input_.values[i * dim_ + c]));
    if (largest < 1.0 / kOrdinary) largest = std::max(largest, largest_way(c));
    const bool is_extreme = largest > 0 && (largest > kOrdinary || largest < 1.0 / kOrdinary);
    scales_[c] = is_extreme ? normalizing_scale(largest) : 1.0;
    for (size_t i = 0; i < count_; ++i) key(i, c) = scales_[c] * input_.values[input_.row_of_key(i) * dim_ + c];
  }

  // The largest of the given derivatives times the intervals beside them, at most 1.
  double largest_way(size_t c) const {
    double largest = 0;
    for (size_t i = 0; i + 1 < count_; ++i)
      for (size_t end = 0; end < 2; ++end) {
        const size_t row = first_row(i + end);
        if (input_.first.data && row != kNoIndex) largest = std::max(largest, way(input_.first, row, c, step(i), 1));
        if (input_.second.data) largest = std::max(largest, way(input_.second, row, c, step(i), 2));
      }
    return largest;
  }
  double way(const Numbers& derivatives, size_t row, size_t c, double h, int times) const {
    double product = derivatives[row * dim_ + c];
    for (; times > 0; --times)
      if (!scaled<double>(product, h, product)) return 1.0;
    return std::min(magnitude(product), 1.0);
  }

  // The row of first derivatives that is of a key; none of one within a CUBIC, or at an end of it that is not given.
  size_t first_row(size_t key) const {
    if (curve_.method != kCubic) return input_.row_of_key(key);
    if (key == 0 && options_.start.condition == End::given) return 0;
    return key + 1 == count_ && options_.end.condition == End::given ? 1 : kNoIndex;
  }

  // Replaces the last key by the first; false where they are far apart.
  bool close() {
    const size_t last = count_ - 1;
    for (size_t c = 0; c < dim_; ++c) {
      double largest = 0;
      for (size_t i = 0; i < count_; ++i) largest = std::max(largest, magnitude(key(i, c)));
      if (magnitude(key(last, c) - key(0, c)) > options_.closure * largest) return false;
      key(last, c) = key(0, c);
    }
    return true;
  }

  // ---- Shapes ----

  static constexpr double kSteepest = 0x1p500;  // an interval times a slope

  // An interval, once or twice, times a given derivative; false where it is past the limit.
  bool given(const Numbers& derivatives, size_t row, size_t c, double h, int times, double& product) const {
    product = derivatives[row * dim_ + c];
    for (; times > 0; --times)
      if (!scaled<double>(product, h, product)) return false;
    return scaled<double>(product, scales_[c], product) && magnitude(product) <= kSteepest;
  }

  Outcome solve_slopes() {
    const EndSetting* const ends[] = {&options_.start, &options_.end};
    const size_t rows[] = {0, count_ - 1};
    for (size_t end = 0; end < 2; ++end) {
      if (ends[end]->condition != End::given) continue;
      const double h = step(end == 0 ? 0 : count_ - 2);
      for (size_t c = 0; c < dim_; ++c) {
        double& slope = slopes_[rows[end] * dim_ + c];
        if (!given(input_.first, end, c, h, 1, slope)) return {Status::rate_too_fast, rows[end]};
        slope /= h;
      }
    }
    return spline_slopes({times_, keys_, count_, dim_}, spline_end(options_.start.condition),
                         spline_end(options_.end.condition), slopes_, slopes_ + count_ * dim_);
  }

  // h times the slopes at both ends of a segment; false where they are too large, and `fault` says of which key.
  bool scaled_slopes(size_t i, size_t c, double h, double (&scaled_slope)[2], size_t& fault) const {
    for (size_t end = 0; end < 2; ++end) {
      fault = i + end;
      if (curve_.method != kCubic) {
        if (!given(input_.first, input_.row_of_key(fault), c, h, 1, scaled_slope[end])) return false;
      } else {
        const double slope = slopes_[fault * dim_ + c];
        if (magnitude(slope) > kSteepest / h) return false;
        scaled_slope[end] = h * slope;
      }
    }
    return true;
  }

  // Fills the shape of a segment (curve/evaluate_vector.hpp).
  Outcome set_shape(size_t i) {
    Outcome outcome;
    for (size_t c = 0; c < dim_ && curve_.terms > 0 && outcome.status == Status::ok; ++c)
      outcome = set_component(i, c, shapes_ + i * curve_.terms * dim_ + c);
    return outcome;
  }

  // Of a component, whose terms are `dim` numbers apart. A cubic that swings too far has none: NaN.
  Outcome set_component(size_t i, size_t c, double* shape) {
    const double h = step(i);
    double slope[2];
    size_t fault;
    if (!scaled_slopes(i, c, h, slope, fault)) {
      if (curve_.method != kCubic) return {Status::rate_too_fast, fault};
      shape[0] = shape[dim_] = std::numeric_limits<double>::quiet_NaN();
      return {};
    }
    const double chord = key(i + 1, c) - key(i, c);
    const double a = slope[0] - chord, b = chord - slope[1];
    shape[0] = a;
    shape[dim_] = b;
    if (curve_.terms == 2) return {};
    double bend[2];
    for (size_t end = 0; end < 2; ++end)
      if (!given(input_.second, input_.row_of_key(i + end), c, h, 2, bend[end]))
        return {Status::rate_too_fast, i + end};
    shape[2 * dim_] = 0.5 * bend[0] + (2.0 * a - b);
    shape[3 * dim_] = 0.5 * bend[1] + (2.0 * b - a);
    return {};
  }

  // ---- What the kernels may take for granted ----

  static constexpr double kOrdinary = 0x1p300;

  bool is_ordinary() const {
    for (size_t c = 0; c < dim_; ++c)
      if (scales_[c] != 1.0) return false;
    for (size_t i = 0; i + 1 < count_; ++i)
      if (step(i) < 0x1p-200) return false;
    const size_t numbers = (count_ - 1) * curve_.terms * dim_;
    for (size_t i = 0; i < numbers; ++i)
      if (!is_finite(shapes_[i]) || magnitude(shapes_[i]) > kOrdinary) return false;
    return true;
  }

  const Options& options_;
  const VectorInput& input_;
  VectorCurve& curve_;
  const size_t count_, dim_;
  double *times_, *scales_, *keys_, *shapes_;
  double* slopes_;  // [count][dim], and the scratch of the spline behind it
};

bool has_given_end(const Options& options) {
  return options.start.condition == End::given || options.end.condition == End::given;
}

}  // namespace

bool vector_curve_size(const Options& options, size_t input_count, size_t dim, CurveSize& size) {
  constexpr size_t kMost = PTRDIFF_MAX / 64;  // doubles a row and their sums stay far from an overflow
  if (input_count >= kMost || dim > kMost / 8) return false;
  const size_t count = options.key_count(input_count), terms = find_vector_method(options.method)->terms;
  const size_t row = dim * sizeof(double);
  const bool is_cubic = options.method == kCubic;
  const size_t handle_per_key = kKnotBytes + (1 + terms) * row;
  const size_t workspace_per_key = is_cubic ? row + kSplineScratchPerKnot * sizeof(double) : 0;
  const size_t fixed = sizeof(VectorCurve) + row;
  if (count > (PTRDIFF_MAX - fixed) / (handle_per_key + workspace_per_key)) return false;
  size.handle = fixed + count * (kKnotBytes + row) + (count - 1) * terms * row;
  size.workspace = count * workspace_per_key;
  return true;
}

Status check_vector_settings(const Options& options, const VectorInput& input) {
  const VectorMethodRow& row = *find_vector_method(options.method);
  const bool needs_first = row.needs_first || has_given_end(options);
  const bool has_first = input.first.data != nullptr, has_second = input.second.data != nullptr;
  if ((needs_first && !has_first) || (row.needs_second && !has_second)) return Status::input_missing;
  return (has_first && !needs_first) || (has_second && !row.needs_second) ? Status::input_unwanted : Status::ok;
}

Outcome build_vector_curve(const Options& options, const VectorInput& input, void* handle, void* workspace,
                           VectorCurve** out) {
  auto* curve = static_cast<VectorCurve*>(handle);
  *curve = {};
  const size_t count = options.key_count(input.count), row = input.dim * sizeof(double);
  curve->method = options.method;
  curve->dim = input.dim;
  curve->terms = find_vector_method(options.method)->terms;
  curve->holds_keys = find_vector_method(options.method)->holds_keys;
  place_knots(count, sizeof(VectorCurve) - offsetof(VectorCurve, timeline), curve->timeline);
  curve->scales_offset = sizeof(VectorCurve) + count * kKnotBytes;
  curve->keys_offset = curve->scales_offset + row;
  curve->shapes_offset = curve->keys_offset + count * row;
  const Outcome outcome = VectorBuilder(options, input, *curve, static_cast<double*>(workspace)).build();
  if (outcome.status != Status::ok) return outcome;
  curve->tag = VectorCurve::kTag;
  *out = curve;
  return {};
}

}  // namespace qtraj
