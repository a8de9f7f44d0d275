// The upper halves of vector registers are left clean: where they are in use, each SSE instruction of the caller, and
// most programs are made of these, waits for them, and runs ten times slower. Compilers see to it in functions that
// use vectors; GCC 12 forgets it where it stores zeros 32 bytes at a time in a function that does not.
#pragma once

#include <immintrin.h>

namespace qtraj {
namespace {

template <auto function>
struct CleanUpper;
template <class Result, class... Arguments, Result (*function)(Arguments...)>
struct CleanUpper<function> {
  static Result call(Arguments... arguments) {
    const Result result = function(arguments...);
    _mm256_zeroupper();
    return result;
  }
};

// The same function, and clean upper halves after it.
template <auto function>
constexpr auto clean_upper = CleanUpper<function>::call;

}  // namespace
}  // namespace qtraj
