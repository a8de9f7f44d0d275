#include "qtraj/rate_equations.hpp"

#include <utility>

#include "qtraj/end_rate.hpp"
#include "qtraj/given_rates.hpp"
#include "qtraj/knots.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {
namespace {

// |h w| past this: the squares in beta, over the shortest interval, could overflow.
constexpr double kLargestRise = 0x1p200;

}  // namespace

RateWorkspace rate_workspace_of(const Construction& construction) {
  const size_t count = construction.keys.count;
  double* at = construction.workspace;
  const auto vectors = [&] { return reinterpret_cast<double(*)[3]>(std::exchange(at, at + 3 * count)); };
  const auto matrices = [&] { return reinterpret_cast<double(*)[9]>(std::exchange(at, at + 9 * count)); };
  RateWorkspace workspace;
  workspace.w = vectors();
  workspace.saved = vectors();
  workspace.r = vectors();
  workspace.turning = vectors();
  workspace.jacobian = matrices();
  workspace.inverse = matrices();
  workspace.space.x = vectors();
  workspace.space.upper = matrices();
  workspace.space.column = matrices();
  return workspace;
}

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
    const TurningFactors turning = turning_factors(r);
    store(r, workspace_.r[i]);
    store(Vector3(turning.along_once, turning.along_twice, turning.sideways), workspace_.turning[i]);
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
  const double* turning = workspace_.turning[segment];
  const TurningFactors factors = {turning[0], turning[1], turning[2]};
  row.right -= (weight / h(segment)) * turning_acceleration(factors, r(segment), end_rise);
  row.diagonal += weight * product(turning_jacobian(factors, r(segment), end_rise), inverse(segment));
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

double RateEquations::fastest_rate() const {
  double fastest = 0;
  for (size_t knot = 0; knot < keys_.count; ++knot) fastest = std::max(fastest, local_rate(knot));
  return fastest;
}

// What a change of the rate at a knot is measured by. Where all around is at rest, repeated keys, a share of the
// fastest knot's rate; where everything is, or moves by denormal steps, a rate of no account.
double RateEquations::scale_at(size_t knot, double fastest) const {
  return std::max({local_rate(knot), 1e-6 * fastest, 1e-290});
}

double RateEquations::longest_beside(size_t knot) const {
  if (!closed() && knot == 0) return h(0);
  if (!closed() && knot == keys_.segments()) return h(knot - 1);
  return std::max(h(before(knot)), h(after(knot)));
}

bool RateEquations::apply_step(double& size) {
  const double fastest = fastest_rate();
  size = 0;
  for (size_t knot = 0; knot < unknowns(); ++knot) {
    const Vector3 change = load(workspace_.space.x[knot]), rate = w(knot) + change;
    if (largest_component(rate) > kLargestRise / longest_beside(knot)) return false;
    size = std::max(size, largest_component(change) / scale_at(knot, fastest));
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

void RateEquations::copy(double (*from)[3], double (*to)[3]) const {
  for (size_t knot = 0; knot < keys_.count; ++knot) store(load(from[knot]), to[knot]);
}

void RateEquations::save() const { copy(workspace_.w, workspace_.saved); }
void RateEquations::restore() const { copy(workspace_.saved, workspace_.w); }

double RateEquations::change_from_saved() const {
  const double fastest = fastest_rate();
  double change = 0;
  for (size_t knot = 0; knot < keys_.count; ++knot) {
    const double difference = largest_component(Vector3(w(knot) - load(workspace_.saved[knot])));
    change = std::max(change, difference / scale_at(knot, fastest));
  }
  return change;
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
  constexpr double kAtRest = 1e-280;  // rates of no account, with few digits left
  return largest_alpha > kAtRest ? largest_jump / largest_alpha : 0.0;
}

}  // namespace qtraj
