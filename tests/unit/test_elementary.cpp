#include <algorithm>
#include <cmath>

#include "math/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

// Error of `value` in units in the last place of the exact result, which long double holds to 2^-11 of them.
double ulps(double value, long double exact) {
  const double rounded = std::abs(static_cast<double>(exact));
  const double ulp = std::nextafter(rounded, INFINITY) - rounded;
  return static_cast<double>(std::abs(value - exact)) / ulp;
}

constexpr double kPi = 3.141592653589793;

}  // namespace

TEST_CASE("sine and cosine are within one ulp, up to 2^50 rad", "[elementary]") {
  test::Random random(1);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    const double range = i % 4 == 0 ? 1.0 : i % 4 == 1 ? 10.0 : i % 4 == 2 ? 6e6 : 0x1p50;
    const double x = random.uniform(-range, range);
    const qtraj::SinCos at = qtraj::sin_cos(x);
    worst = std::max({worst, ulps(at.sin, std::sin(static_cast<long double>(x))),
                      ulps(at.cos, std::cos(static_cast<long double>(x)))});
  }
  CHECK(worst < 1.0);
}

TEST_CASE("sine and cosine keep their digits beside multiples of a quarter turn", "[elementary][singular]") {
  double worst = 0;
  for (int quarters = -2000; quarters <= 2000; ++quarters) {
    double x = quarters * (kPi / 2);
    for (int step = 0; step < 5; ++step, x = std::nextafter(x, INFINITY)) {
      const qtraj::SinCos at = qtraj::sin_cos(x);
      if (x != 0) worst = std::max(worst, ulps(at.sin, std::sin(static_cast<long double>(x))));
      worst = std::max(worst, ulps(at.cos, std::cos(static_cast<long double>(x))));
    }
  }
  CHECK(worst < 1.0);
}

TEST_CASE("sine and cosine at 0, of denormals and of huge angles", "[elementary][singular]") {
  CHECK(qtraj::sin_cos(0.0).sin == 0.0);
  CHECK(qtraj::sin_cos(0.0).cos == 1.0);
  CHECK(qtraj::sin_cos(5e-324).sin == 5e-324);
  for (const double x : {1e15, 0x1p50, 1e16, 1e300, 1.7976931348623157e308}) {
    const qtraj::SinCos at = qtraj::sin_cos(x), opposite = qtraj::sin_cos(-x);
    CHECK(std::abs(at.sin * at.sin + at.cos * at.cos - 1.0) <= 4.5e-16);
    CHECK(opposite.sin == -at.sin);
    CHECK(opposite.cos == at.cos);
  }
  CHECK(qtraj::sin_cos(1e300).sin == qtraj::sin_cos(0x1p50).sin);
  CHECK(ulps(qtraj::sin_cos(0x1p50).sin, std::sin(static_cast<long double>(0x1p50))) < 1.0);
}

TEST_CASE("the arctangent is within two ulps in every direction", "[elementary]") {
  test::Random random(2);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    const double angle = random.uniform(-kPi, kPi), radius = std::exp2(random.uniform(-500, 500));
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    worst =
        std::max(worst, ulps(qtraj::atan2(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x))));
  }
  CHECK(worst < 2.0);
}

TEST_CASE("the arctangent on both sides of its switches", "[elementary][singular]") {
  double worst = 0;
  // directions at odd multiples of pi/8, where the reduction changes, and of pi/4, where the axes are exchanged
  for (const double tangent : {0.41421356237309503, 1.0, 2.414213562373095, 1e-300, 1e-8}) {
    for (const double nudge : {1.0, 1.0 + 0x1p-52, 1.0 - 0x1p-53}) {
      for (const double x : {1.0, -1.0}) {
        for (const double y : {tangent * nudge, -tangent * nudge}) {
          const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
          worst = std::max({worst, ulps(qtraj::atan2(y, x), exact)});
        }
      }
    }
  }
  CHECK(worst < 2.0);
  CHECK(qtraj::atan2(0.0, 0.0) == 0.0);
  CHECK(qtraj::atan2(0.0, 1.0) == 0.0);
  CHECK(qtraj::atan2(0.0, -1.0) == kPi);
  CHECK(qtraj::atan2(-0.0, -1.0) == kPi);
  CHECK(qtraj::atan2(1.0, 0.0) == kPi / 2);
  CHECK(qtraj::atan2(-1.0, 0.0) == -kPi / 2);
  CHECK(qtraj::atan2(1e-320, 1.0) == 1e-320);
  CHECK(qtraj::atan2(8e307, 8e307) == kPi / 4);
}
