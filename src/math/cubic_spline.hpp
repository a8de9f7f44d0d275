#pragma once

#include "base/settings.hpp"
#include "base/status.hpp"

namespace qtraj {

enum class SplineEnd { natural, not_a_knot, periodic };
SplineEnd spline_end(End condition);  // natural for the default

// The values a cubic spline goes through: y [count][dim] at x [count], strictly increasing, count >= 2.
struct SplineData {
  const double* x;
  const double* y;
  size_t count, dim;

  double step(size_t i) const { return x[i + 1] - x[i]; }
  double chord_slope(size_t i, size_t component) const;
};

constexpr size_t kSplineScratchPerKnot = 2;

// First derivatives, slopes [count][dim], of the C2 cubic through the data (C. de Boor, "A Practical Guide to Splines",
// chapter IV, in first derivatives), in O(count). periodic: both ends, the first and last y being equal. Two points: a
// line. Three points, both ends not_a_knot: the parabola. scratch: [count * kSplineScratchPerKnot].
//
// Rows are divided by the interval they span, so that their weights lie in [0, 3] and no product of intervals is
// formed. Stable without pivoting: rows are diagonally dominant. not_finite, with the index of the knot, where a
// not_a_knot end continues so steeply over its interval h that |h slope| exceeds 2^500.
Outcome spline_slopes(const SplineData& data, SplineEnd start, SplineEnd end, double* slopes, double* scratch);

}  // namespace qtraj
