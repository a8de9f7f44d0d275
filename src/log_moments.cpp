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
  const double factor = relative.inverse * evaluate<Plain, AcosRatio>(versine_of<Plain>(relative));
  const double root = std::sqrt(relative.sine_squared);
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
  const double across = sum(0) - (sum(5) + sum(8) + sum(10));
  Matrix3 hessian;
  hessian << sum(5) + across, sum(6), sum(7), sum(6), sum(8) + across, sum(9), sum(7), sum(9), sum(10) + across;
  return {sum(0), sum(1), std::sqrt(logs.largest_square), {sum(2), sum(3), sum(4)}, hessian};
}

}  // namespace qtraj
