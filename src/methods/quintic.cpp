// The builders of ROTATION_QUINTIC and QUATERNION_QUINTIC.
#include "math/so3.hpp"
#include "methods/key_rates.hpp"
#include "methods/method.hpp"
#include "methods/polynomials.hpp"
#include "methods/turns.hpp"

namespace qtraj {
namespace {

// Past this the squares of rates in the formulas could overflow.
constexpr double kLimit = 0x1p240;

Outcome given_segment_rates(const Construction& construction, size_t segment, StepRates& rates) {
  const double h = construction.keys.step(segment);
  for (size_t end = 0; end < 2; ++end) {
    const size_t key = segment + end;
    if (!given_scaled_omega(construction, key, h, kLimit, rates.first[end])) return {Status::rate_too_fast, key};
    if (!given_scaled_alpha(construction, key, h, kLimit, rates.second[end])) return {Status::rate_too_fast, key};
  }
  return {};
}

void keep_end_rates(Construction& construction, size_t segment, const StepRates& rates) {
  const double h = construction.keys.step(segment);
  if (segment == 0) construction.omega_start = rates.first[0] / h;
  construction.omega_end = rates.first[1] / h;
}

}  // namespace

// ROTATION_QUINTIC: q_i exp(r/2), r the quintic with the ends of HERMITE and the given body accelerations:
// r''(0) = alpha_i, r''(h) = Jr^-1(R_i) (alpha_{i+1} - beta(R_i, r'(h))), beta of so3.hpp; a step with whole turns as
// there.
// rate_too_fast with a key's index where |h omega| or |h^2 alpha| exceeds 2^240.
Outcome build_rotation_quintic(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<RotationVectorSegment<5>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    StepRates rates;
    Outcome outcome = given_segment_rates(construction, i, rates);
    if (outcome.status != Status::ok) return outcome;

    Step step;
    outcome = take_step(construction, i, &rates, step);
    if (outcome.status != Status::ok) return outcome;
    const Chart chart = chart_of(keys[i], step);
    const Vector3 first[2] = {first_derivative(chart.start, rates.first[0]),
                              first_derivative(chart.end, rates.first[1])};
    const EndValues<Vector3> p = {{0.5 * chart.start, 0.5 * chart.end},
                                  {0.5 * first[0], 0.5 * first[1]},
                                  {0.5 * second_derivative(chart.start, first[0], rates.second[0]),
                                   0.5 * second_derivative(chart.end, first[1], rates.second[1])}};
    bound = std::max(bound, set_quintic(chart.base, keys.step(i), p, segments[i]));
    keep_end_rates(construction, i, rates);
  }
  construction.range = range_of(bound);
  return {};
}

// QUATERNION_QUINTIC: the quintic in R^4 with q' = (0, omega_world/2) q and q'' = (-|omega|^2/4, alpha_world/2) q at
// the keys, normalised (Y. Liu et al., "A quaternion-based trajectory planning", ROBIO 2017, doi
// 10.1109/ROBIO.2017.8324769). rate_too_fast as above.
Outcome build_quaternion_quintic(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<NormalizedSegment<5>*>(construction.segments);
  double largest = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    StepRates rates;
    const Outcome outcome = given_segment_rates(construction, i, rates);
    if (outcome.status != Status::ok) return outcome;

    EndValues<Quaternion> ends;
    for (size_t end = 0; end < 2; ++end) {
      const Quaternion q = keys[i + end].value;
      const Vector3& h_omega = rates.first[end];
      ends.first[end] = multiply(q, quaternion(0.0, 0.5 * h_omega));
      ends.second[end] = multiply(q, quaternion(-0.25 * dot(h_omega, h_omega), 0.5 * rates.second[end]));
    }
    Quaternion c[6];
    quintic_through<Quaternion>(ends, 0.5 * difference(keys[i + 1], keys[i]), 0.5 * sum(keys[i], keys[i + 1]), c);
    segments[i].scale = 2.0 / keys.step(i);
    for (size_t term = 0; term < 6; ++term) {
      store(c[term], segments[i].c[term]);
      largest = std::max(largest, largest_component(c[term]));
    }
    keep_end_rates(construction, i, rates);
  }
  constexpr double kFloatRange = 0x1p20;  // squares and products of four then stay in the range of float
  construction.range = largest > kFloatRange ? ExponentRange::any : ExponentRange::quarter_turn;
  return {};
}

}  // namespace qtraj
