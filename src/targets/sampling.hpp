// Sampling by the target in use.
#pragma once

#include "targets/kernels.hpp"

namespace qtraj {

extern SampleFunction<double>* const sample_double_by_target[kTargetCount];
extern SampleFunction<float>* const sample_float_by_target[kTargetCount];
extern SampleAtFunction<double>* const sample_at_double_by_target[kTargetCount];
extern SampleAtFunction<float>* const sample_at_float_by_target[kTargetCount];
extern SampleVectorsFunction<double>* const sample_vectors_double_by_target[kTargetCount];
extern SampleVectorsFunction<float>* const sample_vectors_float_by_target[kTargetCount];

inline Outcome sample(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor,
                      const SampleOutputs<double>& outputs) {
  return sample_double_by_target[target()](trajectory, times, count, cursor, outputs);
}
inline Outcome sample(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor,
                      const SampleOutputs<float>& outputs) {
  return sample_float_by_target[target()](trajectory, times, count, cursor, outputs);
}
inline Status sample_at(const Trajectory& trajectory, double time, size_t& cursor,
                        const SampleOutputs<double>& outputs) {
  return sample_at_double_by_target[target()](trajectory, time, cursor, outputs);
}
inline Status sample_at(const Trajectory& trajectory, double time, size_t& cursor,
                        const SampleOutputs<float>& outputs) {
  return sample_at_float_by_target[target()](trajectory, time, cursor, outputs);
}

inline Outcome sample(const VectorCurve& curve, const TimeSource& times, size_t count, size_t& cursor,
                      const VectorOutputs<double>& outputs) {
  return sample_vectors_double_by_target[target()](curve, times, count, cursor, outputs);
}
inline Outcome sample(const VectorCurve& curve, const TimeSource& times, size_t count, size_t& cursor,
                      const VectorOutputs<float>& outputs) {
  return sample_vectors_float_by_target[target()](curve, times, count, cursor, outputs);
}

// The motion at a time within a segment, up to the segment's very ends; rates in the body frame.
struct SegmentMotion {
  double q[4], omega[3], alpha[3];
};

// For diagnostics, in plain arithmetic whatever target is in use. Writes only the rates that are asked for; false where
// one of these overflows.
bool segment_motion(const Trajectory& trajectory, size_t segment, double elapsed, bool with_omega, bool with_alpha,
                    SegmentMotion& motion);

}  // namespace qtraj
