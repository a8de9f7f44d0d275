#include "qtraj/rotation_spline.hpp"

#include <utility>

#include "qtraj/block_tridiagonal.hpp"
#include "qtraj/end_rate.hpp"
#include "qtraj/given_rates.hpp"
#include "qtraj/knots.hpp"
#include "qtraj/rotation_vector_polynomial.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {
namespace {

// |h w| past this: the squares in beta, over the shortest interval, could overflow.
constexpr double kLargestRise = 0x1p200;

// Working space, each [count]: rates at the knots, the Newton step, the elimination, and a copy of the rates to go
// back to. R_i and the matrices of segment i are in row i.
struct Workspace {
  double (*w)[3];
  double (*saved)[3];
  double (*r)[3];
  double (*jacobian)[9];  // Jr(R_i)
  double (*inverse)[9];   // A_i
  BlockSpace space;
};
static_assert(kRotationSplineWorkspacePerKey == 4 * 3 + 4 * 9, "four vectors and four matrices");

Workspace workspace_of(const Construction& construction) {
  const size_t count = construction.keys.count;
  double* at = construction.workspace;
  const auto vectors = [&] { return reinterpret_cast<double(*)[3]>(std::exchange(at, at + 3 * count)); };
  const auto matrices = [&] { return reinterpret_cast<double(*)[9]>(std::exchange(at, at + 9 * count)); };
  Workspace workspace;
  workspace.w = vectors();
  workspace.saved = vectors();
  workspace.r = vectors();
  workspace.jacobian = matrices();
  workspace.inverse = matrices();
  workspace.space.x = vectors();
  workspace.space.upper = matrices();
  workspace.space.column = matrices();
  return workspace;
}

// The equations for the rates, beta weighted by a factor from 0 to 1, and what solving them needs. Rows are multiplied
// by h_before h_after/(h_before + h_after): their weights are then shares of intervals, and nothing overflows.
class RateEquations {
 public:
  RateEquations(Construction& construction, const Workspace& workspace)
      : construction_(construction), keys_(construction.keys), workspace_(workspace) {}

  // Matrices of the segments, and the rates that are fixed by end conditions, the others 0.
  Outcome prepare();
  // The rates, or no_convergence.
  Outcome solve();
  // Largest jump of alpha that is left, in units of the largest of |alpha| and |omega|/h.
  double residual() const;

 private:
  bool closed() const { return construction_.options.closed(); }
  // A closed curve has one rate for its first and last knot.
  size_t unknowns() const { return closed() ? keys_.segments() : keys_.count; }

  double h(size_t segment) const { return keys_.step(segment); }
  Vector3 w(size_t knot) const { return load(workspace_.w[knot]); }
  Vector3 r(size_t segment) const { return load(workspace_.r[segment]); }
  Matrix3 jacobian(size_t segment) const { return Matrix3(workspace_.jacobian[segment]); }
  Matrix3 inverse(size_t segment) const { return Matrix3(workspace_.inverse[segment]); }
  // Segments on both sides of a knot, going on with the other end where the curve is closed.
  size_t before(size_t knot) const { return knot == 0 ? keys_.segments() - 1 : knot - 1; }
  size_t after(size_t knot) const { return knot == keys_.segments() ? 0 : knot; }

  const EndSetting* open_end(size_t knot) const;
  Outcome fix_end(size_t knot);
  bool is_fixed(size_t knot) const;

  BlockRow row(size_t knot, double weight) const;
  BlockRow inner_row(size_t knot, double weight) const;
  BlockRow natural_row(size_t knot, double weight) const;
  void add_turning(size_t segment, const Vector3& rate, double weight, BlockRow& row) const;

  // One Newton step; its size relative to the rates around each knot. False where it cannot be taken.
  bool step(double weight, double& size);
  bool apply_step(double& size);
  double local_rate(size_t knot) const;
  bool converge(double weight);
  bool continue_from_zero();
  double change_from_saved() const;
  void copy(double (*from)[3], double (*to)[3]) const;

  Construction& construction_;
  const Keyframes& keys_;
  const Workspace& workspace_;
};

const EndSetting* RateEquations::open_end(size_t knot) const {
  if (closed()) return nullptr;
  if (knot == 0) return &construction_.options.start;
  return knot == keys_.segments() ? &construction_.options.end : nullptr;
}

bool RateEquations::is_fixed(size_t knot) const {
  const EndSetting* end = open_end(knot);
  return end && end->condition != End::natural;
}

Outcome RateEquations::fix_end(size_t knot) {
  const EndSetting& end = *open_end(knot);
  const size_t segment = knot == 0 ? 0 : knot - 1;
  if (end.condition == End::chord) {
    store(chord_rate(keys_, segment), workspace_.w[knot]);
  } else if (end.condition == End::given) {
    Vector3 rise;
    if (!scaled_to_body(end.omega, construction_.options.rate_frame, keys_[knot].value, h(segment), kLargestRise, rise))
      return {Status::not_finite, knot};
    store(Vector3(rise / h(segment)), workspace_.w[knot]);
  } else {
    const Side side = knot == 0 ? Side::start : Side::end;
    store(estimated_end_rate(keys_, side, 3, construction_.input.epsilon()), workspace_.w[knot]);
  }
  return {};
}

Outcome RateEquations::prepare() {
  for (size_t i = 0; i < keys_.segments(); ++i) {
    const Vector3 r = 2.0 * relative_log(keys_[i], keys_[i + 1]);
    store(r, workspace_.r[i]);
    block::store(right_jacobian_matrix(r), workspace_.jacobian[i]);
    block::store(inverse_right_jacobian_matrix(r), workspace_.inverse[i]);
  }
  for (size_t knot = 0; knot < keys_.count; ++knot) {
    store(Vector3::Zero().eval(), workspace_.w[knot]);
    if (!is_fixed(knot)) continue;
    const Outcome outcome = fix_end(knot);
    if (outcome.status != Status::ok) return outcome;
  }
  return {};
}

// beta(R, A w) at the right end of a segment, with its derivative: multiplied by h, so that w only appears as h w.
void RateEquations::add_turning(size_t segment, const Vector3& rate, double weight, BlockRow& row) const {
  const Vector3 end_rise = product(inverse(segment), Vector3(h(segment) * rate));
  row.right -= (weight / h(segment)) * turning_acceleration(r(segment), end_rise);
  row.diagonal += weight * product(turning_jacobian(r(segment), end_rise), inverse(segment));
}

BlockRow RateEquations::inner_row(size_t knot, double weight) const {
  const size_t b = before(knot), a = after(knot);
  const IntervalShares share = interval_shares(h(b), h(a));
  BlockRow row;
  row.lower = 2.0 * share.right * jacobian(b);
  row.diagonal = 4.0 * Matrix3::Identity();
  row.upper = 2.0 * share.left * inverse(a);
  const size_t next = closed() && knot + 1 == unknowns() ? 0 : knot + 1;
  row.right = 6.0 * (share.right / h(b) * r(b) + share.left / h(a) * r(a)) - 4.0 * w(knot) - product(row.lower, w(b)) -
              product(row.upper, w(next));
  add_turning(b, w(knot), weight * share.right, row);
  return row;
}

// alpha = 0.
BlockRow RateEquations::natural_row(size_t knot, double weight) const {
  BlockRow row = {Matrix3::Zero(), 2.0 * Matrix3::Identity(), Matrix3::Zero(), Vector3::Zero()};
  if (knot == 0) {
    row.upper = inverse(0);
    row.right = 3.0 / h(0) * r(0) - 2.0 * w(0) - product(row.upper, w(1));
  } else {
    const size_t b = knot - 1;
    row.lower = jacobian(b);
    row.right = 3.0 / h(b) * r(b) - 2.0 * w(knot) - product(row.lower, w(b));
    add_turning(b, w(knot), 0.5 * weight, row);
  }
  return row;
}

BlockRow RateEquations::row(size_t knot, double weight) const {
  if (is_fixed(knot)) return {Matrix3::Zero(), Matrix3::Identity(), Matrix3::Zero(), Vector3::Zero()};
  return open_end(knot) ? natural_row(knot, weight) : inner_row(knot, weight);
}

double RateEquations::local_rate(size_t knot) const {
  double rate = largest_component(w(knot));
  if (knot > 0) rate = std::max(rate, largest_component(r(knot - 1)) / h(knot - 1));
  if (knot < keys_.segments()) rate = std::max(rate, largest_component(r(knot)) / h(knot));
  return rate;
}

bool RateEquations::apply_step(double& size) {
  double fastest = 0;
  for (size_t knot = 0; knot < unknowns(); ++knot) fastest = std::max(fastest, local_rate(knot));
  size = 0;
  for (size_t knot = 0; knot < unknowns(); ++knot) {
    const Vector3 change = load(workspace_.space.x[knot]), rate = w(knot) + change;
    const double longest = std::max(h(before(knot)), h(after(knot)));
    if (largest_component(rate) > kLargestRise / longest) return false;
    // a share of the fastest knot's rate stands in where all is at rest: repeated keys
    const double scale = std::max(local_rate(knot), 1e-6 * fastest);
    if (scale > 0) size = std::max(size, largest_component(change) / scale);
    store(rate, workspace_.w[knot]);
  }
  if (closed()) store(w(0), workspace_.w[unknowns()]);
  return true;
}

bool RateEquations::step(double weight, double& size) {
  const auto rows = [&](size_t knot) { return row(knot, weight); };
  ++construction_.iterations;
  const bool solved = closed() ? solve_cyclic(unknowns(), rows, workspace_.space)
                               : solve_tridiagonal(unknowns(), rows, workspace_.space);
  return solved && apply_step(size);
}

// Newton's method while it converges at once: a first step of at most half the rates, each later one at most half the
// one before. Two more steps after the one below 1e-9 reach rounding.
bool RateEquations::converge(double weight) {
  constexpr double kSmall = 1e-9;
  double allowed = 0.5, size = 1.0;
  while (size >= kSmall) {
    if (!step(weight, size) || size > std::max(allowed, kSmall)) return false;
    allowed = 0.5 * size;
  }
  return step(weight, size) && step(weight, size);
}

void RateEquations::copy(double (*from)[3], double (*to)[3]) const {
  for (size_t knot = 0; knot < keys_.count; ++knot) store(load(from[knot]), to[knot]);
}

double RateEquations::change_from_saved() const {
  double fastest = 0, change = 0;
  for (size_t knot = 0; knot < keys_.count; ++knot) fastest = std::max(fastest, local_rate(knot));
  for (size_t knot = 0; knot < keys_.count; ++knot) {
    const double scale = std::max(local_rate(knot), 1e-6 * fastest);
    const double difference = largest_component(Vector3(w(knot) - load(workspace_.saved[knot])));
    if (scale > 0) change = std::max(change, difference / scale);
  }
  return change;
}

bool RateEquations::continue_from_zero() {
  double weight = 0, increment = 0.25;
  while (weight < 1.0) {
    copy(workspace_.w, workspace_.saved);
    const double next = std::min(1.0, weight + increment);
    if (converge(next) && change_from_saved() <= 0.5) {
      weight = next;
      increment *= 1.7;
      continue;
    }
    copy(workspace_.saved, workspace_.w);
    increment *= 0.5;
    if (increment < 1e-7) return false;
  }
  return true;
}

Outcome RateEquations::solve() {
  // without beta the equations are linear: one step from anywhere
  double size;
  if (!step(0.0, size)) return {Status::no_convergence, kNoIndex};
  copy(workspace_.w, workspace_.saved);
  if (converge(1.0)) return {};
  copy(workspace_.saved, workspace_.w);
  return {continue_from_zero() ? Status::ok : Status::no_convergence, kNoIndex};
}

double RateEquations::residual() const {
  // in units of the shortest interval: rates over the shortest ones squared could overflow
  double shortest = h(0);
  for (size_t i = 1; i < keys_.segments(); ++i) shortest = std::min(shortest, h(i));
  double largest_jump = 0, largest_alpha = 0;
  for (size_t knot = 0; knot < unknowns(); ++knot) {
    if (!is_fixed(knot)) {
      const bool end = open_end(knot) != nullptr;
      const double reach = end ? 0.5 * h(before(knot + (knot == 0)))
                               : h(before(knot)) * interval_shares(h(before(knot)), h(after(knot))).right;
      largest_jump = std::max(largest_jump, largest_component(row(knot, 1.0).right) * (shortest / reach));
    }
    if (knot == keys_.segments()) continue;
    const double unit = shortest / h(knot);
    const Vector3 alpha = 6.0 / h(knot) * r(knot) - 4.0 * w(knot) - 2.0 * product(inverse(knot), w(knot + 1));
    largest_alpha = std::max({largest_alpha, largest_component(alpha) * unit, largest_component(w(knot)) * unit});
  }
  return largest_alpha > 0 ? largest_jump / largest_alpha : 0.0;
}

}  // namespace

Outcome build_rotation_spline(Construction& construction) {
  const Workspace workspace = workspace_of(construction);
  const Keyframes& keys = construction.keys;
  RateEquations equations(construction, workspace);
  Outcome outcome = equations.prepare();
  if (outcome.status != Status::ok) return outcome;
  // two keys that close a curve are one orientation: at rest
  const bool at_rest = keys.count == 2 && construction.options.closed();
  if (!at_rest) outcome = equations.solve();
  if (outcome.status != Status::ok) return outcome;
  construction.residual = at_rest ? 0.0 : equations.residual();

  auto* segments = static_cast<RotationVectorSegment<3>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    const double h = keys.step(i);
    const Vector3 start = 0.5 * h * load(workspace.w[i]), end = 0.5 * h * load(workspace.w[i + 1]);
    const EndValues<Vector3> p = {
        {Vector3::Zero(), 0.5 * load(workspace.r[i])}, {start, product(Matrix3(workspace.inverse[i]), end)}, {}};
    bound = std::max(bound, set_cubic(keys[i].value, h, p, segments[i]));
  }
  construction.range = range_of(bound);
  construction.omega_start = load(workspace.w[0]);
  construction.omega_end = load(workspace.w[keys.segments()]);
  return {};
}

}  // namespace qtraj
