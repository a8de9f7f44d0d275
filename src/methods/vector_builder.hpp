// From a caller's rows of numbers and options to a vector curve. Knots, gaps, ends and loops are those of orientation
// curves.
#pragma once

#include "base/floating.hpp"
#include "curve/vector_curve.hpp"
#include "methods/options.hpp"
#include "methods/timeline_builder.hpp"

namespace qtraj {

// A caller's numbers; data may be null.
struct Numbers {
  const void* data;
  bool is_float;

  double operator[](size_t i) const {
    return is_float ? static_cast<double>(static_cast<const float*>(data)[i]) : static_cast<const double*>(data)[i];
  }
  // Of the number as it is: converting a signalling NaN would raise FE_INVALID.
  bool is_finite_at(size_t i) const {
    return is_float ? is_finite(static_cast<const float*>(data)[i]) : is_finite(static_cast<const double*>(data)[i]);
  }
};

// Keys as the caller passed them. The pointers to times and values are checked.
struct VectorInput {
  const double* times;    // [count]
  Numbers values;         // [count][dim]
  Numbers first, second;  // derivatives by time, [count][dim], or of a CUBIC with given ends first [2][dim]
  size_t count, dim;

  // The row that a key is: one that a period adds is the first once more.
  size_t row_of_key(size_t key) const { return key < count ? key : 0; }
};

// The size of a curve through `count` keys of the caller; false where it would exceed PTRDIFF_MAX.
bool vector_curve_size(const Options& options, size_t count, size_t dim, CurveSize& size);

// Whether the input has the derivatives that the method and its ends need, and no others: ok, input_missing or
// input_unwanted.
Status check_vector_settings(const Options& options, const VectorInput& input);

// Builds in 8-byte aligned memory of the sizes above. Settings have been checked; the workspace is free afterwards. On
// an error the index of a key: the lowest at fault and, at one index, the first of not_finite, time_order, time_span;
// not_closed, with the last key, where a curve that closes has a component that differs there from the first key by
// more than options.closure times its largest magnitude; rate_too_fast where an interval times a given derivative is
// past 2^500; not_finite where absurdly uneven knots throw a cubic out of range.
Outcome build_vector_curve(const Options& options, const VectorInput& input, void* handle, void* workspace,
                           VectorCurve** out);

}  // namespace qtraj
