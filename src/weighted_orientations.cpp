#include "qtraj/weighted_orientations.hpp"

#include <cstring>

namespace qtraj {
namespace {

// 2^-e for a largest weight in [2^e, 2^(e+1)); 2^1023 for a subnormal, 2^-1022 for one of 2^1023 and more.
double scale_of_weights(double largest) {
  uint64_t bits;
  std::memcpy(&bits, &largest, sizeof bits);
  constexpr uint64_t kLargestExponent = 2046;
  const uint64_t exponent = std::max<uint64_t>(kLargestExponent - (bits >> 52), 1);
  bits = exponent << 52;
  double scale;
  std::memcpy(&scale, &bits, sizeof scale);
  return scale;
}

}  // namespace

Quaternion unit(const Quaternion& q) {
  const Quaternion scaled = scale_for(largest_component(q)) * q;
  return scaled / length(scaled);
}

double WeightedOrientations::epsilon() const { return q.single ? FLT_EPSILON : DBL_EPSILON; }

Outcome WeightedOrientations::check() {
  double largest = weights.data ? 0.0 : 1.0;
  for (size_t sample = 0; sample < count; ++sample) {
    if (!q.is_finite(sample) || (weights.data && !weights.is_finite(sample))) return {Status::not_finite, sample};
    if (largest_component(q[sample]) == 0) return {Status::zero_norm, sample};
    if (!weights.data) continue;
    const double weight = weights[sample][0];
    if (weight < 0) return {Status::negative_weight, sample};
    largest = std::max(largest, weight);
  }
  if (largest == 0) return {Status::zero_norm, kNoIndex};
  weight_scale = scale_of_weights(largest);
  return {};
}

Quaternion WeightedOrientations::with_sign_of_first(const Quaternion& mean) const {
  for (size_t sample = 0; sample < count; ++sample) {
    if (weight(sample) == 0) continue;
    const double cosine = dot(mean, unit(sample));
    if (cosine != 0) return cosine < 0 ? Quaternion(-mean) : mean;
  }
  return mean;
}

}  // namespace qtraj
