// Great circles on S^3: how the arc of a segment follows from its ends.
#pragma once

#include "math/quaternion.hpp"

namespace qtraj {

// Middle, direction and half the angle of the arc from a to b on S^3, given b - a and a + b, of which the caller knows
// best how to form them without cancellation. b = a: e = 0, angle 0. b = -a within kOpposite: no arc is singled out,
// and the one whose middle is a (0, 1, 0, 0) is taken, a turn about the body x axis.
constexpr double kOpposite = 1e-14;
struct Arc {
  Quaternion m, e;
  double half_angle;
};
Arc arc_between(const Quaternion& chord, const Quaternion& opposite_chord);

}  // namespace qtraj
