#include "methods/keyframes.hpp"

#include "base/floating.hpp"
#include "base/times.hpp"
#include "math/so3.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<UnitKeyRows> kUnitKeyKernels[] = QTRAJ_OF_EACH_TARGET(unit_keys);

// `times` are the copies, which nobody writes to while they are looked at.
Status check_keyframe(const KeyframeInput& input, const double* times, size_t key, bool is_ordinary) {
  const bool finite =
      is_finite(times[key]) && (is_ordinary || is_finite(input.q_wb, key)) &&
      (!input.omega.data || is_finite(input.omega, key)) && (!input.alpha.data || is_finite(input.alpha, key)) &&
      (!input.in_tangents.data || (is_finite(input.in_tangents, key) && is_finite(input.out_tangents, key)));
  if (!finite) return Status::not_finite;
  if (!is_ordinary && is_zero(input.q_wb, key)) return Status::zero_norm;
  return check_knot(times, key);
}

// Makes keys unit from `first` on, as many as the kernel does, and returns how many. At most a block of them, which is
// then still in the cache when signs are made continuous.
size_t fill_units(const KeyframeInput& input, size_t first, Keyframes& keys, KeyframeReport& report) {
  constexpr size_t kBlock = 128;
  return kUnitKeyKernels[target()]({input.q_wb, keys.q, keys.q_remainder, &report.worst_norm_error}, first,
                                   std::min(first + kBlock, input.count));
}

void fill_unit(const KeyframeInput& input, size_t key, Keyframes& keys, KeyframeReport& report) {
  const Normalized normalized = normalize(row_of(input.q_wb, key));
  report.worst_norm_error = std::max(report.worst_norm_error, std::abs(normalized.norm - 1.0));
  keys.set(key, normalized.unit);
}

// Gives the key the sign that continues the one before, unless signs are kept.
void continue_sign(size_t key, bool keeps_signs, Keyframes& keys, KeyframeReport& report) {
  double neighbours = dot(load(keys.q[key - 1]), load(keys.q[key]));
  if (neighbours < 0) {
    neighbours = -neighbours;
    if (!keeps_signs) {
      keys.set(key, negate(keys[key]));
      ++report.sign_flips;
    }
  }
  report.least_dot = std::min(report.least_dot, neighbours);
}

// The same for a closing key, whose sign is not the caller's and no flip.
void continue_closing_sign(size_t key, bool keeps_signs, Keyframes& keys, KeyframeReport& report) {
  KeyframeReport of_closing;
  continue_sign(key, keeps_signs, keys, of_closing);
  report.least_dot = std::min(report.least_dot, of_closing.least_dot);
}

}  // namespace

void Keyframes::set(size_t key, const UnitQuaternion& unit) {
  store(unit.value, q[key]);
  store(unit.error, q_remainder[key]);
}

Outcome clean_keyframes(const KeyframeInput& input, bool keeps_signs, const Keyframes& keys, KeyframeReport& report) {
  Keyframes cleaned = keys;
  size_t ordinary = 0;  // keys below this index are done, or were made unit by the kernel
  for (size_t key = 0; key < input.count; ++key) {
    if (key >= ordinary) ordinary = key + fill_units(input, key, cleaned, report);
    cleaned.times[key] = input.times[key];
    const Status status = check_keyframe(input, cleaned.times, key, key < ordinary);
    if (status != Status::ok) return {status, key};
    if (key >= ordinary) fill_unit(input, key, cleaned, report);
    if (key > 0) continue_sign(key, keeps_signs, cleaned, report);
  }
  return {};
}

size_t count_sign_flips(const KeyframeInput& input, const Keyframes& keys) {
  size_t flips = 0;
  for (size_t key = 0; key < input.count; ++key) {
    const Quaternion given = scaled_to_one(row_of(input.q_wb, key));
    flips += dot(given, keys[key].value) < 0 ? 1 : 0;
  }
  return flips;
}

Outcome add_closing_key(const KeyframeInput& input, double period, Keyframes& keys, KeyframeReport& report) {
  const size_t last = keys.count - 1;
  const Status status = set_closing_time(keys.times, last, period);
  if (status != Status::ok) return {status, input.count - 1};
  keys.set(last, keys[0]);
  continue_closing_sign(last, false, keys, report);
  return {};
}

Outcome close_keyframes(double closure, bool keeps_signs, Keyframes& keys, KeyframeReport& report) {
  const size_t last = keys.count - 1;
  UnitQuaternion first_key = keys[0];
  if (dot(first_key.value, keys[last].value) < 0) first_key = negate(first_key);
  if (2.0 * relative_rotation(first_key, keys[last]).angle > closure) return {Status::not_closed, last};
  keys.set(last, first_key);
  continue_closing_sign(last, keeps_signs, keys, report);
  return {};
}

}  // namespace qtraj
