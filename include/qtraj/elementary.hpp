// The project's own sine, cosine and arctangent: the same bits on every CPU, compiler and libm.
#pragma once

namespace qtraj {

constexpr double kPi = 0x1.921fb54442d18p+1;

struct SinCos {
  double sin, cos;
};

// Sine and cosine of x, rad, any finite x. Error below 1 ulp for |x| <= 2^50. Beyond, where neighbouring doubles are a
// quarter of a radian and more apart, x counts as +-2^50: finite and on the unit circle, but no direction is meant.
SinCos sin_cos(double x);

// Angle of the point (x, y), rad, in (-pi, pi], for |x|, |y| <= DBL_MAX / 2; 0 at the origin. Error below 2 ulp.
// The sign of a zero is not looked at: atan2(-0.0, -1.0) is pi.
double atan2(double y, double x);

}  // namespace qtraj
