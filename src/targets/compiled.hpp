// What the files that are compiled for every target have in common. CMake compiles each of them once per target, with
// the target's flags and these names:
//   QTRAJ_TARGET      the namespace of its functions: avx2, ..., scalar, scalar_fused
//   QTRAJ_ARITHMETIC  Plain or Fused
//   QTRAJ_SCALAR      the namespace of scalar code in that arithmetic
//   QTRAJ_VECTORS     for all but scalar code: the name that Highway has for the target
#pragma once

#if !defined(QTRAJ_TARGET)
#error "name this file in qtraj_kernel_sources (CMakeLists.txt)"
#endif

#include "math/arithmetic.hpp"
#include "targets/kernels.hpp"

#if defined(QTRAJ_VECTORS)
#include "rows/wide_rows.hpp"
#endif

namespace qtraj {
namespace {

using Arithmetic = QTRAJ_ARITHMETIC;

// vzeroupper at the end of functions compiled for AVX. Were the upper halves of the vector registers left dirty, the
// caller's SSE code would pay for merging with them at every instruction, ten times its run time on some processors.
// Compilers insert vzeroupper in functions that use vectors, but GCC 12 omits it where the only use is to store zeros
// 32 bytes at a time.
struct VzeroupperAtExit {
#if defined(__AVX__)
  ~VzeroupperAtExit() { __builtin_ia32_vzeroupper(); }
#else
  ~VzeroupperAtExit() {}
#endif
};

// The Number that rows are done in, and what rows of float are that are computed with in float. run_rows does rows in
// vectors until these stop, at a vector with a row that is not ordinary or at the end, and goes on one row after the
// other.
#if defined(QTRAJ_VECTORS)
static_assert(HWY_TARGET == QTRAJ_VECTORS, "compiled with the flags of another target");

using Number = Wide<double>;
using FloatNumber = Wide<float>;

template <auto vectors, auto scalar, class Rows>
QTRAJ_INLINE size_t run_rows(const Rows& rows, size_t first, size_t count) {
  const VzeroupperAtExit at_exit;
  const size_t done = vectors(rows, first, count);
  return first + done < count ? done + scalar(rows, first + done, count) : done;
}
#else
using Number = double;
using FloatNumber = float;

template <auto scalar, auto, class Rows>
QTRAJ_INLINE size_t run_rows(const Rows& rows, size_t first, size_t count) {
  const VzeroupperAtExit at_exit;
  return scalar(rows, first, count);
}
#endif

}  // namespace
}  // namespace qtraj
