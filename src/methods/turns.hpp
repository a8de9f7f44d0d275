// Steps from key to key that make whole turns. A rotation does not tell how often it has turned: of the rotation
// vectors (theta + 2 pi k) n that lead from one key to the next, theta n being the shortest, a rule of the options
// chooses k.
#pragma once

#include "methods/method.hpp"

namespace qtraj {

// What given rates at both ends say of a step, body frames, in units of the step: h omega and, where there are any,
// h^2 alpha.
struct StepRates {
  Vector3 first[2], second[2];

  // How far they turn it: the mean of the rates, and what the change of the accelerations adds (exact for a quintic
  // about one axis).
  Vector3 turn() const { return 0.5 * (first[0] + first[1]) + (1.0 / 12.0) * (second[0] - second[1]); }
};

struct Step {
  Vector3 log;     // half-angle vector: the step leads from its first key by exp(log) to its last
  bool has_turns;  // k other than 0
};

// The step over a segment by the rule of the options; `rates` are null where the method has none. The last key gets the
// sign in which the step ends. ambiguous, with the last key's index, where a step that makes whole turns ends where it
// began, to 16 eps, and no rates tell an axis; and, by FROM_RATES, where it ends within 1e-6 rad of where it began, and
// rates turn it by more than half a turn about another axis. A step without an axis of its own ends within 16 eps of
// its last key.
Outcome take_step(Construction& construction, size_t segment, const StepRates* rates, Step& step);

// Rotation vectors over a step: q = base exp(r/2), r from `start` to `end`, full angles.
struct Chart {
  Quaternion base;
  Vector3 start, end;
};

// Of a step without whole turns the base is its first key. Else it lies within the step, where neither end is closer
// than pi/2 to a whole number of turns from it: there Jr is singular, and rates would grow without bound.
Chart chart_of(const UnitQuaternion& first_key, const Step& step);

// r' and r'' of a chart at an end, from body rates there.
Vector3 first_derivative(const Vector3& r, const Vector3& omega);
Vector3 second_derivative(const Vector3& r, const Vector3& dr, const Vector3& alpha);

}  // namespace qtraj
