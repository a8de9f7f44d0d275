#include "row_kernels.hpp"
#include "sample.hpp"

namespace qtraj {
namespace {

template <class Real>
constexpr SampleKernels<Real> kScalarSamples = {sample<Plain, Real>, sample_at<Plain, Real>};

}  // namespace

const Kernel kScalarKernel = {"scalar plain", kScalarSamples<double>, kScalarSamples<float>,
                              kRowKernels<Plain, double>};

bool segment_motion(const Trajectory& trajectory, size_t segment, double elapsed, bool wants_omega, bool wants_alpha,
                    SegmentMotion& motion) {
  return with_evaluator<Plain>(trajectory, [&](const auto& evaluator) {
    using Evaluator = std::decay_t<decltype(evaluator)>;
    const Sampler<Evaluator, Plain, double, true> sampler(evaluator, trajectory,
                                                          {Frame::body, wants_omega, wants_alpha});
    Row<double> row;
    if (sampler.sample_segment(segment, elapsed, row) != Status::ok) return false;
    write(row.q, motion.q, 0);
    if (wants_omega) write(row.omega, motion.omega, 0);
    if (wants_alpha) write(row.alpha, motion.alpha, 0);
    return true;
  });
}

}  // namespace qtraj
