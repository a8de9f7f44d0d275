// Plain loops over rows, what a C programmer writes with the C library: the peer `loop`. loops.cpp is compiled for
// every target of the library, so that a kernel stands beside a loop for the same instruction set.
#pragma once

#include <cstddef>

#include "compiled_targets.hpp"

namespace bench {

// Over arrays of rows, `in` and `out` as many as the function has.
template <class Real>
using RowLoop = void (*)(const Real* const* in, size_t count, Real* const* out);

template <class Real>
struct NamedLoop {
  const char* name;
  RowLoop<Real> loop;
};

// An array as its bytes.
template <class Byte>
struct Bytes {
  Byte* data;
  size_t count;
};

#define QTRAJ_DECLARE_LOOPS(target, arithmetic, runs_here, unused)                                          \
  namespace loops_##target {                                                                                \
    extern const NamedLoop<double> doubles[]; /* up to one without a name */                                \
    extern const NamedLoop<float> floats[];                                                                 \
    /* Reads all inputs and writes all outputs, and computes nothing: what memory takes of any function. */ \
    void move_bytes(const Bytes<const char>* in, size_t inputs, const Bytes<char>* out, size_t outputs);    \
  }
QTRAJ_EACH_TARGET(QTRAJ_DECLARE_LOOPS, )
#undef QTRAJ_DECLARE_LOOPS

}  // namespace bench
