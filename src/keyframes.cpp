#include "qtraj/keyframes.hpp"

#include <cfloat>

#include "qtraj/floating.hpp"
#include "qtraj/knots.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {
namespace {

Status check_keyframe(const KeyframeInput& input, size_t key) {
  const bool finite = is_finite(input.times[key]) && input.q_wb.is_finite(key) &&
                      (!input.omega.data || input.omega.is_finite(key)) &&
                      (!input.alpha.data || input.alpha.is_finite(key));
  if (!finite) return Status::not_finite;
  if (largest_component(input.q_wb[key]) == 0) return Status::zero_norm;
  return check_knot(input.times, key);
}

}  // namespace

double KeyframeInput::epsilon() const { return q_wb.single ? FLT_EPSILON : DBL_EPSILON; }

void Keyframes::set(size_t key, const UnitQuaternion& unit) {
  store(unit.value, q[key]);
  store(unit.error, q_remainder[key]);
}

Outcome clean_keyframes(const KeyframeInput& input, const Keyframes& keys, KeyframeReport& report) {
  Keyframes cleaned = keys;
  for (size_t key = 0; key < input.count; ++key) {
    const Status status = check_keyframe(input, key);
    if (status != Status::ok) return {status, key};

    const Normalized normalized = normalize(input.q_wb[key]);
    UnitQuaternion unit = normalized.unit;
    report.worst_norm_error = std::max(report.worst_norm_error, std::abs(normalized.norm - 1.0));
    if (key > 0) {
      double neighbours = dot(load(keys.q[key - 1]), unit.value);
      if (neighbours < 0) {
        unit = negate(unit);
        neighbours = -neighbours;
        ++report.sign_flips;
      }
      report.least_dot = std::min(report.least_dot, neighbours);
    }
    cleaned.times[key] = input.times[key];
    cleaned.set(key, unit);
  }
  return {};
}

Outcome close_keyframes(Keyframes& keys) {
  constexpr double kTolerance = 1e-6;
  const size_t last = keys.count - 1;
  UnitQuaternion first_key = keys[0];
  if (dot(first_key.value, keys[last].value) < 0) first_key = negate(first_key);
  if (2.0 * relative_rotation(first_key, keys[last]).angle > kTolerance) return {Status::not_closed, last};
  keys.set(last, first_key);
  return {};
}

}  // namespace qtraj
