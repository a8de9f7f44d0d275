// Keyframes enter here: a caller's arrays are checked, normalised and made sign-continuous once, before anything else
// sees them.
#pragma once

#include "base/status.hpp"
#include "functions/for_each_row.hpp"
#include "math/quaternion.hpp"
#include "rows/arguments.hpp"

namespace qtraj {

// Keyframes as the caller passed them; omega, alpha and tangent data may be null, the latter both or none. The pointers
// to data are checked.
struct KeyframeInput {
  const double* times;
  Input<4> q_wb;
  Input<3> omega, alpha;
  const int32_t* turns;  // of each step between keys, the one to a key that a period adds included; may be null
  size_t count;
  Input<4> in_tangents = {}, out_tangents = {};  // dq/dt, 1/s, before and after each key

  // The row that a key has its rates and tangents from: a key that was added to close the curve is the first once more.
  size_t row_of_key(size_t key) const { return key < count ? key : 0; }
  double epsilon() const { return epsilon_of(q_wb); }
};

// Invariant: times strictly increase, q are unit to 1e-30, <q_{i-1}, q_i> >= 0 but where a step makes whole turns or
// the signs are as given.
struct Keyframes {
  double* times;             // [count]
  double (*q)[4];            // [count], rounded
  double (*q_remainder)[4];  // [count], rounding errors of q; working space of the constructor
  size_t count;

  UnitQuaternion operator[](size_t key) const { return {load(q[key]), load(q_remainder[key])}; }
  KeyArrays arrays() const { return {times, q, q_remainder}; }
  void set(size_t key, const UnitQuaternion& unit);
  size_t segments() const { return count - 1; }
  // Length of a segment, s.
  double step(size_t segment) const { return times[segment + 1] - times[segment]; }
};

// Checks all input and fills `keys` from 0 to input.count. On an error the lowest index at fault and,
// at one index, the first of not_finite, zero_norm, time_order, time_span.
Outcome clean_keyframes(const KeyframeInput& input, bool keeps_signs, const Keyframes& keys, KeyframeReport& report);

// How many keys of the input have another sign.
size_t count_sign_flips(const KeyframeInput& input, const Keyframes& keys);

// Makes the last key the first once more, a period after it. time_order with the index of the last key of the input
// where the period ends before it, time_span where it overflows.
Outcome add_closing_key(const KeyframeInput& input, double period, Keyframes& keys, KeyframeReport& report);

// Makes the last key +- the first, of the sign that continues the key before it, or, where signs are kept, its own;
// not_closed where they are more than `closure` rad apart as orientations.
Outcome close_keyframes(double closure, bool keeps_signs, Keyframes& keys, KeyframeReport& report);

}  // namespace qtraj
