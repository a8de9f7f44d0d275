// How smooth the curves are at their knots, and that they never jump.
#include "support/derivative.hpp"

namespace {

using test::Keys;
using test::multiply;
using test::Quaternion;
using test::Random;
using test::Side;
using test::Trajectory;

constexpr double kDegree = 0.017453292519943295;

// Largest relative jump of q' at the inner knots.
double worst_rate_jump(const Trajectory& trajectory, const Keys& keys) {
  double worst = 0;
  for (size_t knot = 1; knot + 1 < keys.count(); ++knot) {
    const double before = keys.times[knot] - keys.times[knot - 1], after = keys.times[knot + 1] - keys.times[knot];
    const Quaternion left = test::derivative(trajectory, keys.times[knot], Side::left, before / 400);
    const Quaternion right = test::derivative(trajectory, keys.times[knot], Side::right, after / 400);
    const double scale = std::max({test::length(left), test::length(right), 1.0 / std::min(before, after)});
    worst = std::max(worst, test::distance(left, right) / scale);
  }
  return worst;
}

// Keys at intervals that differ by a factor of `ratio`, in turn.
Keys uneven_keys(Random& random, size_t count, double largest_step, double ratio) {
  Keys keys = random_walk(random, count, largest_step, 1.0, 1.0);
  double time = 0;
  for (size_t key = 0; key < count; ++key) {
    keys.times[key] = time;
    time += key % 2 == 0 ? 1.0 : ratio;
  }
  return keys;
}

// Closes in on the largest step between neighbouring samples: what is left of it after 30 halvings.
double step_that_stays(const Trajectory& trajectory, const Keys& keys) {
  constexpr size_t kPerSegment = 200;
  double largest = 0, low = 0, high = 0;
  for (size_t segment = 0; segment + 1 < keys.count(); ++segment) {
    const double start = keys.times[segment], step = (keys.times[segment + 1] - start) / kPerSegment;
    Quaternion previous = trajectory.at(start);
    for (size_t i = 1; i <= kPerSegment; ++i) {
      const double time = i < kPerSegment ? start + static_cast<double>(i) * step : keys.times[segment + 1];
      const Quaternion q = trajectory.at(time);
      if (test::distance(previous, q) > largest) {
        largest = test::distance(previous, q);
        low = start + static_cast<double>(i - 1) * step;
        high = time;
      }
      previous = q;
    }
  }
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = 0.5 * (low + high);
    const Quaternion q = trajectory.at(middle);
    const bool first_half = test::distance(trajectory.at(low), q) > test::distance(q, trajectory.at(high));
    (first_half ? high : low) = middle;
  }
  return test::distance(trajectory.at(low), trajectory.at(high));
}

}  // namespace

TEST_CASE("SQUAD has one rate at each knot, on knots as uneven as they come", "[squad][continuity]") {
  Random random(1);
  for (const double ratio : {1.0, 1.7, 0.2, 10.0, 1e-3, 1e4}) {
    for (const int32_t tangents : {QTRAJ_TANGENT_CATMULL_ROM, QTRAJ_TANGENT_MEAN_VELOCITY}) {
      for (const int32_t end : {QTRAJ_END_CHORD, QTRAJ_END_ESTIMATED}) {
        const Keys keys = uneven_keys(random, 10, 100 * kDegree, ratio);
        CAPTURE(ratio, tangents, end);
        CHECK(worst_rate_jump(Trajectory({QTRAJ_SQUAD, end, tangents}, keys), keys) <= 1e-5);
      }
    }
  }
}

TEST_CASE("LOG_SPLINE has one rate and one second derivative at each knot", "[log_spline][continuity]") {
  Random random(2);
  for (const int32_t end : {QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT}) {
    for (const int32_t reference : {QTRAJ_REFERENCE_FIRST, QTRAJ_REFERENCE_MEAN}) {
      const Keys keys = random_walk(random, 12, 40 * kDegree, 0.5, 2.0);
      const Trajectory trajectory({QTRAJ_LOG_SPLINE, end, 0, reference}, keys);
      CAPTURE(end, reference);
      CHECK(worst_rate_jump(trajectory, keys) <= 1e-6);
      for (size_t knot = 1; knot + 1 < keys.count(); ++knot) {
        const Quaternion left = test::second_derivative(trajectory, keys.times[knot], Side::left, 1e-3);
        const Quaternion right = test::second_derivative(trajectory, keys.times[knot], Side::right, 1e-3);
        CHECK(test::distance(left, right) <= 1e-4 * (1 + test::length(left)));
      }
    }
  }
}

TEST_CASE("no curve jumps, for steps up to 179 degrees", "[continuity]") {
  for (uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const Keys keys = random_walk(random, 8, 179 * kDegree, 0.2, 2.0);
    for (const test::Settings& settings :
         {test::Settings{QTRAJ_SLERP}, test::Settings{QTRAJ_NLERP}, test::Settings{QTRAJ_SQUAD},
          test::Settings{QTRAJ_SQUAD, QTRAJ_END_ESTIMATED},
          test::Settings{QTRAJ_SQUAD, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_MEAN_VELOCITY},
          test::Settings{QTRAJ_LOG_SPLINE}}) {
      CAPTURE(seed, settings.method, settings.end, settings.tangents);
      CHECK(step_that_stays(Trajectory(settings, keys), keys) <= 1e-6);
    }
  }
}

TEST_CASE("samples of random curves are unit to 4 eps, however many turns they take", "[continuity]") {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const Keys keys = random_walk(random, 8, 179 * kDegree, seed % 2 == 0 ? 0.01 : 0.5, 2.0);
    for (const int32_t method : {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_SQUAD, QTRAJ_LOG_SPLINE}) {
      const Trajectory trajectory({method}, keys);
      std::vector<double> times;
      for (int i = 0; i <= 300; ++i)
        times.push_back(keys.times.front() + i / 300.0 * (keys.times.back() - keys.times.front()));
      times.back() = keys.times.back();
      const std::vector<double> q = trajectory.sample(times);
      const std::vector<float> q_f32 = trajectory.sample_f32(times);
      double worst = 0, worst_f32 = 0;
      for (size_t i = 0; i < times.size(); ++i) {
        long double sum = 0, sum_f32 = 0;
        for (size_t k = 4 * i; k < 4 * i + 4; ++k) {
          sum += static_cast<long double>(q[k]) * q[k];
          sum_f32 += static_cast<long double>(q_f32[k]) * q_f32[k];
        }
        worst = std::max(worst, static_cast<double>(std::abs(std::sqrt(sum) - 1)));
        worst_f32 = std::max(worst_f32, static_cast<double>(std::abs(std::sqrt(sum_f32) - 1)));
      }
      CAPTURE(seed, method);
      CHECK(worst <= 4 * 0x1p-52);
      CHECK(worst_f32 <= 4 * 0x1p-23);
    }
  }
}

TEST_CASE("three turns about one axis come back from LOG_SPLINE", "[log_spline]") {
  Random random(3);
  for (const double degrees : {60.0, 90.0, 120.0}) {
    for (const int32_t end : {QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT}) {
      const test::Vector axis = random.direction();
      const Quaternion first = random.orientation();
      const auto spin = [&](double time) { return multiply(first, test::about(axis, degrees * kDegree * time)); };
      Keys keys;
      for (int key = 0; key * degrees <= 1080.0; ++key) keys.add(key, spin(key));
      const Trajectory trajectory({QTRAJ_LOG_SPLINE, end}, keys);
      CAPTURE(degrees, end);
      double worst = 0;
      for (int i = 0; i <= 1000; ++i) {
        const double time = i * 1e-3 * keys.times.back();
        worst = std::max(worst, test::largest_difference(trajectory.at(time), spin(time)));
      }
      CHECK(worst <= 1e-12);
    }
  }
}
