#include "means/log_moments.hpp"

#include "rows/nearest_log.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<LogRows> kLogKernels[] = QTRAJ_OF_EACH_TARGET(add_logs);

}  // namespace

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
  samples.sum([&](const SampleRows& rows, size_t first, size_t count) {
    return kLogKernels[target()]({rows, from, &logs}, first, count);
  });
  double sum[11];
  for (size_t term = 0; term < 11; ++term) sum[term] = logs.sums.value(term);
  // u u^T has trace 1, so that W less the trace of the sum is sum w d cot d
  const double across = sum[0] - (sum[5] + sum[8] + sum[10]);
  Matrix3 hessian;
  hessian << sum[5] + across, sum[6], sum[7], sum[6], sum[8] + across, sum[9], sum[7], sum[9], sum[10] + across;
  return {sum[0], sum[1], std::sqrt(logs.largest_square), {sum[2], sum[3], sum[4]}, hessian};
}

}  // namespace qtraj
