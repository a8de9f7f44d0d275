// Great circles on S^3: the arc of a segment from its two ends.
#pragma once

#include "math/quaternion.hpp"

namespace qtraj {

// The arc from a to b on S^3: its middle m, its direction e there, and half its angle, rad. The caller passes b - a and
// a + b, because it knows how to form them without cancellation. Singular: b = a gives e = 0 and angle 0; for b = -a,
// within kOpposite, no arc is singled out, and the one whose middle is a (0, 1, 0, 0) is taken, a turn about the body x
// axis.
constexpr double kOpposite = 1e-14;
struct Arc {
  Quaternion m, e;
  double half_angle;
};
Arc arc_between(const Quaternion& chord, const Quaternion& opposite_chord);

}  // namespace qtraj
