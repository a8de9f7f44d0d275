// Compiled for AArch64.
#include "kernel.hpp"

#if defined(QTRAJ_NEON_KERNEL)

#include "batch.hpp"

static_assert(HWY_TARGET == HWY_NEON, "compiled with the flags of another target");

namespace qtraj {

const SampleKernels<float> kNeonFloatSamples = kBatchSamples<Fused, float>;

}  // namespace qtraj

#endif
