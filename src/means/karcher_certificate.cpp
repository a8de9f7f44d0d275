#include "means/karcher_certificate.hpp"

#include "math/error_free.hpp"
#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

constexpr double kHalfPi = 0.5 * kPi;
constexpr int kSteps = 64;

// dbar, by a pass over the samples; the error of the summation is below that of the terms.
double mean_distance(const WeightedOrientations& samples, const Quaternion& mean, double sum_of_weights) {
  DoubleDouble sum = {0, 0};
  for (size_t sample = 0; sample < samples.count; ++sample) {
    const double weight = samples.weight(sample);
    if (weight == 0) continue;
    const DoubleDouble next = two_sum(sum.value, weight * nearest_log(mean, samples.unit(sample)).angle);
    sum = {next.value, sum.error + next.error};
  }
  return (sum.value + sum.error) / sum_of_weights;
}

// S, at least `tie`: every orientation with an f as small is within it.
double search_radius(const Spectrum& spectrum, const Quaternion& mean, const LogMoments& at_mean, double dbar,
                     double epsilon) {
  double radius = 2.0 * dbar;
  const double rms_cosine = sin_cos(at_mean.root_mean_square()).cos;
  const double t = rms_cosine * rms_cosine - 1e-12;
  const double first = spectrum.values[0] / spectrum.sum_of_weights;
  const double second = spectrum.values[1] / spectrum.sum_of_weights;
  if (t > second && !spectrum.ties(epsilon)) {
    const double cosine_squared = std::min((t - second) / (first - second), 1.0);
    const double from_eigenvector = atan2(std::sqrt(1.0 - cosine_squared), std::sqrt(cosine_squared));
    radius = std::min(radius, nearest_log(mean, spectrum.vectors[0]).angle + from_eigenvector);
  }
  return std::max(64.0 * epsilon, std::min(radius, kHalfPi));
}

// Bounds of what the samples contribute at the distances s_k = S k / 64 from m, k = 1..64.
struct Profile {
  double s[kSteps + 1];
  double curvature[kSteps + 1];  // lower bound of that of f/2, by samples that stay within pi/2
  double far[kSteps + 1];        // weight of samples that may have been passed at pi/2
};

// Computes the profile by a pass over the samples.
Profile profile_of(const WeightedOrientations& samples, const Quaternion& mean, double radius) {
  const double tie = 64.0 * samples.epsilon();
  Profile profile = {};
  double cosine[kSteps + 1], sine[kSteps + 1];
  for (int k = 1; k <= kSteps; ++k) {
    profile.s[k] = radius * k / kSteps;
    const SinCos at = sin_cos(profile.s[k]);
    cosine[k] = at.cos, sine[k] = at.sin;
  }
  for (size_t sample = 0; sample < samples.count; ++sample) {
    const double weight = samples.weight(sample);
    if (weight == 0) continue;
    const NearestLog at = nearest_log(mean, samples.unit(sample));
    for (int k = 1; k <= kSteps; ++k) {
      const double angle = at.angle + profile.s[k];
      if (angle >= kHalfPi - tie) {
        profile.far[k] += weight;
      } else {
        // the cosine and sine of d + s_k
        const double c = at.cosine * cosine[k] - at.sine * sine[k], s = at.sine * cosine[k] + at.cosine * sine[k];
        profile.curvature[k] += weight * (angle * c / s);
      }
    }
  }
  return profile;
}

bool increases_outward(const Profile& profile, double slope_at_mean) {
  for (int k = 1; k <= kSteps; ++k) {
    const double slope_gain = profile.curvature[k] * profile.s[k - 1];
    if (!(profile.curvature[k] > 0)) return false;
    if (profile.far[k] > 0 && !(slope_gain > kPi * profile.far[k] + slope_at_mean)) return false;
  }
  return true;
}

}  // namespace

bool is_global_minimum(const WeightedOrientations& samples, const Spectrum& spectrum, const Quaternion& mean,
                       const LogMoments& at_mean) {
  const double tie = 64.0 * samples.epsilon();
  const double room = kHalfPi - tie - at_mean.farthest;
  if (at_mean.farthest < room) return true;
  if (2.0 * at_mean.root_mean_square() < room) return true;  // dbar, which costs a pass, is no larger
  const double dbar = mean_distance(samples, mean, at_mean.weight);
  if (2.0 * dbar < room) return true;
  const double radius = search_radius(spectrum, mean, at_mean, dbar, samples.epsilon());
  return increases_outward(profile_of(samples, mean, radius), length(at_mean.logs));
}

}  // namespace qtraj
