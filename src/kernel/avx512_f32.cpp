// Compiled for x86-64 with AVX-512 F, BW, CD, DQ and VL.
#include "kernel.hpp"

#if defined(QTRAJ_X86_KERNELS)

#include "batch.hpp"
#include "clean_upper.hpp"

static_assert(HWY_TARGET == HWY_AVX3, "compiled with the flags of another target");

namespace qtraj {

const SampleKernels<float> kAvx512FloatSamples = clean_upper_samples<kBatchSamples<Fused, float>>;

}  // namespace qtraj

#endif
