// The floating-point assumptions of all files, checked at compile time: IEEE 754 binary32 and binary64, every operation
// rounded once.
//
// Everything here has internal linkage. Kernels include this header, and they are compiled for several instruction
// sets: of an inline function with external linkage (COMDAT) the linker keeps one copy for all callers, and if that is
// the one compiled for AVX2, an older processor stops at an illegal instruction.
#pragma once

#include <cfloat>
#include <cstdint>
#include <cstring>

#if defined(__FAST_MATH__)
#error "qtraj: -ffast-math changes results; the same bits on every CPU are part of the contract"
#endif
#if FLT_EVAL_METHOD != 0
#error "qtraj: needs arithmetic without extra precision (FLT_EVAL_METHOD 0; on 32-bit x86: -msse2 -mfpmath=sse)"
#endif

namespace qtraj {

// Tests the exponent bits: a comparison with a NaN would raise FE_INVALID, which a caller may trap.
static inline bool is_finite(double value) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return (bits & 0x7ff0000000000000u) != 0x7ff0000000000000u;
}

static inline bool is_finite(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return (bits & 0x7f800000u) != 0x7f800000u;
}

// Selection and conditions of one number. Vectors have overloads of the same names (simd/wide.hpp), whose condition is
// a lane mask.
static inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
static inline float select(bool condition, float yes, float no) { return condition ? yes : no; }
static inline bool any(bool condition) { return condition; }
static inline bool all(bool condition) { return condition; }

// The power of two that scales a finite value other than 0 to [1, 2). A value of 2^1023 and more comes to [2, 4), and a
// subnormal one to [2^-51, 2): no normal power of two is small or large enough.
static inline double normalizing_scale(double value) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const uint64_t exponent = (bits >> 52) & 0x7ff;
  bits = (exponent == 2046 ? 1 : 2046 - exponent) << 52;
  double scale;
  std::memcpy(&scale, &bits, sizeof scale);
  return scale;
}

// The nearest integer for |value| < 2^51, ties to even, without a libm call or a conversion. In another rounding mode
// the result is still an integer within one half of the value. Number: double, or a vector of it.
template <class Number>
static inline Number round_to_integer(Number value) {
  const Number shift(6755399441055744.0);  // 1.5 * 2^52: its last bit is worth 1
  const Number half(0.5), one(1.0);
  const Number rounded = (value + shift) - shift;
  const Number not_above = select(half < rounded - value, rounded - one, rounded);
  return select(half < value - rounded, rounded + one, not_above);
}

}  // namespace qtraj
