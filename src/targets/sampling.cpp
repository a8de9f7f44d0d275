#include "targets/sampling.hpp"

namespace qtraj {

SampleFunction<double>* const sample_double_by_target[] = QTRAJ_OF_EACH_TARGET(sample);
SampleFunction<float>* const sample_float_by_target[] = QTRAJ_OF_EACH_TARGET(sample);
SampleVectorsFunction<double>* const sample_vectors_double_by_target[] = QTRAJ_OF_EACH_TARGET(sample_vectors);
SampleVectorsFunction<float>* const sample_vectors_float_by_target[] = QTRAJ_OF_EACH_TARGET(sample_vectors);

namespace {

// The namespaces of scalar code, named by their arithmetic.
namespace of_plain = scalar;
namespace of_fused = scalar_fused;

}  // namespace

#define QTRAJ_SAMPLE_AT(name, arithmetic, runs_here, unused) of_##arithmetic::sample_at,
SampleAtFunction<double>* const sample_at_double_by_target[] = {QTRAJ_EACH_TARGET(QTRAJ_SAMPLE_AT, )};
SampleAtFunction<float>* const sample_at_float_by_target[] = {QTRAJ_EACH_TARGET(QTRAJ_SAMPLE_AT, )};
#undef QTRAJ_SAMPLE_AT

bool segment_motion(const Trajectory& trajectory, size_t segment, double elapsed, bool with_omega, bool with_alpha,
                    SegmentMotion& motion) {
  const SampleOutputs<double> outputs = {motion.q, with_omega ? motion.omega : nullptr,
                                         with_alpha ? motion.alpha : nullptr, Frame::body};
  return scalar::evaluate_in_double(trajectory, segment, elapsed, false, outputs, 0) == Status::ok;
}

}  // namespace qtraj
