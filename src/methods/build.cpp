#include "methods/build.hpp"

#include <cfloat>

#include "math/so3.hpp"
#include "methods/method.hpp"

namespace qtraj {
namespace {

template <class Element>
Element* at_offset(void* block, size_t bytes) {
  return reinterpret_cast<Element*>(static_cast<char*>(block) + bytes);
}

constexpr size_t kKeyBytes = 4 * sizeof(double);

// How far from the knot the arc still has a direction: 2^50 rad, or 2^1000 s.
double far_distance(double rate) { return rate > 0x1p-950 ? 0x1p50 / rate : 0x1p1000; }

// Fills a circle that is all 0.
void set_circle(Extrapolate rule, double knot, double forward, const Quaternion& key, const Vector3& omega_body,
                GreatCircle& circle) {
  circle.knot = knot;
  store(key, circle.m);
  if (rule == Extrapolate::constant_rate) {
    const double largest = largest_component(omega_body);
    if (largest > 0) {
      const Vector3 scaled = omega_body / largest;
      const double scaled_length = length(scaled);
      circle.rate = 0.5 * largest * scaled_length;
      store(multiply(key, quaternion(0.0, scaled / scaled_length)), circle.e);
      store(omega_body, circle.omega_body);
      store(Vector3(largest * to_world(key, scaled)), circle.omega_world);
    }
  }
  const double distance = forward * far_distance(circle.rate);
  // the sum may overflow
  const bool room = std::abs(0.5 * knot + 0.5 * distance) < 0.5 * DBL_MAX;
  circle.far_time = room ? knot + distance : forward * DBL_MAX;
}

// The outcome of a builder with the index of a key as the caller counts it. A key that was added to close the curve has
// the rates and tangents of the first; all else about it is a matter of the last key before it.
Outcome in_input(const KeyframeInput& input, const Outcome& outcome) {
  if (outcome.index == kNoIndex || outcome.index < input.count) return outcome;
  return {outcome.status, outcome.status == Status::rate_too_fast ? 0 : input.count - 1};
}

}  // namespace

bool trajectory_size(const Options& options, size_t input_count, CurveSize& size) {
  const MethodRow& row = find_row(options);
  if (input_count == SIZE_MAX) return false;
  const size_t count = options.key_count(input_count);
  const size_t handle_per_key = kKnotBytes + kKeyBytes + row.segment_bytes;
  const size_t workspace_per_key = kKeyBytes + row.workspace_per_key * sizeof(double);
  const size_t fixed = sizeof(Trajectory);
  if (count > (PTRDIFF_MAX - fixed) / (handle_per_key + workspace_per_key)) return false;
  size.handle = fixed + count * (kKnotBytes + kKeyBytes) + (count - 1) * row.segment_bytes;
  size.workspace = count * workspace_per_key;
  return true;
}

Status check_settings(const Options& options, const KeyframeInput& input, Frame rate_frame) {
  const MethodRow& row = *find_method(options.method);
  const bool needs_omega = row.needs_omega || options.tangents == Tangent::given;
  const bool has_omega = input.omega.data != nullptr, has_alpha = input.alpha.data != nullptr,
             has_tangents = input.in_tangents.data != nullptr;
  if (has_omega && !is_known(rate_frame)) return Status::value;
  if ((needs_omega && !has_omega) || (row.needs_alpha && !has_alpha) || (row.needs_tangents && !has_tangents))
    return Status::input_missing;
  const bool start_rate_missing = options.start.condition == End::given && !options.start.has_rate;
  const bool end_rate_missing = options.end.condition == End::given && !options.end.has_rate;
  const bool has_turns = input.turns != nullptr, needs_turns = options.turns == Turns::given;
  if (start_rate_missing || end_rate_missing || (needs_turns && !has_turns)) return Status::input_missing;
  const bool unwanted = (has_omega && !needs_omega) || (has_alpha && !row.needs_alpha) ||
                        (has_tangents && !row.needs_tangents) || (has_turns && !needs_turns);
  return unwanted ? Status::input_unwanted : Status::ok;
}

Outcome build_trajectory(const Options& options, const KeyframeInput& input, Frame rate_frame, void* handle,
                         void* workspace, Trajectory** out) {
  const MethodRow& row = find_row(options);
  const size_t count = options.key_count(input.count);
  auto* trajectory = static_cast<Trajectory*>(handle);
  *trajectory = {};
  trajectory->method = options.method;
  trajectory->kind = row.kind;
  place_knots(count, sizeof(Trajectory) - offsetof(Trajectory, timeline), trajectory->timeline);
  trajectory->keys_offset = sizeof(Trajectory) + count * kKnotBytes;
  trajectory->segments_offset = trajectory->keys_offset + count * kKeyBytes;

  Keyframes keys = {at_offset<double>(handle, sizeof(Trajectory)),
                    at_offset<double[4]>(handle, trajectory->keys_offset), at_offset<double[4]>(workspace, 0), count};
  KeyframeReport report;
  Outcome outcome = clean_keyframes(input, options.turns == Turns::as_given, keys, report);
  if (outcome.status == Status::ok && options.period > 0)
    outcome = add_closing_key(input, options.period, keys, report);
  if (outcome.status != Status::ok) return outcome;
  if (options.closed() || options.wraps())
    outcome = close_keyframes(options.closure, options.turns == Turns::as_given, keys, report);
  if (outcome.status != Status::ok) return outcome;
  build_timeline(options, row.holds_keys, trajectory->timeline);

  Construction construction = {options,
                               input,
                               rate_frame,
                               keys,
                               at_offset<double>(workspace, count * kKeyBytes),
                               at_offset<char>(handle, trajectory->segments_offset)};
  outcome = row.build(construction);
  if (outcome.status != Status::ok) return in_input(input, outcome);

  trajectory->range = construction.range;
  trajectory->iterations = construction.iterations;
  trajectory->residual = construction.residual;
  const bool keeps_signs = options.turns == Turns::as_given || !construction.has_turns;
  trajectory->sign_flips = keeps_signs ? report.sign_flips : count_sign_flips(input, keys);
  trajectory->worst_norm_error = report.worst_norm_error;
  trajectory->least_dot = report.least_dot;
  const size_t last = keys.segments();
  const Timeline& timeline = trajectory->timeline;
  set_circle(timeline.before.rule, timeline.before.knot, -1.0, keys[0].value, construction.omega_start,
             trajectory->before);
  set_circle(timeline.after.rule, timeline.after.knot, 1.0, keys[last].value, construction.omega_end,
             trajectory->after);
  trajectory->closed = options.closed() || options.wraps();
  trajectory->negate_on_wrap = dot(keys[0].value, keys[last].value) < 0;
  trajectory->tag = Trajectory::kTag;
  *out = trajectory;
  return {};
}

}  // namespace qtraj
