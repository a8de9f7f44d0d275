// Screw motions between two poses: orientation and position together, as one turn about and along one line.
#pragma once

#include "functions/pairs.hpp"
#include "math/scaled.hpp"

namespace qtraj {

// Orientations and positions of poses, one row each or one for all.
struct ScrewRows {
  Input<4> q_a;
  Input<3> p_a;
  Input<4> q_b;
  Input<3> p_b;
  Input<1> fraction;
  Output<4> q;
  Output<3> p;
};

struct Pose {
  Quaternion q;
  Vector3 p;
};

// The motion at constant body rates, angular and linear, from pose a to pose b along the shorter turn:
//   T(u) = T_a exp(u log(T_a^-1 T_b))
// (R. M. Murray, Z. Li, S. S. Sastry, "A Mathematical Introduction to Robotic Manipulation", 1994, eq. 2.36: the
// exponential of a twist; M. Chasles 1830: it is a screw). With N the axis in the world frame, phi half the angle of
// the turn, D = p_b - p_a, D = D_N + D_r along N and across,
//   p(u) = p_a + u W,        W = D_N + s R(N, (u - 1) phi) D_r,   s = (sin(u phi) / (u phi)) (phi / sin phi),
//   p(u) = p_b + (u - 1) W', W' = D_N + s' R(N, u phi) D_r,       s' = s at u - 1 for u,
// R(N, x) being the rotation about N by x. Nothing cancels, and as phi -> 0 both are the straight line whatever N is: W
// is no longer than (pi/2) |D|. The first form is taken up to u = 1/2, the second beyond: fractions 0 and 1 give p_a
// and p_b themselves.
//
// The error of a component of p is below eps (1 |end| + 16 |u'| |D|) with u' = u or u - 1 and `end` the position it is
// counted from, for |u'| phi <= 1e6; that of q is Slerp's.
// Singular: half a turn, to 4 eps of its cosine, is ambiguous: the turn is that of Slerp along the sign of b as given.
class Screw {
 public:
  Screw() = default;
  Screw(const Pair& pair, const Vector3& p_a, const Vector3& p_b);

  // A position that overflows is infinite.
  Status at(double fraction, Pose& pose) const;

 private:
  Slerp turn_;
  Scaled<Vector3> along_, across_, normal_;  // D_N, D_r, N x D_r
  Vector3 p_a_ = Vector3::Zero(), p_b_ = Vector3::Zero();
  double half_angle_ = 0, stretch_ = 1;  // phi, phi / sin phi
  bool is_ambiguous_ = false;
};

Outcome screw_pairs(const ScrewRows& rows, size_t count);

}  // namespace qtraj
