#include "math/cubic_spline.hpp"

#include <cmath>

#include "base/times.hpp"

namespace qtraj {

SplineEnd spline_end(End condition) {
  if (condition == End::not_a_knot) return SplineEnd::not_a_knot;
  if (condition == End::given) return SplineEnd::given;
  if (condition == End::periodic) return SplineEnd::periodic;
  return SplineEnd::natural;
}

double SplineData::chord_slope(size_t i, size_t component) const {
  return (y[(i + 1) * dim + component] - y[i * dim + component]) / step(i);
}

namespace {

// lower d_{i-1} + diagonal d_i + upper d_{i+1} = left delta_{i-1} + right delta_i, delta the slopes of the chords.
struct Row {
  double lower, diagonal, upper, left, right;
};

constexpr Row kNaturalStart = {0, 2, 1, 0, 3}, kNaturalEnd = {1, 2, 0, 3, 0}, kGiven = {0, 1, 0, 0, 0};

// The second derivative is continuous at the knot.
Row inner_row(IntervalShares share) { return {share.right, 2, share.left, 3 * share.right, 3 * share.left}; }

// The inner row at the knot next to a not_a_knot end. The slope at that end is eliminated by the condition
//   right d_0 + d_1 = (2 + left) right delta_0 + left^2 delta_1   (the third derivative is continuous at knot 1).
Row row_after_start(IntervalShares share) {
  return {0, 1, share.left, share.right * share.right, share.left * (2 + share.right)};
}
Row row_before_end(IntervalShares share) {
  return {share.right, 1, 0, share.right * (2 + share.left), share.left * share.left};
}

class SlopeSystem {
 public:
  SlopeSystem(const SplineData& data, SplineEnd start, SplineEnd end, double* slopes, double* scratch)
      : data_(data), start_(start), end_(end), slopes_(slopes), upper_(scratch), first_column_(scratch + data.count) {}

  Outcome solve() {
    const size_t last = data_.count - 1;
    if (last == 1) return solve_two_points();
    if (start_ == SplineEnd::periodic) return solve_periodic();
    const bool no_start_knot = start_ == SplineEnd::not_a_knot, no_end_knot = end_ == SplineEnd::not_a_knot;
    if (last == 2 && no_start_knot && no_end_knot) return set_parabola();

    const Outcome outcome = solve_tridiagonal(no_start_knot ? 1 : 0, no_end_knot ? last - 1 : last);
    if (outcome.status != Status::ok) return outcome;
    if (no_start_knot && !continue_past(1, 0, 0, 1)) return {Status::not_finite, 0};
    if (no_end_knot && !continue_past(last - 1, last, last - 1, last - 2)) return {Status::not_finite, last};
    return {};
  }

 private:
  double& slope(size_t i, size_t component) { return slopes_[i * data_.dim + component]; }
  double delta(size_t i, size_t component) const { return data_.chord_slope(i, component); }
  IntervalShares shares(size_t knot) const { return interval_shares(data_.step(knot - 1), data_.step(knot)); }

  bool is_given(size_t knot) const { return (knot == 0 ? start_ : end_) == SplineEnd::given && is_end(knot); }
  bool is_end(size_t knot) const { return knot == 0 || knot == data_.count - 1; }

  // Without a given slope, the line.
  Outcome solve_two_points() {
    for (size_t c = 0; c < data_.dim; ++c) {
      const double line = delta(0, c);
      const bool given[] = {is_given(0), is_given(1)};
      if (!given[0]) slope(0, c) = given[1] && start_ == SplineEnd::natural ? 1.5 * line - 0.5 * slope(1, c) : line;
      if (!given[1]) slope(1, c) = given[0] && end_ == SplineEnd::natural ? 1.5 * line - 0.5 * slope(0, c) : line;
    }
    return {};
  }

  Outcome set_parabola() {
    const IntervalShares share = shares(1);
    for (size_t c = 0; c < data_.dim; ++c) {
      slope(1, c) = share.right * delta(0, c) + share.left * delta(1, c);
      slope(0, c) = 2 * delta(0, c) - slope(1, c);
      slope(2, c) = 2 * delta(1, c) - slope(1, c);
    }
    return {};
  }

  Row row(size_t knot) const {
    const size_t last = data_.count - 1;
    if (is_given(knot)) return kGiven;
    if (knot == 0) return kNaturalStart;
    if (knot == last) return kNaturalEnd;
    if (knot == 1 && start_ == SplineEnd::not_a_knot) return row_after_start(shares(1));
    if (knot == last - 1 && end_ == SplineEnd::not_a_knot) return row_before_end(shares(last - 1));
    return inner_row(shares(knot));
  }

  double right_side(const Row& row, size_t knot, size_t component) {
    if (is_given(knot)) return slope(knot, component);
    double value = row.left != 0 ? row.left * delta(knot - 1, component) : 0.0;
    if (row.right != 0) value += row.right * delta(knot, component);
    return value;
  }

  // The Thomas algorithm on the rows of knots first..last.
  Outcome solve_tridiagonal(size_t first, size_t last) {
    for (size_t i = first; i <= last; ++i) {
      const Row at = row(i);
      const double lower = i > first ? at.lower : 0.0;
      const double pivot = i > first ? at.diagonal - lower * upper_[i - 1] : at.diagonal;
      // happens only to four knots with two not_a_knot ends whose middle knots coincide to rounding
      if (!(pivot > 0)) return {Status::not_finite, i};
      upper_[i] = at.upper / pivot;
      for (size_t c = 0; c < data_.dim; ++c) {
        const double carried = i > first ? lower * slope(i - 1, c) : 0.0;
        slope(i, c) = (right_side(at, i, c) - carried) / pivot;
      }
    }
    for (size_t i = last; i-- > first;)
      for (size_t c = 0; c < data_.dim; ++c) slope(i, c) -= upper_[i] * slope(i + 1, c);
    return {};
  }

  // The slope at a not_a_knot end from the one at the knot next to it.
  bool continue_past(size_t inner, size_t end, size_t end_interval, size_t inner_interval) {
    const IntervalShares share = shares(inner);
    const double far = end < inner ? share.left : share.right, near = end < inner ? share.right : share.left;
    const double limit = 0x1p500 / data_.step(end_interval) * near;
    for (size_t c = 0; c < data_.dim; ++c) {
      const double numerator = far * far * delta(inner_interval, c) - slope(inner, c);
      if (!(std::abs(numerator) < limit)) return false;
      slope(end, c) = (2 + far) * delta(end_interval, c) + numerator / near;
    }
    return true;
  }

  // Inner rows give d_i = slope_i + first_column_i d_0; the row of knot 0, where the curve closes, then gives d_0.
  Outcome solve_periodic() {
    const size_t last = data_.count - 1;
    for (size_t i = 1; i < last; ++i) {
      const Row at = inner_row(shares(i));
      const double pivot = i > 1 ? at.diagonal - at.lower * upper_[i - 1] : at.diagonal;
      upper_[i] = at.upper / pivot;
      first_column_[i] = -at.lower * (i > 1 ? first_column_[i - 1] : 1.0) / pivot;
      for (size_t c = 0; c < data_.dim; ++c) {
        const double carried = i > 1 ? at.lower * slope(i - 1, c) : 0.0;
        slope(i, c) = (right_side(at, i, c) - carried) / pivot;
      }
    }
    // the last row is followed by knot n, which is knot 0
    first_column_[last - 1] -= upper_[last - 1];
    for (size_t i = last - 1; i-- > 1;) {
      first_column_[i] -= upper_[i] * first_column_[i + 1];
      for (size_t c = 0; c < data_.dim; ++c) slope(i, c) -= upper_[i] * slope(i + 1, c);
    }
    const Row seam = inner_row(interval_shares(data_.step(last - 1), data_.step(0)));
    const double pivot = seam.diagonal + seam.lower * first_column_[last - 1] + seam.upper * first_column_[1];
    for (size_t c = 0; c < data_.dim; ++c) {
      const double right = seam.left * delta(last - 1, c) + seam.right * delta(0, c);
      const double d0 = (right - seam.lower * slope(last - 1, c) - seam.upper * slope(1, c)) / pivot;
      slope(0, c) = slope(last, c) = d0;
      for (size_t i = 1; i < last; ++i) slope(i, c) += first_column_[i] * d0;
    }
    return {};
  }

  const SplineData& data_;
  const SplineEnd start_, end_;
  double* slopes_;
  double* upper_;
  double* first_column_;
};

}  // namespace

Outcome spline_slopes(const SplineData& data, SplineEnd start, SplineEnd end, double* slopes, double* scratch) {
  return SlopeSystem(data, start, end, slopes, scratch).solve();
}

}  // namespace qtraj
