// SQUAD in its two steps: the inner controls of keys, which follow from the tangent rule, and one segment between them.
// The tangent rule is here; the method SQUAD (methods/squad.cpp, which states the formulas) builds its curve with it.
#pragma once

#include "base/settings.hpp"
#include "functions/for_each_row.hpp"

namespace qtraj {

// ---- Controls ----

// A neighbouring segment as a key sees it: the half-angle vector from its first key to its second, and its length.
struct SquadChord {
  Vector3 log;
  double h;
};

// The tangent rule: the half rate (omega_body/2) of the curve at a key, from the chords before and after it,
// CATMULL_ROM (h_after v_before + h_before v_after) / (h_before + h_after), MEAN_VELOCITY (v_before + v_after)/2,
// v = log/h. REST, component by component: 0 where v_before and v_after differ in sign or one is 0, else CATMULL_ROM's
// value but at most 3 min(|v_before|, |v_after|), with which a cubic between two keys does not turn back (F. N. Fritsch
// and R. E. Carlson, "Monotone piecewise cubic interpolation", SIAM J. Numer. Anal. 17, 1980, the sufficient
// condition).
Vector3 rule_half_rate(Tangent rule, const SquadChord& before, const SquadChord& after);

// s times the largest factor in [0, 1] with |factor h s - log| <= pi; past 2 pi the control would wrap. |log| up to pi.
Vector3 limited_half_rate(const Vector3& s, const SquadChord& chord);

// Controls a_i and b_i of all keys by the rule CATMULL_ROM with CHORD ends, the arcs between neighbours as their signs
// give them; methods/squad.cpp states the formulas. times data may be null: uniform. The first key's b and the last
// one's a, which no segment uses, are those keys, and so are, because of CHORD, the first one's a and the last one's b.
// Of a single key both controls are that key. On uniform times they are K. Shoemake's
//   a_i = b_i = q_i exp(-(log(q_i* q_{i+1}) + log(q_i* q_{i-1}))/4).
//
// Error of a component below 2e-15; where a rate is shortened beside neighbours more than 3 rad apart on S^3, which
// leaves the limit ill-defined, below 1e-7. Singular: the controls of opposite neighbours are ambiguous, and the body
// turns about its own x axis from one to the other (Slerp in functions/pairs.hpp).
//
// A key at fault makes the controls of its neighbours NaN too, unless these are the first or the last key. The outcome
// is that of the first key that is not_finite or zero_norm, whose time is time_order or time_span (as those of knots),
// or whose controls are ambiguous.
struct SquadKeyRows {
  Input<1> times;
  Input<4> q_wb;
  Output<4> a, b;
};
Outcome squad_controls(const SquadKeyRows& keys, size_t count);

// ---- One segment ----

// One segment of SQUAD from its keys and controls, one row each, at fractions u of it (K. Shoemake, "Quaternion
// calculus and fast animation", SIGGRAPH course 10, 1987):
//   slerp(P, C; f),  f = 2u(1 - u),  P = slerp(q0, q1; u),  C = slerp(a, b; u),
// every arc as the signs give it. u is any real number: outside [0, 1] all three arcs go on along their great circles.
//
// P and C are rounded before the third slerp, which magnifies their error where they are nearly opposite or f is large.
// With phi the largest angle on S^3 of the three turns, u angle(q0, q1), u angle(a, b) and f angle(P, C), and with
// m = cos(angle(P, C)/2), the error of a component is below 1e-15 (1 + |phi|)(1 + |f| / m) for |u| <= 1000; beyond,
// results are finite and unit. Singular: ambiguous where the ends of one of the three arcs are opposite, by the rule of
// Slerp.
struct SquadSegmentRows {
  Input<4> q0, q1, a, b;
  Input<1> fraction;
  Output<4> q;
};
Outcome squad_segment(const SquadSegmentRows& segment, size_t count);

}  // namespace qtraj
