// Inverses of lengths near 1, against long double.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include "math/unit_quaternion.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

struct Errors {
  long double inverse = 0, inverse_root = 0;  // relative
};

template <class Arithmetic>
Errors worst_errors() {
  test::Random random(1);
  Errors worst;
  for (int i = 0; i < 200000; ++i) {
    const double excess = i < 2 ? (i == 0 ? -0x1p-19 : 0x1p-19) : random.uniform(-0x1p-19, 0x1p-19);
    const long double square = 1.0L + static_cast<long double>(excess);
    const long double inverse = static_cast<long double>(qtraj::inverse_near_one<Arithmetic>(excess));
    const long double root = static_cast<long double>(qtraj::inverse_root_near_one<Arithmetic>(excess));
    worst.inverse = std::max(worst.inverse, std::abs(inverse * square - 1));
    worst.inverse_root = std::max(worst.inverse_root, std::abs(root * std::sqrt(square) - 1));
  }
  return worst;
}

}  // namespace

// half an ulp for the last rounding, and what the series leave out: 2^-57 and 5/16 of that
TEST_CASE("inverses near 1 are good to 0.57 eps", "[kernel]") {
  for (const Errors& worst : {worst_errors<qtraj::Plain>(), worst_errors<qtraj::Fused>()}) {
    CAPTURE(worst.inverse, worst.inverse_root);
    CHECK(worst.inverse <= 0.57L * DBL_EPSILON);
    CHECK(worst.inverse_root <= 0.57L * DBL_EPSILON);
  }
}

TEST_CASE("squares count as near 1 up to 2^-19 from it, exclusively", "[kernel]") {
  const double limit = 0x1p-19;
  CHECK(qtraj::is_near_one(0.0));
  CHECK(qtraj::is_near_one(std::nextafter(limit, 0)));
  CHECK(qtraj::is_near_one(-std::nextafter(limit, 0)));
  CHECK_FALSE(qtraj::is_near_one(limit));
  CHECK_FALSE(qtraj::is_near_one(-limit));
}
