// SQUAD with QTRAJ_TANGENT_REST: it rests at keys where a component reverses or stands, is limited elsewhere, and does
// not overshoot.
#include <cfloat>

#include "support/capi_variants.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

constexpr double kPi = 3.14159265358979323846;

Options resting(int32_t end = QTRAJ_END_DEFAULT) { return make_options({"", QTRAJ_SQUAD, end, QTRAJ_TANGENT_REST}); }

// A tilt that does not matter, and turns of it about one axis of the body.
constexpr test::Vector kAxis = {0.48, -0.6, 0.64};
test::Quaternion turned(double angle) { return test::multiply({0.5, -0.5, 0.5, 0.5}, test::about(kAxis, angle)); }
double angle_of(const double* q) {
  const test::Quaternion back = test::multiply({0.5, 0.5, -0.5, -0.5}, {q[0], q[1], q[2], q[3]});
  return 2 * std::atan2(back[1] * kAxis[0] + back[2] * kAxis[1] + back[3] * kAxis[2], back[0]);
}

Keyframes<double> keys_at(const std::vector<double>& times, const std::vector<double>& angles) {
  Keyframes<double> keys = {times, {}};
  for (const double angle : angles) {
    const test::Quaternion q = turned(angle);
    keys.q.insert(keys.q.end(), q.begin(), q.end());
  }
  return keys;
}

// Rates at the keys about the axis.
std::vector<double> speeds(const qtraj_trajectory* curve, const std::vector<double>& times) {
  const Motion<double> motion = must_sample_rates<double>(curve, QTRAJ_FRAME_BODY, times);
  std::vector<double> along;
  for (size_t i = 0; i < motion.omega.size(); i += 3)
    along.push_back(motion.omega[i] * kAxis[0] + motion.omega[i + 1] * kAxis[1] + motion.omega[i + 2] * kAxis[2]);
  return along;
}

TEST_CASE("C API: TANGENT_REST rests where steps reverse or stand, and is limited to 3 times the slower one",
          "[capi][squad][tangent_rest]") {
  const std::vector<double> times = {0, 1, 2, 4, 5, 6, 7}, angles = {0, 0.5, 0.2, 0.2, 0.3, 1.3, 1.4};
  const Trajectory curve = must_build(resting().get(), keys_at(times, angles));
  const std::vector<double> found = speeds(curve.get(), times);
  // chords 0.5, -0.3, 0, 0.1, 1, 0.1: CATMULL_ROM would have 0.55 at the last two, past 3 * 0.1
  const double expected[] = {0.5, 0, 0, 0, 0.3, 0.3, 0.1};
  for (size_t key = 0; key < 7; ++key) CHECK(std::abs(found[key] - expected[key]) <= 4e-15);
}

TEST_CASE("C API: TANGENT_REST is CATMULL_ROM up to the limit, on both sides of it", "[capi][squad][tangent_rest]") {
  const Options catmull_rom = make_options({"", QTRAJ_SQUAD, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_CATMULL_ROM});
  const std::vector<double> times = {0, 1, 3};
  for (const double sign : {1.0, -1.0})
    for (const double second : {0.2, 0.4, 0.6, 0.999999, 1.0, 1.000001, 1.2, 2.0}) {
      // chord rates 0.05 and second/2, means weighted 2 : 1: the limit is reached at (2 * 0.05 + second/2)/3 = 0.15
      CAPTURE(sign, second);
      const Keyframes<double> keys = keys_at(times, {0, sign * 0.05, sign * (0.05 + 0.7 * second)});
      const double mean = speeds(must_build(catmull_rom.get(), keys).get(), times)[1];
      const double found = speeds(must_build(resting().get(), keys).get(), times)[1];
      CHECK(std::abs(mean - sign * (0.1 + 0.35 * second) / 3) <= 1e-15);
      CHECK(std::abs(found - sign * std::min(std::abs(mean), 0.15)) <= 1e-15);
      CHECK((second >= 1.0) == (std::abs(found) > 0.1499999));
    }
}

TEST_CASE("C API: between two equal keys a curve with TANGENT_REST stands still: no rate at all, q to rounding",
          "[capi][squad][tangent_rest]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(3);
    for (int round = 0; round < 50; ++round) {
      const test::Keys walk = random_walk(random, 7, 2.5, 0.1, 3.0);
      Keyframes<Real> keys = {walk.times, std::vector<Real>(walk.q.begin(), walk.q.end())};
      for (size_t k = 0; k < 4; ++k) keys.q[16 + k] = (round % 2 == 0 ? 1 : -1) * keys.q[12 + k];  // keys 3 and 4
      const Trajectory curve = must_build(resting().get(), keys);
      std::vector<double> times;
      for (int i = 0; i <= 20; ++i) times.push_back(walk.times[3] + (walk.times[4] - walk.times[3]) * i / 21.0);
      const Motion<Real> motion = must_sample_rates<Real>(curve.get(), QTRAJ_FRAME_WORLD, times);
      CHECK(motion.omega == std::vector<Real>(3 * times.size()));
      CHECK(motion.alpha == std::vector<Real>(3 * times.size()));
      // blending two equal points rounds by the time
      const Real rounding = 4 * std::numeric_limits<Real>::epsilon();
      for (size_t i = 4; i < motion.q.size(); ++i) CHECK(std::abs(motion.q[i] - motion.q[i % 4]) <= rounding);
    }
  });
}

// By how much samples of a segment pass the keys at its ends, or turn back, relative to the largest angle.
double overshoot(const qtraj_trajectory* curve, const Keyframes<double>& keys, const std::vector<double>& angles) {
  constexpr size_t kPerSegment = 400;
  const std::vector<double> q = must_sample<double>(curve, times_in(keys.times, kPerSegment));
  double worst = 0;
  for (size_t i = 0; i + 1 < keys.count(); ++i) {
    const double direction = angles[i + 1] < angles[i] ? -1 : 1, step = direction * (angles[i + 1] - angles[i]);
    double reached = 0;
    for (size_t k = 0; k <= kPerSegment; ++k) {
      // the angle from the first key, whatever the sign of the sample
      const double off = std::remainder(angle_of(&q[4 * (i * kPerSegment + k)]) - angles[i], 2 * kPi);
      const double along = direction * off;
      test::raise_to(worst, reached - along);  // turns back
      test::raise_to(worst, along - step);     // passes the next key
      reached = std::max(reached, along);
    }
  }
  return worst;
}

TEST_CASE("C API: an ESTIMATED end of TANGENT_REST does not overshoot either", "[capi][squad][tangent_rest]") {
  // standing at first and at last; without the limit the curve leaves the keys by 7 degrees
  const double angles[] = {0, 0, 0.5 * kPi, 0.5 * kPi};
  Keyframes<double> keys;
  for (int i = 0; i < 4; ++i) {
    keys.times.push_back(i);
    for (const double component : turned(angles[i])) keys.q.push_back(component);
  }
  const Trajectory curve = must_build(resting(QTRAJ_END_ESTIMATED).get(), keys);
  std::vector<double> times;
  for (int i = 0; i <= 300; ++i) times.push_back(0.01 * i);
  const std::vector<double> q = must_sample<double>(curve.get(), times);
  for (size_t i = 0; i < times.size(); ++i) {
    CAPTURE(times[i]);
    CHECK(angle_of(&q[4 * i]) >= -4e-15);
    CHECK(angle_of(&q[4 * i]) <= 0.5 * kPi + 4e-15);
  }
}

TEST_CASE("C API: about one axis TANGENT_REST goes from key to key without turning back",
          "[capi][squad][tangent_rest]") {
  test::Random random(5);
  double worst = 0, of_catmull_rom = 0;
  for (int round = 0; round < 400; ++round) {
    const auto count = static_cast<size_t>(random.uniform(3, 9));
    std::vector<double> times, angles;
    double time = random.uniform(-5, 5), angle = random.uniform(-1, 1);
    for (size_t key = 0; key < count; ++key) {
      times.push_back(time), angles.push_back(angle);
      time += std::pow(round % 2 == 0 ? 3.0 : 100.0, random.uniform(-1, 0));
      // CHORD ends: no step is more than half a turn
      angle += random.uniform(0, 1) < 0.2 ? 0.0 : random.uniform(-1, 1) * (round % 3 == 0 ? 3.0 : 0.5);
    }
    const Keyframes<double> keys = keys_at(times, angles);
    test::raise_to(worst, overshoot(must_build(resting().get(), keys).get(), keys, angles));
    test::raise_to(of_catmull_rom,
                   overshoot(must_build(make_options({"", QTRAJ_SQUAD}).get(), keys).get(), keys, angles));
  }
  CAPTURE(worst);
  CHECK(worst <= 4e-15);
  CHECK(of_catmull_rom > 0.1);
}

TEST_CASE("C API: TANGENT_REST judges each component in the body frame of its key", "[capi][squad][tangent_rest]") {
  // small turns: about x to and fro, about y on and on
  const double xs[] = {0, 1e-3, 0, 1e-3}, ys[] = {0, 1e-3, 2e-3, 3e-3};
  Keyframes<double> keys = {{0, 1, 2, 3}, {}};
  for (size_t key = 0; key < 4; ++key) keys.q.insert(keys.q.end(), {1, xs[key] / 2, ys[key] / 2, 0});
  const Trajectory curve = must_build(resting().get(), keys);
  const Motion<double> at = must_sample_rates<double>(curve.get(), QTRAJ_FRAME_BODY, {1, 2});
  for (const size_t row : {size_t{0}, size_t{3}}) {
    CHECK(std::abs(at.omega[row]) <= 1e-15);
    CHECK(std::abs(at.omega[row + 1] - 1e-3) <= 2e-9);
  }
}

TEST_CASE("C API: TANGENT_REST is C1 and does not see signs; PERIODIC ends follow it at the seam",
          "[capi][squad][tangent_rest]") {
  test::Random random(7);
  for (const int32_t end : {QTRAJ_END_DEFAULT, QTRAJ_END_ESTIMATED, QTRAJ_END_PERIODIC})
    for (int round = 0; round < 20; ++round) {
      Keyframes<double> keys = closed_tour<double>(9);
      for (double& time : keys.times) time += random.uniform(0, 0.1);
      const Trajectory curve = must_build(resting(end).get(), keys);
      std::vector<double> jumps(27);
      REQUIRE(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_WORLD, jumps.data(), nullptr) == QTRAJ_OK);
      for (const double jump : jumps) CHECK(std::abs(jump) <= 1e-13);
      const std::vector<double> times = times_in(keys.times, 9), q = must_sample<double>(curve.get(), times);
      for (size_t key = 1; key < 9; key += 2)
        for (size_t k = 4 * key; k < 4 * key + 4; ++k) keys.q[k] = -keys.q[k];
      CHECK(must_sample<double>(must_build(resting(end).get(), keys).get(), times) == q);
    }
  // to and fro: at the seam the steps on both sides reverse, and CHORD ends would not rest
  const std::vector<double> times = {0, 1, 2, 3, 4}, angles = {0, 0.5, 0.6, 0.5, 0};
  const std::vector<double> closed =
      speeds(must_build(resting(QTRAJ_END_PERIODIC).get(), keys_at(times, angles)).get(), times);
  CHECK((std::abs(closed.front()) <= 1e-15 && std::abs(closed.back()) <= 1e-15 && std::abs(closed[2]) <= 1e-15));
  CHECK(std::abs(speeds(must_build(resting().get(), keys_at(times, angles)).get(), times).front() - 0.5) <= 1e-15);
}

TEST_CASE("C API: rates for TANGENT_REST are INPUT_UNWANTED", "[capi][squad][tangent_rest][errors]") {
  const Keyframes<double> keys = closed_tour<double>(4);
  Rates<double> rates;
  rates.omega.assign(12, 0.0);
  CHECK(build(resting().get(), keys, rates).status == QTRAJ_E_INPUT_UNWANTED);
}

}  // namespace
