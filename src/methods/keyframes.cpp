#include "methods/keyframes.hpp"

#include "base/floating.hpp"
#include "base/times.hpp"
#include "math/so3.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<CleanRows> kCleanKernels[] = QTRAJ_OF_EACH_TARGET(clean_keys);

// The keys that the kernel cleans from `first` on. Returns how many.
size_t clean_many(const KeyframeInput& input, size_t first, bool keeps_signs, const Keyframes& keys,
                  KeyframeReport& report) {
  return kCleanKernels[target()]({input.q_wb, keeps_signs, keys.q, keys.q_remainder, &report}, first, input.count);
}

// Whether the rates, or tangents, of keys from `first` to `end` are finite.
bool has_finite_rates(const KeyframeInput& input, size_t first, size_t end) {
  return (!input.omega.data || are_finite(input.omega, first, end)) &&
         (!input.alpha.data || are_finite(input.alpha, first, end)) &&
         (!input.in_tangents.data ||
          (are_finite(input.in_tangents, first, end) && are_finite(input.out_tangents, first, end)));
}

// `times` are the copies, which nobody writes to while they are looked at.
Status check_keyframe(const double* times, size_t key, bool rates_are_finite, Status of_orientation) {
  if (!is_finite(times[key]) || !rates_are_finite) return Status::not_finite;
  return of_orientation != Status::ok ? of_orientation : check_knot(times, key);
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
  size_t ordinary = 0;          // orientations below this index are done
  bool are_all_finite = false;  // the rates at them
  for (size_t key = 0; key < input.count; ++key) {
    if (key >= ordinary) {
      ordinary = key + clean_many(input, key, keeps_signs, cleaned, report);
      are_all_finite = has_finite_rates(input, key, ordinary);
    }
    const bool is_done = key < ordinary;
    cleaned.times[key] = input.times[key];
    const bool rates_are_finite = (is_done && are_all_finite) || has_finite_rates(input, key, key + 1);
    const Status status =
        check_keyframe(cleaned.times, key, rates_are_finite, is_done ? Status::ok : check_key(input.q_wb, key));
    if (status != Status::ok) return {status, key};
    if (is_done) continue;
    fill_unit(input, key, cleaned, report);
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
