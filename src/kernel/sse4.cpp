// Compiled for x86-64 with SSE4.2.
#include "kernel.hpp"

#if defined(QTRAJ_X86_KERNELS)

#include "batch.hpp"
#include "row_kernels.hpp"
#include "wide_arrays.hpp"

static_assert(HWY_TARGET == HWY_SSE4, "compiled with the flags of another target");

namespace qtraj {

const Kernel kSse4Kernel = {"sse4 plain", kBatchSamples<Plain, double>, kSse4FloatSamples,
                            kRowKernels<Plain, Wide<double>>};

}  // namespace qtraj

#endif
