// The upper halves of vector registers are left clean: where they are in use, each SSE instruction of the caller, and
// most programs are made of these, waits for them, and runs ten times slower. Compilers see to it in functions that
// use vectors; GCC 12 forgets it where it stores zeros 32 bytes at a time in a function that does not.
#pragma once

#include <immintrin.h>

#include <type_traits>

#include "kernel.hpp"

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

template <const auto& samples>
constexpr std::decay_t<decltype(samples)> clean_upper_samples = {clean_upper<samples.sample>,
                                                                 clean_upper<samples.sample_at>};

template <const RowKernels& rows>
constexpr RowKernels clean_upper_rows = {clean_upper<rows.slerp>,
                                         clean_upper<rows.nlerp>,
                                         clean_upper<rows.rotate>,
                                         clean_upper<rows.normalize>,
                                         clean_upper<rows.make_continuous>,
                                         clean_upper<rows.unit_keys>,
                                         clean_upper<rows.relative_rotations>,
                                         clean_upper<rows.jacobians>,
                                         clean_upper<rows.raise_to_weights>,
                                         clean_upper<rows.add_scatter>,
                                         clean_upper<rows.add_logs>};

}  // namespace
}  // namespace qtraj
