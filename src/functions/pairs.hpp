// Two quaternions of any norm but 0, and slerp and nlerp between them at any real fraction: 0 at a, 1 at b.
//
// Kernels (rows/pairs.hpp) do ordinary rows: fractions between 0 and 1 of pairs less than a quarter turn of S^3 apart.
// The classes below do all others. They take inputs as exact: the turn from a to b is known to a few eps relative at
// every angle, so that even the shortest arc can be followed for many turns. Results are computed from the nearer end,
// from a up to fraction 1/2 and from b beyond: at fractions 0 and 1 they are a / |a| and b / |b| as rounded, whatever
// the other end is.
#pragma once

#include "base/settings.hpp"
#include "base/status.hpp"
#include "functions/for_each_row.hpp"
#include "rows/arguments.hpp"

namespace qtraj {

// b = a exp(angle axis), both unit. Under SHORTEST b is the nearer to a of b and -b as given; half a turn apart, where
// the cosine is 0 to 4 eps, it keeps its sign. a always keeps its sign.
struct Pair {
  Quaternion a, b;
  Vector3 axis;         // unit, body frame; 0 where sine is
  double sine, cosine;  // of the angle on S^3, times a common factor; a sine below 1e-150 counts as 0
};

// Finite a and b, not 0.
Pair make_pair(const Quaternion& a, const Quaternion& b, Path path);

// The same from rows: not_finite where one is not finite, zero_norm where one is 0.
Status read_pair(const Input<4>& a, const Input<4>& b, size_t row, Path path, Pair& pair);

// An end q of a pair and the unit tangent of its great circle there: q exp(x axis) = q cos x + along sin x.
struct PairEnd {
  Quaternion q = Quaternion::Zero(), along = Quaternion::Zero();
};

// The great circle through a and b at constant rate, a (a* b)^fraction (K. Shoemake, "Animating rotation with
// quaternion curves", SIGGRAPH 1985, section 3.3), as a exp(fraction angle axis) or b exp((fraction - 1) angle axis).
//
// With theta = fraction angle, rad on S^3 (the body turns by twice that), the error of a component is below
// 6e-16 + 7e-16 |theta| for |theta| <= 1e6, and below 6e-16 for fractions in [0, 1]. Beyond 1e6 rad results are finite
// and unit.
// Singular: b = -a within 1e-14 rad (AS_GIVEN) is ambiguous, and the body turns about its own x axis, axis = (1, 0, 0),
// angle = pi.
class Slerp {
 public:
  Slerp() = default;
  explicit Slerp(const Pair& pair);

  Status at(double fraction, Quaternion& q) const;

  // log(a* b), the half-angle vector from a to b.
  const Vector3& log() const { return log_; }
  bool is_ambiguous() const { return is_ambiguous_; }

 private:
  PairEnd a_, b_;
  Vector3 log_ = Vector3::Zero();
  double angle_ = 0;
  bool is_ambiguous_ = false;
};

// p / |p|, p = (1 - fraction) a + fraction b. The error of a component is below 7e-16 however close to 0 the chord
// passes. (If inputs were themselves rounded to eps, that adds an error of eps / |p|.)
// Singular: zero_norm where |p| < 1e-14, close to fraction 1/2 of opposite a and b.
class Nlerp {
 public:
  Nlerp() = default;
  explicit Nlerp(const Pair& pair);

  Status at(double fraction, Quaternion& q) const;

 private:
  PairEnd a_, b_;
  double sine_ = 0, cosine_ = 1;  // of half the angle
};

// One fraction a row.
Outcome slerp(const PairRows& pairs, size_t count);
Outcome nlerp(const PairRows& pairs, size_t count);

}  // namespace qtraj
