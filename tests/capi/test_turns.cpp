// Steps that turn by more than half a turn: by the signs of the keys, by numbers given, and by what the rates say.
#include <qtraj.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"
#include "support/catch.hpp"

using namespace capi;

namespace {

constexpr double kPi = 3.14159265358979323846;

Options with_turns(int32_t method, int32_t rule) {
  Options options = make_options({"", method});
  REQUIRE(qtraj_options_set_turns(options.get(), rule) == QTRAJ_OK);
  return options;
}

// Keys about a fixed axis at the angles, and rates of the same axis.
struct Turning {
  Keyframes<double> keys;
  Rates<double> rates;
};
const double kAxis[3] = {2.0 / 7, -3.0 / 7, 6.0 / 7};
Turning turning(const std::vector<double>& times, const std::vector<double>& angles, const std::vector<double>& speeds,
                bool with_alpha) {
  Turning t;
  t.keys.times = times;
  for (size_t i = 0; i < times.size(); ++i) {
    t.keys.q.push_back(std::cos(angles[i] / 2));
    for (const double a : kAxis) t.keys.q.push_back(a * std::sin(angles[i] / 2));
    for (const double a : kAxis) t.rates.omega.push_back(a * speeds[i]);
    for (int k = 0; with_alpha && k < 3; ++k) t.rates.alpha.push_back(0);
  }
  return t;
}

// Largest component by which a curve is off the orientation at an angle about the axis; signs must agree.
double off(const qtraj_trajectory* curve, double time, double angle, double sign = 1) {
  double q[4];
  REQUIRE(qtraj_sample_at(curve, time, nullptr, q) == QTRAJ_OK);
  double worst = std::abs(q[0] - sign * std::cos(angle / 2));
  for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(q[1 + k] - sign * kAxis[k] * std::sin(angle / 2)));
  return worst;
}
double speed_at(const qtraj_trajectory* curve, double time) {
  double omega[3];
  REQUIRE(qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, time, nullptr, nullptr, omega, nullptr) == QTRAJ_OK);
  return omega[0] * kAxis[0] + omega[1] * kAxis[1] + omega[2] * kAxis[2];
}

TEST_CASE("C API: each method takes its own rules for turns", "[capi][turns]") {
  for (const int32_t method : all_methods()) {
    const bool turns = method == QTRAJ_SLERP || method == QTRAJ_ROTATION_SPLINE || method == QTRAJ_HERMITE ||
                       method == QTRAJ_ROTATION_QUINTIC;
    const bool signs = turns || method == QTRAJ_QUATERNION_HERMITE;
    const bool of_rates = method == QTRAJ_HERMITE || method == QTRAJ_ROTATION_QUINTIC;
    const Options options = make_options({"", method});
    CAPTURE(method);
    CHECK(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_DEFAULT) == QTRAJ_OK);
    CHECK(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
    const qtraj_status some = turns ? QTRAJ_OK : QTRAJ_E_SETTING;
    CHECK(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_AS_GIVEN) == (signs ? QTRAJ_OK : QTRAJ_E_SETTING));
    CHECK(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_GIVEN) == some);
    CHECK(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_FROM_RATES) == (of_rates ? QTRAJ_OK : QTRAJ_E_SETTING));
    for (const int32_t unknown : {1, 700, 705, int32_t{QTRAJ_FRAME_BODY}, INT32_MIN})
      CHECK(qtraj_options_set_turns(options.get(), unknown) == QTRAJ_E_VALUE);
    CHECK(qtraj_options_set_turns(nullptr, QTRAJ_TURNS_SHORTEST) == QTRAJ_E_NULL);
  }
}

TEST_CASE("C API: a spinner comes back from its rows and rates, however long a row", "[capi][turns]") {
  const double speed = 18 * kPi / 180;
  for (const int32_t method : {QTRAJ_HERMITE, QTRAJ_ROTATION_QUINTIC})
    for (const double row : {8.0, 9.0, 10.0, 11.0, 12.5, 15.0, 17.0, 19.0, 20.0, 30.0, 40.0, 95.0})
      for (const double sign : {1.0, -1.0})
        for_double_and_float([&](auto zero) {
          using Real = decltype(zero);
          const bool is_float = sizeof(Real) == 4;
          std::vector<double> times, angles, speeds;
          for (int i = 0; i < 7; ++i) {
            times.push_back(row * i);
            angles.push_back(sign * speed * times.back());
            speeds.push_back(sign * speed);
          }
          const Turning given = turning(times, angles, speeds, method == QTRAJ_ROTATION_QUINTIC);
          const Keyframes<Real> keys = {given.keys.times, {given.keys.q.begin(), given.keys.q.end()}};
          const Rates<Real> rates = {{given.rates.omega.begin(), given.rates.omega.end()},
                                     {given.rates.alpha.begin(), given.rates.alpha.end()}};
          CAPTURE(method, row, sign, is_float);
          const Trajectory curve = must_build(make_options({"", method}).get(), keys, rates);
          double worst = 0, worst_rate = 0;
          for (double time = 0; time <= times.back(); time += 0.37) {
            worst = std::max(worst, off(curve.get(), time, sign * speed * time));
            worst_rate = std::max(worst_rate, std::abs(speed_at(curve.get(), time) - sign * speed));
          }
          CHECK(worst <= (is_float ? 4e-6 : 1e-12));
          CHECK(worst_rate <= (is_float ? 1e-6 : 1e-12));
          double angle = 7;
          size_t index = 99;
          CHECK(qtraj_rate_mismatch(curve.get(), &angle, &index) == QTRAJ_OK);
          CHECK(angle <= (is_float ? 1e-5 : 1e-12));
        });
}

// A body that tumbles slowly for 4 s: a turn by a about z, then by b about the body's x, so that
// omega_body = b' x + (turned back by b) a' z.
struct Tumble {
  Keyframes<double> keys;
  Rates<double> rates;
};
Tumble tumble(double row) {
  Tumble tumble;
  for (int i = 0; i * row < 4; ++i) {
    const double t = row * i, a = 0.9 * t, b = 0.5 * t;
    const double q[4] = {std::cos(a / 2) * std::cos(b / 2), std::cos(a / 2) * std::sin(b / 2),
                         std::sin(a / 2) * std::sin(b / 2), std::sin(a / 2) * std::cos(b / 2)};
    tumble.keys.times.push_back(t);
    tumble.keys.q.insert(tumble.keys.q.end(), q, q + 4);
    for (const double w : {0.5, 0.9 * std::sin(b), 0.9 * std::cos(b)}) tumble.rates.omega.push_back(w);
  }
  return tumble;
}

TEST_CASE("C API: the mismatch of good rates is of third order", "[capi][turns]") {
  const auto mismatch = [](double row) {
    const Tumble given = tumble(row);
    double angle = 0;
    const Trajectory curve = must_build(make_options({"", QTRAJ_HERMITE}).get(), given.keys, given.rates);
    REQUIRE(qtraj_rate_mismatch(curve.get(), &angle, nullptr) == QTRAJ_OK);
    return angle;
  };
  for (const double row : {0.4, 0.2, 0.1}) {
    CAPTURE(row);
    CHECK(mismatch(row) / mismatch(0.5 * row) > 7.5);
    CHECK(mismatch(row) / mismatch(0.5 * row) < 8.5);
  }
}

TEST_CASE("C API: the mismatch takes rates in the body frame in the middle of the step", "[capi][turns]") {
  // a step of 2 rad about z, and 1 rad/s about x at both ends: a rad off that axis on either side, and 2 rad short
  const Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, std::cos(1.0), 0, 0, std::sin(1.0)}};
  double angle = 0;
  size_t index = 7;
  const Trajectory curve =
      must_build(make_options({"", QTRAJ_HERMITE}).get(), keys, Rates<double>{{1, 0, 0, 1, 0, 0}, {}});
  REQUIRE(qtraj_rate_mismatch(curve.get(), &angle, &index) == QTRAJ_OK);
  CHECK(std::abs(angle - std::hypot(std::cos(1.0), 2.0)) <= 1e-14);
  CHECK(index == 0);
}

TEST_CASE("C API: the ends of a ROTATION_SPLINE count the turns of its steps", "[capi][turns]") {
  const double step = 8 * kPi / 3;  // 480 degrees: 120 and a whole turn
  const Turning t = turning({0, 2, 4, 6, 8}, {0, step, 2 * step, 3 * step, 4 * step}, {0, 0, 0, 0, 0}, false);
  const int32_t turns[4] = {1, 1, 1, 1};
  for (const int32_t end : {QTRAJ_END_ESTIMATED, QTRAJ_END_CHORD, QTRAJ_END_NATURAL}) {
    const Options options = with_turns(QTRAJ_ROTATION_SPLINE, QTRAJ_TURNS_GIVEN);
    REQUIRE(qtraj_options_set_ends(options.get(), end, end) == QTRAJ_OK);
    qtraj_trajectory* out = nullptr;
    REQUIRE(qtraj_create_with_turns(options.get(), 0, t.keys.times.data(), t.keys.q.data(), nullptr, nullptr, turns, 5,
                                    &out, nullptr) == QTRAJ_OK);
    const Trajectory curve(out);
    CAPTURE(end);
    for (double time = 0; time <= 8; time += 0.25) CHECK(std::abs(speed_at(curve.get(), time) - 0.5 * step) <= 1e-12);
  }
}

TEST_CASE("C API: rates that are not what they should be show as a mismatch", "[capi][turns]") {
  const Tumble given = tumble(0.1);
  const Keyframes<double>& keys = given.keys;
  const Rates<double>& rates = given.rates;
  const Options options = make_options({"", QTRAJ_HERMITE});
  const auto mismatch = [&](double scale, int32_t frame) {
    Rates<double> scaled = rates;
    for (double& w : scaled.omega) w *= scale;
    double angle = 0;
    REQUIRE(qtraj_rate_mismatch(must_build(options.get(), keys, scaled, frame).get(), &angle, nullptr) == QTRAJ_OK);
    return angle;
  };
  CHECK(mismatch(1, QTRAJ_FRAME_BODY) <= 1e-4);
  CHECK(mismatch(180 / kPi, QTRAJ_FRAME_BODY) > 0.4);  // degrees for radians
  CHECK(mismatch(-1, QTRAJ_FRAME_BODY) > 0.1);         // the sign: twice the step
  CHECK(mismatch(1, QTRAJ_FRAME_WORLD) > 0.05);        // world for body: of the size of the step, 0.1
  double angle = 7;
  size_t index = 7;
  CHECK(qtraj_rate_mismatch(nullptr, &angle, &index) == QTRAJ_E_NULL);
  CHECK((angle == 7 && index == 7));
}

TEST_CASE("C API: turns given, positive, negative and none, of every method that has them", "[capi][turns]") {
  const std::vector<double> times = {0, 1, 3, 4, 6};
  const std::vector<int32_t> turns = {0, 1, -1, 3};
  std::vector<double> angles = {0.3};
  const double steps[] = {1.2, 0.4 + 2 * kPi, 2.9 - 2 * kPi, 1.0 + 6 * kPi};
  for (const double step : steps) angles.push_back(angles.back() + step);
  for (const int32_t method : {QTRAJ_SLERP, QTRAJ_ROTATION_SPLINE, QTRAJ_HERMITE, QTRAJ_ROTATION_QUINTIC}) {
    CAPTURE(method);
    const bool has_rates = method >= QTRAJ_HERMITE, has_alpha = method > QTRAJ_HERMITE;
    const Turning t = turning(times, angles, {0.1, -0.2, 0.3, 0.1, 0}, has_alpha);
    // signs as a file may have them: all w >= 0
    Keyframes<double> keys = t.keys;
    for (size_t i = 0; i < 20; i += 4)
      if (keys.q[i] < 0)
        for (size_t k = i; k < i + 4; ++k) keys.q[k] = -keys.q[k];
    const Options options = with_turns(method, QTRAJ_TURNS_GIVEN);
    qtraj_trajectory* out = nullptr;
    REQUIRE(qtraj_create_with_turns(options.get(), QTRAJ_FRAME_BODY, keys.times.data(), keys.q.data(),
                                    has_rates ? t.rates.omega.data() : nullptr, t.rates.alpha_or_null(), turns.data(),
                                    5, &out, nullptr) == QTRAJ_OK);
    const Trajectory curve(out);
    const double sign = std::cos(angles[0] / 2) < 0 ? -1 : 1;
    for (size_t i = 0; i < 5; ++i) CHECK(off(curve.get(), times[i], angles[i], sign) <= 1e-14);
    // the turn of each step: the integral of the rate about the axis
    for (size_t i = 0; i < 4; ++i) {
      const int kPieces = 2000;
      double sum = 0;
      for (int k = 0; k < kPieces; ++k)
        sum += speed_at(curve.get(), times[i] + (times[i + 1] - times[i]) * (k + 0.5) / kPieces);
      CHECK(std::abs(sum * (times[i + 1] - times[i]) / kPieces - steps[i]) <= 1e-4);
    }
    // the same from float keys and in the caller's memory
    const std::vector<float> qf(keys.q.begin(), keys.q.end()), wf(t.rates.omega.begin(), t.rates.omega.end()),
        af(t.rates.alpha.begin(), t.rates.alpha.end());
    REQUIRE(qtraj_create_with_turns_f32(options.get(), QTRAJ_FRAME_BODY, keys.times.data(), qf.data(),
                                        has_rates ? wf.data() : nullptr, has_alpha ? af.data() : nullptr, turns.data(),
                                        5, &out, nullptr) == QTRAJ_OK);
    const Trajectory from_float(out);
    for (const double time : {0.5, 2.0, 3.5, 5.5}) {
      double q[4], single[4];
      REQUIRE(qtraj_sample_at(curve.get(), time, nullptr, q) == QTRAJ_OK);
      REQUIRE(qtraj_sample_at(from_float.get(), time, nullptr, single) == QTRAJ_OK);
      for (int k = 0; k < 4; ++k) CHECK(std::abs(q[k] - single[k]) <= 1e-5);
    }
    size_t bytes = 0;
    REQUIRE(qtraj_init_size(options.get(), 5, &bytes) == QTRAJ_OK);
    std::vector<double> memory(bytes / 8);
    REQUIRE(qtraj_init(memory.data(), bytes, options.get(), QTRAJ_FRAME_BODY, keys.times.data(), keys.q.data(),
                       has_rates ? t.rates.omega.data() : nullptr, t.rates.alpha_or_null(), turns.data(), 5, &out,
                       nullptr) == QTRAJ_OK);
    CHECK(
        same_bits(must_sample<double>(out, times_in(times, 9)), must_sample<double>(curve.get(), times_in(times, 9))));
  }
}

TEST_CASE("C API: AS_GIVEN goes the way that the signs say", "[capi][turns]") {
  for (const int32_t method : {QTRAJ_SLERP, QTRAJ_ROTATION_SPLINE, QTRAJ_HERMITE, QTRAJ_ROTATION_QUINTIC}) {
    CAPTURE(method);
    // 0, 270, 300, 200 degrees, half angles beyond a quarter turn: dot products below 0
    const std::vector<double> times = {0, 1, 2, 3}, angles = {0, 1.5 * kPi, 1.6 * kPi, 4.8 * kPi - 2 * kPi};
    const Turning t = turning(times, angles, {4, 3, 0, 0}, method > QTRAJ_HERMITE);
    const bool has_rates = method >= QTRAJ_HERMITE;
    const Options options = with_turns(method, QTRAJ_TURNS_AS_GIVEN);
    const Trajectory curve = must_build(options.get(), t.keys, has_rates ? t.rates : Rates<double>());
    CHECK(qtraj_sign_flips(curve.get()) == 0);
    for (size_t i = 0; i < 4; ++i) CHECK(off(curve.get(), times[i], angles[i]) <= 1e-14);
    if (method == QTRAJ_SLERP)
      for (const double u : {0.1, 0.5, 0.9}) {
        CHECK(off(curve.get(), u, u * angles[1]) <= 1e-14);
        CHECK(off(curve.get(), 2 + u, angles[2] + u * (angles[3] - angles[2])) <= 1e-14);
        CHECK(std::abs(speed_at(curve.get(), u) - angles[1]) <= 1e-13);
      }
  }
}

TEST_CASE("C API: loops of 720 degrees keep winding", "[capi][turns]") {
  // two turns a loop by three keys, each step 240 degrees: the signs of the closing key are those of the first
  for (const int32_t method : {QTRAJ_SLERP, QTRAJ_ROTATION_SPLINE, QTRAJ_HERMITE}) {
    CAPTURE(method);
    const double step = 4 * kPi / 3, speed = step / 2;
    const Turning t = turning({0, 2, 4, 6}, {0, step, 2 * step, 3 * step}, {speed, speed, speed, speed}, false);
    const Options options = with_turns(method, QTRAJ_TURNS_GIVEN);
    if (method == QTRAJ_ROTATION_SPLINE)
      REQUIRE(qtraj_options_set_ends(options.get(), QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC) == QTRAJ_OK);
    REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
            QTRAJ_OK);
    REQUIRE(qtraj_options_set_period(options.get(), 6) == QTRAJ_OK);
    const int32_t turns[3] = {-1, -1, -1};  // 240 = 120 the other way round
    qtraj_trajectory* out = nullptr;
    REQUIRE(qtraj_create_with_turns(options.get(), QTRAJ_FRAME_BODY, t.keys.times.data(), t.keys.q.data(),
                                    method == QTRAJ_HERMITE ? t.rates.omega.data() : nullptr, nullptr, turns, 3, &out,
                                    nullptr) == QTRAJ_OK);
    const Trajectory curve(out);
    for (double time = -20; time < 40; time += 0.3) {
      CAPTURE(time);
      CHECK(off(curve.get(), time, speed * time) <= 1e-13);
      CHECK(std::abs(speed_at(curve.get(), time) - speed) <= 1e-12);
    }
    double angle = 0;
    REQUIRE(qtraj_curve_total_angle(curve.get(), &angle) == QTRAJ_OK);
    CHECK(std::abs(angle - 4 * kPi) <= 1e-9);
  }
}

TEST_CASE("C API: a whole turn that ends where it began needs an axis", "[capi][turns][errors]") {
  const Keyframes<double> keys = {{0, 1, 2}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, -0.8, -0.6, 0, 0}};
  const int32_t turns[2] = {0, 1}, none[2] = {0, 0};
  for (const int32_t method : {QTRAJ_SLERP, QTRAJ_ROTATION_SPLINE}) {
    const Built as_given = build(with_turns(method, QTRAJ_TURNS_AS_GIVEN).get(), keys);
    CHECK(as_given.status == QTRAJ_E_AMBIGUOUS);
    CHECK(as_given.bad_index == 2);
    CHECK(as_given.trajectory == nullptr);
    const Options given = with_turns(method, QTRAJ_TURNS_GIVEN);
    qtraj_trajectory* out = nullptr;
    size_t bad = 0;
    CHECK(qtraj_create_with_turns(given.get(), 0, keys.times.data(), keys.q.data(), nullptr, nullptr, turns, 3, &out,
                                  &bad) == QTRAJ_E_AMBIGUOUS);
    CHECK((bad == 2 && out == nullptr));
    REQUIRE(qtraj_create_with_turns(given.get(), 0, keys.times.data(), keys.q.data(), nullptr, nullptr, none, 3, &out,
                                    &bad) == QTRAJ_OK);
    qtraj_destroy(out);
  }
  // rates tell the axis, but not where they are 0
  const Options hermite = with_turns(QTRAJ_HERMITE, QTRAJ_TURNS_GIVEN);
  Rates<double> rates = {{0, 0, 0, 0, 0, 1, 0, 0, 1}, {}};
  qtraj_trajectory* out = nullptr;
  size_t bad = 0;
  REQUIRE(qtraj_create_with_turns(hermite.get(), QTRAJ_FRAME_BODY, keys.times.data(), keys.q.data(), rates.omega.data(),
                                  nullptr, turns, 3, &out, &bad) == QTRAJ_OK);
  double q[4];
  CHECK(qtraj_sample_at(out, 1.5, nullptr, q) == QTRAJ_OK);
  const double half_turned[4] = {0, 0, -0.6, 0.8};  // the key times half a turn about the body's z
  for (int k = 0; k < 4; ++k) CHECK(std::abs(q[k] - half_turned[k]) <= 1e-15);
  qtraj_destroy(out);
  rates.omega.assign(9, 0.0);
  CHECK(qtraj_create_with_turns(hermite.get(), QTRAJ_FRAME_BODY, keys.times.data(), keys.q.data(), rates.omega.data(),
                                nullptr, turns, 3, &out, &bad) == QTRAJ_E_AMBIGUOUS);
  CHECK(bad == 2);
}

TEST_CASE("C API: a step that hardly turns, about another axis than its rates, is AMBIGUOUS", "[capi][turns][errors]") {
  const Options options = make_options({"", QTRAJ_HERMITE});
  for (const double noise : {1e-14, 1e-9, 4e-7}) {
    const Keyframes<double> keys = {{0, 1, 2}, {1, 0, 0, 0, 1, 0, 0, 0, 1, noise, 0, 0}};
    const Rates<double> spin = {{0, 0, 2 * kPi, 0, 0, 2 * kPi, 0, 0, 2 * kPi}, {}},
                        slow = {{0, 0, 2, 0, 0, 2, 0, 0, 2}, {}};
    CAPTURE(noise);
    const Built built = build(options.get(), keys, spin);
    CHECK(built.status == QTRAJ_E_AMBIGUOUS);
    CHECK(built.bad_index == 2);
    CHECK(build(options.get(), keys, slow).status == QTRAJ_OK);
    CHECK(build(with_turns(QTRAJ_HERMITE, QTRAJ_TURNS_SHORTEST).get(), keys, spin).status == QTRAJ_OK);
  }
  const Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, 1, 6e-7, 0, 0}};
  CHECK(build(options.get(), keys, Rates<double>{{0, 0, 2 * kPi, 0, 0, 2 * kPi}, {}}).status == QTRAJ_OK);
}

TEST_CASE("C API: the memory of a trajectory may begin where its turns end", "[capi][turns]") {
  const Keyframes<double> keys = {{0, 1, 2}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 1, 0, 0, 0}};
  const Options options = with_turns(QTRAJ_SLERP, QTRAJ_TURNS_GIVEN);
  size_t bytes = 0;
  REQUIRE(qtraj_init_size(options.get(), 3, &bytes) == QTRAJ_OK);
  std::vector<double> block(bytes / 8 + 1);
  auto* turns = reinterpret_cast<int32_t*>(block.data());
  turns[0] = turns[1] = 1;
  qtraj_trajectory* out = nullptr;
  const auto init_at = [&](void* memory) {
    return qtraj_init(memory, bytes, options.get(), 0, keys.times.data(), keys.q.data(), nullptr, nullptr, turns, 3,
                      &out, nullptr);
  };
  CHECK(init_at(block.data() + 1) == QTRAJ_OK);
  CHECK(init_at(block.data()) == QTRAJ_E_OVERLAP);
}

TEST_CASE("C API: turns that are missing, or not wanted", "[capi][turns][errors]") {
  const Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, 0.8, 0.6, 0, 0}};
  const int32_t turns[1] = {1};
  const Options given = with_turns(QTRAJ_SLERP, QTRAJ_TURNS_GIVEN), shortest = make_options({"", QTRAJ_SLERP});
  CHECK(build(given.get(), keys).status == QTRAJ_E_INPUT_MISSING);
  qtraj_trajectory* out = nullptr;
  const auto create_with = [&](const qtraj_options* options, const int32_t* numbers) {
    return qtraj_create_with_turns(options, 0, keys.times.data(), keys.q.data(), nullptr, nullptr, numbers, 2, &out,
                                   nullptr);
  };
  CHECK(create_with(given.get(), nullptr) == QTRAJ_E_NULL);
  CHECK(create_with(shortest.get(), turns) == QTRAJ_E_INPUT_UNWANTED);
  CHECK(create_with(nullptr, turns) == QTRAJ_E_NULL);
  CHECK(create_with(given.get(), turns) == QTRAJ_OK);
  qtraj_destroy(out);
}

TEST_CASE("C API: rates that add a nutation to a spin meet it, near whole turns too", "[capi][turns]") {
  // spin about z and a small tilt that moves: the curve has the rates given at its keys, and stays near the truth
  for (const double row : {12.0, 18.0, 20.0, 20.5, 22.0, 38.0, 40.0, 41.0}) {
    Keyframes<double> keys;
    Rates<double> rates;
    const double spin = 18 * kPi / 180, tilt = 0.02;
    for (int i = 0; i < 6; ++i) {
      const double t = row * i, a = spin * t, c = tilt * std::sin(0.01 * t), dc = tilt * 0.01 * std::cos(0.01 * t);
      keys.times.push_back(t);
      // turn by c about x, then by a about the body's z
      for (const double component : {std::cos(c / 2) * std::cos(a / 2), std::sin(c / 2) * std::cos(a / 2),
                                     -std::sin(c / 2) * std::sin(a / 2), std::cos(c / 2) * std::sin(a / 2)})
        keys.q.push_back(component);
      for (const double w : {dc * std::cos(a), -dc * std::sin(a), spin}) rates.omega.push_back(w);
    }
    CAPTURE(row);
    const Built built = build(make_options({"", QTRAJ_HERMITE}).get(), keys, rates);
    REQUIRE(built.status == QTRAJ_OK);
    for (size_t i = 0; i < 6; ++i) {
      double omega[3];
      REQUIRE(qtraj_sample_rates_at(built.trajectory.get(), QTRAJ_FRAME_BODY, keys.times[i], nullptr, nullptr, omega,
                                    nullptr) == QTRAJ_OK);
      for (size_t k = 0; k < 3; ++k) CHECK(std::abs(omega[k] - rates.omega[3 * i + k]) <= 1e-13);
    }
    double peak = 0;
    REQUIRE(qtraj_curve_peak_rates(built.trajectory.get(), &peak, nullptr, nullptr, nullptr) == QTRAJ_OK);
    CHECK(peak <= 1.5 * spin);
  }
}

}  // namespace
