// A caller's array, as it goes from the checks of the C layer down to the kernels: contiguous rows of `Width` numbers,
// float or double, aligned like a number and no more. Kernels include this header: it holds plain data, and functions
// of internal linkage (base/floating.hpp says why).
#pragma once

#include <cstddef>

namespace qtraj {

// Rows to read. An array of one row is broadcast to all rows of a call.
template <size_t Width>
struct Input {
  const void* data;
  size_t rows;
  bool is_float;
};
template <size_t Width, class Real>
static inline Input<Width> input(const Real* data, size_t rows) {
  return {data, rows, sizeof(Real) == sizeof(float)};
}

// Rows to write.
template <size_t Width>
struct Output {
  void* data;
  size_t rows;
  bool is_float;
};
template <size_t Width, class Real>
static inline Output<Width> output(Real* data, size_t rows) {
  return {data, rows, sizeof(Real) == sizeof(float)};
}

// Two outputs with a row each for every row of the input; the second may have no data.
template <size_t Width>
struct OutputPair {
  Output<Width> first, second;
};

// `count` rows of an array from `first` on; none of an array without data.
template <size_t Width>
static inline size_t bytes_before(size_t row, bool is_float) {
  return row * Width * (is_float ? sizeof(float) : sizeof(double));
}
template <size_t Width>
static inline Input<Width> rows_from(const Input<Width>& array, size_t first, size_t count) {
  const auto* data = static_cast<const char*>(array.data);
  return {data ? data + bytes_before<Width>(first, array.is_float) : nullptr, count, array.is_float};
}
template <size_t Width>
static inline Output<Width> rows_from(const Output<Width>& array, size_t first, size_t count) {
  auto* data = static_cast<char*>(array.data);
  return {data ? data + bytes_before<Width>(first, array.is_float) : nullptr, count, array.is_float};
}

// The same of an array that one row of may serve all.
template <size_t Width>
static inline Input<Width> chunk_of(const Input<Width>& array, size_t first, size_t count) {
  return array.rows == 1 ? array : rows_from(array, first, count);
}

// Arguments of functions over rows with one input and with two.
template <size_t InWidth, size_t OutWidth>
struct UnaryRows {
  Input<InWidth> in;
  Output<OutWidth> out;
};
template <size_t AWidth, size_t BWidth, size_t OutWidth>
struct BinaryRows {
  Input<AWidth> a;
  Input<BWidth> b;
  Output<OutWidth> out;
};

}  // namespace qtraj
