#include "sample.hpp"

namespace qtraj {

const Kernel kPlainKernel = {"scalar plain", sample<Plain, double>, sample<Plain, float>};

bool segment_motion(const Trajectory& trajectory, size_t segment, double elapsed, bool wants_omega, bool wants_alpha,
                    SegmentMotion& motion) {
  return with_evaluator<Plain>(trajectory, [&](auto evaluator) {
    using Evaluator = decltype(evaluator);
    using Segment = typename Evaluator::Segment;
    const auto& record = reinterpret_cast<const Segment*>(bytes_of(trajectory) + trajectory.segments_offset)[segment];
    Row<double> row;
    Rates<double> rates;
    Evaluator::sample(record, elapsed, row.q);
    Evaluator::sample_rates(record, elapsed, rates);
    if (!finish_rates<Plain>(row.q, rates, Evaluator::scale(record), {Frame::body, wants_omega, wants_alpha}, row))
      return false;
    write(row.q, motion.q, 0);
    if (wants_omega) write(row.omega, motion.omega, 0);
    if (wants_alpha) write(row.alpha, motion.alpha, 0);
    return true;
  });
}

}  // namespace qtraj
