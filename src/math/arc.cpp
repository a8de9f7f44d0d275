#include "math/arc.hpp"

#include "math/trigonometry.hpp"

namespace qtraj {

namespace {

// The component of m orthogonal to e (Gram-Schmidt), normalised.
Quaternion orthogonalized(const Quaternion& m, const Quaternion& e) {
  const Quaternion rejection = m - dot(m, e) * e;
  return rejection / length(rejection);
}

}  // namespace

Arc arc_between(const Quaternion& chord, const Quaternion& opposite_chord) {
  const double chord_length = length(chord), opposite_length = length(opposite_chord);
  const double half_angle = atan2(chord_length, opposite_length);
  if (chord_length == 0) return {opposite_chord / opposite_length, Quaternion::Zero(), 0.0};
  const Quaternion e = chord / chord_length;
  if (opposite_length < kOpposite * chord_length) return {-multiply(e, Quaternion(0, 1, 0, 0)), e, half_angle};
  const Quaternion m = opposite_chord / opposite_length;
  // the rounding error of a short sum need not be orthogonal to the chord, and the arc would leave the sphere
  const bool is_short = opposite_length < 1e-6 * chord_length;
  return {is_short ? orthogonalized(orthogonalized(m, e), e) : m, e, half_angle};
}

}  // namespace qtraj
