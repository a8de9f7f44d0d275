// Compiled for x86-64 with AVX2, FMA and BMI2.
#include "kernel.hpp"

#if defined(QTRAJ_X86_KERNELS)

#include "batch.hpp"
#include "clean_upper.hpp"

static_assert(HWY_TARGET == HWY_AVX2, "compiled with the flags of another target");

namespace qtraj {

const SampleKernels<float> kAvx2FloatSamples = clean_upper_samples<kBatchSamples<Fused, float>>;

}  // namespace qtraj

#endif
