// The table of methods: a new interpolant is a builder in a file of its own and a row here.
#include "methods/method.hpp"

namespace qtraj {

Outcome build_step(Construction& construction);
Outcome build_slerp(Construction& construction);
Outcome build_turning_slerp(Construction& construction);
Outcome build_nlerp(Construction& construction);
Outcome build_squad(Construction& construction);
Outcome build_log_spline(Construction& construction);
Outcome build_rotation_spline(Construction& construction);
Outcome build_hermite(Construction& construction);
Outcome build_rotation_quintic(Construction& construction);
Outcome build_quaternion_quintic(Construction& construction);
Outcome build_quaternion_hermite(Construction& construction);

namespace {

// Of a known end condition.
constexpr unsigned bit(End end) {
  return end == End::standard ? 1u : 2u << (static_cast<unsigned>(end) - static_cast<unsigned>(End::chord));
}

constexpr unsigned kSquadEnds =
    bit(End::standard) | bit(End::chord) | bit(End::estimated) | bit(End::given) | bit(End::periodic);
constexpr unsigned kLogSplineEnds = bit(End::standard) | bit(End::natural) | bit(End::not_a_knot) | bit(End::periodic);

constexpr unsigned kRotationSplineEnds = bit(End::standard) | bit(End::chord) | bit(End::natural) |
                                         bit(End::estimated) | bit(End::given) | bit(End::periodic);

constexpr unsigned bit(Turns rule) {
  return 1u << (static_cast<unsigned>(rule) - static_cast<unsigned>(Turns::shortest));
}
constexpr unsigned kShortest = bit(Turns::shortest), kSigns = kShortest | bit(Turns::as_given),
                   kTurns = kSigns | bit(Turns::given), kTurnsOfRates = kTurns | bit(Turns::from_rates);

// Method, segments, their bytes, ends, tangent rule, reference, omega, alpha, turns, workspace, builder, tangents.
constexpr MethodRow kMethods[] = {
    {Method{QTRAJ_SLERP}, SegmentKind::arc, sizeof(ArcSegment), 0, false, false, false, false, kTurns, 0, build_slerp},
    {Method{QTRAJ_NLERP}, SegmentKind::normalized, sizeof(NormalizedSegment<1>), 0, false, false, false, false,
     kShortest, 0, build_nlerp},
    {Method{QTRAJ_SQUAD}, SegmentKind::nested_arcs, sizeof(NestedArcsSegment), kSquadEnds, true, false, false, false,
     kShortest, kSquadWorkspacePerKey, build_squad},
    {Method{QTRAJ_LOG_SPLINE}, SegmentKind::rotation_vector, sizeof(RotationVectorSegment<3>), kLogSplineEnds, false,
     true, false, false, kShortest, kLogSplineWorkspacePerKey, build_log_spline},
    {Method{QTRAJ_ROTATION_SPLINE}, SegmentKind::rotation_vector, sizeof(RotationVectorSegment<3>), kRotationSplineEnds,
     false, false, false, false, kTurns, kRotationSplineWorkspacePerKey, build_rotation_spline},
    {Method{QTRAJ_HERMITE}, SegmentKind::rotation_vector, sizeof(RotationVectorSegment<3>), 0, false, false, true,
     false, kTurnsOfRates, 0, build_hermite},
    {Method{QTRAJ_ROTATION_QUINTIC}, SegmentKind::rotation_vector_quintic, sizeof(RotationVectorSegment<5>), 0, false,
     false, true, true, kTurnsOfRates, 0, build_rotation_quintic},
    {Method{QTRAJ_QUATERNION_QUINTIC}, SegmentKind::normalized_quintic, sizeof(NormalizedSegment<5>), 0, false, false,
     true, true, kShortest, 0, build_quaternion_quintic},
    {Method{QTRAJ_STEP}, SegmentKind::arc, sizeof(ArcSegment), 0, false, false, false, false, kShortest, 0, build_step,
     false, true},
    {Method{QTRAJ_QUATERNION_HERMITE}, SegmentKind::normalized_quintic, sizeof(NormalizedSegment<5>), 0, false, false,
     false, false, kSigns, 0, build_quaternion_hermite, true},
};

// SLERP past a half turn: arcs are half turns at most.
constexpr MethodRow kTurningSlerp = {Method{QTRAJ_SLERP},
                                     SegmentKind::rotation_vector,
                                     sizeof(RotationVectorSegment<3>),
                                     0,
                                     false,
                                     false,
                                     false,
                                     false,
                                     kTurns,
                                     0,
                                     build_turning_slerp};

constexpr unsigned kCubicEnds =
    bit(End::standard) | bit(End::natural) | bit(End::not_a_knot) | bit(End::given) | bit(End::periodic);

// Method, terms, first and second derivatives, ends.
constexpr VectorMethodRow kVectorMethods[] = {
    {Method{QTRAJ_VECTOR_STEP}, 0, false, false, 0, true},     {Method{QTRAJ_VECTOR_LINEAR}, 0, false, false, 0},
    {Method{QTRAJ_VECTOR_CUBIC}, 2, false, false, kCubicEnds}, {Method{QTRAJ_VECTOR_HERMITE}, 2, true, false, 0},
    {Method{QTRAJ_VECTOR_QUINTIC}, 4, true, true, 0},
};

template <class Row, size_t Count>
const Row* find(const Row (&rows)[Count], Method method) {
  for (const Row& row : rows)
    if (row.method == method) return &row;
  return nullptr;
}

}  // namespace

const MethodRow* find_method(Method method) { return find(kMethods, method); }
const VectorMethodRow* find_vector_method(Method method) { return find(kVectorMethods, method); }

const MethodRow& find_row(const Options& options) {
  const MethodRow& row = *find_method(options.method);
  return row.kind == SegmentKind::arc && options.turns != Turns::shortest ? kTurningSlerp : row;
}

// ---- What options may set ----

bool accepts_end(Method method, End condition) {
  const MethodRow* row = find_method(method);
  return is_known(condition) && ((row ? row->ends : find_vector_method(method)->ends) & bit(condition)) != 0;
}

bool accepts_turns(Method method, Turns rule) {
  const MethodRow* row = find_method(method);
  if (!row) return false;
  return rule == Turns::standard || (is_known(rule) && (row->turns & bit(rule)) != 0);
}

bool has_tangents(Method method) {
  const MethodRow* row = find_method(method);
  return row && row->has_tangents;
}

bool has_reference(Method method) {
  const MethodRow* row = find_method(method);
  return row && row->has_reference;
}

Turns default_turns(Method method) {
  const MethodRow* row = find_method(method);
  if (row && row->needs_tangents) return Turns::as_given;  // tangents belong to the signs that keys are written with
  return accepts_turns(method, Turns::from_rates) ? Turns::from_rates : Turns::shortest;
}

}  // namespace qtraj
