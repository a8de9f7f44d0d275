// ROTATION_SPLINE: continuous angular acceleration, and its ends.
#include <cstdio>
#include <set>

#include "support/derivative.hpp"
#include "support/recording.hpp"

namespace {

using test::Keys;
using test::multiply;
using test::Quaternion;
using test::Random;
using test::Trajectory;
using test::Vector;

constexpr double kDegree = 0.017453292519943295;

double largest_row(const std::vector<double>& rows) {
  double largest = 0;
  for (size_t row = 0; row + 2 < rows.size(); row += 3)
    largest = std::max(largest, test::length(Vector{rows[row], rows[row + 1], rows[row + 2]}));
  return largest;
}

// The scale of accelerations: the larger of the largest |alpha| and |omega|/h.
double alpha_scale(const Trajectory& trajectory, const Keys& keys) {
  double scale = 0;
  for (size_t i = 0; i + 1 < keys.count(); ++i) {
    const double h = keys.times[i + 1] - keys.times[i];
    const std::vector<double> times = {keys.times[i], keys.times[i] + 0.5 * h, keys.times[i] + 0.99 * h};
    const auto motion = trajectory.sample_rates(QTRAJ_FRAME_BODY, times);
    scale = std::max({scale, largest_row(motion.alpha), largest_row(motion.omega) / h});
  }
  return scale;
}

double largest_speed(const Trajectory& trajectory, const Keys& keys) {
  return largest_row(trajectory.sample_rates(QTRAJ_FRAME_BODY, keys.times).omega);
}

struct Jumps {
  double omega, alpha;
};
Jumps largest_jumps(const Trajectory& trajectory) {
  std::vector<double> omega(3 * qtraj_key_count(trajectory.get())), alpha(omega.size());
  REQUIRE(qtraj_curve_jumps(trajectory.get(), QTRAJ_FRAME_BODY, omega.data(), alpha.data()) == QTRAJ_OK);
  return {largest_row(omega), largest_row(alpha)};
}

void check_smooth(const Trajectory& trajectory, const Keys& keys) {
  const double scale = alpha_scale(trajectory, keys);
  const Jumps jumps = largest_jumps(trajectory);
  CHECK(jumps.alpha <= 1e-12 * scale);
  CHECK(jumps.omega <= 1e-13 * largest_speed(trajectory, keys));
  CHECK(qtraj_residual(trajectory.get()) <= 1e-12);
}

}  // namespace

TEST_CASE("alpha has no jump on 1000 random curves with steps up to 179 degrees", "[rotation_spline]") {
  int most_iterations = 0;
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed);
    const Keys keys = random_walk(random, 12, 179 * kDegree, 0.2, 2.0);
    const Trajectory trajectory({QTRAJ_ROTATION_SPLINE}, keys);
    CAPTURE(seed);
    check_smooth(trajectory, keys);
    most_iterations = std::max(most_iterations, static_cast<int>(qtraj_iterations(trajectory.get())));
  }
  std::printf("ROTATION_SPLINE, 1000 curves: at most %d iterations\n", most_iterations);
}

TEST_CASE("alpha has no jump on recordings, for every end", "[rotation_spline][recordings]") {
  for (const test::Recording& recording : test::all_recordings()) {
    for (const int32_t end : {QTRAJ_END_ESTIMATED, QTRAJ_END_CHORD, QTRAJ_END_NATURAL}) {
      CAPTURE(recording.name, end);
      check_smooth(Trajectory({QTRAJ_ROTATION_SPLINE, end}, recording.keys), recording.keys);
    }
  }
}

TEST_CASE("steps of exactly 179 degrees about changing axes converge", "[rotation_spline][singular]") {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    Keys keys;
    Quaternion q = random.orientation();
    for (int key = 0; key < 20; ++key, q = multiply(q, test::about(random.direction(), 179 * kDegree)))
      keys.add(key, q);
    CAPTURE(seed);
    check_smooth(Trajectory({QTRAJ_ROTATION_SPLINE}, keys), keys);
  }
}

// The solver keeps a matrix, and stops, by the sizes of its steps: each limit is passed by a curve that grows slowly.
TEST_CASE("alpha has no jump on either side of the solver's limits", "[rotation_spline][singular]") {
  std::set<int32_t> iterations;
  for (uint64_t seed = 0; seed < 20; ++seed)
    for (double degrees = 1e-6; degrees < 179; degrees *= 1.1) {
      Random random(seed);
      const Keys keys = random_walk(random, 12, degrees * kDegree, 0.2, 2.0);
      const Trajectory trajectory({QTRAJ_ROTATION_SPLINE}, keys);
      CAPTURE(seed, degrees);
      check_smooth(trajectory, keys);
      iterations.insert(qtraj_iterations(trajectory.get()));
    }
  // the linear step and one more at the least; all numbers up to the most
  CHECK(*iterations.begin() == 2);
  CHECK(*iterations.rbegin() >= 6);
  CHECK(iterations.size() == static_cast<size_t>(*iterations.rbegin() - 1));
}

TEST_CASE("a natural end has no angular acceleration", "[rotation_spline][ends]") {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const Keys keys = random_walk(random, 2 + seed % 9, 150 * kDegree, 0.2, 2.0);
    const Trajectory trajectory({QTRAJ_ROTATION_SPLINE, QTRAJ_END_NATURAL}, keys);
    const double scale = alpha_scale(trajectory, keys);
    CAPTURE(seed);
    for (const double time : {keys.times.front(), keys.times.back()})
      CHECK(test::length(trajectory.rates_at(QTRAJ_FRAME_BODY, time).alpha) <= 1e-12 * scale);
  }
}

TEST_CASE("a chord end has the rate of the slerp over its segment", "[rotation_spline][ends]") {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const Keys keys = random_walk(random, 7, 150 * kDegree, 0.2, 2.0);
    const Trajectory trajectory({QTRAJ_ROTATION_SPLINE, QTRAJ_END_CHORD}, keys), slerp({QTRAJ_SLERP}, keys);
    for (const double time : {keys.times.front(), keys.times.back()}) {
      const Vector expected = slerp.rates_at(QTRAJ_FRAME_WORLD, time).omega;
      const Vector omega = trajectory.rates_at(QTRAJ_FRAME_WORLD, time).omega;
      CHECK(test::distance(omega, expected) <= 1e-13 * test::length(expected));
    }
  }
}

TEST_CASE("estimated ends reproduce a cubic angle about one axis", "[rotation_spline][ends]") {
  const Vector axis = {2.0 / 3, -1.0 / 3, 2.0 / 3};
  const auto angle = [](double t) { return t * (1.0 - t * (0.5 - 0.2 * t)); };
  const auto rate = [](double t) { return 1.0 - t * (1.0 - 0.6 * t); };
  Keys keys;
  for (const double time : {0.0, 0.4, 0.9, 1.3, 2.0, 2.5}) keys.add(time, test::about(axis, angle(time)));
  const Trajectory trajectory({QTRAJ_ROTATION_SPLINE}, keys);
  for (int i = 0; i <= 100; ++i) {
    const double time = 0.025 * i;
    const auto at = trajectory.rates_at(QTRAJ_FRAME_WORLD, time);
    CHECK(test::largest_difference(at.q, test::about(axis, angle(time))) <= 1e-15);
    CHECK(test::distance(at.omega, {axis[0] * rate(time), axis[1] * rate(time), axis[2] * rate(time)}) <= 1e-14);
  }
}

TEST_CASE("a periodic spline is smooth across its seam, for either sign of the last key", "[rotation_spline][ends]") {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    Keys keys = random_walk(random, 2 + seed % 7, 90 * kDegree, 0.3, 2.0);
    const double sign = seed % 2 == 0 ? 1.0 : -1.0;
    Quaternion last = keys.orientation(0);
    for (double& component : last) component *= sign;
    keys.add(keys.times.back() + 1.1, last);
    const Trajectory trajectory({QTRAJ_ROTATION_SPLINE, QTRAJ_END_PERIODIC}, keys);
    CAPTURE(seed);
    check_smooth(trajectory, keys);  // jumps at the ends are those of the seam
  }
}

TEST_CASE("through two keys the spline is the slerp for every end that is not given", "[rotation_spline][singular]") {
  Random random(5);
  for (const int32_t end : {QTRAJ_END_ESTIMATED, QTRAJ_END_CHORD, QTRAJ_END_NATURAL}) {
    const Keys keys = random_walk(random, 2, 179 * kDegree, 0.5, 3.0);
    const Trajectory trajectory({QTRAJ_ROTATION_SPLINE, end}, keys), slerp({QTRAJ_SLERP}, keys);
    for (int i = 0; i <= 20; ++i) {
      const double time = keys.times[0] + i * 0.05 * (keys.times[1] - keys.times[0]);
      CHECK(test::largest_difference(trajectory.at(time), slerp.at(time)) <= 1e-15);
    }
  }
}

TEST_CASE("intervals that grow by half each time converge at once", "[rotation_spline][singular]") {
  Keys keys;
  double time = 1e-60;
  for (int key = 0; key < 420; ++key, time *= 1.5) keys.add(time, test::about({0, 0, 1}, 0.1 * key));
  const Trajectory trajectory({QTRAJ_ROTATION_SPLINE}, keys);
  CHECK(qtraj_iterations(trajectory.get()) <= 10);
  CHECK(qtraj_residual(trajectory.get()) <= 1e-12);
}

TEST_CASE("repeated keys neither stop the solver nor disturb it", "[rotation_spline][singular]") {
  Random random(6);
  Keys keys;
  for (int key = 0; key < 12; ++key)
    keys.add(key, key < 3 || key > 8 ? test::about({1, 0, 0}, 0.3) : random.orientation());
  check_smooth(Trajectory({QTRAJ_ROTATION_SPLINE}, keys), keys);
  Keys still;
  for (int key = 0; key < 6; ++key) still.add(key, test::about({0, 0, 1}, 1.0));
  const Trajectory at_rest({QTRAJ_ROTATION_SPLINE}, still);
  CHECK(test::length(at_rest.rates_at(QTRAJ_FRAME_BODY, 2.5).omega) == 0.0);
  CHECK(qtraj_residual(at_rest.get()) == 0.0);
}
