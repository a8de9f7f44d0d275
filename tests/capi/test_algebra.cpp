// Products, norms, angles and rotations: error bounds on a million rows, and their singular cases.
#include <qtraj.h>

#include "support/catch.hpp"
#include "support/hard_rows.hpp"

namespace {

using namespace test;

const double kPi = static_cast<double>(wide::kPi);

TEST_CASE("C API: products are within 2 eps of the norms' product, or not finite where they overflow",
          "[capi][algebra]") {
  const std::vector<double>&a = hard_quaternions(), &b = hard_neighbours();
  std::vector<double> product(4 * kHardRows), dots(kHardRows);
  size_t product_fault = 0, dot_fault = 0;
  const qtraj_status status =
      qtraj_multiply(a.data(), kHardRows, b.data(), kHardRows, kHardRows, product.data(), &product_fault);
  const qtraj_status dot_status =
      qtraj_dot(a.data(), kHardRows, b.data(), kHardRows, kHardRows, dots.data(), &dot_fault);
  Worst worst, worst_dot;
  size_t first_overflow = SIZE_MAX, first_dot_overflow = SIZE_MAX, wrong = 0;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Quaternion p = wide::quaternion(&a[4 * row]), q = wide::quaternion(&b[4 * row]);
    const wide::Quaternion reference = wide::multiply(p, q);
    const wide::Real reference_dot = wide::dot(p, q), norms = std::sqrt(wide::dot(p, p) * wide::dot(q, q));
    const double bound = static_cast<double>(std::min<wide::Real>(2 * kEps * norms, DBL_MAX)) + kLeast;
    if (overflows(reference)) {
      first_overflow = std::min(first_overflow, row);
      for (size_t k = 0; k < 4; ++k) wrong += !std::isnan(product[4 * row + k]);
    } else {
      worst.add(row, wide::error(&product[4 * row], reference), bound);
    }
    if (std::abs(reference_dot) > DBL_MAX) {
      first_dot_overflow = std::min(first_dot_overflow, row);
      wrong += !std::isnan(dots[row]);
    } else {
      worst_dot.add(row, wide::error(&dots[row], std::array<wide::Real, 1>{reference_dot}), bound);
    }
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_dot.ratio <= 1);
  CHECK(wrong == 0);
  CHECK(status == QTRAJ_E_NOT_FINITE);
  CHECK(product_fault == first_overflow);
  CHECK(dot_status == QTRAJ_E_NOT_FINITE);
  CHECK(dot_fault == first_dot_overflow);
}

TEST_CASE("C API: conjugates are exact, inverses good to 2.5 eps and norms to 1.5 eps", "[capi][algebra]") {
  const std::vector<double>& q = hard_quaternions();
  std::vector<double> conjugate(4 * kHardRows), inverse(4 * kHardRows), norm(kHardRows);
  REQUIRE(qtraj_conjugate(q.data(), kHardRows, conjugate.data(), nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_inverse(q.data(), kHardRows, inverse.data(), nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_norm(q.data(), kHardRows, norm.data(), nullptr) == QTRAJ_OK);
  Worst worst_inverse, worst_norm;
  size_t wrong = 0;
  for (size_t row = 0; row < kHardRows; ++row) {
    const double* at = &q[4 * row];
    const double* conjugated = &conjugate[4 * row];
    wrong += !(conjugated[0] == at[0] && conjugated[1] == -at[1] && conjugated[2] == -at[2] && conjugated[3] == -at[3]);
    const wide::Quaternion wide_q = wide::quaternion(at);
    const wide::Real square = wide::dot(wide_q, wide_q), reference_norm = std::sqrt(square);
    for (size_t k = 0; k < 4; ++k) {
      const wide::Real reference = (k == 0 ? wide_q[k] : -wide_q[k]) / square;
      worst_inverse.add(row, static_cast<double>(std::abs(inverse[4 * row + k] - reference)),
                        static_cast<double>(2.5 * kEps * std::abs(reference)) + kLeast);
    }
    worst_norm.add(row, static_cast<double>(std::abs(norm[row] - reference_norm)),
                   static_cast<double>(1.5 * kEps * reference_norm));
  }
  CHECK(wrong == 0);
  CHECK(worst_inverse.ratio <= 1);
  CHECK(worst_norm.ratio <= 1);
}

TEST_CASE("C API: angles are good to 0.75 eps at every angle, sign and norm", "[capi][algebra]") {
  const std::vector<double>&a = hard_quaternions(), &b = hard_neighbours();
  std::vector<double> distance(kHardRows), angle(kHardRows);
  REQUIRE(qtraj_distance(a.data(), kHardRows, b.data(), kHardRows, kHardRows, distance.data(), nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_rotation_angle(a.data(), kHardRows, b.data(), kHardRows, kHardRows, angle.data(), nullptr) == QTRAJ_OK);
  // long double normalises to 1e-19: that is what it can tell of a tiny angle
  const double reference_error = 8 * static_cast<double>(std::numeric_limits<wide::Real>::epsilon());
  Worst worst_distance, worst_angle, worst_absolute;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Quaternion from = wide::quaternion(&a[4 * row]), to = wide::quaternion(&b[4 * row]);
    const wide::Real reference = wide::angle(from, to);
    const wide::Real reference_angle = 2 * std::min(reference, wide::angle(from, wide::scaled(-1, to)));
    const double error = static_cast<double>(std::abs(distance[row] - reference)),
                 angle_error = static_cast<double>(std::abs(angle[row] - reference_angle));
    worst_distance.add(row, error, static_cast<double>(0.75 * kEps * reference) + reference_error);
    worst_angle.add(row, angle_error, static_cast<double>(0.75 * kEps * reference_angle) + reference_error);
    worst_absolute.add(row, std::max(error, angle_error), 2 * kEps);
  }
  CHECK(worst_distance.ratio <= 1);
  CHECK(worst_angle.ratio <= 1);
  CHECK(worst_absolute.ratio <= 1);
}

TEST_CASE("C API: angles are exact at 0 and pi, and right to 2 eps for steps below rounding", "[capi][algebra]") {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion q = scaled(hard_norm(random, 160), random.orientation()), opposite = scaled(-1, q);
    double distance, angle;
    qtraj_distance(q.data(), 1, q.data(), 1, 1, &distance, nullptr);
    qtraj_rotation_angle(q.data(), 1, opposite.data(), 1, 1, &angle, nullptr);
    REQUIRE((distance == 0 && angle == 0));
    qtraj_distance(q.data(), 1, opposite.data(), 1, 1, &distance, nullptr);
    REQUIRE(distance == kPi);
  }
  // half turns apart, exactly
  const double one[4] = {0.5, 0.5, 0.5, 0.5}, other[4] = {0.5, 0.5, -0.5, -0.5};
  double distance, angle;
  qtraj_distance(one, 1, other, 1, 1, &distance, nullptr);
  qtraj_rotation_angle(one, 1, other, 1, 1, &angle, nullptr);
  CHECK(distance == kPi / 2);
  CHECK(angle == kPi);
  // 1 and 1 + step i differ by the angle `step`
  for (const double step : {1e-8, 1e-16, 1e-30, 1e-150, 1e-200, 1e-300, 5e-324}) {
    const double from[4] = {1, 0, 0, 0}, to[4] = {1, 0, step, 0};
    qtraj_distance(from, 1, to, 1, 1, &distance, nullptr);
    qtraj_rotation_angle(from, 1, to, 1, 1, &angle, nullptr);
    CHECK(std::abs(distance - step) <= kEps * step + kLeast);
    CHECK(std::abs(angle - 2 * step) <= 2 * kEps * step + 2 * kLeast);
  }
}

template <class Real, class Rotate>
double worst_rotation(Rotate&& rotate, double quaternion_decades, double vector_decades, double bound) {
  const std::vector<double> wide_q = HardRows(4, quaternion_decades).quaternions(),
                            wide_v = HardRows(5, vector_decades).vectors();
  const std::vector<Real> q(wide_q.begin(), wide_q.end()), v(wide_v.begin(), wide_v.end());
  std::vector<Real> world(3 * kHardRows);
  REQUIRE(rotate(q.data(), kHardRows, v.data(), kHardRows, kHardRows, world.data(), nullptr) == QTRAJ_OK);
  Worst worst;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Vector body = wide::vector(&v[3 * row]);
    const double error = wide::error(&world[3 * row], wide::rotate(wide::quaternion(&q[4 * row]), body));
    worst.add(
        row, error,
        bound * static_cast<double>(wide::norm(body)) + static_cast<double>(std::numeric_limits<Real>::denorm_min()));
  }
  return worst.ratio;
}

TEST_CASE("C API: rotations are within 5 eps of the vector's length, in float within half an ulp", "[capi][algebra]") {
  CHECK(worst_rotation<double>(qtraj_rotate, 160, 300, 5 * kEps) <= 1);
  CHECK(worst_rotation<float>(qtraj_rotate_f32, 30, 37, 0.5 * FLT_EPSILON + 5 * kEps) <= 1);
}

TEST_CASE("C API: a product of basis elements is exact, and zero is a quaternion like others", "[capi][algebra]") {
  const double units[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}, zero[4] = {};
  const int products[4][4] = {{1, 2, 3, 4}, {2, -1, 4, -3}, {3, -4, -1, 2}, {4, 3, -2, -1}};  // 1-based, with sign
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      double q[4];
      CHECK(qtraj_multiply(units[i], 1, units[j], 1, 1, q, nullptr) == QTRAJ_OK);
      for (int k = 0; k < 4; ++k)
        CHECK(q[k] == (k + 1 == std::abs(products[i][j]) ? (products[i][j] > 0 ? 1.0 : -1.0) : 0.0));
    }
  double q[4], number = 7;
  CHECK(qtraj_multiply(zero, 1, units[2], 1, 1, q, nullptr) == QTRAJ_OK);
  CHECK((q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0));
  CHECK(qtraj_conjugate(zero, 1, q, nullptr) == QTRAJ_OK);
  CHECK((q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0));
  CHECK(qtraj_norm(zero, 1, &number, nullptr) == QTRAJ_OK);
  CHECK(number == 0);
  number = 7;
  CHECK(qtraj_dot(zero, 1, units[1], 1, 1, &number, nullptr) == QTRAJ_OK);
  CHECK(number == 0);
}

TEST_CASE("C API: products and norms reach DBL_MAX and subnormal numbers, past them they are NOT_FINITE",
          "[capi][algebra][extremes]") {
  constexpr double kMost = DBL_MAX;
  double q[4], number;
  const auto product = [&](const Quaternion& a, const Quaternion& b) {
    return qtraj_multiply(a.data(), 1, b.data(), 1, 1, q, nullptr);
  };
  // parts overflow, the sum does not
  CHECK(product({kMost, kMost, 0, 0}, {0.5, -0.5, 0, 0}) == QTRAJ_OK);
  CHECK((q[0] == kMost && q[1] == 0));
  CHECK(product({kMost, kMost, 0, 0}, {1, 1, 0, 0}) == QTRAJ_E_NOT_FINITE);
  CHECK((std::isnan(q[0]) && std::isnan(q[3])));
  CHECK(product({5e-324, 0, 0, 0}, {0x1p1000, 0, 0, kMost}) == QTRAJ_OK);
  CHECK((q[0] == 0x1p-74 && q[3] == kMost * 0x1p-537 * 0x1p-537));
  CHECK(product({5e-324, 0, 0, 0}, {0, 0, 0, 5e-324}) == QTRAJ_OK);
  CHECK(q[3] == 0);

  const auto norm = [&](const Quaternion& a) { return qtraj_norm(a.data(), 1, &number, nullptr); };
  CHECK(norm({0, kMost, 0, 0}) == QTRAJ_OK);
  CHECK(number == kMost);
  CHECK(norm({0, kMost / 2, kMost / 2, kMost / 2}) == QTRAJ_OK);
  CHECK(std::abs(number / (kMost / 2) - std::sqrt(3.0)) <= 3 * kEps);
  CHECK(norm({kMost, kMost, 0, 0}) == QTRAJ_E_NOT_FINITE);
  CHECK(std::isnan(number));
  CHECK(norm({5e-324, 0, 0, 0}) == QTRAJ_OK);
  CHECK(number == 5e-324);
  const Quaternion large = {kMost, 0, 0, 0}, half = {kMost / 2, kMost / 2, 0, 0}, two = {2, 0, 0, 0},
                   opposite = {1, -1, 0, 0};
  CHECK(qtraj_dot(large.data(), 1, two.data(), 1, 1, &number, nullptr) == QTRAJ_E_NOT_FINITE);
  CHECK(qtraj_dot(half.data(), 1, opposite.data(), 1, 1, &number, nullptr) == QTRAJ_OK);
  CHECK(number == 0);

  const auto inverse = [&](double x) {
    const Quaternion a = {0, 0, x, 0};
    return qtraj_inverse(a.data(), 1, q, nullptr);
  };
  CHECK(inverse(5e-324) == QTRAJ_E_NOT_FINITE);
  CHECK(inverse(0x1p-1023) == QTRAJ_OK);
  CHECK(q[2] == -0x1p1023);
  CHECK(inverse(0x1p1023) == QTRAJ_OK);
  CHECK(q[2] == -0x1p-1023);
  CHECK(inverse(kMost) == QTRAJ_OK);
  CHECK(std::abs(q[2] + 1 / kMost) <= kLeast);

  // a vector turned onto an axis may leave double, one turned away from it comes back
  const double eighth[4] = {std::cos(std::atan(1) / 2), 0, 0, std::sin(std::atan(1) / 2)},
               corner[3] = {kMost, kMost, 0}, axis[3] = {kMost, 0, 5e-324};
  double turned[3];
  CHECK(qtraj_rotate(eighth, 1, corner, 1, 1, turned, nullptr) == QTRAJ_E_NOT_FINITE);
  CHECK((std::isnan(turned[0]) && std::isnan(turned[2])));
  CHECK(qtraj_rotate(eighth, 1, axis, 1, 1, turned, nullptr) == QTRAJ_OK);
  CHECK((std::abs(turned[0] / kMost - std::sqrt(0.5)) <= 5 * kEps && turned[2] <= 5e-324));
}

}  // namespace
