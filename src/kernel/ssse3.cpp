// Compiled for x86-64 with SSSE3.
#include "kernel.hpp"

#if defined(QTRAJ_X86_KERNELS)

#include "batch.hpp"
#include "row_kernels.hpp"
#include "wide_arrays.hpp"

static_assert(HWY_TARGET == HWY_SSSE3, "compiled with the flags of another target");

namespace qtraj {

const Kernel kSsse3Kernel = {
    "ssse3 plain",           sample_batch<Plain, double>,     sample_batch<Plain, float>, sample_at<Plain, double>,
    sample_at<Plain, float>, kRowKernels<Plain, Wide<double>>};

}  // namespace qtraj

#endif
