#include "methods/turns.hpp"

#include "base/floating.hpp"
#include "math/so3.hpp"
#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

// The shortest rotation of a step, its axis where it has one, and whether the keys' signs say the other way round.
struct ShortestStep {
  UnitQuaternion to;  // the last key with the sign of the shortest step
  bool is_negated;
  Vector3 log, axis;
  double angle;  // theta, full
  bool has_axis;
};
ShortestStep shortest_step(const Construction& construction, size_t segment) {
  const UnitQuaternion from = construction.keys[segment], to = construction.keys[segment + 1];
  ShortestStep step;
  step.is_negated = dot(from.value, to.value) < 0;
  step.to = step.is_negated ? negate(to) : to;
  const RelativeRotation rotation = relative_rotation(from, step.to);
  const double sine = length(rotation.sin_part);
  // below this the axis is rounding noise, as in unwrap
  step.has_axis = sine > 16.0 * construction.input.epsilon();
  step.axis = step.has_axis ? Vector3(rotation.sin_part / sine) : Vector3::Zero();
  step.log = log_of(rotation);
  step.angle = 2.0 * rotation.angle;
  return step;
}

// An axis from the rates, where there are any that turn.
bool axis_from_rates(const StepRates* rates, Vector3& axis) {
  if (!rates) return false;
  const Vector3 turn = rates->turn();
  const double largest = largest_component(turn);
  if (largest == 0) return false;
  axis = turn / largest;
  axis /= length(axis);
  return true;
}

// The k nearest to the turn that the rates make about the axis. 0 where that has no digits of one turn left.
double turns_from_rates(const StepRates& rates, const ShortestStep& step, const Vector3& axis) {
  const double turn = dot(rates.turn(), axis);
  if (!(std::abs(turn) < 0x1p50)) return 0;
  return round_to_integer((turn - step.angle) / (2.0 * kPi));
}

double turns_by_rule(const Construction& construction, size_t segment, const StepRates* rates, const ShortestStep& step,
                     const Vector3& axis) {
  switch (construction.options.turns) {
    case Turns::as_given:  // without an axis a whole turn goes the way of the rates
      return step.is_negated ? (step.has_axis ? -1.0 : 1.0) : 0.0;
    case Turns::given:
      return construction.input.turns[segment];
    case Turns::from_rates:
      return rates ? turns_from_rates(*rates, step, axis) : 0.0;
    default:
      return 0.0;
  }
}

// Whether the step hardly turns, about an axis that is mostly noise, while the rates turn by more than half a turn
// about another: no branch about the step's axis is what they say.
bool contradicts(const StepRates* rates, const ShortestStep& step) {
  constexpr double kHardly = 1e-6;
  if (!rates || !step.has_axis || step.angle > kHardly) return false;
  const Vector3 turn = rates->turn();
  if (!(largest_component(turn) < 0x1p50)) return false;
  return length(Vector3(turn - dot(turn, step.axis) * step.axis)) > kPi;
}

bool is_odd(double turns) { return std::fmod(turns, 2.0) != 0; }

}  // namespace

Outcome take_step(Construction& construction, size_t segment, const StepRates* rates, Step& step) {
  const ShortestStep shortest = shortest_step(construction, segment);
  Vector3 axis = shortest.axis;
  const bool has_axis = shortest.has_axis || axis_from_rates(rates, axis);
  const double turns = turns_by_rule(construction, segment, rates, shortest, axis);
  if (construction.options.turns == Turns::from_rates && contradicts(rates, shortest))
    return {Status::ambiguous, segment + 1};
  step.has_turns = turns != 0;
  step.log = shortest.log;
  if (step.has_turns) {
    if (!has_axis) return {Status::ambiguous, segment + 1};
    if (shortest.has_axis)
      step.log = (0.5 * shortest.angle + turns * kPi) * axis;
    else
      step.log += (turns * kPi) * axis;
    construction.has_turns = true;
  }
  if (is_odd(turns) != shortest.is_negated)
    construction.keys.set(segment + 1, is_odd(turns) ? negate(shortest.to) : shortest.to);
  return {};
}

Chart chart_of(const UnitQuaternion& first_key, const Step& step) {
  if (!step.has_turns) return {first_key.value, Vector3::Zero(), 2.0 * step.log};
  // A base a n into the step has its ends at -a n and (angle - a) n. In the middle both are angle/2 away; where that is
  // near a whole number of turns, half a turn further on they are near half ones.
  const double angle = 2.0 * length(step.log);
  const Vector3 axis = (2.0 / angle) * step.log;
  const double past_turns = 0.5 * angle - 2.0 * kPi * round_to_integer(0.25 * angle / kPi);
  const double a = 0.5 * angle + (std::abs(past_turns) < 0.5 * kPi ? kPi : 0.0);
  const Quaternion base = multiply(first_key.value, exp_map(Vector3((0.5 * a) * axis)));
  return {normalize(base).unit.value, -a * axis, (angle - a) * axis};
}

Vector3 first_derivative(const Vector3& r, const Vector3& omega) {
  return largest_component(r) == 0 ? omega : inverse_right_jacobian(r, omega);
}

Vector3 second_derivative(const Vector3& r, const Vector3& dr, const Vector3& alpha) {
  if (largest_component(r) == 0) return alpha;
  return inverse_right_jacobian(r, Vector3(alpha - turning_acceleration(turning_factors(r), r, dr)));
}

}  // namespace qtraj
