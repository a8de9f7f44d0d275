#include "functions/spline_curve.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#include "base/floating.hpp"
#include "base/times.hpp"

namespace qtraj {
namespace {

bool is_spline_end(End end) {
  return end == End::standard || end == End::natural || end == End::not_a_knot || end == End::periodic;
}

Outcome check_data(const SplineData& data) {
  for (size_t i = 0; i < data.count; ++i) {
    bool finite = is_finite(data.x[i]);
    for (size_t c = 0; c < data.dim; ++c) finite = finite && is_finite(data.y[i * data.dim + c]);
    const Status status = finite ? check_knot(data.x, i) : Status::not_finite;
    if (status != Status::ok) return {status, i};
  }
  return {};
}

class SplineCurve {
 public:
  SplineCurve(size_t count, size_t dim, double* workspace)
      : count_(count),
        dim_(dim),
        x_(workspace),
        y_(x_ + count),
        slopes_(y_ + count * dim),
        scales_(slopes_ + count * dim),
        scratch_(scales_ + dim) {}

  Outcome build(const SplineData& data, End start, End end) {
    const Outcome outcome = check_data(data);
    if (outcome.status != Status::ok) return outcome;
    std::copy_n(data.x, count_, x_);
    for (size_t c = 0; c < dim_; ++c) copy_scaled(data, c);
    if (start == End::periodic && !close()) return {Status::not_closed, count_ - 1};
    return spline_slopes({x_, y_, count_, dim_}, spline_end(start), spline_end(end), slopes_, scratch_);
  }

  // `row` is left unfinished where the status is not ok.
  Status evaluate(double query, double* row) const {
    const double first = x_[0], last = x_[count_ - 1], reach = end_reach(first, last);
    // halved first, so that no difference overflows
    if (0.5 * first - 0.5 * query > 0.5 * reach || 0.5 * query - 0.5 * last > 0.5 * reach) return Status::time_range;
    query = std::clamp(query, first, last);
    const size_t not_after = static_cast<size_t>(std::upper_bound(x_, x_ + count_, query) - x_);
    const size_t interval = std::min(not_after, count_ - 1) - 1;
    for (size_t c = 0; c < dim_; ++c)
      if (!evaluate(query, interval, c, row[c])) return Status::not_finite;
    return Status::ok;
  }

 private:
  // Copies a component, scaled to a largest value of 1 to 4 so that no slope overflows.
  void copy_scaled(const SplineData& data, size_t component) {
    double largest = 0;
    for (size_t i = 0; i < count_; ++i) largest = std::max(largest, std::abs(data.y[i * dim_ + component]));
    const double scale = largest > 0 ? normalizing_scale(largest) : 1.0;
    for (size_t i = 0; i < count_; ++i) y_[i * dim_ + component] = scale * data.y[i * dim_ + component];
    scales_[component] = scale;
  }

  // Replaces the last value by the first; false where they are far apart.
  bool close() {
    constexpr double kTolerance = 1e-6;
    for (size_t c = 0; c < dim_; ++c) {
      double largest = 0;
      for (size_t i = 0; i < count_; ++i) largest = std::max(largest, std::abs(y_[i * dim_ + c]));
      double& last = y_[(count_ - 1) * dim_ + c];
      if (std::abs(last - y_[c]) > kTolerance * largest) return false;
      last = y_[c];
    }
    return true;
  }

  // Evaluates the cubic from its values and slopes at both ends of the interval; false where it is too large.
  bool evaluate(double query, size_t interval, size_t component, double& value) const {
    const size_t left = interval * dim_ + component, right = left + dim_;
    const double h = x_[interval + 1] - x_[interval];
    const double limit = 0x1p500 / h;
    if (std::max(std::abs(slopes_[left]), std::abs(slopes_[right])) > limit) return false;
    const double chord = y_[right] - y_[left];
    const double left_excess = h * slopes_[left] - chord, right_excess = chord - h * slopes_[right];
    const double u = (query - x_[interval]) / h, v = (x_[interval + 1] - query) / h;  // v = 1 - u
    const double scaled = (v * y_[left] + u * y_[right]) + u * v * (v * left_excess + u * right_excess);
    const double scale = scales_[component];
    if (scale < 1 && std::abs(scaled) > DBL_MAX * scale) return false;
    value = scaled / scale;
    return true;
  }

  size_t count_, dim_;
  double *x_, *y_, *slopes_, *scales_, *scratch_;
};

}  // namespace

bool are_spline_ends(End start, End end) {
  return is_spline_end(start) && is_spline_end(end) && (start == End::periodic) == (end == End::periodic);
}

size_t spline_curve_workspace(size_t count, size_t dim) {
  // x and scratch, y and slopes, scales
  return count * (1 + kSplineScratchPerKnot) + 2 * count * dim + dim;
}

Outcome sample_spline_curve(const SplineData& data, End start, End end, const double* queries, size_t query_count,
                            double* y_out, double* workspace) {
  SplineCurve curve(data.count, data.dim, workspace);
  Outcome outcome = curve.build(data, start, end);
  const bool built = outcome.status == Status::ok;
  for (size_t k = 0; k < query_count; ++k) {
    double* row = y_out + k * data.dim;
    Status status = Status::not_finite;
    if (built && is_finite(queries[k])) status = curve.evaluate(queries[k], row);
    if (status == Status::ok) continue;
    std::fill_n(row, data.dim, std::numeric_limits<double>::quiet_NaN());
    if (outcome.status == Status::ok) outcome = {status, data.count + k};
  }
  return outcome;
}

}  // namespace qtraj
