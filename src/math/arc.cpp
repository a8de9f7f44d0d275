#include "math/arc.hpp"

#include "math/chords.hpp"

namespace qtraj {

namespace {

// The component of m orthogonal to e (Gram-Schmidt), normalised.
Quaternion orthogonalized(const Quaternion& m, const Quaternion& e) {
  const Quaternion rejection = m - dot(m, e) * e;
  return rejection / length(rejection);
}

// The arc between ends that are opposite to 1e-6.
Arc long_arc(const ChordsOf<double>& chords) {
  const double half_angle = half_angle_of(chords);
  const Quaternion e = load(chords.chord) / chords.length;
  if (chords.opposite_length < kOpposite * chords.length) return {-multiply(e, Quaternion(0, 1, 0, 0)), e, half_angle};
  // the rounding error of a short sum need not be orthogonal to the chord, and the arc would leave the sphere
  const Quaternion m = load(chords.opposite) / chords.opposite_length;
  return {orthogonalized(orthogonalized(m, e), e), e, half_angle};
}

}  // namespace

Arc arc_between(const Quaternion& chord, const Quaternion& opposite_chord) {
  ChordsOf<double> chords;
  store(chord, chords.chord);
  store(opposite_chord, chords.opposite);
  measure_chords(chords);
  if (is_nearly_opposite(chords)) return long_arc(chords);
  const ArcOf<double> arc = arc_of(chords);
  return {load(arc.m), load(arc.e), arc.half_angle};
}

}  // namespace qtraj
