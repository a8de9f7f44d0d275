// What a trajectory knows of itself.
#include <cfloat>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

TEST_CASE("C API: getters of a NULL handle give 0 or NaN", "[capi][getters][errors]") {
  CHECK(qtraj_method(nullptr) == 0);
  CHECK(qtraj_key_count(nullptr) == 0);
  CHECK(std::isnan(qtraj_start_time(nullptr)));
  CHECK(std::isnan(qtraj_end_time(nullptr)));
  CHECK(qtraj_sign_flips(nullptr) == 0);
  CHECK(std::isnan(qtraj_worst_norm_error(nullptr)));
  CHECK(std::isnan(qtraj_least_dot(nullptr)));
  CHECK(qtraj_iterations(nullptr) == 0);
  CHECK(std::isnan(qtraj_residual(nullptr)));
}

TEST_CASE("C API: getters describe the keys as given", "[capi][getters]") {
  // norms 2, 3, 0.5 and 1; the last two point away from the key before them
  const Keyframes<double> keys = {{-1, 0.5, 2, 7}, {2, 0, 0, 0, 0, 3, 0, 0, -0.3, -0.4, 0, 0, -1, 0, 0, 0}};
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    const Keyframes<Real> mine = {keys.times, std::vector<Real>(keys.q.begin(), keys.q.end())};
    for (const int32_t method : all_methods()) {
      CAPTURE(method);
      const Options options = make_options({"", method});
      REQUIRE(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
      const Trajectory curve = must_build(options.get(), mine, rates_for<Real>({"", method}, 4));
      CHECK(qtraj_method(curve.get()) == method);
      CHECK(qtraj_key_count(curve.get()) == 4);
      CHECK(qtraj_start_time(curve.get()) == -1.0);
      CHECK(qtraj_end_time(curve.get()) == 7.0);
      CHECK(qtraj_sign_flips(curve.get()) == 2);
      CHECK(qtraj_worst_norm_error(curve.get()) == 2.0);
      CHECK(qtraj_least_dot(curve.get()) == 0.0);
      if (method == QTRAJ_ROTATION_SPLINE) {
        CHECK(qtraj_iterations(curve.get()) > 0);
        CHECK((qtraj_residual(curve.get()) >= 0.0 && qtraj_residual(curve.get()) <= 1e-12));
      } else {
        CHECK(qtraj_iterations(curve.get()) == 0);
        CHECK(qtraj_residual(curve.get()) == 0.0);
      }

      double times[4], q[16];
      REQUIRE(qtraj_keys(curve.get(), times, q) == QTRAJ_OK);
      CHECK(std::equal(times, times + 4, keys.times.begin()));
      const double used[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0.6, 0.8, 0, 0, 1, 0, 0, 0};
      for (size_t k = 0; k < 16; ++k) CHECK(std::abs(q[k] - used[k]) <= 2 * std::numeric_limits<Real>::epsilon());
    }
  });
}

TEST_CASE("C API: the first key keeps its sign and a tie keeps the given sign", "[capi][getters]") {
  const Keyframes<double> keys = {{0, 1, 2}, {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0}};
  for (const int32_t method : all_methods()) {
    const Options options = make_options({"", method});
    REQUIRE(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
    const Trajectory curve = must_build(options.get(), keys, rates_for<double>({"", method}, 3));
    double q[12];
    REQUIRE(qtraj_keys(curve.get(), nullptr, q) == QTRAJ_OK);
    CHECK(std::equal(q, q + 12, keys.q.begin()));
    CHECK(qtraj_sign_flips(curve.get()) == 0);
  }
}

TEST_CASE("C API: keys come out unit and sign-continuous, in either array or both", "[capi][getters]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Keyframes<double> keys = closed_tour<double>(12);
    const Trajectory curve = must_build(make_options(variant).get(), keys, rates_for<double>(variant, 12));
    std::vector<double> times(12), q(48), alone(12), q_alone(48);
    CHECK(qtraj_keys(curve.get(), times.data(), q.data()) == QTRAJ_OK);
    CHECK(qtraj_keys(curve.get(), alone.data(), nullptr) == QTRAJ_OK);
    CHECK(qtraj_keys(curve.get(), nullptr, q_alone.data()) == QTRAJ_OK);
    CHECK(qtraj_keys(curve.get(), nullptr, nullptr) == QTRAJ_OK);
    CHECK(times == keys.times);
    CHECK(same_bits(alone, times));
    CHECK(same_bits(q_alone, q));
    CHECK(worst_norm_error(q) <= 4);
    double least = 1;
    for (size_t i = 4; i < 48; i += 4)
      least = std::min(least, q[i] * q[i - 4] + q[i + 1] * q[i - 3] + q[i + 2] * q[i - 2] + q[i + 3] * q[i - 1]);
    CHECK(least >= 0);
    CHECK(std::abs(least - qtraj_least_dot(curve.get())) <= 4 * DBL_EPSILON);
    // and the curve goes through them
    const std::vector<double> at_knots = must_sample<double>(curve.get(), times);
    double worst = 0;
    for (size_t k = 0; k < 48; ++k) worst = std::max(worst, std::abs(at_knots[k] - q[k]));
    CHECK(worst <= 16 * DBL_EPSILON);
  }
}

TEST_CASE("C API: keys refuses a NULL handle and overlapping outputs and then leaves them alone",
          "[capi][getters][errors]") {
  const Trajectory curve = must_build(make_options({"", QTRAJ_SLERP}).get(), closed_tour<double>(3));
  const std::vector<double> untouched(32, 7.0);
  std::vector<double> block = untouched;
  double* q = block.data() + 8;  // [12]
  CHECK(qtraj_keys(nullptr, block.data(), q) == QTRAJ_E_NULL);
  CHECK(qtraj_keys(nullptr, nullptr, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_keys(nullptr, q, q) == QTRAJ_E_NULL);
  CHECK(qtraj_keys(curve.get(), q, q) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_keys(curve.get(), q + 11, q) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_keys(curve.get(), q - 2, q) == QTRAJ_E_OVERLAP);
  CHECK(block == untouched);
  CHECK(qtraj_keys(curve.get(), q - 3, q) == QTRAJ_OK);
  CHECK(qtraj_keys(curve.get(), q + 12, q) == QTRAJ_OK);
  CHECK(block[4] == 7.0);
  CHECK(block[23] == 7.0);
}

TEST_CASE("C API: least_norm is that of NLERP's chords, 1 for other methods", "[capi][getters]") {
  // a right angle on S^3: the chord's middle is 1/sqrt 2 from the centre
  const Keyframes<double> keys = {{0, 2, 6, 7}, {1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}};
  for (const int32_t method : all_methods()) {
    CAPTURE(method);
    if (method == QTRAJ_QUATERNION_QUINTIC || needs_tangents(method)) continue;  // have tests of their own
    const Trajectory curve = must_build(make_options({"", method}).get(), keys, rates_for<double>({"", method}, 4));
    double norm = 7, time = 7;
    REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, &time) == QTRAJ_OK);
    if (method == QTRAJ_NLERP) {
      CHECK(std::abs(norm - std::sqrt(0.5)) <= 4 * DBL_EPSILON);
      CHECK(time == 4.0);
    } else {
      CHECK(norm == 1.0);
      CHECK((time >= 0.0 && time <= 7.0));
    }
    double again = 7;
    CHECK(qtraj_curve_least_norm(curve.get(), &again, nullptr) == QTRAJ_OK);
    CHECK(again == norm);
    CHECK(qtraj_curve_least_norm(curve.get(), nullptr, &time) == QTRAJ_E_NULL);
    norm = time = 7;
    CHECK(qtraj_curve_least_norm(nullptr, &norm, &time) == QTRAJ_E_NULL);
    CHECK((norm == 7 && time == 7));
  }
}

TEST_CASE("C API: the norm error of huge and tiny keys is finite and right", "[capi][getters]") {
  const auto error_of = [](double scale) {
    const Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, 0.6 * scale, 0.8 * scale, 0, 0}};
    return qtraj_worst_norm_error(must_build(make_options({"", QTRAJ_SLERP}).get(), keys).get());
  };
  CHECK(std::abs(error_of(1e160) - 1e160) <= 1e146);
  CHECK(error_of(1e-160) == 1.0);
  CHECK(std::abs(error_of(1.0001) - 1e-4) <= 1e-15);
  // the norm itself overflows
  const Keyframes<double> largest = {{0, 1}, {1, 0, 0, 0, DBL_MAX, DBL_MAX, -DBL_MAX, DBL_MAX}};
  const Trajectory curve = must_build(make_options({"", QTRAJ_SLERP}).get(), largest);
  CHECK(std::isfinite(qtraj_worst_norm_error(curve.get())));
  CHECK(qtraj_worst_norm_error(curve.get()) >= 0.9 * DBL_MAX);
}

}  // namespace
