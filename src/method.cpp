#include "qtraj/method.hpp"

#include "qtraj/log_spline.hpp"
#include "qtraj/nlerp.hpp"
#include "qtraj/slerp.hpp"
#include "qtraj/squad.hpp"

namespace qtraj {
namespace {

constexpr unsigned bit(End end) { return 1u << static_cast<unsigned>(end); }

constexpr unsigned kSquadEnds =
    bit(End::standard) | bit(End::chord) | bit(End::estimated) | bit(End::given) | bit(End::periodic);
constexpr unsigned kLogSplineEnds = bit(End::standard) | bit(End::natural) | bit(End::not_a_knot) | bit(End::periodic);

constexpr MethodRow kMethods[] = {
    {Method::slerp, SegmentKind::arc, sizeof(ArcSegment), 0, false, false, 0, build_slerp},
    {Method::nlerp, SegmentKind::normalized, sizeof(NormalizedSegment<1>), 0, false, false, 0, build_nlerp},
    {Method::squad, SegmentKind::nested_arcs, sizeof(NestedArcsSegment), kSquadEnds, true, false, kSquadWorkspacePerKey,
     build_squad},
    {Method::log_spline, SegmentKind::rotation_vector, sizeof(RotationVectorSegment<3>), kLogSplineEnds, false, true,
     kLogSplineWorkspacePerKey, build_log_spline},
};

}  // namespace

bool MethodRow::accepts_end(End condition) const {
  const auto number = static_cast<int32_t>(condition);
  return number >= 0 && number <= static_cast<int32_t>(End::periodic) && (ends & bit(condition)) != 0;
}

const MethodRow* find_method(Method method) {
  for (const MethodRow& row : kMethods)
    if (row.method == method) return &row;
  return nullptr;
}

}  // namespace qtraj
