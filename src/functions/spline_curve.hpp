// The cubic spline of math/cubic_spline.hpp as a function: of a caller's data, checked and of any finite size, at any
// queries.
#pragma once

#include "math/cubic_spline.hpp"

namespace qtraj {

// Whether a scalar spline has these ends: standard (natural), natural, not_a_knot, and periodic on both sides.
bool are_spline_ends(End start, End end);

// Doubles of working space; their number does not overflow where data.x and data.y fit memory, count >= 2.
size_t spline_curve_workspace(size_t count, size_t dim);

// y_out [query_count][dim] of the C2 cubic through data.y [count][dim] at data.x, data as the caller passed them,
// count >= 2. Components do not influence each other.
//
// With Y the largest |y| of a component and r the longest interval over the shortest, values are within 4 eps Y (1 +
// r), with a not_a_knot end 4 eps Y (1 + r)^2: how far the curve can swing on uneven knots. At a knot the value is y,
// to 1e-300 Y.
//
// not_finite, time_order, time_span with the row of x and y at fault, as for keyframes; not_closed, with the last row,
// where both ends are periodic and the last y is more than 1e-6 Y away from the first (else it counts as the first);
// not_finite with a knot where spline_slopes fails: all rows are NaN. Queries follow, index count + query, their row
// NaN: not_finite; time_range outside x; not_finite where the value overflows or the curve swings past 1e150 Y. y_out
// may be any of the inputs.
Outcome sample_spline_curve(const SplineData& data, End start, End end, const double* queries, size_t query_count,
                            double* y_out, double* workspace);

}  // namespace qtraj
