#include "math/quaternion.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

qtraj::Quaternion from(const test::Quaternion& q) { return {q[0], q[1], q[2], q[3]}; }

// | |value + error|^2 - 1 | without rounding the squares.
long double square_error(const qtraj::UnitQuaternion& unit) {
  long double error = -1;
  for (int k = 0; k < 4; ++k) {
    const double high = unit.value[k];
    const long double square = static_cast<long double>(high) * high;
    error += square + 2 * static_cast<long double>(high) * unit.error[k];
  }
  return std::abs(error);
}

}  // namespace

TEST_CASE("normalising keeps twice the digits, at every magnitude", "[quaternion]") {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double norm = std::exp2(random.uniform(-1000, 1000));
    const qtraj::Quaternion q = norm * from(random.orientation());
    const qtraj::Normalized result = qtraj::normalize(q);
    CHECK(square_error(result.unit) <= 1e-18L);  // what long double can tell
    CHECK(result.unit.error.cwiseAbs().maxCoeff() <= 2.3e-16);
    CHECK(std::abs(result.norm / norm - 1) <= 1e-15);
  }
}

TEST_CASE("normalising the smallest and the largest quaternions", "[quaternion][singular]") {
  for (const double magnitude : {5e-324, 1e-320, 2.2250738585072014e-308, 1e-160, 1e160, 1.7976931348623157e308}) {
    const qtraj::Normalized one = qtraj::normalize({0, -magnitude, 0, 0});
    CHECK(one.unit.value == qtraj::Quaternion(0, -1, 0, 0));
    CHECK(one.norm == magnitude);
    const qtraj::Normalized four = qtraj::normalize({magnitude, magnitude, -magnitude, magnitude});
    CHECK(four.unit.value == qtraj::Quaternion(0.5, 0.5, -0.5, 0.5));
  }
  // 2 DBL_MAX cannot be told
  const double largest = 1.7976931348623157e308;
  CHECK(qtraj::normalize({largest, largest, largest, largest}).norm == largest);
}

TEST_CASE("differences of neighbouring keys keep their relative accuracy", "[quaternion]") {
  // two keys 1e-15 rad apart, neither unit: the exact difference of the unit ones is known to first order
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    const qtraj::Quaternion a = from(random.orientation());
    qtraj::Quaternion b = a;
    b[i % 4] = std::nextafter(b[i % 4], 2.0);
    const double step = b[i % 4] - a[i % 4];
    const qtraj::Quaternion difference = qtraj::difference(qtraj::normalize(b).unit, qtraj::normalize(a).unit);
    qtraj::Quaternion expected = -step * a[i % 4] * a;
    expected[i % 4] += step;
    CHECK((difference - expected).norm() <= 1e-14 * step + 1e-31);
  }
}

TEST_CASE("the product is Hamilton's and rotates body vectors to world", "[quaternion]") {
  const qtraj::Quaternion i(0, 1, 0, 0), j(0, 0, 1, 0), k(0, 0, 0, 1);
  CHECK(qtraj::multiply(i, j) == k);
  CHECK(qtraj::multiply(j, k) == i);
  CHECK(qtraj::multiply(k, i) == j);
  CHECK(qtraj::multiply(i, i) == qtraj::Quaternion(-1, 0, 0, 0));

  test::Random random(3);
  for (int n = 0; n < 100; ++n) {
    const qtraj::Quaternion q = from(random.orientation());
    const test::Vector d = random.direction();
    const qtraj::Vector3 v(d[0], d[1], d[2]);
    const qtraj::Quaternion product = qtraj::multiply(qtraj::multiply(q, qtraj::quaternion(0, v)), qtraj::conjugate(q));
    CHECK((qtraj::rotate(q, v) - qtraj::vector_part(product)).norm() <= 1e-15);
  }
  // a quarter turn about z takes x to y
  const qtraj::Quaternion quarter(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  CHECK((qtraj::rotate(quarter, {1, 0, 0}) - qtraj::Vector3(0, 1, 0)).norm() <= 5e-16);
}
