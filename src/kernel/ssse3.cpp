// Compiled for x86-64 with SSSE3.
#include "kernel.hpp"

#if defined(QTRAJ_X86_KERNELS)

#include "batch.hpp"
#include "row_kernels.hpp"
#include "wide_arrays.hpp"

static_assert(HWY_TARGET == HWY_SSSE3, "compiled with the flags of another target");

namespace qtraj {

const Kernel kSsse3Kernel = {"ssse3 plain", kBatchSamples<Plain, double>, kSsse3FloatSamples,
                             kRowKernels<Plain, Wide<double>>};

}  // namespace qtraj

#endif
