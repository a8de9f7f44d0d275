#include "means/weighted_orientations.hpp"

#include "rows/row_loop.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<WeightRows> kWeightKernels[] = QTRAJ_OF_EACH_TARGET(raise_to_weights);

}  // namespace

Quaternion unit(const Quaternion& q) {
  const Quaternion scaled = scale_for(largest_component(q)) * q;
  return scaled / length(scaled);
}

void SampleBlock::add(const Quaternion& q, double weight) {
  store(q, q_[count_]);
  if (!is_ordinary(q_[count_])) store(scaled_to_one(q), q_[count_]);
  weights_[count_++] = weight;
}

SampleRows SampleBlock::next_part() {
  const SampleRows part = {input<4>(q_[0], count_), input<1>(weights_, count_), 1.0, true, true};
  rows_before_ += count_;
  count_ = 0;
  return part;
}

SampleRows SampleBlock::last_part() {
  // a block of which no row is left, because those after the parts before weigh nothing, is closed by padding alone
  const bool is_open = rows_before_ > 0;
  size_t rows = count_;
  for (; rows % kSumLanes != 0 || (rows == 0 && is_open); ++rows) {
    if (rows > 0) std::copy_n(q_[0], 4, q_[rows]);
    weights_[rows] = 0;
  }
  rows_before_ = count_ = 0;
  return {input<4>(q_[0], rows), input<1>(weights_, rows), 1.0, true, false};
}

bool WeightedOrientations::scale_weights() {
  if (!weights.data) return true;
  double largest = 0;
  if (kWeightKernels[target()]({weights, &largest}, 0, count) < count || largest == 0) return false;
  weight_scale = normalizing_scale(largest);
  return true;
}

bool WeightedOrientations::take(size_t sample, SampleBlock& block) const {
  if (check_key(q, sample) != Status::ok) return false;
  if (weight(sample) > 0) block.add(row_of(q, sample), weight(sample));
  return true;
}

Outcome WeightedOrientations::first_fault() const {
  bool has_weight = !weights.data;
  for (size_t sample = 0; sample < count; ++sample) {
    if (!is_finite(q, sample) || (weights.data && !is_finite(weights, sample))) return {Status::not_finite, sample};
    if (is_zero(q, sample)) return {Status::zero_norm, sample};
    if (!weights.data) continue;
    const double weight = number_of(weights, sample);
    if (weight < 0) return {Status::negative_weight, sample};
    has_weight = has_weight || weight > 0;
  }
  return has_weight ? Outcome{} : Outcome{Status::zero_norm, kNoIndex};
}

Quaternion WeightedOrientations::with_sign_of_first(const Quaternion& mean) const {
  for (size_t sample = 0; sample < count; ++sample) {
    // as given: scaled, a weight above 0 may be 0
    if (weights.data && number_of(weights, sample) == 0) continue;
    const double cosine = dot(mean, unit(sample));
    if (cosine != 0) return cosine < 0 ? Quaternion(-mean) : mean;
  }
  return mean;
}

}  // namespace qtraj
