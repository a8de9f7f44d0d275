// Dispatch: which target is in use, by default the best of those compiled (targets.cmake) that this processor can run.
#pragma once

#include <atomic>
#include <cstddef>

// Written by CMake: #define QTRAJ_EACH_TARGET(ROW, ...) ROW(name, arithmetic, runs_here, ...) ..., best first, the last
// one ROW(scalar, plain, true, ...).
#include "compiled_targets.hpp"

namespace qtraj {

#define QTRAJ_COUNT(name, arithmetic, runs_here, unused) +1
constexpr size_t kTargetCount = 0 QTRAJ_EACH_TARGET(QTRAJ_COUNT, );
#undef QTRAJ_COUNT

// The number of the target in use, kTargetCount until it is first asked for. Threads that find it so at the same time
// all choose the same one.
extern std::atomic<size_t> target_in_use;
size_t choose_target();
static inline size_t target() {
  const size_t chosen = target_in_use.load(std::memory_order_relaxed);
  return chosen < kTargetCount ? chosen : choose_target();
}

// "avx2 fused", "scalar plain", ...
const char* target_name(size_t target);

// For tests: puts the target of that name in use, in all threads; null puts the best one in use again. False where this
// processor cannot run it or there is none of the name.
bool force_target(const char* name);

// {avx512::function, avx2::function, ..., scalar::function}: indexed by target().
#define QTRAJ_ADDRESS(name, arithmetic, runs_here, function) name::function,
#define QTRAJ_OF_EACH_TARGET(function) \
  { QTRAJ_EACH_TARGET(QTRAJ_ADDRESS, function) }

}  // namespace qtraj
