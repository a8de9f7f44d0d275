// Compiled for x86-64 with AVX2, FMA and BMI2.
#include "kernel.hpp"

#if defined(QTRAJ_X86_KERNELS)

#include "batch.hpp"
#include "clean_upper.hpp"
#include "row_kernels.hpp"
#include "wide_arrays.hpp"

static_assert(HWY_TARGET == HWY_AVX2, "compiled with the flags of another target");

namespace qtraj {

const Kernel kAvx2Kernel = {"avx2 fused", clean_upper_samples<kBatchSamples<Fused, double>>, kAvx2FloatSamples,
                            clean_upper_rows<kRowKernels<Fused, Wide<double>>>};

}  // namespace qtraj

#endif
