// Kernels of every instruction set, one after the other.
#ifndef QTRAJ_TESTS_FORCED_KERNEL_HPP
#define QTRAJ_TESTS_FORCED_KERNEL_HPP

#include <cstring>

#include "kernel/kernel.hpp"

namespace test {

const char* const kTargets[] = {"avx512 fused", "avx2 fused",  "neon fused",
                                "sse4 plain",   "ssse3 plain", "scalar plain"};

inline bool is_fused(const char* target) { return std::strstr(target, "fused") != nullptr; }

// While it lives, sampling uses the kernel of that name, where this CPU can run it.
class ForcedKernel {
 public:
  explicit ForcedKernel(const char* target) : target_(target), runs_here_(qtraj::force_kernel(target)) {}
  ~ForcedKernel() { qtraj::force_kernel(nullptr); }
  ForcedKernel(const ForcedKernel&) = delete;
  ForcedKernel& operator=(const ForcedKernel&) = delete;

  bool runs_here() const { return runs_here_; }
  bool is_fused() const { return test::is_fused(target_); }

 private:
  const char* target_;
  bool runs_here_;
};

}  // namespace test

#endif
