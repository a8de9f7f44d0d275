// A caller's array, the same from the C layer's check to the kernels: rows of `Width` numbers, float or double, one
// after another, with no alignment but that of a number. Vector files include this header: plain data, and functions of
// internal linkage.
#pragma once

#include <cstddef>

namespace qtraj {

// Rows to read. One row alone serves all rows of a call.
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

// Functions over rows of one and of two inputs take these.
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
