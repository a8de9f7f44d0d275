#include "math/so3.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using qtraj::Quaternion;
using qtraj::UnitQuaternion;
using qtraj::Vector3;

constexpr double kEps = 0x1p-52, kPi = 3.141592653589793;

Vector3 direction(test::Random& random) {
  const test::Vector d = random.direction();
  return {d[0], d[1], d[2]};
}
UnitQuaternion unit(const Quaternion& q) { return qtraj::normalize(q).unit; }
UnitQuaternion random_unit(test::Random& random) {
  const test::Quaternion q = random.orientation();
  return unit({q[0], q[1], q[2], q[3]});
}

}  // namespace

TEST_CASE("the logarithm between two orientations inverts the exponential", "[so3][singular]") {
  test::Random random(1);
  const double angle = GENERATE(0.0, 1e-300, 1e-12, 1e-8, 1e-4, 1.0, 1.5707963, 1.5707964, 3.0, 3.14159);
  CAPTURE(angle);
  for (int i = 0; i < 50; ++i) {
    const Vector3 v = angle * direction(random);
    const Vector3 log = qtraj::relative_log(unit({1, 0, 0, 0}), unit(qtraj::exp_map(v)));
    // close to pi the axis is only known to eps / (pi - angle)
    CHECK((log - v).norm() <= 4 * kEps * angle * (1 + angle / (kPi - angle)));
  }
}

TEST_CASE("small steps between any two orientations keep their relative accuracy", "[so3]") {
  test::Random random(2);
  for (const double angle : {1e-3, 1e-8, 1e-12}) {
    for (int i = 0; i < 50; ++i) {
      // b = a exp(v) to twice the digits of double
      const UnitQuaternion a = random_unit(random);
      const Vector3 v = angle * direction(random);
      const Quaternion offset = qtraj::exp_map_minus_one(v);
      const Quaternion step = qtraj::multiply(a.value, offset) + qtraj::multiply(a.error, offset);
      UnitQuaternion b = {a.value + step, {}};
      b.error = ((a.value - b.value) + step) + a.error;
      CHECK((qtraj::relative_log(a, b) - v).norm() <= 8 * kEps * angle);
    }
  }
}

TEST_CASE("exp minus one is the exponential without its rounding", "[so3]") {
  test::Random random(3);
  for (const double angle : {0.0, 1e-200, 1e-9, 0.1, 1.0, 3.0}) {
    const Vector3 v = angle * direction(random);
    const Quaternion whole = qtraj::exp_map(v), part = qtraj::exp_map_minus_one(v);
    CHECK((whole - (part + Quaternion(1, 0, 0, 0))).norm() <= 4 * kEps);
    CHECK(std::abs(qtraj::vector_part(part).stableNorm() - std::sin(angle)) <= 4 * kEps * angle);
    CHECK(std::abs(part[0] + 0.5 * angle * angle) <= angle * angle * (angle * angle / 20 + 4 * kEps));
  }
}

TEST_CASE("unwrap continues a spin through every half and full turn", "[so3][unwrap]") {
  test::Random random(4);
  for (const double degrees : {10.0, 60.0, 90.0, 120.0, 170.0}) {
    const Vector3 axis = direction(random);
    const double half_step = 0.5 * degrees * kPi / 180;
    Vector3 p = Vector3::Zero();
    for (int i = 1; i * degrees <= 3600; ++i) {
      const UnitQuaternion q = unit(qtraj::exp_map(i * half_step * axis));
      p = qtraj::unwrap(qtraj::relative_rotation(unit({1, 0, 0, 0}), q), p, kEps);
      CAPTURE(degrees, i);
      CHECK((p - i * half_step * axis).norm() <= 8 * kEps * (1 + i * half_step));
    }
  }
}

TEST_CASE("unwrap at plus and minus the reference stays on the axis of the sequence", "[so3][unwrap][singular]") {
  const UnitQuaternion one = unit({1, 0, 0, 0}), minus_one = unit({-1, 0, 0, 0});
  const Vector3 axis = Vector3(1, 2, 2) / 3;
  const auto unwrapped = [&](const UnitQuaternion& q, double previous) {
    return qtraj::unwrap(qtraj::relative_rotation(one, q), previous * axis, kEps);
  };
  // even multiples of pi at 1, odd ones at -1, the nearest to the angle before
  CHECK((unwrapped(one, 0.1) - 0 * axis).norm() <= 1e-15);
  CHECK((unwrapped(one, 6.0) - 2 * kPi * axis).norm() <= 1e-14);
  CHECK((unwrapped(one, 12.0) - 4 * kPi * axis).norm() <= 1e-14);
  CHECK((unwrapped(minus_one, 3.0) - kPi * axis).norm() <= 1e-14);
  CHECK((unwrapped(minus_one, 9.0) - 3 * kPi * axis).norm() <= 1e-14);
  CHECK(unwrapped(one, 0.0) == Vector3::Zero());
  // within 16 eps of 1 the axis is noise
  const UnitQuaternion noisy = unit({1, 1e-15, -2e-15, 1e-15});
  CHECK((unwrapped(noisy, 6.2) - 2 * kPi * axis).norm() <= 1e-14);
  const UnitQuaternion clear = unit({1, 1e-13, 2e-13, 2e-13});
  CHECK((unwrapped(clear, 6.2) - (2 * kPi + 3e-13) * axis).norm() <= 1e-14);
}

TEST_CASE("the right Jacobian takes rates of the rotation vector to body rates", "[so3]") {
  test::Random random(5);
  // both sides of the switch at |r| = pi, and beyond a turn
  for (const double angle : {0.0, 1e-9, 0.5, 3.141592, 3.141594, 5.0, 7.0, 40.0}) {
    for (int i = 0; i < 20; ++i) {
      const Vector3 r = angle * direction(random), dr = direction(random);
      constexpr double kStep = 1e-4;
      const auto at = [&](double t) { return qtraj::exp_map(0.5 * (r + t * dr)); };
      // 2 q* q' by a central difference of fourth order
      const Quaternion dq = (8.0 * (at(kStep) - at(-kStep)) - (at(2 * kStep) - at(-2 * kStep))) / (12.0 * kStep);
      const Vector3 omega = 2.0 * qtraj::vector_part(qtraj::multiply(qtraj::conjugate(at(0)), dq));
      CAPTURE(angle);
      CHECK((qtraj::right_jacobian(r, dr) - omega).norm() <= 1e-10);
    }
  }
}

TEST_CASE("the inverse right Jacobian inverts it, up to a turn", "[so3]") {
  test::Random random(6);
  for (const double angle : {0.0, 1e-12, 0.5, 3.0, 3.141592, 3.141594, 6.0}) {
    for (int i = 0; i < 20; ++i) {
      const Vector3 r = angle * direction(random), w = direction(random);
      const Vector3 back = qtraj::right_jacobian(r, qtraj::inverse_right_jacobian(r, w));
      CAPTURE(angle);
      CHECK((back - w).norm() <= 3e-15 / (1 - angle / 6.3));
      const qtraj::Matrix3 jacobian = qtraj::jacobian_and_turning(r).jacobian;
      CHECK((qtraj::product(jacobian, w) - qtraj::right_jacobian(r, w)).norm() <= 2e-15);
    }
  }
}

TEST_CASE("the turning acceleration is the change of the right Jacobian along the way", "[so3]") {
  test::Random random(7);
  for (const double angle : {0.0, 1e-9, 0.5, 3.141592, 3.141594, 5.0}) {
    for (int i = 0; i < 20; ++i) {
      const Vector3 r = angle * direction(random), d = direction(random);
      constexpr double kStep = 1e-4;
      const auto jacobian = [&](double t) { return qtraj::right_jacobian(r + t * d, d); };
      // (Jr(r + t d) d)' at 0, fourth order
      const Vector3 expected =
          (8.0 * (jacobian(kStep) - jacobian(-kStep)) - (jacobian(2 * kStep) - jacobian(-2 * kStep))) / (12.0 * kStep);
      CAPTURE(angle);
      const qtraj::TurningFactors factors = qtraj::jacobian_and_turning(r).turning;
      CHECK((qtraj::turning_acceleration(factors, r, d) - expected).norm() <= 1e-11);
      CHECK(qtraj::turning_acceleration(factors, r, d) == qtraj::turning_acceleration(qtraj::turning_factors(r), r, d));

      // quadratic in d: its derivative is the exact difference over any step
      const Vector3 step = 0.25 * direction(random);
      const Vector3 difference =
          qtraj::turning_acceleration(factors, r, d + step) - qtraj::turning_acceleration(factors, r, d - step);
      CHECK((2.0 * qtraj::product(qtraj::turning_jacobian(factors, r, d), step) - difference).norm() <= 1e-14);
    }
  }
}

TEST_CASE("body and world vectors turn into each other", "[so3]") {
  const Quaternion quarter(std::sqrt(0.5), 0, 0, std::sqrt(0.5));  // body x is world y
  CHECK((qtraj::to_world(quarter, {1, 0, 0}) - Vector3(0, 1, 0)).norm() <= 5e-16);
  CHECK((qtraj::to_body(quarter, {0, 1, 0}) - Vector3(1, 0, 0)).norm() <= 5e-16);
}
