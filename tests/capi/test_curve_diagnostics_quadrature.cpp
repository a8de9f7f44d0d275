// Curve diagnostics against dense samples of qtraj_sample_rates, and the least norm of the normalised methods.
#include <cfloat>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

double length(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

struct Dense {
  double angle = 0, energy = 0, omega = 0, alpha = 0;
};

// Every segment in `pieces` parts, in each Gauss-Legendre of five points: an error below 1e-10 for curves this calm.
Dense integrate(const qtraj_trajectory* curve, const std::vector<double>& knots, size_t pieces) {
  constexpr double kNodes[] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr double kWeights[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                 0.2369268850561891};
  std::vector<double> times, widths;
  for (size_t i = 0; i + 1 < knots.size(); ++i)
    for (size_t piece = 0; piece < pieces; ++piece) {
      const double width = (knots[i + 1] - knots[i]) / static_cast<double>(pieces);
      widths.push_back(width);
      for (const double node : kNodes)
        times.push_back(knots[i] + width * (static_cast<double>(piece) + 0.5 + 0.5 * node));
    }
  const Motion<double> motion = must_sample_rates<double>(curve, QTRAJ_FRAME_WORLD, times);
  Dense dense;
  for (size_t i = 0; i < times.size(); ++i) {
    const double omega = length(&motion.omega[3 * i]), alpha = length(&motion.alpha[3 * i]);
    const double weight = 0.5 * widths[i / 5] * kWeights[i % 5];
    dense.angle += weight * omega;
    dense.energy += weight * alpha * alpha;
    dense.omega = std::max(dense.omega, omega);
    dense.alpha = std::max(dense.alpha, alpha);
  }
  return dense;
}

// Keys for every method, closed for those that need it.
Keyframes<double> keys_for(const Variant& variant, test::Random& random, double step) {
  if (variant.end == QTRAJ_END_PERIODIC) return closed_tour<double>(6);
  const test::Keys walk = test::random_walk(random, 6, step, 0.3, 2.0);
  return {walk.times, walk.q};
}

TEST_CASE("C API: energy, length and peaks are those of dense samples, for every method", "[capi][diagnostics]") {
  test::Random random(53);
  for (const double step : {0.2, 1.5})
    for (int round = 0; round < 4; ++round)
      for (const Variant& variant : variants()) {
        CAPTURE(variant.name, step, round);
        const Keyframes<double> keys = keys_for(variant, random, step);
        const Built built = build(make_options(variant).get(), keys, rates_for<double>(variant, 6));
        if (built.status == QTRAJ_E_AMBIGUOUS) continue;
        REQUIRE(built.status == QTRAJ_OK);
        const qtraj_trajectory* curve = built.trajectory.get();
        double energy = 0, angle = 0, omega = 0, alpha = 0, omega_time = 0, alpha_time = 0;
        REQUIRE(qtraj_curve_energy(curve, &energy) == QTRAJ_OK);
        REQUIRE(qtraj_curve_total_angle(curve, &angle) == QTRAJ_OK);
        REQUIRE(qtraj_curve_peak_rates(curve, &omega, &omega_time, &alpha, &alpha_time) == QTRAJ_OK);
        const Dense dense = integrate(curve, keys.times, 400);
        // where |omega| has a kink or nearly one, dense samples converge slowly
        CHECK(std::abs(angle - dense.angle) <= 2e-7 * dense.angle);
        CHECK(std::abs(energy - dense.energy) <= 1e-9 * dense.energy + 1e-25);
        // a maximum is at least every sample, and hardly more than the densest
        CHECK(omega >= dense.omega * (1 - 1e-12));
        CHECK(alpha >= dense.alpha * (1 - 1e-12));
        CHECK(omega <= dense.omega * (1 + 1e-2));
        CHECK(alpha <= dense.alpha * (1 + 5e-2) + 1e-12);
        // and it is there: on one side of the time named
        const auto at = [&](double time, bool of_omega) {
          double most = 0;
          for (const double near : {std::nextafter(time, -DBL_MAX), time}) {
            double q[4], rates[2][3];
            if (qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, near, nullptr, q, rates[0], rates[1]) == QTRAJ_OK)
              most = std::max(most, length(rates[of_omega ? 0 : 1]));
          }
          return most;
        };
        CHECK(std::abs(at(omega_time, true) - omega) <= 1e-9 * omega + 1e-14);
        CHECK(std::abs(at(alpha_time, false) - alpha) <= 1e-9 * alpha + 1e-12);
      }
}

TEST_CASE("C API: length and energy do not depend on the frame, the start or the sign of the keys",
          "[capi][diagnostics]") {
  test::Random random(59);
  for (const int32_t method : {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_SQUAD, QTRAJ_ROTATION_SPLINE}) {
    const test::Keys walk = test::random_walk(random, 7, 2.0, 0.3, 2.0);
    Keyframes<double> keys = {walk.times, walk.q}, moved = keys;
    const test::Quaternion turn = random.orientation();
    for (size_t i = 0; i < 7; ++i) {
      const test::Quaternion q = test::multiply(turn, walk.orientation(i));
      for (size_t k = 0; k < 4; ++k) moved.q[4 * i + k] = i % 2 == 0 ? -q[k] : q[k];
    }
    double results[2][2] = {};
    for (const auto* each : {&keys, &moved}) {
      const Trajectory curve = must_build(make_options({"", method}).get(), *each);
      REQUIRE(qtraj_curve_energy(curve.get(), &results[each == &moved][0]) == QTRAJ_OK);
      REQUIRE(qtraj_curve_total_angle(curve.get(), &results[each == &moved][1]) == QTRAJ_OK);
    }
    CAPTURE(method);
    CHECK(std::abs(results[0][0] - results[1][0]) <= 1e-10 * results[0][0] + 1e-25);
    CHECK(std::abs(results[0][1] - results[1][1]) <= 1e-10 * results[0][1]);
  }
}

// One turn about x from rest to rest, or with equal rates at both ends.
Trajectory quaternion_quintic(double half_angle, double rate, double duration) {
  const Variant variant = {"", QTRAJ_QUATERNION_QUINTIC};
  const Keyframes<double> keys = {{1, 1 + duration}, {1, 0, 0, 0, std::cos(half_angle), std::sin(half_angle), 0, 0}};
  Rates<double> rates = rates_for<double>(variant, 2, 0.0);
  rates.omega[0] = rates.omega[3] = rate;
  return must_build(make_options(variant).get(), keys, rates);
}

TEST_CASE("C API: least_norm of a quaternion quintic from rest to rest is that of the chord", "[capi][least_norm]") {
  for (const double half_angle : {0.1, 0.5, 1.0, 1.5707963267948966}) {
    CAPTURE(half_angle);
    const Trajectory curve = quaternion_quintic(half_angle, 0.0, 4.0);
    double norm = 0, time = 0;
    REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, &time) == QTRAJ_OK);
    CHECK(std::abs(norm - std::cos(0.5 * half_angle)) <= 1e-14);  // a half turn: sqrt(1/2)
    CHECK(std::abs(time - 3.0) <= 1e-6);
  }
}

TEST_CASE("C API: least_norm of fast ends is far lower, and is the least of dense values", "[capi][least_norm]") {
  // about one axis, the quintic through (1, 0) and (0, 1) with equal rates w: in s = 2u - 1 by its Hermite basis
  const auto norm_at = [](double w, double u) {
    const double u2 = u * u, u3 = u2 * u, u4 = u3 * u, u5 = u4 * u;
    const double h0 = 1 - 10 * u3 + 15 * u4 - 6 * u5, h1 = u - 6 * u3 + 8 * u4 - 3 * u5,
                 h2 = 0.5 * (u2 - 3 * u3 + 3 * u4 - u5), g0 = 1 - h0, g1 = -4 * u3 + 7 * u4 - 3 * u5,
                 g2 = 0.5 * (u3 - 2 * u4 + u5);
    // keys (1, 0), (0, 1); first derivatives (0, w/2), (-w/2, 0); second -w^2/4 times the keys
    const double x = h0 - 0.25 * w * w * h2 - 0.5 * w * g1, y = 0.5 * w * h1 + g0 - 0.25 * w * w * g2;
    return std::sqrt(x * x + y * y);
  };
  for (const double rate : {-6.0, 3.0, 10.0, 20.0, 24.0, 25.0}) {
    CAPTURE(rate);
    double least = 1, least_at = 0;
    for (int i = 0; i <= 200000; ++i) {
      const double u = i / 200000.0;
      if (norm_at(rate, u) < least) least = norm_at(rate, u), least_at = u;
    }
    const Trajectory curve = quaternion_quintic(1.5707963267948966, rate, 1.0);
    double norm = 0, time = 0;
    REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, &time) == QTRAJ_OK);
    CHECK(norm <= least + 1e-13);
    CHECK(norm >= least - 1e-6);
    CHECK(std::min(std::abs(time - 1 - least_at), std::abs(2 - time - least_at)) <= 1e-4);  // it may have two
    if (rate == 25.0) CHECK(norm < 0.02);
  }
}

TEST_CASE("C API: least_norm is 1 for the methods that do not normalise, at a time within the knots",
          "[capi][least_norm]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Trajectory curve =
        must_build(make_options(variant).get(), closed_tour<double>(6), rates_for<double>(variant, 6));
    double norm = 0, time = 1e9;
    REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, &time) == QTRAJ_OK);
    CHECK((time >= qtraj_start_time(curve.get()) && time <= qtraj_end_time(curve.get())));
    if (variant.method == QTRAJ_NLERP || variant.method == QTRAJ_QUATERNION_QUINTIC || variant.needs_tangents())
      CHECK((norm < 1 && norm > 0.5));
    else
      CHECK(norm == 1);
  }
}

TEST_CASE("C API: peaks and length of a quintic that passes close by 0 are found", "[capi][diagnostics][least_norm]") {
  // through (1, 0, 0, 0) and (0, 1, 0, 0) with the rate at which the quintic about x would hit 0; a little off the axis
  for (const double aside : {1e-2, 1e-3, 1e-4}) {
    CAPTURE(aside);
    const Variant variant = {"", QTRAJ_QUATERNION_QUINTIC};
    Rates<double> rates = rates_for<double>(variant, 2, 0.0);
    rates.omega[0] = rates.omega[3] = 25.099668870541507;
    const Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, 0, 1, aside, 0}};
    const Trajectory curve = must_build(make_options(variant).get(), keys, rates);
    double norm = 0, peak = 0, time = 0, angle = 0;
    REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, nullptr) == QTRAJ_OK);
    CHECK(norm < 3 * aside);
    REQUIRE(qtraj_curve_peak_rates(curve.get(), &peak, &time, nullptr, nullptr) == QTRAJ_OK);
    CHECK(std::abs(time - 0.5) <= 1e-3);
    CHECK(peak > 1 / aside);
    const Dense dense = integrate(curve.get(), keys.times, 100000);
    CHECK(peak >= dense.omega * (1 - 1e-9));
    REQUIRE(qtraj_curve_total_angle(curve.get(), &angle) == QTRAJ_OK);
    CHECK(std::abs(angle - dense.angle) <= 1e-9 * dense.angle);
  }
}

}  // namespace
