// What the methods' builders and the table of methods (method.cpp) share.
#pragma once

#include "curve/segment.hpp"
#include "methods/keyframes.hpp"
#include "methods/options.hpp"

namespace qtraj {

// What a builder reads and what it leaves.
struct Construction {
  const Options& options;
  const KeyframeInput& input;  // for the given rates
  Frame rate_frame;            // of the given rates
  Keyframes keys;
  double* workspace;  // MethodRow::workspace_per_key doubles a key
  void* segments;     // [keys.segments()] of the method's record

  // Left by the builder: rates of the curve at the first and last knot, body frame, for CONSTANT_RATE. Under other
  // rules nobody asks for them.
  Vector3 omega_start = Vector3::Zero(), omega_end = Vector3::Zero();
  // Largest |p| of rotation-vector segments.
  ExponentRange range = ExponentRange::quarter_turn;
  // Of methods that iterate: how often the system was solved, parts of it by their share, and the residual of the
  // equations (qtraj_residual).
  int32_t iterations = 0;
  double residual = 0;
  // Whether a step makes whole turns, so that signs of keys are not those that cleaning left (methods/turns.hpp).
  bool has_turns = false;

  // Sets the rates that are asked for to rate(key, segment), the first or the last ones.
  template <class Rate>
  void set_end_rates(const Rate& rate) {
    const size_t last = keys.segments();
    if (options.start.extrapolate == Extrapolate::constant_rate) omega_start = rate(0, 0);
    if (options.end.extrapolate == Extrapolate::constant_rate) omega_end = rate(last, last - 1);
  }
};

// Working space of builders, doubles a key.
constexpr size_t kSquadWorkspacePerKey = 6, kLogSplineWorkspacePerKey = 8, kRotationSplineWorkspacePerKey = 63;

struct MethodRow {
  Method method;
  SegmentKind kind;
  size_t segment_bytes;
  unsigned ends;  // a bit for each End condition that set_ends takes
  bool has_tangents, has_reference;
  bool needs_omega, needs_alpha;  // rates at all keys
  unsigned turns;                 // a bit for each Turns rule that set_turns takes
  size_t workspace_per_key;
  Outcome (*build)(Construction&);
  bool needs_tangents = false;  // dq/dt at all keys
  bool holds_keys = false;      // each until the next one
};

// Methods of vector curves.
struct VectorMethodRow {
  Method method;
  size_t terms;                    // of a segment's shape (curve/vector_curve.hpp)
  bool needs_first, needs_second;  // derivatives at all keys
  unsigned ends;                   // a bit for each End condition that set_ends takes
  bool holds_keys = false;         // each until the next one
};

// nullptr where the method is unknown.
const MethodRow* find_method(Method method);
const VectorMethodRow* find_vector_method(Method method);

// What options may set, of orientation and of vector methods alike.
bool accepts_end(Method method, End condition);
bool accepts_turns(Method method, Turns rule);
bool has_tangents(Method method);
bool has_reference(Method method);
Turns default_turns(Method method);

// The row that builds what the options ask for: a method with turns may have segments of another kind.
const MethodRow& find_row(const Options& options);

}  // namespace qtraj
