// Rates that the caller gives: met at the keys, in the frame they are given in; and what each method needs.
#include <cfloat>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
const int32_t kFrames[] = {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD};
const int32_t kRateMethods[] = {QTRAJ_HERMITE, QTRAJ_ROTATION_QUINTIC, QTRAJ_QUATERNION_QUINTIC};

Rates<double> random_rates(test::Random& random, const Variant& variant, size_t count, double speed) {
  Rates<double> rates;
  for (size_t i = 0; i < 3 * count; ++i) {
    rates.omega.push_back(random.uniform(-speed, speed));
    if (variant.needs_alpha()) rates.alpha.push_back(random.uniform(-3 * speed, 3 * speed));
  }
  return rates;
}

struct Scale {
  double omega, alpha;
};
// Largest |omega|, and the larger of largest |alpha| and |omega|/h, of a curve.
Scale scale_of(const qtraj_trajectory* curve, const std::vector<double>& knots) {
  const Motion<double> motion = must_sample_rates<double>(curve, QTRAJ_FRAME_BODY, times_in(knots, 16));
  const auto length = [](const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); };
  double shortest = DBL_MAX;
  for (size_t i = 1; i < knots.size(); ++i) shortest = std::min(shortest, knots[i] - knots[i - 1]);
  Scale scale = {0, 0};
  for (size_t i = 0; i < motion.omega.size(); i += 3) {
    scale.omega = std::max(scale.omega, length(&motion.omega[i]));
    scale.alpha = std::max(scale.alpha, length(&motion.alpha[i]));
  }
  return {scale.omega, std::max(scale.alpha, scale.omega / shortest)};
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  return worst;
}

TEST_CASE("C API: given rates are met at the keys from both sides, in both frames", "[capi][given_rates]") {
  test::Random random(31);
  for (const int32_t method : kRateMethods)
    for (const int32_t frame : kFrames)
      for (int round = 0; round < 60; ++round) {
        CAPTURE(method, frame, round);
        const Variant variant = {"", method};
        const test::Keys walk = test::random_walk(random, 9, round % 2 == 0 ? 3.1 : 0.3, 0.2, 2.0);
        const Keyframes<double> keys = {walk.times, walk.q};
        const Rates<double> rates = random_rates(random, variant, 9, round % 3 == 0 ? 6.0 : 0.5);
        const Trajectory curve = must_build(make_options(variant).get(), keys, rates, frame);
        const Scale scale = scale_of(curve.get(), keys.times);

        const Motion<double> right = must_sample_rates<double>(curve.get(), frame, keys.times);
        CHECK(largest_difference(right.omega, rates.omega) <= 1e-13 * scale.omega);
        if (variant.needs_alpha()) CHECK(largest_difference(right.alpha, rates.alpha) <= 1e-13 * scale.alpha);
        // the left-hand values are less by the jumps
        std::vector<double> omega_jump(27), alpha_jump(27);
        REQUIRE(qtraj_curve_jumps(curve.get(), frame, omega_jump.data(), alpha_jump.data()) == QTRAJ_OK);
        CHECK(largest_difference(omega_jump, std::vector<double>(27)) <= 1e-13 * scale.omega);
        if (variant.needs_alpha())
          CHECK(largest_difference(alpha_jump, std::vector<double>(27)) <= 1e-13 * scale.alpha);
      }
}

TEST_CASE("C API: given end rates of SQUAD and ROTATION_SPLINE are met, in both frames", "[capi][given_rates]") {
  test::Random random(37);
  for (const int32_t method : {QTRAJ_SQUAD, QTRAJ_ROTATION_SPLINE})
    for (const int32_t frame : kFrames)
      for (int round = 0; round < 60; ++round) {
        CAPTURE(method, frame, round);
        const test::Keys walk = test::random_walk(random, 8, 2.5, 0.2, 2.0);
        double omega[2][3];
        for (auto& rate : omega)
          for (double& component : rate) component = random.uniform(-1, 1);
        const Options options = make_options({"", method, QTRAJ_END_GIVEN});
        REQUIRE(qtraj_options_set_end_rates(options.get(), frame, omega[0], omega[1]) == QTRAJ_OK);
        const Trajectory curve = must_build(options.get(), Keyframes<double>{walk.times, walk.q});
        const Motion<double> ends =
            must_sample_rates<double>(curve.get(), frame, {walk.times.front(), walk.times.back()});
        const std::vector<double> given = {omega[0][0], omega[0][1], omega[0][2],
                                           omega[1][0], omega[1][1], omega[1][2]};
        CHECK(largest_difference(ends.omega, given) <= 1e-13 * scale_of(curve.get(), walk.times).omega);
      }
}

TEST_CASE("C API: given tangents of SQUAD are met at the keys; a closed curve has one rate at its seam",
          "[capi][given_rates]") {
  test::Random random(41);
  for (const int32_t end : {QTRAJ_END_DEFAULT, QTRAJ_END_PERIODIC})
    for (const int32_t frame : kFrames)
      for (int round = 0; round < 30; ++round) {
        CAPTURE(end, frame, round);
        const Variant variant = {"", QTRAJ_SQUAD, end, QTRAJ_TANGENT_GIVEN};
        const Keyframes<double> keys = closed_tour<double>(9);
        Rates<double> rates = random_rates(random, variant, 9, 1.0);
        const Trajectory curve = must_build(make_options(variant).get(), keys, rates, frame);
        if (end == QTRAJ_END_PERIODIC) std::copy_n(rates.omega.begin(), 3, rates.omega.end() - 3);
        const Motion<double> at = must_sample_rates<double>(curve.get(), frame, keys.times);
        CHECK(largest_difference(at.omega, rates.omega) <= 1e-13 * scale_of(curve.get(), keys.times).omega);
      }
}

TEST_CASE("C API: rates are needed by some methods and refused by the others", "[capi][given_rates][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Keyframes<Real> keys = closed_tour<Real>(5);
    const std::vector<Real> omega(15), alpha(15);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      const Options options = make_options(variant);
      int stale = 0;
      size_t bad_index = 0;
      qtraj_trajectory* out = nullptr;
      const auto create_rates = [&](const Real* omega_in, const Real* alpha_in) {
        bad_index = 0;
        out = reinterpret_cast<qtraj_trajectory*>(&stale);
        const qtraj_status status = create_with_rates(options.get(), QTRAJ_FRAME_WORLD, keys.times.data(),
                                                      keys.q.data(), omega_in, alpha_in, 5, &out, &bad_index);
        CHECK(bad_index == SIZE_MAX);
        CHECK((out != nullptr) == (status == QTRAJ_OK));
        if (status == QTRAJ_OK) qtraj_destroy(out);
        return status;
      };
      const bool needs = variant.needs_rates(), needs_alpha = variant.needs_alpha(),
                 needs_tangents = variant.needs_tangents();
      CHECK(create_rates(omega.data(), nullptr) == (needs_alpha || needs_tangents ? QTRAJ_E_INPUT_MISSING
                                                    : needs                       ? QTRAJ_OK
                                                                                  : QTRAJ_E_INPUT_UNWANTED));
      CHECK(create_rates(omega.data(), alpha.data()) == (needs_alpha      ? QTRAJ_OK
                                                         : needs_tangents ? QTRAJ_E_INPUT_MISSING
                                                                          : QTRAJ_E_INPUT_UNWANTED));
      CHECK(create_rates(nullptr, alpha.data()) == QTRAJ_E_NULL);
      CHECK(create_rates(nullptr, nullptr) == QTRAJ_E_NULL);
      CHECK(build(options.get(), keys).status == (needs || needs_tangents ? QTRAJ_E_INPUT_MISSING : QTRAJ_OK));
      if (variant.end != QTRAJ_END_DEFAULT) continue;
      const bool plain_works = !always_needs_rates(variant.method) && !needs_tangents;
      const qtraj_status status = create(variant.method, keys.times.data(), keys.q.data(), 5, &out, nullptr);
      CHECK(status == (plain_works ? QTRAJ_OK : QTRAJ_E_INPUT_MISSING));
      qtraj_destroy(out);
    }
  });
}

TEST_CASE("C API: faulty given rates are NOT_FINITE with the index of their key", "[capi][given_rates][errors]") {
  for (const int32_t method : kRateMethods) {
    const Variant variant = {"", method};
    const double limit = method == QTRAJ_HERMITE ? 0x1p500 : 0x1p240;
    const Keyframes<double> keys = {{0, 1, 2, 3, 4}, closed_tour<double>(5).q};
    for (const int32_t frame : kFrames)
      for (const size_t key : {size_t{0}, size_t{2}, size_t{4}})
        for (const double bad : {kNaN, -kInfinity, DBL_MAX, -1e200, 1.01 * limit, 0.99 * limit})
          for (const bool in_alpha : {false, true}) {
            if (in_alpha && !variant.needs_alpha()) continue;
            CAPTURE(method, frame, key, bad, in_alpha);
            Rates<double> rates = rates_for<double>(variant, 5, 0.0);
            (in_alpha ? rates.alpha : rates.omega)[3 * key + 1] = bad;
            const Built built = build(make_options(variant).get(), keys, rates, frame);
            const bool fine = std::abs(bad) <= limit;
            CHECK(built.status == (fine ? QTRAJ_OK : std::isfinite(bad) ? QTRAJ_E_RATE_TOO_FAST : QTRAJ_E_NOT_FINITE));
            CHECK(built.bad_index == (fine ? SIZE_MAX : key));
            CHECK((built.trajectory != nullptr) == fine);
          }
  }
}

TEST_CASE("C API: of several faulty rates the lowest key is named", "[capi][given_rates][errors]") {
  for (const int32_t method : {QTRAJ_ROTATION_QUINTIC, QTRAJ_QUATERNION_QUINTIC}) {
    const Variant variant = {"", method};
    const Keyframes<double> keys = {{0, 1, 2, 1002, 1003}, closed_tour<double>(5).q};
    Rates<double> rates = rates_for<double>(variant, 5, 0.0);
    rates.omega[3 * 3] = 1e200;
    rates.alpha[3 * 2 + 2] = 0x1p238;  // too fast for the interval after it only
    const Built built = build(make_options(variant).get(), keys, rates);
    CHECK(built.status == QTRAJ_E_RATE_TOO_FAST);
    CHECK(built.bad_index == 2);
    rates.alpha[3 * 4] = kNaN;  // a NaN is found before any curve is made
    CHECK(build(make_options(variant).get(), keys, rates).bad_index == 4);
  }
}

}  // namespace
