#include "qtraj/elementary.hpp"

#include <cstdint>

#include "kernel/coefficients.hpp"
#include "qtraj/error_free.hpp"
#include "qtraj/floating.hpp"

namespace qtraj {
namespace {

// A polynomial without its first `skip` terms: callers add those last, so that they round once.
template <std::size_t Terms>
double tail(const double (&coefficients)[Terms], std::size_t skip, double x) {
  double sum = coefficients[Terms - 1];
  for (std::size_t k = Terms - 1; k-- > skip;) sum = sum * x + coefficients[k];
  for (std::size_t k = 0; k < skip; ++k) sum *= x;
  return sum;
}

// pi/2 to 159 bits.
constexpr double kHalfPi = 0x1.921fb54442d18p+0;
constexpr double kHalfPiLow = 0x1.1a62633145c07p-54;
constexpr double kHalfPiLowest = -0x1.f1976b7ed8fbcp-110;

// x = quarters pi/2 + high + low, without loss where x is close to a multiple of pi/2.
struct Reduced {
  double quarters, high, low;
};

Reduced subtract_quarters(double x, double quarters) {
  // x less the first product is exact, the two being within a factor of 2 or the second 0, and so is each step but the
  // last
  const Exact product = two_product(quarters, kHalfPi), product_low = two_product(quarters, kHalfPiLow);
  const Exact once = two_sum(x - product.value, -product.error);
  const Exact twice = two_sum(once.value, -product_low.value);
  const double rest = (once.error + twice.error) - (product_low.error + quarters * kHalfPiLowest);
  const double high = twice.value + rest;
  return {quarters, high, (twice.value - high) + rest};
}

Reduced reduce(double x) {
  constexpr double kQuartersPerRadian = 0x1.45f306dc9c883p-1;
  const Reduced first = subtract_quarters(x, round_to_integer(x * kQuartersPerRadian));
  // of many turns the first count may be a quarter off: its product was rounded
  const double missed = round_to_integer(first.high * kQuartersPerRadian);
  return missed == 0 ? first : subtract_quarters(x, first.quarters + missed);
}

}  // namespace

SinCos sin_cos(double x) {
  constexpr double kFar = 0x1p50;
  if (x > kFar) x = kFar;
  if (x < -kFar) x = -kFar;
  const auto [quarters, high, low] = reduce(x);

  const double y = high * high;
  const double s = high + (high * tail(SincArc::kDouble, 1, y) + low);
  // 1 - y/2 rounded, what the rounding left, and the small terms
  const double leading = 1.0 - 0.5 * y;
  const double c = leading + (((1.0 - leading) - 0.5 * y) + (tail(CosArc::kDouble, 2, y) - high * low));
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double atan2(double y, double x) {
  const double ax = x < 0 ? -x : x, ay = y < 0 ? -y : y;
  const double largest = ax > ay ? ax : ay, least = ax > ay ? ay : ax;
  if (largest == 0) return 0;

  // the angle is eighths pi/4 + sign atan(ratio), |ratio| <= tan(pi/8)
  constexpr double kTanEighthPi = 0.41421356237309503;
  const bool wide = least > kTanEighthPi * largest;
  const double ratio = wide ? (least - largest) / (least + largest) : least / largest;
  int eighths = wide ? 1 : 0;
  double sign = 1;
  if (ay > ax) eighths = 2 - eighths, sign = -sign;
  if (x < 0) eighths = 4 - eighths, sign = -sign;

  // multiples of pi/4 and what their rounding left
  constexpr double kHigh[] = {0, 0x1.921fb54442d18p-1, 0x1.921fb54442d18p+0, 0x1.2d97c7f3321d2p+1,
                              0x1.921fb54442d18p+1};
  constexpr double kLow[] = {0, 0x1.1a62633145c07p-55, 0x1.1a62633145c07p-54, 0x1.a79394c9e8a0ap-54,
                             0x1.1a62633145c07p-53};
  const double atan_tail = ratio * tail(AtanRatio::kDouble, 1, ratio * ratio);
  const double magnitude =
      eighths == 0 ? ratio + atan_tail : kHigh[eighths] + (sign * ratio + (sign * atan_tail + kLow[eighths]));
  return y < 0 ? -magnitude : magnitude;
}

}  // namespace qtraj
