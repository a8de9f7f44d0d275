// Derivatives from rates and rates from derivatives: error bounds on a million rows, curves of changing norm, and the
// range of double.
#include <qtraj.h>

#include <cstring>

#include "support/catch.hpp"
#include "support/hard_rows.hpp"

namespace {

using namespace test;
using wide::Real;

const int32_t kFrames[] = {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD};

wide::Quaternion pure(const wide::Vector& v) { return {0, v[0], v[1], v[2]}; }

// Where a rate stands beside q.
wide::Quaternion multiply_in(int32_t frame, const wide::Quaternion& q, const wide::Quaternion& rate) {
  return frame == QTRAJ_FRAME_BODY ? wide::multiply(q, rate) : wide::multiply(rate, q);
}

TEST_CASE("C API: derivatives are within 1.5 eps |omega| and eps (|omega|^2 + 2 |alpha|)", "[capi][derivatives]") {
  const std::vector<double>& q = hard_quaternions();
  const std::vector<double> omega = HardRows(51, 140).vectors(), alpha = HardRows(52, 280).vectors();
  std::vector<double> dq(4 * kHardRows), ddq(4 * kHardRows), dq_alone(4 * kHardRows);
  for (const int32_t frame : kFrames) {
    REQUIRE(qtraj_derivatives_from_rates(frame, q.data(), omega.data(), alpha.data(), kHardRows, dq.data(), ddq.data(),
                                         nullptr) == QTRAJ_OK);
    REQUIRE(qtraj_derivatives_from_rates(frame, q.data(), omega.data(), nullptr, kHardRows, dq_alone.data(), nullptr,
                                         nullptr) == QTRAJ_OK);
    CHECK(std::memcmp(dq.data(), dq_alone.data(), dq.size() * sizeof(double)) == 0);
    Worst worst, worst_second;
    // each frame on half of the rows
    for (size_t row = static_cast<size_t>(frame) % 2; row < kHardRows; row += 2) {
      const wide::Quaternion unit = wide::normalized(wide::quaternion(&q[4 * row])),
                             w = pure(wide::vector(&omega[3 * row])), a = pure(wide::vector(&alpha[3 * row]));
      // u'' = (u omega + u' ...)' step by step: u'' = u' omega / 2 + u alpha / 2
      const wide::Quaternion first = wide::scaled(0.5L, multiply_in(frame, unit, w)),
                             second = wide::scaled(
                                 0.5L, wide::sum(multiply_in(frame, first, w), multiply_in(frame, unit, a)));
      const Real speed = wide::norm(w);
      worst.add(row, wide::error(&dq[4 * row], first), static_cast<double>(1.5 * kEps * speed));
      worst_second.add(row, wide::error(&ddq[4 * row], second),
                       static_cast<double>(kEps * (speed * speed + 2 * wide::norm(a))));
    }
    CHECK(worst.ratio <= 1);
    CHECK(worst_second.ratio <= 1);
  }
}

// Rates of q / |q| by the quotient rule, an independent route: n' = <u, q'>, u' = (q' - n' u) / n,
// n'' = <u', q'> + <u, q''>, u'' = (q'' - n'' u - 2 n' u') / n.
struct WideRates {
  wide::Vector omega, alpha;
};
WideRates reference_rates(int32_t frame, const wide::Quaternion& q, const wide::Quaternion& dq,
                          const wide::Quaternion& ddq) {
  const Real n = wide::norm(q);
  const wide::Quaternion u = wide::scaled(1 / n, q);
  const Real dn = wide::dot(u, dq);
  const wide::Quaternion du = wide::scaled(1 / n, wide::sum(dq, wide::scaled(-dn, u)));
  const Real ddn = wide::dot(du, dq) + wide::dot(u, ddq);
  const wide::Quaternion ddu =
      wide::scaled(1 / n, wide::sum(ddq, wide::sum(wide::scaled(-ddn, u), wide::scaled(-2 * dn, du))));
  const wide::Quaternion inverse = wide::conjugate(u);
  return {wide::scaled(2, wide::vector_part(multiply_in(frame, inverse, du))),
          wide::scaled(2, wide::vector_part(multiply_in(frame, inverse, ddu)))};
}

TEST_CASE("C API: rates of a curve of any norm are within 6 eps of its derivatives' sizes", "[capi][derivatives]") {
  const std::vector<double>&q = hard_quaternions(), &dq_rows = hard_neighbours();
  const std::vector<double> ddq_rows = HardRows(53, 60).quaternions();
  // derivatives of all sizes beside q
  std::vector<double> dq(4 * kHardRows), ddq(4 * kHardRows), omega(3 * kHardRows), alpha(3 * kHardRows);
  const HardRows sizes(54, 70);
  for (size_t row = 0; row < kHardRows; ++row) {
    const double n = static_cast<double>(wide::norm(wide::quaternion(&q[4 * row]))),
                 dn = static_cast<double>(wide::norm(wide::quaternion(&dq_rows[4 * row])));
    for (size_t k = 4 * row; k < 4 * row + 4; ++k) {
      dq[k] = dq_rows[k] / dn * n * sizes.norm(row);
      ddq[k] = ddq_rows[k] * n * sizes.norm(3 * row);
    }
  }
  for (const int32_t frame : kFrames) {
    REQUIRE(qtraj_rates_from_derivatives(frame, q.data(), dq.data(), ddq.data(), kHardRows, omega.data(), alpha.data(),
                                         nullptr) == QTRAJ_OK);
    std::vector<double> omega_alone(3 * kHardRows);
    REQUIRE(qtraj_rates_from_derivatives(frame, q.data(), dq.data(), nullptr, kHardRows, omega_alone.data(), nullptr,
                                         nullptr) == QTRAJ_OK);
    CHECK(std::memcmp(omega.data(), omega_alone.data(), omega.size() * sizeof(double)) == 0);
    Worst worst, worst_alpha;
    for (size_t row = static_cast<size_t>(frame) % 2; row < kHardRows; row += 2) {
      const wide::Quaternion wide_q = wide::quaternion(&q[4 * row]), first = wide::quaternion(&dq[4 * row]),
                             second = wide::quaternion(&ddq[4 * row]);
      const Real n = wide::norm(wide_q), r = wide::norm(first) / n, s = wide::norm(second) / n;
      const WideRates reference = reference_rates(frame, wide_q, first, second);
      worst.add(row, wide::error(&omega[3 * row], reference.omega), static_cast<double>(6 * kEps * r) + kLeast);
      worst_alpha.add(row, wide::error(&alpha[3 * row], reference.alpha),
                      static_cast<double>(6 * kEps * (s + 2 * r * r)) + kLeast);
    }
    CHECK(worst.ratio <= 1);
    CHECK(worst_alpha.ratio <= 1);
  }
}

TEST_CASE("C API: a curve that grows while it turns has the rates of its direction", "[capi][derivatives]") {
  // q = exp(g t) q0 exp(omega t / 2 + alpha t^2 / 4) about a fixed axis, at t = 0: q' = g q + u', q'' = g^2 q + 2 g u'
  // + u''
  Random random(55);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion q0 = random.orientation();
    const Vector axis = random.direction();
    const double growth = random.uniform(-5, 5), rate = random.uniform(-3, 3), change = random.uniform(-3, 3);
    for (const int32_t frame : kFrames) {
      const double w[3] = {rate * axis[0], rate * axis[1], rate * axis[2]},
                   a[3] = {change * axis[0], change * axis[1], change * axis[2]};
      double dq[4], ddq[4], omega[3], alpha[3];
      REQUIRE(qtraj_derivatives_from_rates(frame, q0.data(), w, a, 1, dq, ddq, nullptr) == QTRAJ_OK);
      for (size_t k = 0; k < 4; ++k) {
        ddq[k] += growth * growth * q0[k] + 2 * growth * dq[k];
        dq[k] += growth * q0[k];
      }
      REQUIRE(qtraj_rates_from_derivatives(frame, q0.data(), dq, ddq, 1, omega, alpha, nullptr) == QTRAJ_OK);
      REQUIRE(wide::error(omega, wide::vector(w)) <= 1e-14);
      REQUIRE(wide::error(alpha, wide::vector(a)) <= 1e-13);
    }
  }
}

TEST_CASE("C API: derivatives agree with differences of a turning motion", "[capi][derivatives]") {
  // u(t) = exp(r(t) / 2) by the library, omega_body about a fixed axis: derivative of |r|
  const double axis[3] = {2.0 / 7, -3.0 / 7, 6.0 / 7}, rate = 0.8, change = -0.6, step = 1e-4;
  const auto at = [&](double t) {
    const double angle = 0.3 + rate * t + 0.5 * change * t * t;
    const double r[3] = {angle * axis[0], angle * axis[1], angle * axis[2]};
    Quaternion q;
    REQUIRE(qtraj_q_from_rotation_vector(r, 1, q.data(), nullptr) == QTRAJ_OK);
    return q;
  };
  const Quaternion before = at(-step), now = at(0), after = at(step);
  const double omega[3] = {rate * axis[0], rate * axis[1], rate * axis[2]},
               alpha[3] = {change * axis[0], change * axis[1], change * axis[2]};
  for (const int32_t frame : kFrames) {
    double dq[4], ddq[4];
    REQUIRE(qtraj_derivatives_from_rates(frame, now.data(), omega, alpha, 1, dq, ddq, nullptr) == QTRAJ_OK);
    for (size_t k = 0; k < 4; ++k) {
      CHECK(std::abs(dq[k] - (after[k] - before[k]) / (2 * step)) <= 1e-8);
      CHECK(std::abs(ddq[k] - (after[k] - 2 * now[k] + before[k]) / (step * step)) <= 1e-7);
    }
  }
}

TEST_CASE("C API: rates and derivatives past the range of double are NOT_FINITE, up to it right",
          "[capi][derivatives]") {
  const double one[4] = {1, 0, 0, 0}, big[4] = {0, 0, 1e160, 0}, small[4] = {0, 0, 5e-324, 0};
  const double still[3] = {};
  for (const int32_t frame : kFrames) {
    double dq[4], ddq[4], omega[3], alpha[3];
    const auto derivatives = [&](double w, double a) {
      const double rate[3] = {0, w, 0}, acceleration[3] = {a, 0, 0};
      return qtraj_derivatives_from_rates(frame, one, rate, acceleration, 1, dq, ddq, nullptr);
    };
    // |omega|^2 overflows, but not |omega|^2 / 4 here
    CHECK(derivatives(2e154, 0) == QTRAJ_OK);
    CHECK(std::abs(ddq[0] / -1e308 - 1) <= 4 * kEps);
    CHECK(derivatives(3e154, 0) == QTRAJ_E_NOT_FINITE);
    CHECK((std::isnan(dq[0]) && std::isnan(dq[2]) && std::isnan(ddq[0]) && std::isnan(ddq[1])));
    CHECK(derivatives(DBL_MAX, 0) == QTRAJ_E_NOT_FINITE);
    CHECK(derivatives(1, DBL_MAX) == QTRAJ_OK);
    CHECK((ddq[0] == -0.25 && ddq[1] == DBL_MAX / 2));
    CHECK(derivatives(1e-160, 0) == QTRAJ_OK);
    CHECK((dq[2] == 0.5e-160 && std::abs(ddq[0] + 0.25e-320) <= 2 * kLeast));
    // without alpha the square is not asked for
    const double fast[3] = {0, DBL_MAX, 0};
    CHECK(qtraj_derivatives_from_rates(frame, one, fast, nullptr, 1, dq, nullptr, nullptr) == QTRAJ_OK);
    CHECK(dq[2] == DBL_MAX / 2);
    CHECK(qtraj_derivatives_from_rates(frame, small, fast, still, 1, dq, ddq, nullptr) == QTRAJ_E_NOT_FINITE);

    const double unit_rate[4] = {0, 1, 0, 0}, none[4] = {};
    CHECK(qtraj_rates_from_derivatives(frame, big, unit_rate, none, 1, omega, alpha, nullptr) == QTRAJ_OK);
    CHECK((std::abs(std::abs(omega[2]) / 2e-160 - 1) <= 4 * kEps && alpha[0] == 0 && alpha[2] == 0));
    CHECK(qtraj_rates_from_derivatives(frame, small, unit_rate, none, 1, omega, alpha, nullptr) == QTRAJ_E_NOT_FINITE);
    CHECK((std::isnan(omega[0]) && std::isnan(alpha[0])));
    CHECK(qtraj_rates_from_derivatives(frame, small, small, small, 1, omega, alpha, nullptr) == QTRAJ_OK);
    CHECK((omega[0] == 0 && omega[1] == 0 && omega[2] == 0 && alpha[0] == 0));
    // the norm's own rate, however large, is no rate
    const double growth[4] = {0, 0, 1e300, 0};
    CHECK(qtraj_rates_from_derivatives(frame, big, growth, growth, 1, omega, alpha, nullptr) == QTRAJ_OK);
    CHECK((omega[0] == 0 && omega[1] == 0 && omega[2] == 0 && alpha[0] == 0 && alpha[1] == 0 && alpha[2] == 0));
  }
}

}  // namespace
