// The builder of ROTATION_SPLINE.
#include "methods/method.hpp"
#include "methods/polynomials.hpp"
#include "methods/rate_equations.hpp"

namespace qtraj {
namespace {

// Newton's method, given up where it does not converge at once: the first step is at most half the rates, each later
// one at most half the one before. After a step below 1e-4 the factorized matrix is kept as long as each step gains at
// least two digits, because such steps cost half as much. After a step below 1e-9 at most two more reach rounding; a
// step whose predicted size, size^2 / before, is below rounding is not taken.
bool converge(RateEquations& equations, double weight) {
  constexpr double kSmall = 1e-9, kKeepMatrix = 1e-4, kGain = 1e-2, kRounding = 3e-17;
  double allowed = 0.5, before = 1.0, size = 1.0;
  bool keeps_matrix = false;
  while (size >= kSmall) {
    if (!keeps_matrix && !equations.factorize(weight)) return false;
    before = size;
    if (!equations.step(weight, size) || size > std::max(allowed, kSmall)) return false;
    allowed = 0.5 * size;
    keeps_matrix = size < kKeepMatrix && size <= kGain * before;
  }
  for (int more = 2; more > 0 && size * (size / before) > kRounding; --more) {
    if (!keeps_matrix && !equations.factorize(weight)) return false;
    keeps_matrix = true;
    before = size;
    if (!equations.step(weight, size)) return false;
  }
  return true;
}

// Whether continuation may go on. The work of a curve is bounded by kStepsPerKnot for each of its knots, on average,
// and kAnyCurve for all of them together, as counted by RateEquations::work(), and by the steps of one weight more.
// Ordinary curves take 3 to 6 a knot, and a step is about a tenth of their construction: the first number is some 50
// ordinary constructions, the second a tenth of a second, which lets short curves go on for longer.
bool may_go_on(const RateEquations& equations) {
  constexpr size_t kStepsPerKnot = 512, kAnyCurve = size_t{1} << 20;
  return equations.work() / kStepsPerKnot < equations.unknowns() + kAnyCurve / kStepsPerKnot;
}

// Continuation: raises the weight of beta from 0 to 1, by increments that grow after success and are halved after
// failure.
bool continue_from_zero(RateEquations& equations) {
  double weight = 0, increment = 0.25;
  while (weight < 1.0) {
    if (!may_go_on(equations)) return false;
    equations.save();
    const double next = std::min(1.0, weight + increment);
    if (converge(equations, next) && equations.change_from_saved() <= 0.5) {
      weight = next;
      increment *= 1.7;
      continue;
    }
    equations.restore();
    increment *= 0.5;
    if (increment < 1e-7) return false;
  }
  return true;
}

// Without beta the equations are linear: one step solves them from anywhere.
bool solve_linear(RateEquations& equations) {
  double size;
  return equations.factorize(0.0) && equations.step(0.0, size);
}

// Newton's method without continuation; where it fails the rates are what they were.
bool converge_at_once(RateEquations& equations) {
  equations.save();
  if (converge(equations, 1.0)) return true;
  equations.restore();
  return false;
}

// Part by part, each with some knots on either side, whose rates the next part finds anew. A change of a rate fades by
// 2 - sqrt(3) = 0.27 from knot to knot of even keys, and by pi/4 at most where steps are half turns (|A_i| <= pi/2, in
// the equations without beta): a part has its rates but for little, which Newton's method on the whole curve then
// finds. A few hard keys therefore cost what they cost alone, not that times the length of the curve.
bool solve_by_parts(RateEquations& equations) {
  constexpr size_t kPart = 64, kBeside = 32;
  const size_t count = equations.unknowns();
  for (size_t first = 0; first < count; first += kPart) {
    equations.select(first - std::min(first, kBeside), std::min(first + kPart + kBeside, count));
    if (!solve_linear(equations)) return false;
    if (!converge_at_once(equations) && !continue_from_zero(equations)) return false;
  }
  equations.select_all();
  return converge(equations, 1.0);
}

bool solve(RateEquations& equations) {
  constexpr size_t kShort = 256;
  if (!solve_linear(equations)) return false;
  if (converge_at_once(equations)) return true;
  if (equations.unknowns() > kShort) {
    if (solve_by_parts(equations)) return true;
    equations.select_all();
    if (!solve_linear(equations)) return false;
  }
  return continue_from_zero(equations);
}

}  // namespace

// ROTATION_SPLINE: q_i exp(r/2), r a cubic per segment with r(0) = 0 and r(h) = R_i = 2 log(q_i* q_{i+1}), the body
// rates w_i at the knots such that alpha is continuous. With A_i = Jr^-1(R_i), r'(h) = A_i w_{i+1}:
//   2 A_{i-1}^-1 w_{i-1}/h_{i-1} + 4 (1/h_{i-1} + 1/h_i) w_i + 2 A_i w_{i+1}/h_i + beta(R_{i-1}, A_{i-1} w_i)
//     = 6 (R_{i-1}/h_{i-1}^2 + R_i/h_i^2),
// equal angular accelerations on both sides of the knot, in the body frame there (the curve of I. G. Kang and F. C.
// Park, "Cubic spline algorithms for orientation interpolation", IJNME 46 (1999), section 3, the rates solved for
// exactly). The solution taken is the one continued from beta = 0; on extreme keys it is not the only one.
//
// no_convergence where that continuation stalls or takes too many steps, a segment turns by more than 2^200 rad, or the
// equations are not met to 1e-9; rate_too_fast with the key's index where a given end rate alone is past 2^200 rad over
// its segment.
Outcome build_rotation_spline(Construction& construction) {
  const Keyframes& keys = construction.keys;
  RateEquations equations(construction);
  Outcome outcome = equations.prepare();
  if (outcome.status != Status::ok) return outcome;
  // two keys that close a curve are one orientation, and the body is at rest
  const bool at_rest = keys.count == 2 && construction.options.closed();
  if (!at_rest && !solve(equations)) return {Status::no_convergence, kNoIndex};
  construction.iterations = equations.iterations();
  construction.residual = at_rest ? 0.0 : equations.residual();
  constexpr double kLargestResidual = 1e-9;  // rounding leaves 1e-15
  if (construction.residual > kLargestResidual) return {Status::no_convergence, kNoIndex};

  auto* segments = static_cast<RotationVectorSegment<3>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    const double h = keys.step(i);
    const EndValues<Vector3> p = {{Vector3::Zero(), 0.5 * equations.r(i)},
                                  {0.5 * h * equations.start_rate(i), 0.5 * h * equations.end_rate(i)},
                                  {}};
    bound = std::max(bound, set_cubic(keys[i].value, h, p, segments[i]));
  }
  construction.range = range_of(bound);
  construction.omega_start = equations.w(0);
  construction.omega_end = equations.w(keys.segments());
  return {};
}

}  // namespace qtraj
