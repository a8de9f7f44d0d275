#pragma once

#include "functions/for_each_row.hpp"

namespace qtraj {

// One segment of SQUAD from its keys and controls, one row each, at fractions u of it (K. Shoemake, "Quaternion
// calculus and fast animation", SIGGRAPH course 10, 1987):
//   slerp(P, C; f),  f = 2u(1 - u),  P = slerp(q0, q1; u),  C = slerp(a, b; u),
// every arc as the signs give it. Any real u: outside [0, 1] all three arcs go on along their great circles.
//
// P and C are rounded before the third slerp, which magnifies that where they are nearly opposite or f is large. With
// phi the largest angle on S^3 of the three turns, u angle(q0, q1), u angle(a, b) and f angle(P, C), and with
// m = cos(angle(P, C)/2), the error of a component is below 1e-15 (1 + |phi|)(1 + |f| / m) for |u| <= 1000; beyond,
// results are finite and unit. Ambiguous where the ends of one of the three arcs are opposite, by the rule of Slerp.
struct SquadSegmentRows {
  Input<4> q0, q1, a, b;
  Input<1> fraction;
  Output<4> q;
};
Outcome squad_segment(const SquadSegmentRows& segment, size_t count);

}  // namespace qtraj
