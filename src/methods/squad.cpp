// The builder of SQUAD. The tangent rule and the controls are in functions/squad.hpp.
#include "functions/squad.hpp"

#include "math/arc.hpp"
#include "math/so3.hpp"
#include "math/trigonometry.hpp"
#include "methods/key_rates.hpp"
#include "methods/method.hpp"
#include "rows/squad_segment.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<SquadRows> kChordKernels[] = QTRAJ_OF_EACH_TARGET(squad_chords),
                               kHalfRateKernels[] = QTRAJ_OF_EACH_TARGET(squad_half_rates),
                               kSegmentKernels[] = QTRAJ_OF_EACH_TARGET(squad_segments);

// Working space: per key the half rate s_i, per segment the log L_i.
struct Workspace {
  double (*half_rate)[3];
  double (*log)[3];
};
Workspace workspace_of(const Construction& construction) {
  auto* rows = reinterpret_cast<double(*)[3]>(construction.workspace);
  return {rows, rows + construction.keys.count};
}

SquadRows rows_of(const Construction& construction) {
  const Workspace workspace = workspace_of(construction);
  return {construction.keys.arrays(), construction.options.tangents, workspace.half_rate, workspace.log,
          static_cast<NestedArcsSegment*>(construction.segments)};
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

  // From the logs.
  QTRAJ_NOINLINE Outcome fill() const {
    for (size_t key = 0; key < keys_.count; ++key) {
      key += fill_by_rule(key);
      Vector3 s;
      const Status status = half_rate(key, s);
      if (status != Status::ok) return {status, key};
      store(s, workspace_.half_rate[key]);
    }
    return {};
  }

 private:
  // The kernel does keys between two segments. Returns how many; the last key is never one of them.
  size_t fill_by_rule(size_t key) const {
    if (key == 0 || construction_.options.tangents == Tangent::given) return 0;
    return kHalfRateKernels[target()](rows_of(construction_), key, keys_.segments());
  }

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
    const SquadChord at = chord(key == 0 ? 0 : key - 1);
    const Vector3 of_chord = at.log / at.h;
    if (end.condition != End::estimated) return of_chord;
    const Vector3 s = 0.5 * estimated_end_rate(keys_, side, 2, construction_.input.epsilon());
    if (construction_.options.tangents != Tangent::rest) return s;
    // of the sign of the chord and at most 3 times its rate, as at the other keys
    return {resting_rate(s[0], of_chord[0], s[0]), resting_rate(s[1], of_chord[1], s[1]),
            resting_rate(s[2], of_chord[2], s[2])};
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

// ---- Segments ----

ArcOf<double> arc_along(const ChordsOf<double>& chords) {
  ArcOf<double> arc;
  copy_arc(arc_between(load(chords.chord), load(chords.opposite)), arc);
  return arc;
}

ChordsOf<double> chords_of(const Keyframes& keys, size_t segment) {
  return chords_between(keys.q[segment], keys.q_remainder[segment], keys.q[segment + 1], keys.q_remainder[segment + 1]);
}

// The outer arcs and the logs.
QTRAJ_NOINLINE void set_chords(const Construction& construction) {
  const Keyframes& keys = construction.keys;
  const SquadRows rows = rows_of(construction);
  for (size_t i = 0; i < keys.segments(); ++i) {
    i += kChordKernels[target()](rows, i, keys.segments());
    if (i == keys.segments()) break;
    copy_arc(arc_along(chords_of(keys, i)), rows.segments[i].keys);
    store(relative_log(keys[i], keys[i + 1]), rows.log[i]);
  }
}

// One segment but for its outer arc and log. Not inlined: its stack would come on top of the kernel's.
QTRAJ_NOINLINE void set_segment(const Keyframes& keys, const SquadRows& rows, size_t i) {
  SquadEnds<double> ends;
  store(keys[i].value, ends.from), store(keys[i + 1].value, ends.to);
  ends.chords = chords_of(keys, i);
  copy_arc(rows.segments[i].keys, ends.outer);
  store(load(rows.log[i]), ends.log);
  ends.h = keys.step(i);
  store(load(rows.half_rate[i]), ends.start_rate), store(load(rows.half_rate[i + 1]), ends.end_rate);
  set_squad_segment(ends, sin_cos_of<double>, arc_along, rows.segments[i]);
}

void set_segments(const Construction& construction) {
  const Keyframes& keys = construction.keys;
  const SquadRows rows = rows_of(construction);
  for (size_t i = 0; i < keys.segments(); ++i) {
    i += kSegmentKernels[target()](rows, i, keys.segments());
    if (i < keys.segments()) set_segment(keys, rows, i);
  }
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
  set_chords(construction);
  const HalfRates half_rates(construction);
  const Outcome outcome = half_rates.fill();
  if (outcome.status != Status::ok) return outcome;
  set_segments(construction);
  const Workspace workspace = workspace_of(construction);
  construction.omega_start = 2.0 * load(workspace.half_rate[0]);
  construction.omega_end = 2.0 * load(workspace.half_rate[construction.keys.segments()]);
  return {};
}

}  // namespace qtraj
