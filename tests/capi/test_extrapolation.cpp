// Times before the first and after the last knot.
#include <cfloat>

#include "support/capi_variants.hpp"
#include "support/ends.hpp"

using namespace capi;
using test::Quaternion;

namespace {

const double kBeyond[] = {5e-324, 1e-12, 1e-3, 0.5, 10.0, 1e6, 1e15, 1e300, DBL_MAX};

template <class Real>
Trajectory tour(const Variant& variant, int32_t before, int32_t after, size_t count = 7) {
  const Options options = make_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), before, after) == QTRAJ_OK);
  return must_build(options.get(), closed_tour<Real>(count), rates_for<Real>(variant, count));
}

Quaternion at(const qtraj_trajectory* trajectory, double time) {
  Quaternion q;
  REQUIRE(qtraj_sample_at(trajectory, time, nullptr, q.data()) == QTRAJ_OK);
  return q;
}

double distance(const Quaternion& a, const Quaternion& b) {
  double worst = 0;
  for (size_t k = 0; k < 4; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  return worst;
}

// Body rate at an end by differences of fourth order of the curve inside; inward: 1 at the start, -1 at the end.
test::Vector end_rate(const qtraj_trajectory* trajectory, double knot, double inward) {
  constexpr double kWeights[] = {-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -1.0 / 4.0};
  const double step = inward * 1e-4;
  Quaternion slope = {0, 0, 0, 0};
  for (int i = 0; i < 5; ++i) {
    const Quaternion q = at(trajectory, knot + i * step);
    for (size_t k = 0; k < 4; ++k) slope[k] += kWeights[i] * q[k] / step;
  }
  const Quaternion q = at(trajectory, knot);
  const Quaternion product = test::multiply({q[0], -q[1], -q[2], -q[3]}, slope);
  return {2 * product[1], 2 * product[2], 2 * product[3]};
}

// q turned for a time at a constant body rate.
Quaternion turned(const Quaternion& q, const test::Vector& omega, double time) {
  const double speed = std::sqrt(omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2]);
  if (speed == 0) return q;
  return test::multiply(q, test::about({omega[0] / speed, omega[1] / speed, omega[2] / speed}, speed * time));
}

TEST_CASE("C API: ERROR is the default on both sides: NaN and TIME_RANGE one step outside", "[capi][extrapolation]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      const Trajectory curve =
          must_build(make_options(variant).get(), closed_tour<Real>(5), rates_for<Real>(variant, 5));
      const double first = qtraj_start_time(curve.get()), last = qtraj_end_time(curve.get());
      Real q[4];
      CHECK(sample_at(curve.get(), first, nullptr, q) == QTRAJ_OK);
      CHECK(sample_at(curve.get(), last, nullptr, q) == QTRAJ_OK);
      for (const double time : {test::before_all(first, last), -DBL_MAX, test::after_all(first, last), DBL_MAX}) {
        CHECK(sample_at(curve.get(), time, nullptr, q) == QTRAJ_E_TIME_RANGE);
        CHECK((std::isnan(q[0]) && std::isnan(q[1]) && std::isnan(q[2]) && std::isnan(q[3])));
      }
    }
  });
}

TEST_CASE("C API: each side follows its own rule", "[capi][extrapolation]") {
  const int32_t rules[] = {QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE};
  for (const Variant& variant : variants()) {
    std::vector<Trajectory> symmetric;
    for (const int32_t rule : rules) symmetric.push_back(tour<double>(variant, rule, rule));
    for (const int32_t before : rules)
      for (const int32_t after : rules) {
        CAPTURE(variant.name, before, after);
        const Trajectory mixed = tour<double>(variant, before, after);
        for (const double time : {-5.5, 20.25}) {
          std::vector<double> q(4), expected(4);
          const int32_t rule = time < 0 ? before : after;
          const auto& like = symmetric[static_cast<size_t>(rule - QTRAJ_EXTRAPOLATE_ERROR)];
          CHECK(sample_at(mixed.get(), time, nullptr, q.data()) ==
                sample_at(like.get(), time, nullptr, expected.data()));
          CHECK((same_bits(q, expected) || (std::isnan(q[0]) && std::isnan(expected[0]))));
        }
      }
  }
}

TEST_CASE("C API: HOLD is the end key at any distance", "[capi][extrapolation]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      const Trajectory curve = tour<Real>(variant, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD);
      const size_t count = qtraj_key_count(curve.get());
      std::vector<double> keys(4 * count);
      REQUIRE(qtraj_keys(curve.get(), nullptr, keys.data()) == QTRAJ_OK);
      for (const double distance_in_time : kBeyond)
        for (const bool after : {false, true}) {
          CAPTURE(distance_in_time, after);
          const double first = qtraj_start_time(curve.get()), last = qtraj_end_time(curve.get());
          const double time = after ? std::max(test::after_all(first, last), distance_in_time)
                                    : std::min(test::before_all(first, last), -distance_in_time);
          double q[4];
          float q_f32[4];
          CHECK(qtraj_sample_at(curve.get(), time, nullptr, q) == QTRAJ_OK);
          CHECK(qtraj_sample_at_f32(curve.get(), time, nullptr, q_f32) == QTRAJ_OK);
          bool same = true;
          for (size_t k = 0; k < 4; ++k) {
            const double key = keys[after ? 4 * (count - 1) + k : k];
            same = same && q[k] == key && q_f32[k] == static_cast<float>(key);
          }
          CHECK(same);
        }
    }
  });
}

TEST_CASE("C API: HOLD keeps the bits of the end key, signs of zeros included", "[capi][extrapolation]") {
  const Keyframes<double> keys = {{0, 1}, {1, -0.0, 0.0, -0.0, 0.6, -0.0, 0.8, 0.0}};
  for (const int32_t method : all_methods()) {
    CAPTURE(method);
    const Options options = make_options({"", method});
    REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD) == QTRAJ_OK);
    const Trajectory curve = must_build(options.get(), keys, rates_for<double>({"", method}, keys.count()));
    std::vector<double> used(8);
    REQUIRE(qtraj_keys(curve.get(), nullptr, used.data()) == QTRAJ_OK);
    CHECK(same_bits(must_sample<double>(curve.get(), {-1.0, 2.0}), used));
  }
}

TEST_CASE("C API: CONSTANT_RATE goes on with the rate that the curve has at its end", "[capi][extrapolation]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      if (!variant.is_continuous()) continue;
      const Trajectory curve = tour<Real>(variant, QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_CONSTANT_RATE);
      for (const double inward : {1.0, -1.0}) {
        const double knot = inward > 0 ? qtraj_start_time(curve.get()) : qtraj_end_time(curve.get());
        const Quaternion key = at(curve.get(), knot);
        const test::Vector omega = end_rate(curve.get(), knot, inward);
        for (const double elapsed : {0.0, 1e-9, 1e-3, 0.1, 1.0, 7.0}) {
          CAPTURE(variant.name, inward, elapsed);
          const double time = knot - inward * elapsed;
          // differences are good to 1e-11
          CHECK(distance(at(curve.get(), time), turned(key, omega, time - knot)) <= 1e-10 * (1 + elapsed));
          float q_f32[4];
          CHECK(qtraj_sample_at_f32(curve.get(), time, nullptr, q_f32) == QTRAJ_OK);
          const Quaternion single = {q_f32[0], q_f32[1], q_f32[2], q_f32[3]};
          CHECK(distance(single, at(curve.get(), time)) <= 3e-7);
        }
      }
    }
  });
}

TEST_CASE("C API: CONSTANT_RATE takes given end rates in either frame", "[capi][extrapolation]") {
  const double omega_body[3] = {0.3, -0.2, 0.4};
  const Keyframes<double> keys = closed_tour<double>(5);
  for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
    const Options options = make_options({"", QTRAJ_SQUAD, QTRAJ_END_GIVEN});
    REQUIRE(qtraj_options_set_end_rates(options.get(), frame, omega_body, omega_body) == QTRAJ_OK);
    REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
                                            QTRAJ_EXTRAPOLATE_CONSTANT_RATE) == QTRAJ_OK);
    const Trajectory curve = must_build(options.get(), keys);
    for (const double time : {keys.times.front() - 2.0, keys.times.back() + 2.0}) {
      const double knot = time < 0 ? keys.times.front() : keys.times.back();
      const Quaternion key = at(curve.get(), knot);
      const Quaternion turn = turned({1, 0, 0, 0}, {0.3, -0.2, 0.4}, time - knot);
      const Quaternion expected = frame == QTRAJ_FRAME_BODY ? test::multiply(key, turn) : test::multiply(turn, key);
      CHECK(distance(at(curve.get(), time), expected) <= 1e-14);
    }
  }
}

TEST_CASE("C API: every rule gives unit quaternions at any distance", "[capi][extrapolation]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const int32_t rule : {QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_PERIODIC}) {
        const Trajectory curve = tour<Real>(variant, rule, rule);
        std::vector<double> times;
        for (const double far : kBeyond) times.insert(times.end(), {-3.0 - far, 12.0 + far});
        for (double far = 1e3; far < 1e17; far *= 1.7) times.insert(times.end(), {-far, far});
        for (const double& time : times) CHECK(std::isfinite(time));
        CAPTURE(variant.name, rule);
        CHECK(worst_norm_error(must_sample<double>(curve.get(), times)) <= 4);
        CHECK(worst_norm_error(must_sample<float>(curve.get(), times)) <= 4);
      }
  });
}

TEST_CASE("C API: PERIODIC wraps the time on either side", "[capi][extrapolation]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      if (!variant.is_continuous()) continue;
      const Trajectory curve = tour<Real>(variant, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC);
      const double first = qtraj_start_time(curve.get()), period = qtraj_end_time(curve.get()) - first;
      for (const double turns : {1.0, 2.0, 7.0, 1000.0, -1.0, -2.0, -9.0, -1000.0})
        for (const double u : {0.0, 0.1, 0.37, 0.5, 0.9}) {
          CAPTURE(variant.name, turns, u);
          const double inside = first + u * period;
          // times are rounded far out, and the curve turns at a few rad/s
          CHECK(distance(at(curve.get(), inside + turns * period), at(curve.get(), inside)) <=
                1e-14 * (1 + std::abs(turns)));
        }
    }
  });
}

TEST_CASE("C API: PERIODIC changes the sign at every wrap where the last key is minus the first",
          "[capi][extrapolation]") {
  Keyframes<double> keys;
  for (int i = 0; i <= 8; ++i) {
    const double half = 3.141592653589793 * i / 8;
    keys.times.push_back(0.5 * i);
    for (const double component : {std::cos(half), 0.6 * std::sin(half), 0.0, 0.8 * std::sin(half)})
      keys.q.push_back(component);
  }
  for (const int32_t method : all_methods()) {
    const Options options = make_options({"", method});
    REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
            QTRAJ_OK);
    const Trajectory curve = must_build(options.get(), keys, rates_for<double>({"", method}, keys.count()));
    for (const int turns : {1, 2, 3, -1, -2, -3})
      for (const double inside : {0.25, 1.0, 3.9}) {
        CAPTURE(method, turns, inside);
        Quaternion expected = at(curve.get(), inside);
        if (turns % 2 != 0)
          for (double& component : expected) component = -component;
        CHECK(distance(at(curve.get(), inside + 4.0 * turns), expected) <= 1e-14);
        float q_f32[4];
        CHECK(qtraj_sample_at_f32(curve.get(), inside + 4.0 * turns, nullptr, q_f32) == QTRAJ_OK);
        CHECK(distance({q_f32[0], q_f32[1], q_f32[2], q_f32[3]}, expected) <= 1e-6);
      }
    // and the curve is continuous where it wraps
    for (const double seam : {-4.0, 0.0, 4.0, 8.0})
      if (method != QTRAJ_STEP)
        CHECK(distance(at(curve.get(), std::nextafter(seam, -DBL_MAX)),
                       at(curve.get(), std::nextafter(seam, DBL_MAX))) <= 1e-14);
  }
}

TEST_CASE("C API: every rule but ERROR is continuous at both ends", "[capi][extrapolation]") {
  for (const Variant& variant : variants())
    for (const int32_t rule : {QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_PERIODIC}) {
      if (!variant.is_continuous()) continue;
      CAPTURE(variant.name, rule);
      const Trajectory curve = tour<double>(variant, rule, rule);
      for (const double knot : {qtraj_start_time(curve.get()), qtraj_end_time(curve.get())}) {
        const Quaternion there = at(curve.get(), knot);
        CHECK(distance(at(curve.get(), std::nextafter(knot, -DBL_MAX)), there) <= 2e-14);
        CHECK(distance(at(curve.get(), std::nextafter(knot, DBL_MAX)), there) <= 2e-14);
      }
    }
}

}  // namespace
