// Functions compiled for AVX leave the upper halves of the vector registers zero, so that the SSE code of the caller
// does not pay for merging with them, ten times its time on some processors. Compilers place vzeroupper in functions
// that use vectors; GCC 12 omits it where it stores zeros 32 bytes at a time in a function that uses none.
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
