#include "qtraj/squad.hpp"

#include "qtraj/arc.hpp"
#include "qtraj/elementary.hpp"
#include "qtraj/end_rate.hpp"
#include "qtraj/knots.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {
namespace {

// Working space: per key the half rate s_i, per segment the log L_i.
struct Workspace {
  double (*half_rate)[3];
  double (*log)[3];
};
Workspace workspace_of(const Construction& construction) {
  auto* rows = reinterpret_cast<double(*)[3]>(construction.workspace);
  return {rows, rows + construction.keys.count};
}

// Half rate by the tangent rule from the chords before and after a knot.
Vector3 rule_half_rate(Tangent rule, const Vector3& log_before, double h_before, const Vector3& log_after,
                       double h_after) {
  const Vector3 v_before = log_before / h_before, v_after = log_after / h_after;
  if (rule == Tangent::mean_velocity) return 0.5 * v_before + 0.5 * v_after;
  const IntervalShares shares = interval_shares(h_before, h_after);
  return shares.right * v_before + shares.left * v_after;
}

// s shortened to the largest factor in [0, 1] with |factor h s - L| <= pi.
Vector3 limited(const Vector3& s, double h, const Vector3& log) {
  // x = h s, or, where that is far past any limit, the vector along it whose largest component is 8
  const double largest = largest_component(s);
  const bool far = largest > 8.0 / h;
  const Vector3 x = far ? Vector3((8.0 / largest) * s) : Vector3(h * s);
  const double xx = dot(x, x), xl = dot(x, log), room = kPi * kPi - dot(log, log);
  if (!(xx - 2.0 * xl > room)) return s;
  const double factor = (xl + std::sqrt(xl * xl + xx * room)) / xx;
  return (factor / h) * x;
}

// Whether a control at this rate would be 2 pi or more away from its chord.
bool control_wraps(const Vector3& s, double h, const Vector3& log) {
  if (largest_component(s) > 16.0 / h) return true;
  return length(Vector3(h * s - log)) >= 2.0 * kPi;
}

// Half rates of the curve at the keys, by the tangent rule and the end conditions.
class HalfRates {
 public:
  explicit HalfRates(const Construction& construction)
      : construction_(construction), keys_(construction.keys), workspace_(workspace_of(construction)) {}

  // Fills the workspace for all keys.
  Outcome fill() const {
    for (size_t i = 0; i < keys_.segments(); ++i) store(relative_log(keys_[i], keys_[i + 1]), workspace_.log[i]);
    for (size_t key = 0; key < keys_.count; ++key) {
      Vector3 s;
      const Status status = half_rate(key, s);
      if (status != Status::ok) return {status, key};
      store(s, workspace_.half_rate[key]);
    }
    return {};
  }

 private:
  Vector3 log(size_t segment) const { return load(workspace_.log[segment]); }

  // Segments on both sides of a key; a closed curve goes on with the other end, an open one has none there.
  struct Sides {
    size_t before, after;
    bool has_before, has_after;
  };
  Sides sides(size_t key) const {
    const bool first = key == 0, last = key == keys_.segments(), closed = construction_.options.closed();
    return {first ? keys_.segments() - 1 : key - 1, last ? 0 : key, !first || closed, !last || closed};
  }

  Status half_rate(size_t key, Vector3& s) const {
    const Options& options = construction_.options;
    // where the rates at the keys are given, so are those at the ends, unless an end condition was chosen there; the
    // last key of a closed curve counts as the first
    const EndSetting* end = key == 0 ? &options.start : key == keys_.segments() ? &options.end : nullptr;
    const bool closed = options.closed();
    const bool from_keys = options.tangents == Tangent::given && (!end || end->condition == End::standard || closed);
    const size_t source = closed && key == keys_.segments() ? 0 : key;
    if (from_keys) return given(construction_.input.omega[source], construction_.rate_frame, key, s);
    if (end && end->condition == End::given) return given(end->omega, options.rate_frame, key, s);

    const Sides at = sides(key);
    if (end && end->condition != End::periodic)
      s = open_end(*end, key);
    else
      s = rule_half_rate(options.tangents, log(at.before), keys_.step(at.before), log(at.after), keys_.step(at.after));
    if (at.has_before) s = limited(s, keys_.step(at.before), log(at.before));
    if (at.has_after) s = limited(s, keys_.step(at.after), log(at.after));
    return Status::ok;
  }

  Vector3 open_end(const EndSetting& end, size_t key) const {
    const Side side = key == 0 ? Side::start : Side::end;
    if (end.condition == End::estimated) return 0.5 * estimated_end_rate(keys_, side, 2, construction_.input.epsilon());
    const size_t segment = key == 0 ? 0 : key - 1;
    return log(segment) / keys_.step(segment);
  }

  Status given(const Vector3& omega, Frame frame, size_t key, Vector3& s) const {
    // past this no interval is short enough, and turning the vector could overflow
    if (largest_component(omega) > 0x1p520) return Status::option;
    s = 0.5 * (frame == Frame::world ? to_body(keys_[key].value, omega) : omega);
    const Sides at = sides(key);
    const bool wraps = (at.has_before && control_wraps(s, keys_.step(at.before), log(at.before))) ||
                       (at.has_after && control_wraps(s, keys_.step(at.after), log(at.after)));
    return wraps ? Status::option : Status::ok;
  }

  const Construction& construction_;
  const Keyframes& keys_;
  Workspace workspace_;
};

void store_arc(const Arc& arc, NestedArcsSegment::Arc& out) {
  out.half_angle = arc.half_angle;
  store(arc.m, out.m);
  store(arc.e, out.e);
}

// Im(P* C) as NestedArcsSegment::relative has it. `m_offset` is the part of the inner middle across the outer one.
void store_relative(const Arc& outer, const Arc& inner, const Quaternion& m_offset, double (&relative)[4][3]) {
  const auto between = [](const Quaternion& a, const Quaternion& b) { return vector_part(multiply(conjugate(a), b)); };
  store(between(outer.m, m_offset), relative[0]);
  store(between(outer.m, inner.e), relative[1]);
  store(between(outer.e, inner.m), relative[2]);
  store(between(outer.e, inner.e), relative[3]);
}

}  // namespace

Outcome build_squad(Construction& construction) {
  const HalfRates half_rates(construction);
  const Outcome outcome = half_rates.fill();
  if (outcome.status != Status::ok) return outcome;

  const Keyframes& keys = construction.keys;
  const Workspace workspace = workspace_of(construction);
  auto* segments = static_cast<NestedArcsSegment*>(construction.segments);
  for (size_t i = 0; i < keys.segments(); ++i) {
    const double h = keys.step(i);
    const UnitQuaternion from = keys[i], to = keys[i + 1];
    const Quaternion chord = difference(to, from), opposite_chord = sum(from, to);

    // how far the controls are from their keys: a_i - q_i and b_{i+1} - q_{i+1}; in these terms the ends of the inner
    // arc differ without cancellation
    const Vector3 log = load(workspace.log[i]);
    const Vector3 start_rate = load(workspace.half_rate[i]), end_rate = load(workspace.half_rate[i + 1]);
    const Quaternion a_offset = multiply(from.value, exp_map_minus_one(0.5 * (h * start_rate - log)));
    const Quaternion b_offset = multiply(to.value, exp_map_minus_one(0.5 * (log - h * end_rate)));

    const Quaternion control_sum = a_offset + b_offset;
    const Arc outer = arc_between(chord, opposite_chord);
    const Arc inner = arc_between(chord + (b_offset - a_offset), opposite_chord + control_sum);
    segments[i].scale = 2.0 / h;
    store_arc(outer, segments[i].keys);
    store_arc(inner, segments[i].controls);
    // The sum of the keys is along the outer middle: what the controls add to it makes the difference of the middles,
    // without cancellation on short arcs. On long ones the inner middle itself tells it as well.
    const bool is_short = inner.half_angle < 0.5;
    const double inner_sum = length(Quaternion(opposite_chord + control_sum));
    store_relative(outer, inner, is_short ? Quaternion(control_sum / inner_sum) : inner.m, segments[i].relative);
  }
  construction.omega_start = 2.0 * load(workspace.half_rate[0]);
  construction.omega_end = 2.0 * load(workspace.half_rate[keys.segments()]);
  return {};
}

}  // namespace qtraj
