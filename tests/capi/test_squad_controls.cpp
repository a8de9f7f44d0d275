// squad_controls: its bound, its agreement with the trajectory's own controls, singular keys.
#include <cfloat>

#include "support/pair_functions.hpp"
#include "support/trajectory.hpp"
#include "support/wide_pair.hpp"

using test::Quaternion;
using test::Random;

namespace {

struct Controls {
  qtraj_status status;
  size_t bad_index;
  std::vector<double> a, b;
};
Controls squad_controls(const std::vector<double>& times, const std::vector<double>& q) {
  Controls controls{QTRAJ_OK, 7, std::vector<double>(q.size()), std::vector<double>(q.size())};
  controls.status = qtraj_squad_controls(times.empty() ? nullptr : times.data(), q.data(), q.size() / 4,
                                         controls.a.data(), controls.b.data(), &controls.bad_index);
  return controls;
}

// exp(log) on S^3 times q from the left.
wide::Quaternion moved(const wide::Quaternion& q, const wide::Vector& log) { return wide::multiply(q, wide::exp(log)); }

// A neighbouring segment as a key sees it.
struct Side {
  wide::Pair pair;
  wide::Real h;
};

wide::Vector combination(wide::Real x, const wide::Vector& a, wide::Real y, const wide::Vector& b) {
  return wide::sum(wide::scaled(x, a), wide::scaled(y, b));
}

// Half rate at a key: CATMULL_ROM, shortened by bisection where it would turn a control past pi from its chord.
struct HalfRate {
  wide::Vector s;
  bool is_limited;
};
HalfRate half_rate(const Side& before, const Side& after) {
  const wide::Real span = before.h + after.h;
  const wide::Vector s =
      combination(after.h / (before.h * span), before.pair.log, before.h / (after.h * span), after.pair.log);
  const auto is_within = [&](wide::Real factor) {
    return wide::norm(combination(factor * before.h, s, -1, before.pair.log)) <= wide::kPi &&
           wide::norm(combination(factor * after.h, s, -1, after.pair.log)) <= wide::kPi;
  };
  if (is_within(1)) return {s, false};
  wide::Real low = 0, high = 1;
  for (int step = 0; step < 64; ++step) (is_within((low + high) / 2) ? low : high) = (low + high) / 2;
  return {wide::scaled(low, s), true};
}

TEST_CASE("C API: squad_controls stays within its bound on random and singular keys", "[capi][squad_controls]") {
  Random random(31);
  double worst = 0, worst_limited = 0, worst_norm = 0;
  size_t limited = 0, ambiguous = 0, wrong_ambiguous = 0;
  for (int chain = 0; chain < 84000; ++chain) {  // of twelve keys each
    constexpr size_t kCount = 12;
    const bool is_uniform = chain % 3 == 0;
    std::vector<double> times, q;
    Quaternion key = random.orientation();
    double time = random.uniform(-10, 10);
    for (size_t i = 0; i < kCount; ++i) {
      const Quaternion given = test::scaled(test::hard_norm(random, 160), key);
      q.insert(q.end(), given.begin(), given.end());
      if (!is_uniform) times.push_back(time);
      time += std::pow(10.0, random.uniform(-2, 2));
      key = test::hard_neighbour(random, key);
    }
    const Controls controls = squad_controls(times, q);
    std::vector<Side> sides;
    bool is_ambiguous = false;
    for (size_t i = 0; i + 1 < kCount; ++i) {
      const wide::Pair pair = wide::pair(&q[4 * i], &q[4 * i + 4], false);
      sides.push_back({pair, is_uniform ? 1 : wide::Real(times[i + 1]) - times[i]});
      is_ambiguous = is_ambiguous || pair.supplement < 1e-14L;
    }
    ambiguous += is_ambiguous;
    wrong_ambiguous += controls.status != (is_ambiguous ? QTRAJ_E_AMBIGUOUS : QTRAJ_OK);
    for (size_t i = 1; i + 1 < kCount; ++i) {
      const Side &before = sides[i - 1], &after = sides[i];
      worst_norm = std::max({worst_norm, std::abs(pairs::norm_of(&controls.a[4 * i]) - 1),
                             std::abs(pairs::norm_of(&controls.b[4 * i]) - 1)});
      if (std::min(before.pair.supplement, after.pair.supplement) < 1e-13L) continue;
      const HalfRate rate = half_rate(before, after);
      const wide::Quaternion a = moved(after.pair.a, combination(after.h / 2, rate.s, -0.5L, after.pair.log));
      const wide::Quaternion b = moved(after.pair.a, combination(-before.h / 2, rate.s, 0.5L, before.pair.log));
      const double error = std::max(wide::error(&controls.a[4 * i], a), wide::error(&controls.b[4 * i], b));
      const bool is_near_opposite = std::max(before.pair.angle, after.pair.angle) > 3;
      limited += rate.is_limited;
      if (rate.is_limited && is_near_opposite)
        worst_limited = std::max(worst_limited, error);
      else
        worst = std::max(worst, error);
    }
  }
  CAPTURE(worst / 2e-15, worst_limited / 1e-7, worst_norm / (4 * DBL_EPSILON));
  CHECK(worst <= 2e-15);
  CHECK(worst_limited <= 1e-7);
  CHECK(worst_norm <= 4 * DBL_EPSILON);
  CHECK(wrong_ambiguous == 0);
  CHECK(limited > 10000);
  CHECK(ambiguous > 1000);
}

TEST_CASE("C API: squad_controls and squad_segment make the library's SQUAD", "[capi][squad_controls][squad_segment]") {
  Random random(32);
  for (int curve = 0; curve < 300; ++curve) {
    // spacings up to 1 : 100, where the tangent rule is limited, and long steps
    const test::Keys given = test::random_walk(random, 8, 6.0, 0.05, curve % 2 == 0 ? 5.0 : 0.06);
    const test::Trajectory trajectory({QTRAJ_SQUAD}, given);
    const test::Keys keys = trajectory.keys();
    const Controls controls = squad_controls(keys.times, keys.q);
    REQUIRE(controls.status == QTRAJ_OK);
    REQUIRE(controls.bad_index == SIZE_MAX);
    double worst = 0;
    for (size_t i = 0; i + 1 < keys.count(); ++i)
      for (const double u : {0.0, 1e-3, 0.25, 0.5, 0.7, 1.0}) {
        Quaternion q;
        REQUIRE(qtraj_squad_segment(&keys.q[4 * i], &keys.q[4 * i + 4], &controls.a[4 * i], &controls.b[4 * i + 4], &u,
                                    1, q.data(), nullptr) == QTRAJ_OK);
        const double time = (1 - u) * keys.times[i] + u * keys.times[i + 1];
        // the time, rounded, is another fraction
        const double fraction_error = 4 * DBL_EPSILON * std::abs(time) / (keys.times[i + 1] - keys.times[i]);
        worst = std::max(worst, test::largest_difference(q, trajectory.at(time)) / (4e-15 + 10 * fraction_error));
      }
    if (worst > 1) FAIL("curve " << curve << " off by " << worst);
  }
}

TEST_CASE("C API: on uniform times the controls are Shoemake's, with times or without", "[capi][squad_controls]") {
  Random random(33);
  for (int curve = 0; curve < 200; ++curve) {
    const test::Keys keys = test::random_walk(random, 6, 2.0, 0.5, 0.5);
    std::vector<double> uniform;
    for (size_t i = 0; i < keys.count(); ++i) uniform.push_back(0.5 * static_cast<double>(i));
    const Controls with_times = squad_controls(uniform, keys.q), without = squad_controls({}, keys.q);
    double worst = 0;
    for (size_t i = 1; i + 1 < keys.count(); ++i) {
      const wide::Pair forward = wide::pair(&keys.q[4 * i], &keys.q[4 * i + 4], false);
      const wide::Pair backward = wide::pair(&keys.q[4 * i], &keys.q[4 * i - 4], false);
      const wide::Quaternion expected = moved(forward.a, combination(-0.25L, forward.log, -0.25L, backward.log));
      for (const std::vector<double>* controls : {&with_times.a, &with_times.b, &without.a, &without.b})
        worst = std::max(worst, wide::error(&(*controls)[4 * i], expected));
    }
    if (worst > 2e-15) FAIL("off by " << worst);
  }
}

TEST_CASE("C API: the controls of the first and the last key are those keys, for one key too",
          "[capi][squad_controls]") {
  Random random(34);
  for (const size_t count : {1, 2, 3, 7}) {
    const test::Keys keys = test::random_walk(random, count, 2.0, 0.1, 3.0);
    std::vector<double> q = keys.q;
    for (double& component : q) component *= -1e200;
    const Controls controls = squad_controls(keys.times, q);
    CHECK(controls.status == QTRAJ_OK);
    for (const size_t at : {size_t{0}, 4 * (count - 1)})
      for (size_t k = at; k < at + 4; ++k) {
        CHECK(std::abs(controls.a[k] + keys.q[k]) <= 3e-16);
        CHECK(std::abs(controls.b[k] + keys.q[k]) <= 3e-16);
      }
  }
}

TEST_CASE("C API: signs of keys are taken as given: the long way round has other controls", "[capi][squad_controls]") {
  Random random(35);
  const test::Keys keys = test::random_walk(random, 4, 1.0, 1.0, 1.0);
  std::vector<double> flipped = keys.q;
  for (size_t k = 8; k < 12; ++k) flipped[k] = -flipped[k];
  const Controls as_given = squad_controls({}, keys.q), other = squad_controls({}, flipped);
  CHECK(other.status == QTRAJ_OK);
  CHECK(std::abs(as_given.a[4] - other.a[4]) > 1e-3);
}

TEST_CASE("C API: opposite neighbours make both controls ambiguous and the body turn about its x axis",
          "[capi][squad_controls]") {
  // from 1 on to -1 and back: half a turn of S^3 about x, there and back
  const std::vector<double> q = {1, 0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0};
  const Controls controls = squad_controls({}, q);
  CHECK(controls.status == QTRAJ_E_AMBIGUOUS);
  CHECK(controls.bad_index == 1);
  // logs 0, pi x, 0: the half rate at both is (pi/2) x, so that a_1 = exp(-(pi/4) x) and b_1 = exp(-(pi/4) x)
  const double half = std::sqrt(0.5);
  for (const std::vector<double>* rows : {&controls.a, &controls.b}) {
    CHECK(test::largest_difference({(*rows)[4], (*rows)[5], (*rows)[6], (*rows)[7]}, {half, -half, 0, 0}) <= 1e-15);
    CHECK(test::largest_difference({(*rows)[8], (*rows)[9], (*rows)[10], (*rows)[11]}, {-half, -half, 0, 0}) <= 1e-15);
    CHECK(test::largest_difference({(*rows)[12], (*rows)[13], (*rows)[14], (*rows)[15]}, {-1, 0, 0, 0}) == 0);
  }

  // the controls of the ends are the keys, whatever is next to them
  const Controls at_start = squad_controls({}, {1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0});
  CHECK(at_start.status == QTRAJ_E_AMBIGUOUS);
  CHECK(at_start.bad_index == 1);
  CHECK(squad_controls({}, {1, 0, 0, 0, -1, 0, 0, 0}).status == QTRAJ_OK);
}

}  // namespace
