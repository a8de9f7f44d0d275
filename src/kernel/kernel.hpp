// Kernels sample trajectories and do functions over rows and sums over samples: the same code, compiled for each
// instruction set and arithmetic; one runs here.
#pragma once

#include <atomic>

#include "qtraj/arrays.hpp"
#include "qtraj/block_sum.hpp"
#include "qtraj/trajectory.hpp"

#if !defined(QTRAJ_NO_SIMD) && defined(__x86_64__)
#define QTRAJ_X86_KERNELS
#elif !defined(QTRAJ_NO_SIMD) && defined(__aarch64__)
#define QTRAJ_NEON_KERNEL
#endif

namespace qtraj {

// Times to sample: an array, or start + (double)i step where `array` is null.
struct TimeSource {
  const double* array;
  double start, step;
};

// Rows to write: q [count][4], omega and alpha [count][3] in `frame`; each may be null.
template <class Real>
struct SampleOutputs {
  Real* q;
  Real* omega;
  Real* alpha;
  Frame frame;
};

// Sums over samples of weight w above 0. Scatter: the upper triangle of sum w q q^T, q made unit, row by row.
using ScatterSums = BlockSum<10>;
// In the notation of qtraj/log_moments.hpp: W, f, sum w r, the upper triangle of sum w (1 - d cot d) u u^T; largest
// d^2.
struct LogSums {
  BlockSum<11> sums;
  double largest_square = 0;
};

// Functions over rows. Each does rows from `first` on and returns how many: up to `count`, or to one that is not
// ordinary (array_rows.hpp), which the core then does by itself. The row alone tells whether it is.
struct RowKernels {
  size_t (*slerp)(const PairArrays& arrays, size_t first, size_t count);
  size_t (*nlerp)(const PairArrays& arrays, size_t first, size_t count);
  size_t (*rotate)(const RotateArrays& arrays, size_t first, size_t count);
  size_t (*normalize)(const KeyArrays& arrays, size_t first, size_t count);
  // Signs continued from the row before `first`, which is done; `flips` counts the rows that are changed.
  size_t (*make_continuous)(const KeyArrays& arrays, size_t first, size_t count, size_t& flips);

  // Keys made unit; worst_norm_error is raised to how far their lengths are from 1.
  size_t (*unit_keys)(const UnitKeyArrays& arrays, size_t first, size_t count, double& worst_norm_error);
  // All rows, as unit quaternions are ordinary.
  size_t (*relative_rotations)(const RelativeRotationArrays& arrays, size_t first, size_t count);
  // Up to one that turns by more than half a turn.
  size_t (*jacobians)(const JacobianRecords& records, size_t first, size_t count);

  // Weights from the first one on, up to one that is not finite or negative; `largest` is raised to them.
  size_t (*raise_to_weights)(const SampleArrays& samples, double& largest);
  // Samples from `first` on in whole blocks (qtraj/block_sum.hpp), up to one with a sample that is not ordinary or has
  // weight 0, or whose rows do not fill the lanes. Weights are finite and not negative.
  size_t (*add_scatter)(const SampleArrays& samples, size_t first, ScatterSums& sums);
  size_t (*add_logs)(const SampleArrays& samples, size_t first, const double (&base)[4], LogSums& sums);
};

// Sampling into arrays of double or of float.
template <class Real>
struct SampleKernels {
  // Samples at the times. Every row is written, one at fault with NaN; the outcome is that of the first at fault.
  // `cursor`, a segment index or any other number, says where to look first and receives a segment that was used.
  Outcome (*sample)(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor,
                    const SampleOutputs<Real>& outputs);
  // One sample.
  Status (*sample_at)(const Trajectory& trajectory, double time, size_t& cursor, const SampleOutputs<Real>& outputs);
};

struct Kernel {
  const char* target;  // instruction set and arithmetic, as qtraj_target reports it
  const SampleKernels<double>& of_double;
  const SampleKernels<float>& of_float;
  RowKernels rows;
};

// The curve of one segment, up to its very ends, in plain arithmetic: what diagnostics are made of. Rates in the body
// frame; only those wanted are written, and it is false where one of these overflows.
struct SegmentMotion {
  double q[4], omega[3], alpha[3];
};
bool segment_motion(const Trajectory& trajectory, size_t segment, double elapsed, bool wants_omega, bool wants_alpha,
                    SegmentMotion& motion);

// One for each instruction set. Fused arithmetic: avx2, avx512 and neon; all others are plain. Sampling into float is a
// file of its own, as it takes the compiler more than half as long as the rest.
extern const Kernel kScalarKernel;
#if defined(QTRAJ_X86_KERNELS)
extern const Kernel kSsse3Kernel, kSse4Kernel, kAvx2Kernel, kAvx512Kernel;
extern const SampleKernels<float> kSsse3FloatSamples, kSse4FloatSamples, kAvx2FloatSamples, kAvx512FloatSamples;
#elif defined(QTRAJ_NEON_KERNEL)
extern const Kernel kNeonKernel;
extern const SampleKernels<float> kNeonFloatSamples;
#endif

// The kernel in use; null until it is first asked for. All threads that find it null choose the same, the best one that
// this CPU runs.
extern std::atomic<const Kernel*> chosen_kernel;
const Kernel& choose_kernel();
static inline const Kernel& kernel() {
  const Kernel* chosen = chosen_kernel.load(std::memory_order_relaxed);
  return chosen ? *chosen : choose_kernel();
}

// For tests: the kernel of that name from now on, in all threads; null: the one for this CPU again. False where this
// CPU cannot run it or there is none of the name.
bool force_kernel(const char* target);

}  // namespace qtraj
