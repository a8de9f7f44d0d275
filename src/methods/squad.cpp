// The builder of SQUAD. The tangent rule and the controls are in functions/squad.hpp.
#include "functions/squad.hpp"

#include "math/arc.hpp"
#include "math/trigonometry.hpp"
#include "methods/key_rates.hpp"
#include "methods/key_rotations.hpp"
#include "methods/method.hpp"

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

// Whether the logarithm of a control would wrap at this rate: |h s - L| >= 2 pi.
bool control_wraps(const Vector3& s, const SquadChord& chord) {
  if (largest_component(s) > 16.0 / chord.h) return true;
  return length(Vector3(chord.h * s - chord.log)) >= 2.0 * kPi;
}

// Half rates of the curve at the keys, by the tangent rule and the end conditions.
class HalfRates {
 public:
  explicit HalfRates(const Construction& construction)
      : construction_(construction), keys_(construction.keys), workspace_(workspace_of(construction)) {}

  // Fills the workspace for all keys.
  Outcome fill() const {
    for_each_log(keys_, [&](size_t segment, const Vector3& log) { store(log, workspace_.log[segment]); });
    for (size_t key = 0; key < keys_.count; ++key) {
      Vector3 s;
      const Status status = half_rate(key, s);
      if (status != Status::ok) return {status, key};
      store(s, workspace_.half_rate[key]);
    }
    return {};
  }

 private:
  SquadChord chord(size_t segment) const { return {load(workspace_.log[segment]), keys_.step(segment)}; }

  // The segments on both sides of a key. Past an end a closed curve goes on with its other end, an open one has none.
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
    // given rates at the keys are also the end rates, unless an end condition was chosen; the last key of a closed
    // curve counts as the first
    const EndSetting* end = key == 0 ? &options.start : key == keys_.segments() ? &options.end : nullptr;
    const bool closed = options.closed();
    const bool from_keys = options.tangents == Tangent::given && (!end || end->condition == End::standard || closed);
    const size_t source = closed && key == keys_.segments() ? 0 : key;
    if (from_keys)
      return given(row_of(construction_.input.omega, construction_.input.row_of_key(source)), construction_.rate_frame,
                   key, s);
    if (end && end->condition == End::given) return given(end->omega, options.rate_frame, key, s);

    const Sides at = sides(key);
    if (end && end->condition != End::periodic)
      s = open_end(*end, key);
    else
      s = rule_half_rate(options.tangents, chord(at.before), chord(at.after));
    if (at.has_before) s = limited_half_rate(s, chord(at.before));
    if (at.has_after) s = limited_half_rate(s, chord(at.after));
    return Status::ok;
  }

  Vector3 open_end(const EndSetting& end, size_t key) const {
    const Side side = key == 0 ? Side::start : Side::end;
    if (end.condition == End::estimated) return 0.5 * estimated_end_rate(keys_, side, 2, construction_.input.epsilon());
    const SquadChord at = chord(key == 0 ? 0 : key - 1);
    return at.log / at.h;
  }

  Status given(const Vector3& omega, Frame frame, size_t key, Vector3& s) const {
    // past this every control wraps, however short the interval, and rotating the vector could overflow
    if (largest_component(omega) > 0x1p520) return Status::rate_too_fast;
    s = 0.5 * (frame == Frame::world ? to_body(keys_[key].value, omega) : omega);
    const Sides at = sides(key);
    const bool wraps =
        (at.has_before && control_wraps(s, chord(at.before))) || (at.has_after && control_wraps(s, chord(at.after)));
    return wraps ? Status::rate_too_fast : Status::ok;
  }

  const Construction& construction_;
  const Keyframes& keys_;
  Workspace workspace_;
};

// Whether the arcs are close enough for the kernels' near form. The cosine of their distance at s in [-1, 1] has a
// second derivative below (x + y)^2, x and y being their half angles: between the ends and the middle it stays within
// an eighth of that of its chords.
bool are_near(const Arc& outer, const Arc& inner, double cosine_at_start, double cosine_at_end) {
  const double angles = outer.half_angle + inner.half_angle;
  const double least = std::min({cosine_at_start, dot(outer.m, inner.m), cosine_at_end});
  return inner.half_angle <= 0.25 * kPi && least - angles * angles / 8.0 >= 0.5;
}

void store_arc(const Arc& arc, NestedArcsSegment::Arc& out) {
  out.half_angle = arc.half_angle;
  store(arc.m, out.m);
  store(arc.e, out.e);
}

// Fills NestedArcsSegment::relative, Im(P* C). `m_offset` is the part of the inner middle orthogonal to the outer one.
void store_relative(const Arc& outer, const Arc& inner, const Quaternion& m_offset, double (&relative)[4][3]) {
  const auto between = [](const Quaternion& a, const Quaternion& b) { return vector_part(multiply(conjugate(a), b)); };
  store(between(outer.m, m_offset), relative[0]);
  store(between(outer.m, inner.e), relative[1]);
  store(between(outer.e, inner.m), relative[2]);
  store(between(outer.e, inner.e), relative[3]);
}

}  // namespace

// SQUAD on any knots: slerp of two slerps, q_i -> q_{i+1} and a_i -> b_{i+1}, at 2u(1 - u) (K. Shoemake, "Quaternion
// calculus and fast animation", SIGGRAPH course 10, 1987). With the half rate s_i of the curve at knot i
// (omega_body/2), L_i = log(q_i* q_{i+1}) and h_i = t_{i+1} - t_i the controls are
//   a_i = q_i exp((h_i s_i - L_i)/2),  b_i = q_i exp((L_{i-1} - h_{i-1} s_i)/2),
// which makes the rate on both sides of knot i equal s_i, so the curve is C1 on all knots; on uniform ones the
// CATMULL_ROM rule gives Shoemake's a_i = b_i = q_i exp(-(log(q_i* q_{i+1}) + log(q_i* q_{i-1}))/4).
//
// The end rate is s_i only while |h s_i - L| < 2 pi; beyond, the logarithm of a control wraps. Tangents by a rule are
// shortened to |h s_i - L| <= pi on both sides; given ones at or past 2 pi are rate_too_fast with the key's index.
Outcome build_squad(Construction& construction) {
  const HalfRates half_rates(construction);
  const Outcome outcome = half_rates.fill();
  if (outcome.status != Status::ok) return outcome;

  const Keyframes& keys = construction.keys;
  const Workspace workspace = workspace_of(construction);
  auto* segments = static_cast<NestedArcsSegment*>(construction.segments);
  for (size_t i = 0; i < keys.segments(); ++i) {
    const SquadChord log_chord = {load(workspace.log[i]), keys.step(i)};
    const UnitQuaternion from = keys[i], to = keys[i + 1];
    const Quaternion chord = difference(to, from), opposite_chord = sum(from, to);

    // the difference of the ends of the inner arc is formed from the controls' offsets to their keys: no cancellation
    const Vector3 start_rate = load(workspace.half_rate[i]), end_rate = load(workspace.half_rate[i + 1]);
    const Quaternion a_offset = control_offset_after(from.value, start_rate, log_chord);
    const Quaternion b_offset = control_offset_before(to.value, end_rate, log_chord);

    const Quaternion control_sum = a_offset + b_offset;
    const Arc outer = arc_between(chord, opposite_chord);
    const Arc inner = arc_between(chord + (b_offset - a_offset), opposite_chord + control_sum);
    // controls are unit, so that their dot products with the keys are 1 - |offset|^2/2
    const double cosine_at_start = 1.0 - 0.5 * dot(a_offset, a_offset),
                 cosine_at_end = 1.0 - 0.5 * dot(b_offset, b_offset);
    segments[i].scale = 2.0 / log_chord.h;
    segments[i].near = are_near(outer, inner, cosine_at_start, cosine_at_end) ? 1.0 : 0.0;
    store_arc(outer, segments[i].keys);
    store_arc(inner, segments[i].controls);
    // The sum of the keys is along the outer middle. The sum of the controls' offsets therefore gives the difference of
    // the middles without cancellation on short arcs. On long arcs the inner middle itself is as good.
    const bool is_short = inner.half_angle < 0.5;
    const double inner_sum = length(Quaternion(opposite_chord + control_sum));
    store_relative(outer, inner, is_short ? Quaternion(control_sum / inner_sum) : inner.m, segments[i].relative);
  }
  construction.omega_start = 2.0 * load(workspace.half_rate[0]);
  construction.omega_end = 2.0 * load(workspace.half_rate[keys.segments()]);
  return {};
}

}  // namespace qtraj
