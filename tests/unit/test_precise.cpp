#include <cfloat>

#include "math/quaternion.hpp"
#include "math/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/hard_inputs.hpp"

namespace {

using qtraj::DoubleDouble;

long double wide(const DoubleDouble& a) { return static_cast<long double>(a.value) + a.error; }

DoubleDouble split(long double x) {
  const double value = static_cast<double>(x);
  return {value, static_cast<double>(x - value)};
}

}  // namespace

TEST_CASE("the precise arctangent is within a fifth of eps, for arguments of two doubles too", "[precise]") {
  test::Random random(1);
  long double worst = 0, worst_rounded = 0;
  for (int i = 0; i < 200000; ++i) {
    const double angle = test::hard_angle(random), radius = std::exp2(random.uniform(-300, 300));
    // the second doubles are those of a long double, or 0
    const bool exact = i % 2 == 0;
    const long double x = radius * (exact ? std::cos(angle) : std::cos(static_cast<long double>(angle))),
                      y = radius * (exact ? std::sin(angle) : std::sin(static_cast<long double>(angle)));
    if (y < 0) continue;
    const long double reference = std::atan2(y, x);
    const DoubleDouble found = qtraj::precise_atan2(split(y), split(x));
    if (reference == 0) continue;
    worst = std::max(worst, std::abs(wide(found) - reference) / reference);
    worst_rounded = std::max(worst_rounded, std::abs(found.value - reference) / reference);
  }
  CHECK(worst <= 0.2 * DBL_EPSILON);
  CHECK(worst_rounded <= 0.75 * DBL_EPSILON);
}

TEST_CASE("the precise arctangent on its axes and diagonals, and where it switches", "[precise][singular]") {
  const long double pi = 3.14159265358979323846264338327950288L;
  const auto at = [](double y, double x) { return wide(qtraj::precise_atan2({y, 0}, {x, 0})); };
  CHECK(at(0, 0) == 0);
  CHECK(at(0, 1) == 0);
  CHECK(std::abs(at(0, -1) - pi) < 1e-18);
  CHECK(std::abs(at(1, 0) - pi / 2) < 1e-18);
  CHECK(std::abs(at(1, 1) - pi / 4) < 1e-18);
  CHECK(std::abs(at(1, -1) - 3 * pi / 4) < 1e-18);
  for (const double tangent : {0.41421356237309503, 2.414213562373095})
    for (double y = tangent - 4e-16; y < tangent + 4e-16; y = std::nextafter(y, 3.0))
      for (const double x : {1.0, -1.0})
        CHECK(std::abs(at(y, x) - std::atan2(static_cast<long double>(y), static_cast<long double>(x))) <
              0.1 * DBL_EPSILON);
  // the second double alone tells the side of an axis
  CHECK(wide(qtraj::precise_atan2({1, 0}, {0, -1e-18})) > wide(qtraj::precise_atan2({1, 0}, {0, 1e-18})));
}

TEST_CASE("sine and cosine of an angle of two doubles are within eps", "[precise]") {
  test::Random random(2);
  long double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const long double angle = random.uniform(-100, 100) + random.uniform(-1e-14, 1e-14);
    const qtraj::SinCos found = qtraj::sin_cos(split(angle));
    worst = std::max({worst, std::abs(found.sin - std::sin(angle)), std::abs(found.cos - std::cos(angle))});
  }
  CHECK(worst <= DBL_EPSILON);
}

TEST_CASE("a precise length is the length in two doubles", "[precise]") {
  test::Random random(3);
  long double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const double factor = random.uniform(-1, 1);
    const qtraj::Quaternion a = {factor, random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const DoubleDouble found = qtraj::precise_length(a);
    const long double square = static_cast<long double>(a[0]) * a[0] + static_cast<long double>(a[1]) * a[1] +
                               static_cast<long double>(a[2]) * a[2] + static_cast<long double>(a[3]) * a[3];
    worst = std::max(worst, std::abs(wide(found) / std::sqrt(square) - 1));
  }
  CHECK(worst <= std::max(4 * LDBL_EPSILON, 1e-30L));  // long double may have more digits than two doubles
  CHECK(qtraj::precise_length({0, 0, 0, 0}).value == 0);
}
