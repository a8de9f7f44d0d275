// The cubic spline as a function: a vector curve that lives for one call.
#pragma once

#include "methods/vector_builder.hpp"

namespace qtraj {

// Whether a scalar spline has these ends: standard (natural), natural, not_a_knot, and periodic on both sides.
bool are_spline_ends(End start, End end);

// The size that sample_spline_curve() needs; false where it would exceed PTRDIFF_MAX.
bool spline_curve_size(size_t count, size_t dim, CurveSize& size);

// y_out [query_count][dim] of the C2 cubic through y [count][dim] at x [count], as the caller passed them, count >= 2.
//
// With Y the largest |y| of a component and r the longest interval over the shortest, values are within 4 eps Y (1 +
// r), with a not_a_knot end 4 eps Y (1 + r)^2: how far the curve can swing on uneven knots. At a knot the value is y,
// to 1e-300 Y.
//
// The outcome of construction (vector_builder.hpp), all rows NaN; or of sampling, index count + query, that row NaN.
// y_out may be any of the inputs. `memory` has handle and workspace one behind the other.
Outcome sample_spline_curve(const VectorInput& input, End start, End end, const double* queries, size_t query_count,
                            double* y_out, void* memory, const CurveSize& size);

}  // namespace qtraj
