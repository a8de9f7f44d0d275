// Compiled for x86-64 with SSE4.2.
#include "kernel.hpp"

#if defined(QTRAJ_X86_KERNELS)

#include "batch.hpp"

static_assert(HWY_TARGET == HWY_SSE4, "compiled with the flags of another target");

namespace qtraj {

const SampleKernels<float> kSse4FloatSamples = kBatchSamples<Plain, float>;

}  // namespace qtraj

#endif
