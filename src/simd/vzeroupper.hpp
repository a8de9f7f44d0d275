// vzeroupper at the end of functions compiled for AVX. Were the upper halves of the vector registers left dirty, the
// caller's SSE code would pay for merging with them at every instruction, ten times its run time on some processors.
// Compilers insert vzeroupper in functions that use vectors, but GCC 12 omits it where the only use is to store zeros
// 32 bytes at a time.
#pragma once

namespace qtraj {
namespace {

struct VzeroupperAtExit {
#if defined(__AVX__)
  ~VzeroupperAtExit() { __builtin_ia32_vzeroupper(); }
#else
  ~VzeroupperAtExit() {}
#endif
};

}  // namespace
}  // namespace qtraj
