#include "means/moments.hpp"

#include <cfloat>

namespace qtraj {
namespace {

// The sum of the weights, scaled, by compensated summation as in BlockSum.
double sum_of_weights(const WeightedOrientations& samples) {
  if (!samples.weights.data) return static_cast<double>(samples.count);
  double total = 0, error = 0;
  for (size_t sample = 0; sample < samples.count; ++sample) {
    const DoubleDouble sum = two_sum(total, samples.weight(sample));
    total = sum.value;
    error += sum.error;
  }
  return total + error;
}

// Whether a factor, a power of two from 2^-1022 to 2^1022, takes a value below 2^66 out of range.
bool overflows(double value, double factor) {
  constexpr double kReduced = 0x1p-66;
  return std::abs(kReduced * value) * factor > kReduced * DBL_MAX;
}

// Whether a sum of finite numbers does.
bool sum_overflows(double a, double b) { return std::abs(0.5 * a + 0.5 * b) > 0.5 * DBL_MAX; }

bool all_finite(const double* moments) {
  return std::all_of(moments, moments + kMomentCount, [](double moment) { return is_finite(moment); });
}

EigenMean without_mean(Status status) {
  EigenMean mean;
  mean.outcome.status = status;
  return mean;
}

// +-q with w >= 0.
Quaternion with_positive_w(const Quaternion& q) {
  for (int k = 0; k < 4; ++k)
    if (q[k] != 0) return q[k] < 0 ? Quaternion(-q) : q;
  return q;
}

}  // namespace

Outcome add_moments(WeightedOrientations samples, double* moments) {
  constexpr Outcome kOutOfRange = {Status::not_finite, kNoIndex};
  OrientationScatter scatter;
  const Outcome outcome = scatter_of(samples, scatter);
  const bool no_weight = outcome.status == Status::zero_norm && outcome.index == kNoIndex;
  if (outcome.status != Status::ok && !no_weight) return outcome;
  if (!all_finite(moments)) return kOutOfRange;
  if (no_weight) return {};

  ScatterTriangle triangle;
  scatter.read(triangle);
  double sums[kMomentCount] = {sum_of_weights(samples)};
  std::copy_n(triangle, kMomentCount - 1, sums + 1);
  const double unscale = 1.0 / samples.weight_scale;
  for (size_t k = 0; k < kMomentCount; ++k) {
    if (overflows(sums[k], unscale)) return kOutOfRange;
    sums[k] *= unscale;
    if (sum_overflows(moments[k], sums[k])) return kOutOfRange;
    sums[k] += moments[k];
  }
  std::copy_n(sums, kMomentCount, moments);
  return {};
}

EigenMean mean_from_moments(const double* moments) {
  if (!all_finite(moments)) return without_mean(Status::not_finite);
  if (moments[0] < 0) return without_mean(Status::negative_weight);
  const double largest = std::abs(
      *std::max_element(moments, moments + kMomentCount, [](double a, double b) { return std::abs(a) < std::abs(b); }));
  if (largest == 0) return without_mean(Status::zero_norm);

  const double scale = normalizing_scale(largest), weight = scale * moments[0];
  ScatterTriangle triangle;
  for (size_t k = 0; k < kMomentCount - 1; ++k) triangle[k] = scale * moments[k + 1];
  const Spectrum spectrum = spectrum_of(triangle);
  const double tolerance = kMomentsTolerance * weight;
  const bool is_scatter = std::abs(spectrum.sum_of_weights - weight) <= tolerance && spectrum.values[3] >= -tolerance;
  if (!is_scatter) return without_mean(Status::value);

  EigenMean mean;
  mean.q = with_positive_w(unit(spectrum.vectors[0]));
  mean.eigengap = spectrum.eigengap();
  if (spectrum.ties(DBL_EPSILON)) mean.outcome.status = Status::ambiguous;
  return mean;
}

}  // namespace qtraj
