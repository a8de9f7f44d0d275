// The project's own sine, cosine and arctangent: the same bits on every CPU, compiler and libm.
#pragma once

#include <cstddef>

#include "base/floating.hpp"
#include "math/arithmetic.hpp"
#include "math/error_free.hpp"

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

// The same functions in double-double, so that results made of them are rounded once. In arguments and results the
// error part is at most 2 eps of the value.
//
// Angle of the point (x, y), rad, for y >= 0: in [0, pi], to 0.2 eps relative. |x|, |y| < 2^500.
DoubleDouble precise_atan2(const DoubleDouble& y, const DoubleDouble& x);

// Sine and cosine of an angle, rad, each to 1 eps, for |angle| <= 2^26; beyond, where the second double is too
// large to correct by, those of the rounded sum.
SinCos sin_cos(const DoubleDouble& angle);

namespace {

// ---- Sine, cosine and arctangent of double, or of a vector of it, in plain arithmetic: the same bits everywhere, and
// for a vector those of its samples one by one.

// The terms c_k x^k from k = first on, by Horner's scheme. Callers add the first terms last, so that these round once.
template <class Number, size_t Terms>
QTRAJ_INLINE Number terms_from(const double (&coefficients)[Terms], size_t first, Number x) {
  Number sum(coefficients[Terms - 1]);
  for (size_t k = Terms - 1; k-- > first;) sum = sum * x + Number(coefficients[k]);
  for (size_t k = 0; k < first; ++k) sum = sum * x;
  return sum;
}

// Argument reduction: x = quarters pi/2 + high + low, without cancellation where x is close to a multiple of pi/2.
template <class Number>
struct ReducedAngle {
  Number quarters, high, low;
};

template <class Number>
QTRAJ_INLINE void subtract_quarters(Number x, Number quarters, ReducedAngle<Number>& reduced) {
  // pi/2 to 159 bits
  const Number half_pi(0x1.921fb54442d18p+0), half_pi_low(0x1.1a62633145c07p-54),
      half_pi_lowest(-0x1.f1976b7ed8fbcp-110);
  // x - product.value is exact, because the two are within a factor of 2 or the product is 0; every step but the last
  // is exact too
  const DoubleDoubleOf<Number> product = two_product(quarters, half_pi),
                               product_low = two_product(quarters, half_pi_low);
  const DoubleDoubleOf<Number> once = two_sum(x - product.value, -product.error);
  const DoubleDoubleOf<Number> twice = two_sum(once.value, -product_low.value);
  const Number low_terms = (once.error + twice.error) - (product_low.error + quarters * half_pi_lowest);
  reduced.quarters = quarters;
  reduced.high = twice.value + low_terms;
  reduced.low = (twice.value - reduced.high) + low_terms;
}

template <class Number>
QTRAJ_INLINE ReducedAngle<Number> reduce_angle(Number x) {
  const Number quarters_per_radian(0x1.45f306dc9c883p-1);
  ReducedAngle<Number> reduced;
  subtract_quarters(x, round_to_integer(x * quarters_per_radian), reduced);
  // for an angle of many turns the first count may be off by a quarter, because it was taken from a rounded product;
  // lanes that missed none get the same result again
  const Number missed_quarters = round_to_integer(reduced.high * quarters_per_radian);
  const Number zero(0.0);
  if (any(missed_quarters < zero) || any(zero < missed_quarters))
    subtract_quarters(x, reduced.quarters + missed_quarters, reduced);
  return reduced;
}

template <class Number>
struct SinCosOf {
  Number sin, cos;
};

// Of the angle high + low, |high| up to pi/4.
template <class Number>
QTRAJ_INLINE SinCosOf<Number> sin_cos_of_eighth(Number high, Number low) {
  const Number half(0.5), one(1.0);
  const Number y = high * high;
  const Number s = high + (high * terms_from(SincArc::kDouble, 1, y) + low);
  // 1 - y/2, its rounding error, and the small terms
  const Number leading = one - half * y;
  return {s, leading + (((one - leading) - half * y) + (terms_from(CosArc::kDouble, 2, y) - high * low))};
}

template <class Number>
QTRAJ_INLINE SinCosOf<Number> sin_cos_of(Number angle) {
  const Number zero(0.0), half(0.5), two(2.0), far(0x1p50);
  const Number below = select(far < angle, far, angle);
  const ReducedAngle<Number> reduced = reduce_angle(select(below < -far, -far, below));
  const SinCosOf<Number> at = sin_cos_of_eighth(reduced.high, reduced.low);
  const Number s = at.sin, c = at.cos;

  // the quarter, one of -2, -1, 0, 1, 2
  const Number quarter = reduced.quarters - Number(4.0) * round_to_integer(Number(0.25) * reduced.quarters);
  const Number squared = quarter * quarter;
  const auto is_none = squared < half, is_one = squared < two, is_back = quarter < zero;
  return {select(is_none, s, select(is_one, select(is_back, -c, c), -s)),
          select(is_none, c, select(is_one, select(is_back, s, -s), -c))};
}

// The same of angles from 0 to kNoQuarter, which there is nothing to reduce of: the same bits.
constexpr double kNoQuarter = 0.785;
template <class Number>
QTRAJ_INLINE SinCosOf<Number> sin_cos_unreduced(Number angle) {
  return sin_cos_of_eighth(angle, Number(0.0));
}

template <class Number>
QTRAJ_INLINE Number atan2_of(Number y, Number x) {
  const Number zero(0.0), one(1.0), two(2.0), four(4.0);
  const Number ax = select(x < zero, -x, x), ay = select(y < zero, -y, y);
  const Number largest = select(ay < ax, ax, ay), least = select(ay < ax, ay, ax);

  // the angle is eighths pi/4 + sign atan(ratio), |ratio| <= tan(pi/8)
  const auto is_wide = Number(0.41421356237309503) * largest < least;
  const Number numerator = select(is_wide, least - largest, least);
  const Number denominator = select(is_wide, least + largest, largest);
  const Number ratio = numerator / select(zero < denominator, denominator, one);
  Number eighths = select(is_wide, one, zero), sign = one;
  eighths = select(ax < ay, two - eighths, eighths);
  sign = select(ax < ay, -sign, sign);
  eighths = select(x < zero, four - eighths, eighths);
  sign = select(x < zero, -sign, sign);

  // a multiple of pi/4 in double-double; its value is exact
  const Number high = eighths * Number(0x1.921fb54442d18p-1), low = eighths * Number(0x1.1a62633145c07p-55);
  const Number atan_tail = ratio * terms_from(AtanRatio::kDouble, 1, ratio * ratio);
  const Number magnitude = select(eighths < one, ratio + atan_tail, high + (sign * ratio + (sign * atan_tail + low)));
  return select(y < zero, -magnitude, magnitude);
}

}  // namespace
}  // namespace qtraj
