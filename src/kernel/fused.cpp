// Compiled for AVX2 and FMA on x86-64; FMA is part of every AArch64.
#include "sample.hpp"

#if defined(QTRAJ_HAS_FUSED_KERNEL)

namespace qtraj {

const Kernel kFusedKernel = {"scalar fused", sample<Fused, double>, sample<Fused, float>};

}  // namespace qtraj

#endif
