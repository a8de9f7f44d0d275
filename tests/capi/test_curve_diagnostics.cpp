// Curve diagnostics against closed forms.
#include <cfloat>

#include "support/capi_variants.hpp"

using namespace capi;
using test::Quaternion;
using test::Vector;

namespace {

constexpr double kPi = 3.141592653589793;

struct Diagnosis {
  double omega, omega_time, alpha, alpha_time, energy, angle;
};
Diagnosis diagnose(const qtraj_trajectory* curve) {
  Diagnosis d{};
  REQUIRE(qtraj_curve_peak_rates(curve, &d.omega, &d.omega_time, &d.alpha, &d.alpha_time) == QTRAJ_OK);
  REQUIRE(qtraj_curve_energy(curve, &d.energy) == QTRAJ_OK);
  REQUIRE(qtraj_curve_total_angle(curve, &d.angle) == QTRAJ_OK);
  return d;
}

bool close(double value, double expected, double relative) {
  return std::abs(value - expected) <= relative * std::abs(expected);
}

void put(Keyframes<double>& keys, double time, const Quaternion& q) {
  keys.times.push_back(time);
  keys.q.insert(keys.q.end(), q.begin(), q.end());
}

TEST_CASE("C API: diagnostics of a quintic from rest to rest about one axis are its closed forms",
          "[capi][diagnostics]") {
  const Vector axis = {0.48, -0.6, 0.64};
  for (const double angle : {1e-6, 0.1, 1.0, 3.0})
    for (const double duration : {1e-3, 1.0, 40.0}) {
      CAPTURE(angle, duration);
      Keyframes<double> keys;
      const double start = 0.3;
      put(keys, start, test::about({1, 0, 0}, 0.7));
      put(keys, start + duration, test::multiply(test::about({1, 0, 0}, 0.7), test::about(axis, angle)));
      const double h = keys.times[1] - keys.times[0];
      const Variant variant = {"", QTRAJ_ROTATION_QUINTIC};
      const Trajectory curve = must_build(make_options(variant).get(), keys, rates_for<double>(variant, 2, 0.0));
      const Diagnosis d = diagnose(curve.get());
      CHECK(close(d.omega, 15.0 / 8.0 * angle / h, 1e-9));
      CHECK(std::abs(d.omega_time - (start + 0.5 * h)) <= 1e-6 * h);
      CHECK(close(d.alpha, 10.0 / std::sqrt(3.0) * angle / (h * h), 1e-9));
      const double u = (d.alpha_time - start) / h, at = (3.0 - std::sqrt(3.0)) / 6.0;
      CHECK(std::min(std::abs(u - at), std::abs(1.0 - u - at)) <= 1e-6);
      CHECK(close(d.energy, 120.0 / 7.0 * angle * angle / (h * h * h), 1e-9));
      CHECK(close(d.angle, angle, 1e-9));
    }
}

TEST_CASE("C API: diagnostics are right in any unit of time, as long as they themselves do not overflow",
          "[capi][diagnostics][extremes]") {
  // |alpha|^2 overflows from 1e-77 on, |alpha| only at 1e-154, the energy at 1e-103
  for (const double h : {1e-150, 1e-120, 1e-102, 1e-90, 1e-78, 1e-76, 1e-60, 1e60, 1e100}) {
    CAPTURE(h);
    const Keyframes<double> keys = {{0, h}, {1, 0, 0, 0, 1, 1, 0, 0}};
    const double angle = 0.5 * kPi;
    const Variant variant = {"", QTRAJ_ROTATION_QUINTIC};
    const Trajectory curve = must_build(make_options(variant).get(), keys, rates_for<double>(variant, 2, 0.0));
    double omega = 0, alpha = 0, energy = 0, length = 0;
    CHECK(qtraj_curve_peak_rates(curve.get(), &omega, nullptr, &alpha, nullptr) == QTRAJ_OK);
    CHECK(close(omega, 15.0 / 8.0 * angle / h, 1e-9));
    CHECK(close(alpha, 10.0 / std::sqrt(3.0) * angle / h / h, 1e-9));
    CHECK(qtraj_curve_energy(curve.get(), &energy) == (h > 1e-103 ? QTRAJ_OK : QTRAJ_E_NOT_FINITE));
    if (h > 1e-103) CHECK(close(energy, 120.0 / 7.0 * angle * angle / h / h / h, 1e-9));
    CHECK(qtraj_curve_total_angle(curve.get(), &length) == QTRAJ_OK);
    CHECK(close(length, angle, 1e-9));
  }
}

TEST_CASE("C API: diagnostics of a HERMITE cubic from rest to rest about one axis are its closed forms",
          "[capi][diagnostics]") {
  const double angle = 2.0, h = 3.0;
  Keyframes<double> keys;
  put(keys, 0, {1, 0, 0, 0});
  put(keys, h, test::about({0, 1, 0}, angle));
  const Variant variant = {"", QTRAJ_HERMITE};
  const Diagnosis d = diagnose(must_build(make_options(variant).get(), keys, rates_for<double>(variant, 2, 0.0)).get());
  CHECK(close(d.omega, 1.5 * angle / h, 1e-9));
  CHECK(std::abs(d.omega_time - 1.5) <= 1e-6);
  CHECK(close(d.alpha, 6.0 * angle / (h * h), 1e-9));
  CHECK((d.alpha_time == 0 || d.alpha_time == h));
  CHECK(close(d.energy, 12.0 * angle * angle / (h * h * h), 1e-9));
  CHECK(close(d.angle, angle, 1e-9));
}

TEST_CASE("C API: the length of SLERP and NLERP is the sum of their steps, and SLERP has no energy",
          "[capi][diagnostics]") {
  test::Random random(47);
  for (int round = 0; round < 30; ++round) {
    Keyframes<double> keys;
    Quaternion q = random.orientation();
    double time = random.uniform(-3, 3), sum = 0, fastest = 0, fastest_from = 0, fastest_to = 0;
    for (int key = 0; key < 9; ++key) {
      put(keys, time, q);
      const double step = random.uniform(1e-3, 3.1), next = time + random.uniform(0.1, 2.0);
      if (key == 8) break;
      sum += step;
      if (step / (next - time) > fastest) fastest = step / (next - time), fastest_from = time, fastest_to = next;
      q = test::multiply(q, test::about(random.direction(), step));
      time = next;
    }
    CAPTURE(round);
    const Diagnosis slerp = diagnose(must_build(make_options({"", QTRAJ_SLERP}).get(), keys).get());
    CHECK(close(slerp.angle, sum, 1e-9));
    CHECK(slerp.energy <= 1e-20 * fastest * fastest);
    CHECK(close(slerp.omega, fastest, 1e-12));
    CHECK((slerp.omega_time >= fastest_from && slerp.omega_time <= fastest_to));
    const Diagnosis nlerp = diagnose(must_build(make_options({"", QTRAJ_NLERP}).get(), keys).get());
    CHECK(close(nlerp.angle, sum, 1e-9));
  }
}

TEST_CASE("C API: NLERP is fastest in the middle of a step", "[capi][diagnostics]") {
  for (const double angle : {0.5, 2.0, 3.0}) {
    Keyframes<double> keys;
    put(keys, 1, {1, 0, 0, 0});
    put(keys, 3, test::about({0, 0, 1}, angle));
    const Diagnosis d = diagnose(must_build(make_options({"", QTRAJ_NLERP}).get(), keys).get());
    CHECK(close(d.omega, 4.0 * std::tan(angle / 4.0) / 2.0, 1e-12));  // chord over distance
    CHECK(std::abs(d.omega_time - 2.0) <= 1e-6);
  }
}

TEST_CASE("C API: a curve at rest has no rates, no energy, no length and no jumps", "[capi][diagnostics]") {
  const Keyframes<double> keys = {{0, 1, 3, 4, 9}, {1, 2, 3, 4, -1, -2, -3, -4, 1, 2, 3, 4, 2, 4, 6, 8, 1, 2, 3, 4}};
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Trajectory curve = must_build(make_options(variant, 0.0).get(), keys, rates_for<double>(variant, 5, 0.0));
    const Diagnosis d = diagnose(curve.get());
    CHECK((d.omega <= 1e-15 && d.alpha <= 1e-14 && d.energy <= 1e-28 && d.angle <= 1e-14));
    std::vector<double> omega(15), alpha(15);
    REQUIRE(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_WORLD, omega.data(), alpha.data()) == QTRAJ_OK);
    for (size_t k = 0; k < 15; ++k) CHECK((std::abs(omega[k]) <= 1e-15 && std::abs(alpha[k]) <= 1e-14));
  }
}

TEST_CASE("C API: the jump at a corner of SLERP is the change of its rate, in both frames", "[capi][diagnostics]") {
  // a quarter turn about x in 2 s, then one about the body's y in 1 s
  Keyframes<double> keys;
  const Quaternion corner = test::about({1, 0, 0}, 0.5 * kPi);
  put(keys, 0, {1, 0, 0, 0});
  put(keys, 2, corner);
  put(keys, 3, test::multiply(corner, test::about({0, 1, 0}, 0.5 * kPi)));
  const Trajectory curve = must_build(make_options({"", QTRAJ_SLERP}).get(), keys);
  const double before = 0.25 * kPi, after = 0.5 * kPi;
  const Vector body = {-before, after, 0}, world = {-before, 0, after};  // the body's y is the world's z there
  for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
    std::vector<double> omega(9, 7.0), alpha(9, 7.0);
    REQUIRE(qtraj_curve_jumps(curve.get(), frame, omega.data(), alpha.data()) == QTRAJ_OK);
    const Vector expected = frame == QTRAJ_FRAME_BODY ? body : world;
    for (size_t k = 0; k < 3; ++k) {
      CHECK(std::abs(omega[3 + k] - expected[k]) <= 1e-14);
      CHECK((omega[k] == 0 && omega[6 + k] == 0));
    }
    CHECK(alpha == std::vector<double>(9, 0.0));
  }
}

TEST_CASE("C API: a closed curve has its seam's jump at both ends, an open one 0", "[capi][diagnostics]") {
  for (const Variant& variant : variants())
    for (const bool wraps : {false, true})
      for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
        CAPTURE(variant.name, wraps, frame);
        const Keyframes<double> keys = closed_tour<double>(6);
        const Options options = make_options(variant);
        if (wraps)
          REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC,
                                                  QTRAJ_EXTRAPOLATE_PERIODIC) == QTRAJ_OK);
        const Trajectory curve = must_build(options.get(), keys, rates_for<double>(variant, 6));
        // where the curve repeats, its rates at the end are those of the start
        const Trajectory once = must_build(make_options(variant).get(), keys, rates_for<double>(variant, 6));
        const Motion<double> ends =
            must_sample_rates<double>(once.get(), frame, {keys.times.front(), keys.times.back()});
        std::vector<double> omega(18), alpha(18);
        REQUIRE(qtraj_curve_jumps(curve.get(), frame, omega.data(), alpha.data()) == QTRAJ_OK);
        const bool closed = wraps || variant.end == QTRAJ_END_PERIODIC;
        for (size_t k = 0; k < 3; ++k)
          for (const size_t row : {size_t{0}, size_t{15}}) {
            CHECK(std::abs(omega[row + k] - (closed ? ends.omega[k] - ends.omega[3 + k] : 0.0)) <= 1e-12);
            CHECK(std::abs(alpha[row + k] - (closed ? ends.alpha[k] - ends.alpha[3 + k] : 0.0)) <= 1e-11);
          }
      }
}

TEST_CASE("C API: jumps are rounding where the method is smooth, at the seam of PERIODIC too", "[capi][diagnostics]") {
  for (const Variant& variant : variants()) {
    if (variant.method == QTRAJ_SLERP || variant.method == QTRAJ_NLERP || variant.needs_tangents()) continue;
    CAPTURE(variant.name);
    const Keyframes<double> keys = closed_tour<double>(9);
    const Trajectory curve = must_build(make_options(variant).get(), keys, rates_for<double>(variant, 9));
    const Diagnosis d = diagnose(curve.get());
    std::vector<double> omega(27), alpha(27);
    REQUIRE(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_WORLD, omega.data(), alpha.data()) == QTRAJ_OK);
    const bool c1 = variant.method == QTRAJ_SQUAD || variant.method == QTRAJ_HERMITE;
    for (size_t k = 0; k < 27; ++k) {
      CHECK(std::abs(omega[k]) <= 1e-13 * d.omega);
      if (!c1) CHECK(std::abs(alpha[k]) <= 1e-12 * std::max(d.alpha, d.omega / 0.2));
    }
  }
}

}  // namespace
