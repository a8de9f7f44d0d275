#pragma once

#include "qtraj/method.hpp"

namespace qtraj {

constexpr size_t kSquadWorkspacePerKey = 6;

// SQUAD on any knots: slerp of two slerps, q_i -> q_{i+1} and a_i -> b_{i+1}, at 2u(1 - u) (K. Shoemake, "Quaternion
// calculus and fast animation", SIGGRAPH course 10, 1987). With the half rate s_i of the curve at knot i
// (omega_body/2), L_i = log(q_i* q_{i+1}) and h_i = t_{i+1} - t_i the controls are
//   a_i = q_i exp((h_i s_i - L_i)/2),  b_i = q_i exp((L_{i-1} - h_{i-1} s_i)/2),
// which makes the rate on both sides of knot i equal s_i, so the curve is C1 on all knots; on uniform ones the
// CATMULL_ROM rule gives Shoemake's a_i = b_i = q_i exp(-(log(q_i* q_{i+1}) + log(q_i* q_{i-1}))/4).
//
// The end rate is s_i only while |h s_i - L| < 2 pi; beyond, the logarithm of a control wraps. Tangents by a rule are
// shortened to |h s_i - L| <= pi on both sides; given ones at or past 2 pi are status option with the key's index.
Outcome build_squad(Construction& construction);

}  // namespace qtraj
