#include "qtraj/weighted_orientations.hpp"

#include <cfloat>

namespace qtraj {

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
  weight_scale = normalizing_scale(largest);
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
