#include "methods/rate_equations.hpp"

#include "math/arithmetic.hpp"
#include "methods/key_rates.hpp"
#include "methods/key_rotations.hpp"
#include "methods/turns.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<JacobianRecords> kJacobianKernels[] = QTRAJ_OF_EACH_TARGET(jacobians);

// Past this |h w| the squares in beta, over the shortest interval, could overflow.
constexpr double kLargestScaledRate = 0x1p200;

QTRAJ_INLINE Vector3 rate_from(const RateEquation& row, const Vector3& d) {
  return product(load_matrix(row.jacobian), d);
}

// Sets the rate at a knot, as d and as w = J d.
QTRAJ_INLINE void set_rate(const Vector3& d, const Vector3& w, RateEquation& row) {
  store(d, row.d);
  store(w, row.w);
  row.local_rate = std::max(largest_component(w), row.chord_rate);
}

}  // namespace

RateEquations::RateEquations(Construction& construction)
    : construction_(construction),
      keys_(construction.keys),
      unknowns_(closed() ? keys_.segments() : keys_.count),
      rows_(reinterpret_cast<RateEquation*>(construction.workspace)) {
  double* at = construction.workspace + keys_.count * (sizeof(RateEquation) / sizeof(double));
  space_.x = reinterpret_cast<double(*)[3]>(at);
  space_.inverse = reinterpret_cast<double(*)[9]>(at + 3 * keys_.count);
  space_.column = reinterpret_cast<double(*)[9]>(at + 12 * keys_.count);
}

// ---- The equations ----

const EndSetting* RateEquations::open_end(size_t knot) const {
  if (closed()) return nullptr;
  if (knot == 0) return &construction_.options.start;
  return knot == keys_.segments() ? &construction_.options.end : nullptr;
}

IntervalShares RateEquations::shares(size_t knot) const {
  const EndSetting* end = open_end(knot);
  if (!end) return interval_shares(h(previous(knot)), h(knot));
  if (end->condition != End::natural) return {0.0, 0.0};
  return knot == 0 ? IntervalShares{1.0, 0.0} : IntervalShares{0.0, 1.0};
}

Vector3 RateEquations::estimated_rate(size_t knot) const {
  const bool at_start = knot == 0;
  // half-angle vectors of the steps from the end inwards: where they turn far, they tell the branch
  Vector3 steps[kMostNeighbours];
  for (size_t k = 0; k < kMostNeighbours && k < keys_.segments(); ++k)
    steps[k] = at_start ? Vector3(0.5 * r(k)) : Vector3(-0.5 * r(keys_.segments() - 1 - k));
  const bool has_turns = construction_.has_turns;
  return estimated_end_rate(keys_, at_start ? Side::start : Side::end, kMostNeighbours, construction_.input.epsilon(),
                            has_turns ? steps : nullptr);
}

Outcome RateEquations::fix_end(size_t knot) {
  const EndSetting& end = *open_end(knot);
  const size_t segment = knot == 0 ? 0 : knot - 1;
  RateEquation& row = rows_[knot];
  Vector3 w;
  if (end.condition == End::chord) {
    w = construction_.has_turns ? Vector3(r(segment) / h(segment)) : chord_rate(keys_, segment);
  } else if (end.condition == End::given) {
    if (!scaled_to_body(end.omega, construction_.options.rate_frame, keys_[knot].value, h(segment), kLargestScaledRate,
                        w))
      return {Status::rate_too_fast, knot};
    w /= h(segment);
  } else {
    w = estimated_rate(knot);
  }
  const Vector3 d = inverse_right_jacobian(load(row.r), w);
  set_rate(d, rate_from(row, d), row);
  store(load(row.w), row.constant);
  return {};
}

// R of the segments: without turns by a kernel.
Outcome RateEquations::prepare_steps() {
  const auto set = [&](size_t i, const Vector3& log) {
    RateEquation& row = rows_[end_of(i)];
    store(Vector3(2.0 * log), row.r);
    row.h = h(i);
  };
  if (construction_.options.turns == Turns::shortest) {
    for_each_log(keys_, set);
    return {};
  }
  for (size_t i = 0; i < keys_.segments(); ++i) {
    Step step;
    const Outcome outcome = take_step(construction_, i, nullptr, step);
    if (outcome.status != Status::ok) return outcome;
    set(i, step.log);
  }
  return {};
}

// The Jacobian and the factors of beta, which depend on R alone: by a kernel, and what it leaves by the core.
void RateEquations::prepare_segments() {
  static_assert(sizeof(rows_->turning) == sizeof(double[3]), "three numbers, the first along_once");
  const JacobianRecords records = {rows_->r, rows_->jacobian, &rows_->turning.along_once,
                                   sizeof(RateEquation) / sizeof(double)};
  size_t knot = kJacobianKernels[target()](records, 0, unknowns_);
  while (knot < unknowns_) {
    const JacobianAndTurning at_end = jacobian_and_turning(load(rows_[knot].r));
    store_matrix(at_end.jacobian, rows_[knot].jacobian);
    rows_[knot].turning = at_end.turning;
    ++knot;
    knot += kJacobianKernels[target()](records, knot, unknowns_);
  }
}

void RateEquations::prepare_row(size_t knot) {
  RateEquation& row = rows_[knot];
  const RateEquation &before = rows_[previous(knot)], &after = rows_[next(knot)];
  const IntervalShares share = shares(knot);
  const double h_after = knot < keys_.segments() ? h(knot) : row.h;
  const double per_h = 1.0 / row.h, per_h_after = 1.0 / h_after;
  const Vector3 chord = per_h * load(row.r), chord_after = per_h_after * load(after.r);
  store_matrix(0.5 * share.right * product(load_matrix(row.jacobian), load_matrix(before.jacobian)), row.lower);
  row.upper = 0.5 * share.left;
  store(Vector3(1.5 * share.right * chord + 1.5 * share.left * chord_after), row.constant);
  row.turning = 0.25 * share.right * row.turning;
  row.reach = 0.25 * std::max(share.right * row.h, share.left * h_after);
  row.chord_rate = std::max(largest_component(chord), largest_component(chord_after));
  row.limit = kLargestScaledRate * std::min(per_h, per_h_after);
  set_rate(Vector3::Zero(), Vector3::Zero(), row);
}

Outcome RateEquations::prepare() {
  if (!closed()) {
    // there is no rotation before the first knot
    rows_[0] = {};
    rows_[0].h = h(0);
  }
  const Outcome steps = prepare_steps();
  if (steps.status != Status::ok) return steps;
  prepare_segments();
  for (size_t knot = 0; knot < unknowns_; ++knot) {
    prepare_row(knot);
    if (open_end(knot) && rows_[knot].reach == 0) {
      const Outcome outcome = fix_end(knot);
      if (outcome.status != Status::ok) return outcome;
    }
  }
  select_all();
  return {};
}

// The linear system of the Newton step from the rates d; its right side is the residual of the equations.
struct RateEquations::System {
  const RateEquation* rows;
  size_t count;
  double weight;

  QTRAJ_INLINE Matrix3 lower(size_t i) const { return load_matrix(rows[i].lower); }
  QTRAJ_INLINE double upper(size_t i) const { return rows[i].upper; }
  QTRAJ_INLINE Matrix3 diagonal(size_t i) const {
    const RateEquation& row = rows[i];
    if (weight == 0) return load_matrix(row.jacobian);
    return load_matrix(row.jacobian) +
           turning_jacobian(weight * row.turning, load(row.r), Vector3(row.h * load(row.d)));
  }
  QTRAJ_INLINE Vector3 right(size_t i, const Vector3& before) const {
    const RateEquation &row = rows[i], &last = rows[i == 0 ? count - 1 : i - 1],
                       &next = rows[i + 1 == count ? 0 : i + 1];
    Vector3 right_side = load(row.constant) - load(row.w) - row.upper * load(next.d);
    // beta of h d, divided by h: rates only appear as h d, whose squares cannot overflow
    if (weight > 0)
      right_side -= turning_acceleration(weight / row.h * row.turning, load(row.r), Vector3(row.h * load(row.d)));
    // the only term that depends on the row before comes last, so that all others are off the dependency chain
    return right_side - product(load_matrix(row.lower), Vector3(load(last.d) + before));
  }
};

// ---- Their solution ----

void RateEquations::select(size_t first, size_t last) {
  first_ = first;
  last_ = last;
  fastest_ = 0;
  for (size_t knot = first_; knot < last_; ++knot) fastest_ = std::max(fastest_, rows_[knot].local_rate);
}

// The unit for changes of the rate at a knot: the size of the rates around it. Where these are 0, at repeated keys, it
// is a share of the fastest of the selected rates; where that is 0 or subnormal too, a negligible rate.
double RateEquations::scale_at(const RateEquation& row) const {
  return std::max({row.local_rate, 1e-6 * fastest_, 1e-290});
}

bool RateEquations::factorize(double weight) {
  const System system = {rows_, unknowns_, weight};
  return is_cyclic() ? factorize_cyclic(unknowns_, system, space_)
                     : factorize_tridiagonal(first_, last_, system, space_);
}

bool RateEquations::step(double weight, double& size) {
  const System system = {rows_, unknowns_, weight};
  double largest_change = 0, fastest = 0;
  bool within_limits = true;
  const auto add_change = [&](size_t knot, const Vector3& x) {
    RateEquation& row = rows_[knot];
    const Vector3 d = load(row.d) + x, w = rate_from(row, d);
    if (largest_component(w) > row.limit) {
      within_limits = false;
      return;
    }
    largest_change = std::max(largest_change, largest_component(Vector3(w - load(row.w))) / scale_at(row));
    set_rate(d, w, row);
    fastest = std::max(fastest, row.local_rate);
  };
  if (is_cyclic())
    solve_cyclic(unknowns_, system, space_, add_change);
  else
    solve_tridiagonal(first_, last_, system, space_, add_change);
  work_ += last_ - first_;
  fastest_ = fastest;
  size = largest_change;
  return within_limits;
}

void RateEquations::save() {
  for (size_t knot = first_; knot < last_; ++knot) store(load(rows_[knot].d), rows_[knot].saved);
}

void RateEquations::restore() {
  fastest_ = 0;
  for (size_t knot = first_; knot < last_; ++knot) {
    RateEquation& row = rows_[knot];
    set_rate(load(row.saved), rate_from(row, load(row.saved)), row);
    fastest_ = std::max(fastest_, row.local_rate);
  }
}

double RateEquations::change_from_saved() const {
  double change = 0;
  for (size_t knot = first_; knot < last_; ++knot) {
    const RateEquation& row = rows_[knot];
    const Vector3 difference = load(row.w) - rate_from(row, load(row.saved));
    change = std::max(change, largest_component(difference) / scale_at(row));
  }
  return change;
}

double RateEquations::residual() const {
  // in units of the shortest interval, because rates divided by its square could overflow
  double shortest = h(0);
  for (size_t i = 1; i < keys_.segments(); ++i) shortest = std::min(shortest, h(i));
  const System system = {rows_, unknowns_, 1.0};
  double largest_jump = 0, largest_alpha = 0;
  for (size_t knot = 0; knot < unknowns_; ++knot) {
    const RateEquation& row = rows_[knot];
    if (row.reach > 0)
      largest_jump =
          std::max(largest_jump, largest_component(system.right(knot, Vector3::Zero())) * (shortest / row.reach));
    if (knot == keys_.segments()) continue;
    const double unit = shortest / h(knot);
    const Vector3 alpha = 6.0 / h(knot) * r(knot) - 4.0 * load(row.w) - 2.0 * end_rate(knot);
    largest_alpha = std::max({largest_alpha, largest_component(alpha) * unit, largest_component(load(row.w)) * unit});
  }
  constexpr double kAtRest = 1e-280;  // smaller rates are negligible and have few digits left
  return largest_alpha > kAtRest ? largest_jump / largest_alpha : 0.0;
}

}  // namespace qtraj
