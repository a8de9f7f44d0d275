// The builder of LOG_SPLINE.
#include "math/cubic_spline.hpp"
#include "means/eigen_mean.hpp"
#include "methods/key_rotations.hpp"
#include "methods/method.hpp"
#include "methods/polynomials.hpp"

namespace qtraj {
namespace {

// Working space: per key the half-angle vector p_i and its derivative, and the scratch of the spline.
struct Workspace {
  double (*p)[3];
  double (*slope)[3];
  double* scratch;
};
static_assert(kLogSplineWorkspacePerKey == 6 + kSplineScratchPerKnot, "p, slope and scratch");
Workspace workspace_of(const Construction& construction) {
  const size_t count = construction.keys.count;
  auto* rows = reinterpret_cast<double(*)[3]>(construction.workspace);
  return {rows, rows + count, construction.workspace + 6 * count};
}

Status find_reference(const Construction& construction, UnitQuaternion& reference) {
  const Keyframes& keys = construction.keys;
  reference = keys[0];
  if (construction.options.reference == Reference::given) reference = normalize(construction.options.reference_q).unit;
  if (construction.options.reference == Reference::mean) {
    OrientationScatter scatter;
    for (size_t key = 0; key < keys.count; ++key) scatter.add(keys[key].value, 1.0);
    Quaternion mean;
    const Status status = scatter.top_eigenvector(construction.input.epsilon(), mean);
    if (status != Status::ok) return status;
    reference = normalize(mean).unit;
  }
  if (dot(reference.value, keys[0].value) < 0) reference = negate(reference);
  return Status::ok;
}

// p_i of every key, on the branch that continues the one before.
Outcome fill_logs(const Construction& construction, const UnitQuaternion& reference, const Workspace& workspace) {
  const Keyframes& keys = construction.keys;
  Vector3 p = Vector3::Zero();
  const double epsilon = construction.input.epsilon();
  for_each_rotation(reference, keys, [&](size_t key, const RelativeRotation& rotation) {
    p = unwrap(rotation, p, epsilon);
    store(p, workspace.p[key]);
  });
  if (!construction.options.closed()) return {};
  constexpr double kTolerance = 1e-6;
  const size_t last = keys.segments();
  const Vector3 first_p = load(workspace.p[0]);
  if (length(Vector3(p - first_p)) > kTolerance) return {Status::not_closed, last};
  store(first_p, workspace.p[last]);
  return {};
}

// h p' at a knot; false where its square would overflow.
bool scaled_slope_at(const Workspace& workspace, size_t key, double h, Vector3& scaled) {
  const Vector3 slope = load(workspace.slope[key]);
  if (largest_component(slope) > 0x1p500 / h) return false;
  scaled = h * slope;
  return true;
}

}  // namespace

// LOG_SPLINE: q_ref exp(p(t)), p the C2 cubic spline through p_i = unwrap(log(q_ref* q_i)). One chart for the whole
// curve: smooth and cheap near q_ref and for turns about one axis; singular at -q_ref, and after a full turn at q_ref.
//
// not_finite with a key's index where uneven knots make the slopes so large (h p' beyond 2^500 rad) that squares would
// overflow; not_closed where the ends are periodic and the unwrapped p does not come back to its start.
Outcome build_log_spline(Construction& construction) {
  UnitQuaternion reference;
  const Status status = find_reference(construction, reference);
  if (status != Status::ok) return {status, kNoIndex};

  const Keyframes& keys = construction.keys;
  const Workspace workspace = workspace_of(construction);
  Outcome outcome = fill_logs(construction, reference, workspace);
  if (outcome.status != Status::ok) return outcome;
  const SplineData data = {keys.times, workspace.p[0], keys.count, 3};
  outcome = spline_slopes(data, spline_end(construction.options.start.condition),
                          spline_end(construction.options.end.condition), workspace.slope[0], workspace.scratch);
  if (outcome.status != Status::ok) return outcome;

  auto* segments = static_cast<RotationVectorSegment<3>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    const double h = keys.step(i);
    Vector3 first0, first1;
    if (!scaled_slope_at(workspace, i, h, first0)) return {Status::not_finite, i};
    if (!scaled_slope_at(workspace, i + 1, h, first1)) return {Status::not_finite, i + 1};
    const EndValues<Vector3> p = {{load(workspace.p[i]), load(workspace.p[i + 1])}, {first0, first1}, {}};
    bound = std::max(bound, set_cubic(reference.value, h, p, segments[i]));
  }
  construction.range = range_of(bound);

  const auto end_rate = [&](size_t key) -> Vector3 {
    return 2.0 * right_jacobian(2.0 * load(workspace.p[key]), load(workspace.slope[key]));
  };
  construction.omega_start = end_rate(0);
  construction.omega_end = end_rate(keys.segments());
  return {};
}

}  // namespace qtraj
