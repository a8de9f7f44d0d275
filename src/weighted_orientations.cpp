#include "qtraj/weighted_orientations.hpp"

#include <cfloat>

#include "kernel/array_rows.hpp"

namespace qtraj {

Quaternion unit(const Quaternion& q) {
  const Quaternion scaled = scale_for(largest_component(q)) * q;
  return scaled / length(scaled);
}

double WeightedOrientations::epsilon() const { return q.single ? FLT_EPSILON : DBL_EPSILON; }

void SampleBlock::add(const Quaternion& q, double weight) {
  store(q, q_[count_]);
  if (!is_ordinary(q_[count_])) store(scaled_to_one(q), q_[count_]);
  weights_[count_++] = weight;
}

SampleArrays SampleBlock::padded() {
  size_t rows = count_;
  for (; rows % kSumLanes != 0; ++rows) {
    std::copy_n(q_[0], 4, q_[rows]);
    weights_[rows] = 0;
  }
  return {q_, weights_, rows, false, 1.0, true};
}

bool WeightedOrientations::scale_weights() {
  if (!weights.data) return true;
  double largest = 0;
  const SampleArrays arrays = {q.data, weights.data, count, q.single, 1.0, false};
  if (kernel().rows.raise_to_weights(arrays, largest) < count || largest == 0) return false;
  weight_scale = normalizing_scale(largest);
  return true;
}

bool WeightedOrientations::take(size_t sample, SampleBlock& block) const {
  if (check_key(q, sample) != Status::ok) return false;
  if (weight(sample) > 0) block.add(q[sample], weight(sample));
  return true;
}

Outcome WeightedOrientations::first_fault() const {
  bool has_weight = !weights.data;
  for (size_t sample = 0; sample < count; ++sample) {
    if (!q.is_finite(sample) || (weights.data && !weights.is_finite(sample))) return {Status::not_finite, sample};
    if (largest_component(q[sample]) == 0) return {Status::zero_norm, sample};
    if (!weights.data) continue;
    const double weight = weights[sample][0];
    if (weight < 0) return {Status::negative_weight, sample};
    has_weight = has_weight || weight > 0;
  }
  return has_weight ? Outcome{} : Outcome{Status::zero_norm, kNoIndex};
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
