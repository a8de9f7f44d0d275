// The loop that every function over rows is, and rows of a caller's arrays read and written one by one as double.
// Kernels do ordinary rows; here the core does the rows that they leave (rows/row_loop.hpp decides which).
#pragma once

#include <cfloat>
#include <limits>

#include "base/array.hpp"
#include "base/floating.hpp"
#include "base/status.hpp"
#include "math/quaternion.hpp"

namespace qtraj {

// ---- Reading ----

template <size_t Width>
size_t first_element(const Input<Width>& array, size_t row) {
  return array.rows == 1 ? 0 : row * Width;
}

// Tests the bits in memory: converting a signalling NaN would raise FE_INVALID.
template <size_t Width>
bool is_finite(const Input<Width>& array, size_t row) {
  const size_t first = first_element(array, row);
  for (size_t at = first; at < first + Width; ++at) {
    if (array.is_float ? !is_finite(static_cast<const float*>(array.data)[at])
                       : !is_finite(static_cast<const double*>(array.data)[at]))
      return false;
  }
  return true;
}

template <class Real>
bool are_finite(const Real* numbers, size_t count) {
  bool finite = true;
  for (size_t i = 0; i < count; ++i) finite &= is_finite(numbers[i]);  // no branch: many are checked at once
  return finite;
}
// Rows from `first` to `end` of an array that has a row for each of them.
template <size_t Width>
bool are_finite(const Input<Width>& array, size_t first, size_t end) {
  const size_t at = Width * first, count = Width * (end - first);
  return array.is_float ? are_finite(static_cast<const float*>(array.data) + at, count)
                        : are_finite(static_cast<const double*>(array.data) + at, count);
}

template <size_t Width>
Row<Width> row_of(const Input<Width>& array, size_t row) {
  Row<Width> values;
  for (size_t k = 0; k < Width; ++k) {
    const size_t at = first_element(array, row) + k;
    values[static_cast<int>(k)] = array.is_float ? static_cast<double>(static_cast<const float*>(array.data)[at])
                                                 : static_cast<const double*>(array.data)[at];
  }
  return values;
}

inline double number_of(const Input<1>& array, size_t row) { return row_of(array, row)[0]; }

// Whether all numbers of a finite row are 0.
template <size_t Width>
bool is_zero(const Input<Width>& array, size_t row) {
  return largest_component(row_of(array, row)) == 0;
}

// Whether a row is a quaternion with a direction: not_finite, zero_norm or ok.
inline Status check_key(const Input<4>& q, size_t row) {
  if (!is_finite(q, row)) return Status::not_finite;
  return is_zero(q, row) ? Status::zero_norm : Status::ok;
}

// eps of the caller's type: inputs within it of a singular point are noise.
template <size_t Width>
double epsilon_of(const Input<Width>& array) {
  return array.is_float ? static_cast<double>(FLT_EPSILON) : DBL_EPSILON;
}

// ---- Writing ----

// Whether the values are finite in the caller's type; they must not be NaN.
template <size_t Width>
bool holds(const Output<Width>& array, const Row<Width>& values) {
  return largest_component(values) <= (array.is_float ? static_cast<double>(FLT_MAX) : DBL_MAX);
}

template <size_t Width>
void write_row(const Output<Width>& array, size_t row, const Row<Width>& values) {
  for (size_t k = 0; k < Width; ++k) {
    const size_t at = row * Width + k;
    const double value = values[static_cast<int>(k)];
    if (array.is_float)
      static_cast<float*>(array.data)[at] = static_cast<float>(value);
    else
      static_cast<double*>(array.data)[at] = value;
  }
}
template <size_t Width>
void write_nan(const Output<Width>& array, size_t row) {
  write_row(array, row, Row<Width>(Row<Width>::Constant(std::numeric_limits<double>::quiet_NaN())));
}
template <size_t Width>
Row<Width> zero_row(const Output<Width>&) {
  return Row<Width>::Zero();
}

// A row at fault is NaN in both outputs.
template <size_t Width>
struct RowPair {
  Row<Width> first, second;
};
template <size_t Width>
bool holds(const OutputPair<Width>& arrays, const RowPair<Width>& values) {
  return holds(arrays.first, values.first) && (!arrays.second.data || holds(arrays.second, values.second));
}
template <size_t Width>
void write_row(const OutputPair<Width>& arrays, size_t row, const RowPair<Width>& values) {
  write_row(arrays.first, row, values.first);
  if (arrays.second.data) write_row(arrays.second, row, values.second);
}
template <size_t Width>
void write_nan(const OutputPair<Width>& arrays, size_t row) {
  write_nan(arrays.first, row);
  if (arrays.second.data) write_nan(arrays.second, row);
}
template <size_t Width>
RowPair<Width> zero_row(const OutputPair<Width>&) {
  return {Row<Width>::Zero(), Row<Width>::Zero()};
}

// ---- The loop ----

// Calls compute(row, values) for each row and writes the values, or NaN where its status is neither ok nor ambiguous,
// or the values do not fit the caller's type. The outcome is that of the first row at fault. Row i of the output may be
// the memory of row i of an input: `compute` reads before the row is written. kernel(row) is asked first, and again
// after each row that `compute` did: it does rows from that one on by itself, all of them ok, and returns how many.
template <class OutputArray, class Kernel, class Compute>
Outcome for_each_row(size_t count, const OutputArray& out, const Kernel& kernel, const Compute& compute) {
  Outcome outcome;
  for (size_t row = 0; row < count; ++row) {
    row += kernel(row);
    if (row == count) break;
    auto values = zero_row(out);
    Status status = compute(row, values);
    const bool has_values = status == Status::ok || status == Status::ambiguous;
    if (has_values && !holds(out, values)) status = Status::not_finite;
    if (has_values && status != Status::not_finite)
      write_row(out, row, values);
    else
      write_nan(out, row);
    if (status != Status::ok && outcome.status == Status::ok) outcome = {status, row};
  }
  return outcome;
}
template <class OutputArray, class Compute>
Outcome for_each_row(size_t count, const OutputArray& out, const Compute& compute) {
  return for_each_row(
      count, out, [](size_t) { return size_t{0}; }, compute);
}

}  // namespace qtraj
