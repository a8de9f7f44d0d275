// SQUAD: its construction, tangent rules and ends.
#include "support/derivative.hpp"

namespace {

using test::Keys;
using test::multiply;
using test::Quaternion;
using test::Random;
using test::Side;
using test::Trajectory;
using test::Vector;

constexpr double kDegree = 0.017453292519943295;

Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }

// Logarithm and exponential on S^3 as the textbooks have them.
Vector log(const Quaternion& q) {
  const double sine = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), angle = std::atan2(sine, q[0]);
  return sine == 0 ? Vector{0, 0, 0} : Vector{q[1] * angle / sine, q[2] * angle / sine, q[3] * angle / sine};
}
Quaternion exp(const Vector& v) {
  const double angle = test::length(v);
  return angle == 0 ? Quaternion{1, 0, 0, 0} : test::about({v[0] / angle, v[1] / angle, v[2] / angle}, 2 * angle);
}
Quaternion slerp(const Quaternion& a, const Quaternion& b, double fraction) {
  const Vector v = log(multiply(conjugate(a), b));
  return multiply(a, exp({fraction * v[0], fraction * v[1], fraction * v[2]}));
}

// K. Shoemake's inner control at a key with neighbours on both sides, uniform knots.
Quaternion shoemake_control(const Quaternion& before, const Quaternion& at, const Quaternion& after) {
  const Vector forward = log(multiply(conjugate(at), after)), backward = log(multiply(conjugate(at), before));
  Vector v;
  for (size_t k = 0; k < 3; ++k) v[k] = -0.25 * (forward[k] + backward[k]);
  return multiply(at, exp(v));
}

Vector rate_at(const Trajectory& trajectory, double time, Side side, double step) {
  return test::body_rate(trajectory.at(time), test::derivative(trajectory, time, side, step));
}

Trajectory with_end_rates(const Keys& keys, int32_t frame, const Vector& start, const Vector& end) {
  qtraj_options* options = test::make_options({QTRAJ_SQUAD, QTRAJ_END_GIVEN});
  REQUIRE(qtraj_options_set_end_rates(options, frame, start.data(), end.data()) == QTRAJ_OK);
  qtraj_trajectory* handle = nullptr;
  CHECK(qtraj_create_with_options(options, keys.times.data(), keys.q.data(), keys.count(), &handle, nullptr) ==
        QTRAJ_OK);
  qtraj_options_destroy(options);
  return Trajectory(handle);
}

// A closed curve: the last key repeats the first, with its sign or the other.
Keys closed_keys(Random& random, double sign) {
  Keys keys = random_walk(random, 9, 60 * kDegree, 0.3, 2.0);
  const Quaternion first = keys.orientation(0);
  keys.add(keys.times.back() + 1.3, {sign * first[0], sign * first[1], sign * first[2], sign * first[3]});
  return keys;
}

}  // namespace

TEST_CASE("on uniform knots SQUAD is Shoemake's curve", "[squad]") {
  Random random(11);
  for (int curve = 0; curve < 20; ++curve) {
    const Keys given = random_walk(random, 8, 100 * kDegree, 1.0, 1.0);
    const Trajectory trajectory({QTRAJ_SQUAD}, given);
    const Keys keys = trajectory.keys();
    for (size_t i = 1; i + 2 < keys.count(); ++i) {
      const Quaternion from = keys.orientation(i), to = keys.orientation(i + 1);
      const Quaternion a = shoemake_control(keys.orientation(i - 1), from, to);
      const Quaternion b = shoemake_control(from, to, keys.orientation(i + 2));
      const double h = keys.times[i + 1] - keys.times[i];
      for (int step = 0; step <= 16; ++step) {
        const double u = step / 16.0;
        const Quaternion expected = slerp(slerp(from, to, u), slerp(a, b, u), 2 * u * (1 - u));
        CHECK(test::largest_difference(trajectory.at(keys.times[i] + u * h), expected) <= 3e-15);
      }
    }
  }
}

TEST_CASE("through two keys SQUAD and LOG_SPLINE are the slerp", "[squad][log_spline]") {
  Random random(12);
  for (int pair = 0; pair < 20; ++pair) {
    const Keys keys = random_walk(random, 2, 179 * kDegree, 0.5, 3.0);
    const Trajectory expected({QTRAJ_SLERP}, keys);
    for (const test::Settings& settings : {test::Settings{QTRAJ_SQUAD},
                                           {QTRAJ_SQUAD, QTRAJ_END_ESTIMATED},
                                           {QTRAJ_LOG_SPLINE},
                                           {QTRAJ_LOG_SPLINE, QTRAJ_END_NOT_A_KNOT}}) {
      const Trajectory trajectory(settings, keys);
      for (int i = 0; i <= 20; ++i) {
        const double time = keys.times[0] + i * 0.05 * (keys.times[1] - keys.times[0]);
        CHECK(test::largest_difference(trajectory.at(time), expected.at(time)) <= 1e-15);
      }
    }
  }
}

TEST_CASE("given end rates are the rates at the ends, in the frame they are named in", "[squad][ends]") {
  Random random(13);
  for (int curve = 0; curve < 10; ++curve) {
    const Keys given = random_walk(random, 6, 60 * kDegree, 0.8, 1.5);
    const Vector start = random.direction(), end = random.direction();
    const Keys keys = Trajectory({QTRAJ_SLERP}, given).keys();
    const Trajectory body = with_end_rates(keys, QTRAJ_FRAME_BODY, start, end);
    CHECK(test::distance(rate_at(body, keys.times.front(), Side::right, 1e-3), start) <= 1e-8);
    CHECK(test::distance(rate_at(body, keys.times.back(), Side::left, 1e-3), end) <= 1e-8);

    const auto to_world = [](const Quaternion& q, const Vector& v) {
      const Quaternion turned = multiply(multiply(q, {0, v[0], v[1], v[2]}), conjugate(q));
      return Vector{turned[1], turned[2], turned[3]};
    };
    const Trajectory world = with_end_rates(keys, QTRAJ_FRAME_WORLD, to_world(keys.orientation(0), start),
                                            to_world(keys.orientation(keys.count() - 1), end));
    for (int i = 0; i <= 50; ++i) {
      const double time = keys.times.front() + i * 0.02 * (keys.times.back() - keys.times.front());
      CHECK(test::largest_difference(body.at(time), world.at(time)) <= 4e-15);
    }
  }
}

TEST_CASE("rates given at all keys are met at all of them, ends included", "[squad][tangents]") {
  Random random(14);
  const Keys keys = random_walk(random, 7, 60 * kDegree, 0.8, 1.5);
  std::vector<double> omega;
  for (size_t key = 0; key < keys.count(); ++key)
    for (const double component : random.direction()) omega.push_back(component);
  qtraj_options* options = test::make_options({QTRAJ_SQUAD, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_GIVEN});
  qtraj_trajectory* handle = nullptr;
  REQUIRE(qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, keys.times.data(), keys.q.data(), omega.data(), nullptr,
                                  keys.count(), &handle, nullptr) == QTRAJ_OK);
  qtraj_options_destroy(options);
  const Trajectory trajectory(handle);
  for (size_t key = 0; key < keys.count(); ++key) {
    const Vector expected = {omega[3 * key], omega[3 * key + 1], omega[3 * key + 2]};
    if (key > 0) CHECK(test::distance(rate_at(trajectory, keys.times[key], Side::left, 1e-3), expected) <= 1e-8);
    if (key + 1 < keys.count())
      CHECK(test::distance(rate_at(trajectory, keys.times[key], Side::right, 1e-3), expected) <= 1e-8);
  }
}

TEST_CASE("estimated ends are exact for a spin, however fast, and of second order for a bend", "[squad][ends]") {
  Random random(15);
  const Vector axis = random.direction();
  Keys spin;
  for (int key = 0; key < 6; ++key) spin.add(0.7 * key, test::about(axis, 0.7 * key * 3.0));
  const Trajectory trajectory({QTRAJ_SQUAD, QTRAJ_END_ESTIMATED}, spin);
  for (const Side side : {Side::right, Side::left}) {
    const double time = side == Side::right ? spin.times.front() : spin.times.back();
    const Vector rate = rate_at(trajectory, time, side, 1e-3);
    CHECK(test::distance(rate, Vector{3.0 * axis[0], 3.0 * axis[1], 3.0 * axis[2]}) <= 1e-7);
  }

  // angle t^2 about one axis: rate 2 t, which three keys reproduce and two do not
  Keys bend;
  for (const double time : {0.0, 0.3, 0.5, 0.9, 1.0}) bend.add(time, test::about(axis, time * time));
  const auto end_rate = [&](int32_t end) {
    return test::length(rate_at(Trajectory({QTRAJ_SQUAD, end}, bend), 1.0, Side::left, 1e-4));
  };
  CHECK(std::abs(end_rate(QTRAJ_END_ESTIMATED) - 2.0) <= 1e-6);
  CHECK(std::abs(end_rate(QTRAJ_END_CHORD) - 1.9) <= 1e-6);
}

TEST_CASE("a periodic SQUAD has one rate across its seam, for either sign of the last key", "[squad][ends]") {
  Random random(16);
  for (const double sign : {1.0, -1.0}) {
    const Keys keys = closed_keys(random, sign);
    const Trajectory trajectory({QTRAJ_SQUAD, QTRAJ_END_PERIODIC}, keys);
    const Vector out = rate_at(trajectory, keys.times.front(), Side::right, 1e-3);
    const Vector in = rate_at(trajectory, keys.times.back(), Side::left, 1e-3);
    CHECK(test::distance(out, in) <= 1e-7 * (1 + test::length(out)));
  }
}

TEST_CASE("tangents by a rule are shortened where the controls would wrap", "[squad][tangents]") {
  // a slow long interval beside a fast short one: the mean of their rates would turn the long one 55 times over
  Keys keys;
  const Vector axis = {0, 0, 1};
  keys.add(0.0, test::about(axis, 0.0));
  keys.add(0.01, test::about(axis, 1.0));
  keys.add(10.0, test::about(axis, 1.5));
  keys.add(20.0, test::about(axis, 2.0));
  const Trajectory trajectory({QTRAJ_SQUAD, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_MEAN_VELOCITY}, keys);
  const Vector left = rate_at(trajectory, 0.01, Side::left, 1e-6), right = rate_at(trajectory, 0.01, Side::right, 1e-3);
  CHECK(test::distance(left, right) <= 1e-4);
  // |h s - L| = pi over the long interval: s = (pi + 0.25)/9.99 about z
  CHECK(std::abs(0.5 * right[2] - (3.14159265358979 + 0.25) / 9.99) <= 1e-6);
}
