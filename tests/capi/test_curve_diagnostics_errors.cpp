// Curve diagnostics and faulty arguments, NULL outputs, and curves whose rates are out of range.
#include <cfloat>
#include <string>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

const std::string kNothing = "nothing";
constexpr size_t kKeys = 5;

Trajectory tour(const Variant& variant) {
  return must_build(make_options(variant).get(), closed_tour<double>(kKeys), rates_for<double>(variant, kKeys));
}

TEST_CASE("C API: diagnostics of a NULL handle, or without an output that must be there, are NULL",
          "[capi][diagnostics][errors]") {
  const Trajectory curve = tour({"", QTRAJ_SQUAD});
  double a = 7, b = 7, c = 7, d = 7, jumps[3 * kKeys] = {7};
  CHECK(qtraj_curve_jumps(nullptr, QTRAJ_FRAME_BODY, jumps, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_curve_jumps(nullptr, 0, jumps, jumps) == QTRAJ_E_NULL);
  CHECK(qtraj_curve_peak_rates(nullptr, &a, &b, &c, &d) == QTRAJ_E_NULL);
  CHECK(qtraj_curve_energy(nullptr, &a) == QTRAJ_E_NULL);
  CHECK(qtraj_curve_energy(curve.get(), nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_curve_total_angle(nullptr, &a) == QTRAJ_E_NULL);
  CHECK(qtraj_curve_total_angle(curve.get(), nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_curve_least_norm(nullptr, &a, &b) == QTRAJ_E_NULL);
  CHECK(qtraj_curve_least_norm(curve.get(), nullptr, &b) == QTRAJ_E_NULL);
  CHECK((a == 7 && b == 7 && c == 7 && d == 7 && jumps[0] == 7));
}

TEST_CASE("C API: curve_jumps judges frame, then overlap, and then leaves its outputs alone",
          "[capi][diagnostics][errors]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Trajectory curve = tour(variant);
    constexpr size_t kLength = 3 * kKeys;
    std::vector<double> block(3 * kLength, 7.0);
    const std::vector<double> untouched = block;
    double* out = block.data() + kLength;
    for (const int32_t frame : {0, 3, -1, 1000, INT32_MAX, INT32_MIN}) {
      CHECK(qtraj_curve_jumps(curve.get(), frame, out, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_curve_jumps(curve.get(), frame, out, out) == QTRAJ_E_VALUE);
      CHECK(qtraj_curve_jumps(curve.get(), frame, nullptr, nullptr) == QTRAJ_E_VALUE);
    }
    for (const ptrdiff_t shift : {ptrdiff_t{0}, ptrdiff_t{1}, ptrdiff_t{kLength} - 1, 1 - ptrdiff_t{kLength}})
      CHECK(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_BODY, out + shift, out) == QTRAJ_E_OVERLAP);
    CHECK(block == untouched);
    CHECK(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_BODY, out - kLength, out) == QTRAJ_OK);
    CHECK(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_BODY, out + kLength, out) == QTRAJ_OK);
  }
}

TEST_CASE("C API: every output of curve_jumps and curve_peak_rates may be NULL and the others are the same",
          "[capi][diagnostics]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Trajectory curve = tour(variant);
    std::vector<double> omega(3 * kKeys), alpha(3 * kKeys);
    REQUIRE(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_WORLD, omega.data(), alpha.data()) == QTRAJ_OK);
    std::vector<double> alone(3 * kKeys);
    CHECK(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_WORLD, alone.data(), nullptr) == QTRAJ_OK);
    CHECK(same_bits(alone, omega));
    CHECK(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_WORLD, nullptr, alone.data()) == QTRAJ_OK);
    CHECK(same_bits(alone, alpha));
    CHECK(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_WORLD, nullptr, nullptr) == QTRAJ_OK);

    std::vector<double> all(4);
    REQUIRE(qtraj_curve_peak_rates(curve.get(), &all[0], &all[1], &all[2], &all[3]) == QTRAJ_OK);
    for (unsigned subset = 0; subset < 16; ++subset) {
      std::vector<double> some = all;
      const auto at = [&](unsigned k) {
        if (subset >> k & 1) some[k] = -7;
        return (subset >> k & 1) != 0 ? &some[k] : nullptr;
      };
      CHECK(qtraj_curve_peak_rates(curve.get(), at(0), at(1), at(2), at(3)) == QTRAJ_OK);
      CHECK(same_bits(some, all));
    }
    double norm = 7, again = 7, time = 7;
    CHECK(qtraj_curve_least_norm(curve.get(), &norm, nullptr) == QTRAJ_OK);
    CHECK(qtraj_curve_least_norm(curve.get(), &again, &time) == QTRAJ_OK);
    CHECK(norm == again);
  }
}

TEST_CASE("C API: times of peaks and of the least norm are within the knots", "[capi][diagnostics]") {
  test::Random random(43);
  for (int round = 0; round < 40; ++round) {
    const test::Keys walk = test::random_walk(random, 4, 2.5, 0.01, 7.0);
    for (const Variant& variant : variants()) {
      if (variant.end == QTRAJ_END_PERIODIC) continue;
      const Built built = build(make_options(variant, 0.01).get(), Keyframes<double>{walk.times, walk.q},
                                rates_for<double>(variant, 4, 0.01));
      if (built.status != QTRAJ_OK) continue;
      double omega_time = 1e9, alpha_time = 1e9, norm = 0, norm_time = 1e9, q[4];
      REQUIRE(qtraj_curve_peak_rates(built.trajectory.get(), nullptr, &omega_time, nullptr, &alpha_time) == QTRAJ_OK);
      REQUIRE(qtraj_curve_least_norm(built.trajectory.get(), &norm, &norm_time) == QTRAJ_OK);
      CAPTURE(variant.name, round, omega_time, alpha_time, norm_time);
      for (const double time : {omega_time, alpha_time, norm_time})
        CHECK(qtraj_sample_at(built.trajectory.get(), time, nullptr, q) == QTRAJ_OK);
    }
  }
}

// What all diagnostics say of a curve, without a flag: OK and finite numbers, or NOT_FINITE and outputs left alone.
void check_all(const qtraj_trajectory* curve) {
  constexpr double kUntouched = -7;
  double values[8];
  qtraj_status status[4];
  std::vector<double> omega(3 * qtraj_key_count(curve)), alpha(omega.size());
  qtraj_status jumps = QTRAJ_OK;
  CHECK(disturbance([&] {
          std::fill(values, values + 8, kUntouched);
          status[0] = qtraj_curve_peak_rates(curve, &values[0], &values[1], &values[2], &values[3]);
        }) == kNothing);
  CHECK(disturbance([&] { status[1] = qtraj_curve_energy(curve, &values[4]); }) == kNothing);
  CHECK(disturbance([&] { status[2] = qtraj_curve_total_angle(curve, &values[5]); }) == kNothing);
  CHECK(disturbance([&] { status[3] = qtraj_curve_least_norm(curve, &values[6], &values[7]); }) == kNothing);
  for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD})
    CHECK(disturbance([&] { jumps = qtraj_curve_jumps(curve, frame, omega.data(), alpha.data()); }) == kNothing);
  const size_t first[] = {0, 4, 5, 6, 8};
  for (size_t call = 0; call < 4; ++call) {
    CAPTURE(call);
    CHECK((status[call] == QTRAJ_OK || (status[call] == QTRAJ_E_NOT_FINITE && call != 3)));
    for (size_t k = first[call]; k < first[call + 1]; ++k)
      CHECK((status[call] == QTRAJ_OK ? std::isfinite(values[k]) : values[k] == kUntouched));
  }
  bool any_nan = false;
  for (size_t i = 0; i < omega.size(); i += 3) {
    size_t finite = 0;
    for (size_t k = i; k < i + 3; ++k) finite += std::isfinite(omega[k]) + std::isfinite(alpha[k]);
    CHECK((finite == 0 || finite == 6));
    any_nan = any_nan || finite == 0;
  }
  CHECK(jumps == (any_nan ? QTRAJ_E_NOT_FINITE : QTRAJ_OK));
}

TEST_CASE("C API: diagnostics of intervals of any size are finite or NOT_FINITE, without a flag",
          "[capi][diagnostics][extremes]") {
  for (const double gap : {7.5e-155, 1e-154, 2e-154, 5e-154, 1e-153, 1e-150, 1e-120, 1e-80, 1e-40, 1e40, 1e150, 1e300})
    for (const Variant& variant : variants())
      for (const bool outside : {false, true}) {
        CAPTURE(variant.name, gap, outside);
        Keyframes<double> keys = closed_tour<double>(kKeys);
        for (size_t i = 0; i < kKeys; ++i) keys.times[i] = gap * static_cast<double>(i);
        const Options options = make_options(variant, 0.0);
        if (outside)
          REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC,
                                                  QTRAJ_EXTRAPOLATE_PERIODIC) == QTRAJ_OK);
        const Trajectory curve = must_build(options.get(), keys, rates_for<double>(variant, kKeys, 0.0));
        check_all(curve.get());
      }
}

TEST_CASE("C API: diagnostics near the largest rates are finite or NOT_FINITE, without a flag",
          "[capi][diagnostics][extremes]") {
  // accelerations around the largest number: of their length, not only of their components
  for (double gap = 1.5e-154; gap < 5e-154; gap *= 1.004) {
    CAPTURE(gap);
    const Variant variant = {"", QTRAJ_HERMITE};
    const Keyframes<double> keys = {{0, gap}, {1, 0, 0, 0, 1, 1, 1, 1}};
    check_all(must_build(make_options(variant).get(), keys, rates_for<double>(variant, 2, 0.0)).get());
  }
}

}  // namespace
