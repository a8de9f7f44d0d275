// Compiled for x86-64 with SSSE3.
#include "kernel.hpp"

#if defined(QTRAJ_X86_KERNELS)

#include "batch.hpp"

static_assert(HWY_TARGET == HWY_SSSE3, "compiled with the flags of another target");

namespace qtraj {

const SampleKernels<float> kSsse3FloatSamples = kBatchSamples<Plain, float>;

}  // namespace qtraj

#endif
