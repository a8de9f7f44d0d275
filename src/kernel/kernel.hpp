// Kernels sample trajectories: the same code, compiled for each instruction set and arithmetic; one runs here.
#pragma once

#include "qtraj/trajectory.hpp"

// Targets with a fused kernel: AArch64 always, x86-64 on CPUs that have AVX2 and FMA.
#if !defined(QTRAJ_NO_SIMD) && (defined(__x86_64__) || defined(__aarch64__))
#define QTRAJ_HAS_FUSED_KERNEL
#endif

namespace qtraj {

// Times to sample: an array, or start + (double)i step where `array` is null.
struct TimeSource {
  const double* array;
  double start, step;
};

struct Kernel {
  const char* target;  // instruction set and arithmetic, as qtraj_target reports it

  // Rows of q_out [count][4] at the times. Every row is written, one at fault with NaN; the outcome is that of the
  // first at fault. `cursor`, a segment index or any other number, says where to look first and receives the last
  // segment used.
  Outcome (*sample)(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor, double* q_out);
  Outcome (*sample_f32)(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor,
                        float* q_out);
};

extern const Kernel kPlainKernel;
#if defined(QTRAJ_HAS_FUSED_KERNEL)
extern const Kernel kFusedKernel;
#endif

// The kernel for this CPU.
const Kernel& kernel();

}  // namespace qtraj
