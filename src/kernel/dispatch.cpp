#include <cstring>

#include "kernel.hpp"

namespace qtraj {
namespace {

struct Candidate {
  const Kernel* kernel;
  bool (*runs_here)();
};

// Best first.
const Candidate kCandidates[] = {
#if defined(QTRAJ_X86_KERNELS)
    {&kAvx512Kernel,
     [] {
       return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
              __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
              __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
     }},
    {&kAvx2Kernel,
     [] { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"); }},
    {&kSse4Kernel, [] { return __builtin_cpu_supports("sse4.2") != 0; }},
    {&kSsse3Kernel, [] { return __builtin_cpu_supports("ssse3") != 0; }},
#elif defined(QTRAJ_NEON_KERNEL)
    {&kNeonKernel, [] { return true; }},
#endif
    {&kScalarKernel, [] { return true; }},
};

const Kernel& best_kernel() {
  for (const Candidate& candidate : kCandidates)
    if (candidate.runs_here()) return *candidate.kernel;
  return kScalarKernel;
}

}  // namespace

std::atomic<const Kernel*> chosen_kernel{nullptr};

const Kernel& choose_kernel() {
  const Kernel& best = best_kernel();
  chosen_kernel.store(&best, std::memory_order_relaxed);
  return best;
}

bool force_kernel(const char* target) {
  for (const Candidate& candidate : kCandidates) {
    if (target && std::strcmp(candidate.kernel->target, target) != 0) continue;
    if (!candidate.runs_here()) continue;
    chosen_kernel.store(candidate.kernel, std::memory_order_relaxed);
    return true;
  }
  return false;
}

}  // namespace qtraj
