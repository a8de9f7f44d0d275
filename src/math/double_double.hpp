// Lengths and angles to more digits than double holds, so that what is made of them rounds once. An `DoubleDouble` is
// here a sum of two doubles, the second at most 2 eps of the first.
#pragma once

#include "math/error_free.hpp"
#include "math/quaternion.hpp"
#include "math/trigonometry.hpp"

namespace qtraj {

// |a| to 1e-30 relative; the largest component as scale_for leaves it.
DoubleDouble precise_length(const Quaternion& a);

// Angle of the point (x, y), rad, for y >= 0: in [0, pi], to 0.2 eps relative. |x|, |y| < 2^500.
DoubleDouble precise_atan2(const DoubleDouble& y, const DoubleDouble& x);

// Sine and cosine of an angle, rad, each to 1 eps, for |angle| <= 2^26; beyond, where the second double is too
// large to correct by, those of the rounded sum.
SinCos sin_cos(const DoubleDouble& angle);

}  // namespace qtraj
