// Compiled for AArch64.
#include "kernel.hpp"

#if defined(QTRAJ_NEON_KERNEL)

#include "batch.hpp"
#include "row_kernels.hpp"
#include "wide_arrays.hpp"

static_assert(HWY_TARGET == HWY_NEON, "compiled with the flags of another target");

namespace qtraj {

const Kernel kNeonKernel = {"neon fused", kBatchSamples<Fused, double>, kNeonFloatSamples,
                            kRowKernels<Fused, Wide<double>>};

}  // namespace qtraj

#endif
