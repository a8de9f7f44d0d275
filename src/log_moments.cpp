#include "qtraj/log_moments.hpp"

#include "kernel/kernel.hpp"
#include "kernel/nearest_log.hpp"

namespace qtraj {

NearestLog nearest_log(const Quaternion& base, const Quaternion& unit) {
  double from[4], to[4];
  store(base, from);
  store(unit, to);
  RelativeOf<double> relative = {};
  relate<Plain>(from, to, relative);
  const double factor = log_factor<Plain>(relative.q[0], relative.inverse), root = std::sqrt(relative.sine_squared);
  return {factor * Vector3(relative.q[1], relative.q[2], relative.q[3]), std::abs(factor) * root,
          relative.q[0] * relative.inverse, std::abs(relative.inverse) * root};
}

LogMoments log_moments(const WeightedOrientations& samples, const Quaternion& base) {
  double from[4];
  store(base, from);
  LogSums logs;
  samples.sum(
      [&](const SampleArrays& arrays, size_t first) { return kernel().rows.add_logs(arrays, first, from, logs); });
  const auto sum = [&](size_t term) { return logs.sums.value(term); };
  // as u u^T has the trace 1, what the traces leave of W is sum w d cot d
  const double across = sum(0) - (sum(6) + sum(9) + sum(11));
  Matrix3 hessian;
  hessian << sum(6) + across, sum(7), sum(8), sum(7), sum(9) + across, sum(10), sum(8), sum(10), sum(11) + across;
  return {sum(0), sum(1), sum(2), logs.farthest, {sum(3), sum(4), sum(5)}, hessian};
}

}  // namespace qtraj
