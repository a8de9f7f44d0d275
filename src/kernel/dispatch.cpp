#include "kernel.hpp"

namespace qtraj {

const Kernel& kernel() {
#if defined(QTRAJ_HAS_FUSED_KERNEL) && defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return kFusedKernel;
  return kPlainKernel;
#elif defined(QTRAJ_HAS_FUSED_KERNEL)
  return kFusedKernel;
#else
  return kPlainKernel;
#endif
}

}  // namespace qtraj
