// C2 cubic splines through vectors of any dimension, by their first derivatives at the knots: what LOG_SPLINE
// (methods/log_spline.cpp) and cubic vector curves (methods/vector_builder.hpp) are made of.
#pragma once

#include "base/settings.hpp"
#include "base/status.hpp"

namespace qtraj {

enum class SplineEnd { natural, not_a_knot, given, periodic };
SplineEnd spline_end(End condition);  // natural for the default

// The points that a cubic spline passes through: y [count][dim] at x [count], strictly increasing, count >= 2.
struct SplineData {
  const double* x;
  const double* y;
  size_t count, dim;

  double step(size_t i) const { return x[i + 1] - x[i]; }
  double chord_slope(size_t i, size_t component) const;
};

constexpr size_t kSplineScratchPerKnot = 2;

// First derivatives, slopes [count][dim], of the C2 cubic through the data (C. de Boor, "A Practical Guide to Splines",
// chapter IV, in first derivatives), in O(count). periodic applies to both ends; the first and the last y are then
// equal. given: the slopes at that end are there when the call is made, and stay. Of two points a not_a_knot end has
// the slope of the line through them; three points with both ends not_a_knot give a parabola. scratch: [count *
// kSplineScratchPerKnot].
//
// Rows are divided by the interval that they span, so that their weights lie in [0, 3] and no product of intervals is
// formed. Stable without pivoting: rows are diagonally dominant. not_finite, with the index of the knot, where a
// not_a_knot end continues so steeply over its interval h that |h slope| exceeds 2^500.
Outcome spline_slopes(const SplineData& data, SplineEnd start, SplineEnd end, double* slopes, double* scratch);

}  // namespace qtraj
