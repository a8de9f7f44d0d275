#include "qtraj/log_moments.hpp"

#include "qtraj/block_sum.hpp"
#include "qtraj/elementary.hpp"

namespace qtraj {
namespace {

bool first_component_is_negative(const Vector3& v) {
  for (int k = 0; k < 3; ++k)
    if (v[k] != 0) return v[k] < 0;
  return false;
}

// W, f, sum w d, sum w r and the upper triangle of the Hessian.
using Moments = BlockSum<12>;

Moments::Terms terms_of(const NearestLog& at, double weight) {
  const bool is_base = at.sine == 0;
  const double sideways = is_base ? weight : weight * (at.angle * at.cosine / at.sine);
  const Vector3 axis = is_base ? at.log : at.log / at.angle;
  const Vector3 along = (weight - sideways) * axis;
  const Vector3 logs = weight * at.log;
  Moments::Terms terms;
  terms << weight, weight * at.angle * at.angle, weight * at.angle, logs,  //
      along[0] * axis[0] + sideways, along[0] * axis[1], along[0] * axis[2], along[1] * axis[1] + sideways,
      along[1] * axis[2], along[2] * axis[2] + sideways;
  return terms;
}

}  // namespace

NearestLog nearest_log(const Quaternion& base, const Quaternion& unit) {
  const Quaternion relative = multiply(conjugate(base), unit);
  const Vector3 vector = vector_part(relative);
  const double sine = length(vector), cosine = std::abs(relative[0]);
  const double angle = atan2(sine, cosine);
  const bool other_side = relative[0] < 0 || (relative[0] == 0 && first_component_is_negative(vector));
  const double factor = sine == 0 ? 0.0 : angle / sine;
  return {(other_side ? -factor : factor) * vector, angle, cosine, sine};
}

LogMoments log_moments(const WeightedOrientations& samples, const Quaternion& base) {
  Moments sums;
  double farthest = 0;
  for (size_t sample = 0; sample < samples.count; ++sample) {
    const double weight = samples.weight(sample);
    if (weight == 0) continue;
    const NearestLog at = nearest_log(base, samples.unit(sample));
    sums.add(terms_of(at, weight));
    farthest = std::max(farthest, at.angle);
  }
  const Moments::Terms sum = sums.value();
  Matrix3 hessian;
  hessian << sum[6], sum[7], sum[8], sum[7], sum[9], sum[10], sum[8], sum[10], sum[11];
  return {sum[0], sum[1], sum[2], farthest, {sum[3], sum[4], sum[5]}, hessian};
}

}  // namespace qtraj
