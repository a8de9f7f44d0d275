#include "qtraj/quintic.hpp"

#include "qtraj/given_rates.hpp"
#include "qtraj/rotation_vector_polynomial.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {
namespace {

// Past this the squares of rates in the formulas could overflow.
constexpr double kLimit = 0x1p240;

// Given rates at both ends of a segment, body frame, in units of the segment.
struct SegmentRates {
  Vector3 rise[2], bend[2];
};
Outcome given_segment_rates(const Construction& construction, size_t segment, SegmentRates& rates) {
  const double h = construction.keys.step(segment);
  for (size_t end = 0; end < 2; ++end) {
    const size_t key = segment + end;
    if (!given_rise(construction, key, h, kLimit, rates.rise[end])) return {Status::not_finite, key};
    if (!given_bend(construction, key, h, kLimit, rates.bend[end])) return {Status::not_finite, key};
  }
  return {};
}

void keep_end_rates(Construction& construction, size_t segment, const SegmentRates& rates) {
  const double h = construction.keys.step(segment);
  if (segment == 0) construction.omega_start = rates.rise[0] / h;
  construction.omega_end = rates.rise[1] / h;
}

}  // namespace

Outcome build_rotation_quintic(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<RotationVectorSegment<5>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    SegmentRates rates;
    const Outcome outcome = given_segment_rates(construction, i, rates);
    if (outcome.status != Status::ok) return outcome;

    const Vector3 log = relative_log(keys[i], keys[i + 1]), r = 2.0 * log;
    const Vector3 end_rise = inverse_right_jacobian(r, rates.rise[1]);
    const Vector3 end_bend =
        inverse_right_jacobian(r, Vector3(rates.bend[1] - turning_acceleration(turning_factors(r), r, end_rise)));
    const EndValues<Vector3> p = {
        {Vector3::Zero(), log}, {0.5 * rates.rise[0], 0.5 * end_rise}, {0.5 * rates.bend[0], 0.5 * end_bend}};
    bound = std::max(bound, set_quintic(keys[i].value, keys.step(i), p, segments[i]));
    keep_end_rates(construction, i, rates);
  }
  construction.range = range_of(bound);
  return {};
}

Outcome build_quaternion_quintic(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<NormalizedSegment<5>*>(construction.segments);
  double largest = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    SegmentRates rates;
    const Outcome outcome = given_segment_rates(construction, i, rates);
    if (outcome.status != Status::ok) return outcome;

    EndValues<Quaternion> ends;
    for (size_t end = 0; end < 2; ++end) {
      const Quaternion q = keys[i + end].value;
      const Vector3& rise = rates.rise[end];
      ends.rise[end] = multiply(q, quaternion(0.0, 0.5 * rise));
      ends.bend[end] = multiply(q, quaternion(-0.25 * dot(rise, rise), 0.5 * rates.bend[end]));
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
  constexpr double kFloatRange = 0x1p20;  // squares and products of four stay in it
  construction.range = largest > kFloatRange ? ExponentRange::any : ExponentRange::quarter_turn;
  return {};
}

}  // namespace qtraj
