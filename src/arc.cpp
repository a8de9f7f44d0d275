#include "qtraj/arc.hpp"

#include "qtraj/elementary.hpp"

namespace qtraj {

Arc arc_between(const Quaternion& chord, const Quaternion& opposite_chord) {
  const double chord_length = length(chord), opposite_length = length(opposite_chord);
  const double half_angle = atan2(chord_length, opposite_length);
  if (chord_length == 0) return {opposite_chord / opposite_length, Quaternion::Zero(), 0.0};
  const Quaternion e = chord / chord_length;
  if (opposite_length == 0) return {-multiply(e, Quaternion(0, 1, 0, 0)), e, half_angle};
  return {opposite_chord / opposite_length, e, half_angle};
}

}  // namespace qtraj
