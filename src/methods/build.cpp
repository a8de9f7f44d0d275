#include "methods/build.hpp"

#include <cfloat>

#include "base/times.hpp"
#include "curve/knot_lookup.hpp"
#include "math/so3.hpp"
#include "methods/method.hpp"

namespace qtraj {
namespace {

template <class Element>
Element* at_offset(void* block, size_t bytes) {
  return reinterpret_cast<Element*>(static_cast<char*>(block) + bytes);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kKeyBytes = 4 * sizeof(double);
constexpr size_t kKnotBytes = sizeof(double) + Guide::entries(1) * sizeof(uint64_t);

// How far from the knot the arc still has a direction: 2^50 rad, or 2^1000 s.
double far_distance(double rate) { return rate > 0x1p-950 ? 0x1p50 / rate : 0x1p1000; }

Extrapolation extrapolation_at(const EndSetting& setting, double knot, double forward, const Quaternion& key,
                               const Vector3& omega_body) {
  Extrapolation side = {};
  side.rule = setting.extrapolate;
  side.knot = knot;
  store(key, side.m);
  if (setting.extrapolate == Extrapolate::constant_rate) {
    const double largest = largest_component(omega_body);
    if (largest > 0) {
      const Vector3 scaled = omega_body / largest;
      const double scaled_length = length(scaled);
      side.rate = 0.5 * largest * scaled_length;
      store(multiply(key, quaternion(0.0, scaled / scaled_length)), side.e);
      store(omega_body, side.omega_body);
      store(Vector3(largest * to_world(key, scaled)), side.omega_world);
    }
  }
  const double distance = forward * far_distance(side.rate);
  // the sum may overflow
  const bool room = std::abs(0.5 * knot + 0.5 * distance) < 0.5 * DBL_MAX;
  side.far_time = room ? knot + distance : forward * DBL_MAX;
  return side;
}

void set_reach(Trajectory& trajectory) {
  Extrapolation &before = trajectory.before, &after = trajectory.after;
  const double reach = end_reach(before.knot, after.knot);
  before.reach = std::max(before.knot, reach - DBL_MAX) - reach;
  after.reach = std::min(after.knot, DBL_MAX - reach) + reach;
}

void set_period(const Options& options, Trajectory& trajectory) {
  const double first = trajectory.before.knot, last = trajectory.after.knot;
  // before 0 a normal number: a subnormal one is 0 where a processor was told so
  const double before_last = last == 0 ? -DBL_MIN : std::nextafter(last, first);
  trajectory.last_inside = options.wraps() ? before_last : last;
  trajectory.half_period =
      options.period > 0 ? DoubleDouble{0.5 * options.period, 0.0} : two_sum(0.5 * last, -0.5 * first);
}

double longest_interval(const Keyframes& keys) {
  double longest = 0;
  for (size_t i = 0; i < keys.segments(); ++i) longest = std::max(longest, keys.step(i));
  return longest;
}

// The outcome of a builder with the index of a key as the caller counts it. A key that was added to close the curve has
// the rates of the first; all else about it is a matter of the last key before it.
Outcome in_input(const KeyframeInput& input, const Outcome& outcome) {
  if (outcome.index == kNoIndex || outcome.index < input.count) return outcome;
  return {outcome.status, outcome.status == Status::rate_too_fast ? 0 : input.count - 1};
}

}  // namespace

bool trajectory_size(const Options& options, size_t input_count, TrajectorySize& size) {
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
  const bool has_omega = input.omega.data != nullptr, has_alpha = input.alpha.data != nullptr;
  if (has_omega && !is_known(rate_frame)) return Status::value;
  if ((needs_omega && !has_omega) || (row.needs_alpha && !has_alpha)) return Status::input_missing;
  const bool start_rate_missing = options.start.condition == End::given && !options.start.has_rate;
  const bool end_rate_missing = options.end.condition == End::given && !options.end.has_rate;
  const bool has_turns = input.turns != nullptr, needs_turns = options.turns == Turns::given;
  if (start_rate_missing || end_rate_missing || (needs_turns && !has_turns)) return Status::input_missing;
  const bool unwanted = (has_omega && !needs_omega) || (has_alpha && !row.needs_alpha) || (has_turns && !needs_turns);
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
  trajectory->key_count = count;
  trajectory->guide_offset = sizeof(Trajectory) + count * sizeof(double);
  trajectory->keys_offset = trajectory->guide_offset + Guide::entries(count) * sizeof(uint64_t);
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
  build_guide(keys.times, count, at_offset<uint64_t>(handle, trajectory->guide_offset), trajectory->guide_scale,
              trajectory->guide_candidates);

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
  trajectory->before = extrapolation_at(options.start, keys.times[0], -1.0, keys[0].value, construction.omega_start);
  trajectory->after = extrapolation_at(options.end, keys.times[last], 1.0, keys[last].value, construction.omega_end);
  set_reach(*trajectory);
  set_period(options, *trajectory);
  trajectory->longest_gap = longest_interval(keys) > options.longest_gap ? options.longest_gap : kInfinity;
  trajectory->closed = options.closed() || options.wraps();
  trajectory->negate_on_wrap = dot(keys[0].value, keys[last].value) < 0;
  trajectory->tag = Trajectory::kTag;
  *out = trajectory;
  return {};
}

}  // namespace qtraj
