#include "math/trigonometry.hpp"

#include <cmath>

namespace qtraj {

SinCos sin_cos(double x) {
  const SinCosOf<double> at = sin_cos_of(x);
  return {at.sin, at.cos};
}

double atan2(double y, double x) { return atan2_of(y, x); }

namespace {

DoubleDouble negate(const DoubleDouble& a) { return {-a.value, -a.error}; }

DoubleDouble add(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = two_sum(a.value, b.value);
  return {sum.value, sum.error + (a.error + b.error)};
}

DoubleDouble divide(const DoubleDouble& a, const DoubleDouble& b) {
  const double ratio = a.value / b.value;
  const DoubleDouble product = two_product(ratio, b.value);
  return {ratio, (((a.value - product.value) - product.error) + (a.error - ratio * b.error)) / b.value};
}

}  // namespace

DoubleDouble precise_atan2(const DoubleDouble& y, const DoubleDouble& x) {
  const DoubleDouble ax = x.value < 0 ? negate(x) : x;
  const bool steep = y.value > ax.value;
  const DoubleDouble &largest = steep ? y : ax, &least = steep ? ax : y;
  if (largest.value == 0) return {0, 0};

  // the angle is eighths pi/4 + sign atan(ratio), |ratio| <= tan(pi/8)
  constexpr double kTanEighthPi = 0.41421356237309503;
  const bool wide = least.value > kTanEighthPi * largest.value;
  const DoubleDouble ratio = wide ? divide(add(least, negate(largest)), add(least, largest)) : divide(least, largest);
  int eighths = wide ? 1 : 0;
  double sign = 1;
  if (steep) eighths = 2 - eighths, sign = -sign;
  if (x.value < 0) eighths = 4 - eighths, sign = -sign;

  // multiples of pi/4 in double-double
  constexpr DoubleDouble kEighths[] = {{0, 0},
                                       {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
                                       {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},
                                       {0x1.2d97c7f3321d2p+1, 0x1.a79394c9e8a0ap-54},
                                       {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}};
  const double square = ratio.value * ratio.value;
  const double small_terms = ratio.value * terms_from(AtanRatio::kDouble, 1, square) + ratio.error / (1.0 + square);
  const DoubleDouble sum = add(kEighths[eighths], {sign * ratio.value, sign * small_terms});
  return two_sum(sum.value, sum.error);
}

SinCos sin_cos(const DoubleDouble& angle) {
  if (std::abs(angle.value) > 0x1p26) return sin_cos(angle.value + angle.error);
  const SinCos at = sin_cos(angle.value);
  return {at.sin + at.cos * angle.error, at.cos - at.sin * angle.error};
}

}  // namespace qtraj
