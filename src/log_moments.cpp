#include "qtraj/log_moments.hpp"

#include "kernel/kernel.hpp"
#include "kernel/nearest_log.hpp"

namespace qtraj {

NearestLog nearest_log(const Quaternion& base, const Quaternion& unit) {
  double from[4], to[4];
  store(base, from);
  store(unit, to);
  const NearestLogOf<double> at = nearest_log_of(from, to);
  return {load(at.log), at.angle, at.cosine, at.sine};
}

LogMoments log_moments(const WeightedOrientations& samples, const Quaternion& base) {
  double from[4];
  store(base, from);
  LogSums logs;
  samples.sum(
      [&](const SampleArrays& arrays, size_t first) { return kernel().rows.add_logs(arrays, first, from, logs); });
  const auto sum = [&](size_t term) { return logs.sums.value(term); };
  Matrix3 hessian;
  hessian << sum(6), sum(7), sum(8), sum(7), sum(9), sum(10), sum(8), sum(10), sum(11);
  return {sum(0), sum(1), sum(2), logs.farthest, {sum(3), sum(4), sum(5)}, hessian};
}

}  // namespace qtraj
