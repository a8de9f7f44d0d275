// STEP, of trajectories and of vectors: each key until the next, and the last from the last knot on.
#include <cfloat>
#include <cmath>

#include "support/capi_variants.hpp"
#include "support/ends.hpp"
#include "support/long_double.hpp"
#include "support/vector_curve.hpp"

using namespace capi;

namespace {

constexpr int32_t kRules[] = {QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
                              QTRAJ_EXTRAPOLATE_PERIODIC};
constexpr size_t kCount = 7;

// Both curves of one set of knots, by the same rule at both ends.
template <class Real>
struct Steps {
  Keyframes<Real> keys = closed_tour<Real>(kCount);
  VectorKeys<Real> positions = vector_tour<Real>({"", QTRAJ_VECTOR_STEP}, kCount, 3);
  Trajectory trajectory;
  VectorCurve vectors;

  explicit Steps(int32_t rule) {
    positions.times = keys.times;
    const Options options = make_options({"", QTRAJ_STEP}), vector = vector_options(QTRAJ_VECTOR_STEP);
    for (qtraj_options* some : {options.get(), vector.get()})
      REQUIRE(qtraj_options_set_extrapolation(some, rule, rule) == QTRAJ_OK);
    trajectory = must_build(options.get(), keys);
    vectors = must_build_vector(vector.get(), positions);
  }

  // The key that a time within the knots, or 4 ulps of them, stands for.
  size_t key_at(double time) const {
    size_t key = 0;
    while (key + 1 < kCount && time >= keys.times[key + 1]) ++key;
    return key;
  }
};

// Knots, both neighbours of each, the reach of both ends and times between.
std::vector<double> telling_times(const std::vector<double>& knots) {
  const double reach = test::reach_of(knots.front(), knots.back());
  std::vector<double> times = {knots.back(), std::nextafter(knots.back(), DBL_MAX), knots.back() + reach,
                               knots.front() - reach, std::nextafter(knots.front(), -DBL_MAX)};
  for (size_t i = 0; i < knots.size(); ++i) {
    times.push_back(knots[i]);
    if (i > 0) times.push_back(std::nextafter(knots[i], -DBL_MAX)), times.push_back(knots[i] - 0.05);
    if (i + 1 < knots.size()) times.push_back(std::nextafter(knots[i], DBL_MAX)), times.push_back(knots[i] + 0.1);
  }
  return times;
}

// Whether rows are those keys, to half an eps of Real, and all rates 0.
template <class Real>
size_t wrong_rows(const Steps<Real>& steps, const std::vector<size_t>& keys, const Motion<Real>& motion,
                  const VectorMotion<Real>& vectors) {
  size_t wrong = 0;
  for (size_t i = 0; i < keys.size(); ++i) {
    const wide::Quaternion key = wide::quaternion(&steps.keys.q[4 * keys[i]]);
    const wide::Real norm = wide::norm(key), sign = wide::dot(key, wide::quaternion(&motion.q[4 * i])) < 0 ? -1 : 1;
    for (size_t k = 0; k < 4; ++k)
      wrong += !(std::abs(motion.q[4 * i + k] - sign * key[k] / norm) <= std::numeric_limits<Real>::epsilon());
    for (size_t k = 3 * i; k < 3 * i + 3; ++k) {
      wrong += motion.omega[k] != 0 || motion.alpha[k] != 0 || vectors.first[k] != 0 || vectors.second[k] != 0;
      wrong += vectors.value[k] != steps.positions.values[3 * keys[i] + k % 3];
    }
  }
  return wrong;
}

TEST_CASE("C API: STEP is each key until the next, and the last one at the last knot", "[capi][step]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const int32_t rule : kRules) {
      const Steps<Real> steps(rule);
      const bool wraps = rule == QTRAJ_EXTRAPOLATE_PERIODIC;
      std::vector<double> times = telling_times(steps.keys.times);
      for (const bool sorted : {false, true}) {
        CAPTURE(rule, sorted);
        if (sorted) std::sort(times.begin(), times.end());
        std::vector<size_t> keys;
        for (const double time : times) {
          // what repeats is at the first key again at the last knot; keys 0 and kCount - 1 are the same orientation
          keys.push_back(wraps && time >= steps.keys.times.back() ? 0 : steps.key_at(time));
        }
        const auto motion = must_sample_rates<Real>(steps.trajectory.get(), QTRAJ_FRAME_WORLD, times);
        CHECK(capi::same_bits(motion.q, must_sample<Real>(steps.trajectory.get(), times)));
        CHECK(wrong_rows(steps, keys, motion, must_sample_vectors<Real>(steps.vectors.get(), times)) == 0);
        Motion<Real> one(times.size());
        VectorMotion<Real> one_vector(3 * times.size());
        for (size_t i = 0; i < times.size(); ++i) {
          CHECK(sample_rates_at(steps.trajectory.get(), QTRAJ_FRAME_WORLD, times[i], nullptr, &one.q[4 * i],
                                &one.omega[3 * i], &one.alpha[3 * i]) == QTRAJ_OK);
          CHECK(vector_sample_at(steps.vectors.get(), times[i], nullptr, &one_vector.value[3 * i],
                                 &one_vector.first[3 * i], &one_vector.second[3 * i]) == QTRAJ_OK);
        }
        CHECK(wrong_rows(steps, keys, one, one_vector) == 0);
        CHECK(capi::same_bits(one.q, motion.q));
      }
    }
  });
}

TEST_CASE("C API: a batch of STEP may end at the last knot, whatever its length", "[capi][step]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const int32_t rule : kRules) {
      if (rule == QTRAJ_EXTRAPOLATE_PERIODIC) continue;
      const Steps<Real> steps(rule);
      const double first = steps.keys.times.front(), last = steps.keys.times.back();
      for (size_t count = 1; count < 600; count = count < 40 ? count + 1 : 2 * count) {
        CAPTURE(rule, count);
        std::vector<double> times;
        std::vector<size_t> keys;
        for (size_t i = 0; i < count; ++i) {
          times.push_back(i + 1 == count ? last : first + (last - first) * static_cast<double>(i) / double(count));
          keys.push_back(steps.key_at(times.back()));
        }
        CHECK(wrong_rows(steps, keys, must_sample_rates<Real>(steps.trajectory.get(), QTRAJ_FRAME_BODY, times),
                         must_sample_vectors<Real>(steps.vectors.get(), times)) == 0);
      }
    }
  });
}

TEST_CASE("C API: outside its knots STEP holds its ends, or has no value, or repeats", "[capi][step]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const int32_t rule : kRules) {
      CAPTURE(rule);
      const Steps<Real> steps(rule);
      const double first = steps.keys.times.front(), last = steps.keys.times.back(), period = last - first;
      const std::vector<double> times = {test::before_all(first, last),
                                         first - 0.5,
                                         -1e300,
                                         test::after_all(first, last),
                                         last + 0.01,
                                         last + 1e9,
                                         1e300};
      if (rule == QTRAJ_EXTRAPOLATE_ERROR) {
        for (const double time : times) {
          Real q[4], p[3];
          CHECK(sample_at(steps.trajectory.get(), time, nullptr, q) == QTRAJ_E_TIME_RANGE);
          CHECK(vector_sample_at(steps.vectors.get(), time, nullptr, p, static_cast<Real*>(nullptr),
                                 static_cast<Real*>(nullptr)) == QTRAJ_E_TIME_RANGE);
          CHECK((std::isnan(q[0]) && std::isnan(p[2])));
        }
        continue;
      }
      if (rule == QTRAJ_EXTRAPOLATE_PERIODIC) {
        std::vector<double> later;
        std::vector<size_t> keys;
        for (size_t i = 0; i + 1 < kCount; ++i)
          for (const double rounds : {-3.0, -1.0, 1.0, 8.0}) {
            later.push_back(0.5 * (steps.keys.times[i] + steps.keys.times[i + 1]) + rounds * period);
            keys.push_back(i);
          }
        CHECK(wrong_rows(steps, keys, must_sample_rates<Real>(steps.trajectory.get(), QTRAJ_FRAME_BODY, later),
                         must_sample_vectors<Real>(steps.vectors.get(), later)) == 0);
        continue;
      }
      const std::vector<size_t> keys = {0, 0, 0, kCount - 1, kCount - 1, kCount - 1, kCount - 1};
      CHECK(wrong_rows(steps, keys, must_sample_rates<Real>(steps.trajectory.get(), QTRAJ_FRAME_BODY, times),
                       must_sample_vectors<Real>(steps.vectors.get(), times)) == 0);
    }
  });
}

TEST_CASE("C API: a loop of STEP has the last key until the period ends", "[capi][step]") {
  const Keyframes<double> keys = {{0, 1, 2}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0, 1, 0, 0}};
  const VectorKeys<double> positions = {{0, 1, 2}, {5, 6, 7}, {}, {}, 1};
  const Options options = make_options({"", QTRAJ_STEP}), vector = vector_options(QTRAJ_VECTOR_STEP);
  for (qtraj_options* some : {options.get(), vector.get()}) {
    REQUIRE(qtraj_options_set_period(some, 3.5) == QTRAJ_OK);
    REQUIRE(qtraj_options_set_extrapolation(some, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) == QTRAJ_OK);
  }
  const Trajectory curve = must_build(options.get(), keys);
  const VectorCurve vectors = must_build_vector(vector.get(), positions);
  CHECK(qtraj_end_time(curve.get()) == 3.5);
  CHECK(qtraj_vector_key_count(vectors.get()) == 4);
  CHECK(qtraj_vector_end_time(vectors.get()) == 3.5);
  const std::vector<double> times = {0,   0.99, 1, 2, std::nextafter(3.5, 0.0), 3.5, std::nextafter(3.5, 9.0),
                                     4.5, -0.5, 7};
  const std::vector<double> p = {5, 5, 6, 7, 7, 5, 5, 6, 7, 5}, x = {0, 0, 0.6, 1, 1, 0, 0, 0.6, 1, 0};
  CHECK(must_sample_vectors<double>(vectors.get(), times).value == p);
  const std::vector<double> q = must_sample<double>(curve.get(), times);
  for (size_t i = 0; i < times.size(); ++i) CHECK(std::abs(std::abs(q[4 * i + 1]) - x[i]) <= DBL_EPSILON);
}

TEST_CASE("C API: gaps of STEP have no value, their knots do", "[capi][step][gap]") {
  const Keyframes<double> keys = {{0, 1, 5, 6}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  const VectorKeys<double> positions = {keys.times, {5, 6, 7, 8}, {}, {}, 1};
  const Options options = make_options({"", QTRAJ_STEP}), vector = vector_options(QTRAJ_VECTOR_STEP);
  for (qtraj_options* some : {options.get(), vector.get()}) REQUIRE(qtraj_options_set_longest_gap(some, 2) == QTRAJ_OK);
  const Trajectory curve = must_build(options.get(), keys);
  const VectorCurve vectors = must_build_vector(vector.get(), positions);
  const double times[] = {0, 1, 1.1, 4.9, 5, 6}, expected[] = {5, 6, NAN, NAN, 7, 8};
  for (size_t i = 0; i < 6; ++i) {
    double q[4], p;
    const qtraj_status status = std::isnan(expected[i]) ? QTRAJ_E_GAP : QTRAJ_OK;
    CHECK(qtraj_sample_at(curve.get(), times[i], nullptr, q) == status);
    CHECK(qtraj_vector_sample_at(vectors.get(), times[i], nullptr, &p, nullptr, nullptr) == status);
    CHECK((std::isnan(expected[i]) ? std::isnan(p) && std::isnan(q[0]) : p == expected[i]));
  }
}

}  // namespace
