// Kernels of every instruction set, one after the other.
#ifndef QTRAJ_TESTS_FORCED_KERNEL_HPP
#define QTRAJ_TESTS_FORCED_KERNEL_HPP

#include <cstring>
#include <vector>

#include "targets/targets.hpp"

namespace test {

// Those that were compiled.
inline std::vector<const char*> target_names() {
  std::vector<const char*> names;
  for (size_t target = 0; target < qtraj::kTargetCount; ++target) names.push_back(qtraj::target_name(target));
  return names;
}

inline bool is_fused(const char* target) { return std::strstr(target, "fused") != nullptr; }

// While it lives, sampling uses the kernel of that name, where this CPU can run it.
class ForcedKernel {
 public:
  explicit ForcedKernel(const char* target) : target_(target), runs_here_(qtraj::force_target(target)) {}
  ~ForcedKernel() { qtraj::force_target(nullptr); }
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
