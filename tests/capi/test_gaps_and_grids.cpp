// Gaps in recordings, and the ends of even grids.
#include <qtraj.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

#include "support/capi_floating.hpp"
#include "support/capi_one_sample.hpp"
#include "support/capi_variants.hpp"
#include "support/catch.hpp"
#include "support/ends.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

// ---- Gaps ----

TEST_CASE("C API: a time inside a long gap is GAP, the knots at its ends are samples", "[capi][gap]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      Keyframes<Real> keys = closed_tour<Real>(9);
      for (size_t i = 4; i < 9; ++i) keys.times[i] += 12.0;  // between keys 3 and 4
      const Rates<Real> rates = rates_for<Real>(variant, 9);
      const Options options = make_options(variant);
      const Trajectory whole = must_build(options.get(), keys, rates);
      REQUIRE(qtraj_options_set_longest_gap(options.get(), 3.0) == QTRAJ_OK);
      const Trajectory curve = must_build(options.get(), keys, rates);
      const double from = keys.times[3], to = keys.times[4];

      std::vector<double> times = times_in(keys.times, 40);
      for (const double time : {from, std::nextafter(from, to), 0.5 * (from + to), std::nextafter(to, from), to})
        times.push_back(time);
      for (const bool sorted : {false, true}) {
        if (sorted) std::sort(times.begin(), times.end());
        const std::vector<Real> expected = must_sample<Real>(whole.get(), times);
        const Motion<Real> expected_rates = must_sample_rates<Real>(whole.get(), QTRAJ_FRAME_BODY, times);
        std::vector<Real> q(4 * times.size());
        Motion<Real> motion(times.size());
        size_t bad = 0, bad_rates = 0, first = times.size(), wrong = 0;
        CHECK(sample(curve.get(), times.data(), times.size(), q.data(), &bad) == QTRAJ_E_GAP);
        CHECK(sample_rates(curve.get(), QTRAJ_FRAME_BODY, times.data(), times.size(), motion.q.data(),
                           motion.omega.data(), motion.alpha.data(), &bad_rates) == QTRAJ_E_GAP);
        for (size_t i = times.size(); i-- > 0;) {
          const bool in_gap = times[i] > from && times[i] < to;
          if (in_gap) first = i;
          for (size_t k = 4 * i; k < 4 * i + 4; ++k)
            wrong += in_gap ? !std::isnan(q[k]) || !std::isnan(motion.q[k])
                            : q[k] != expected[k] || motion.q[k] != expected[k];
          for (size_t k = 3 * i; k < 3 * i + 3; ++k)
            wrong += in_gap ? !std::isnan(motion.omega[k]) || !std::isnan(motion.alpha[k])
                            : motion.omega[k] != expected_rates.omega[k] || motion.alpha[k] != expected_rates.alpha[k];
          Real one[4], omega[3];
          size_t cursor = 0;
          const qtraj_status status = in_gap ? QTRAJ_E_GAP : QTRAJ_OK;
          wrong += sample_at(curve.get(), times[i], &cursor, one) != status;
          wrong += in_gap ? !std::isnan(one[0]) : one[0] != expected[4 * i];
          wrong += sample_rates_at(curve.get(), QTRAJ_FRAME_BODY, times[i], nullptr, one, omega,
                                   static_cast<Real*>(nullptr)) != status;
        }
        CHECK(wrong == 0);
        CHECK(bad == first);
        CHECK(bad_rates == first);
      }
      std::vector<Real> uniform(400);
      size_t bad = 0;
      CHECK(sample_uniform(curve.get(), from - 0.25, 0.25, 100, uniform.data(), &bad) == QTRAJ_E_GAP);
      CHECK(bad == 2);
    }
  });
}

TEST_CASE("C API: the longest gap is a limit that intervals may reach; none is infinite", "[capi][gap]") {
  const Keyframes<double> keys = {{0, 1, 3}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 1, 0, 0, 0}};
  const Options options = make_options({"", QTRAJ_SLERP});
  const auto at = [&](double seconds, double time) {
    REQUIRE(qtraj_options_set_longest_gap(options.get(), seconds) == QTRAJ_OK);
    double q[4];
    return qtraj_sample_at(must_build(options.get(), keys).get(), time, nullptr, q);
  };
  CHECK(at(2.0, 2.5) == QTRAJ_OK);
  CHECK(at(std::nextafter(2.0, 0.0), 2.5) == QTRAJ_E_GAP);
  CHECK(at(std::nextafter(2.0, 0.0), 0.5) == QTRAJ_OK);
  CHECK(at(DBL_MIN, 0.5) == QTRAJ_E_GAP);
  CHECK(at(0, 2.5) == QTRAJ_OK);
  CHECK(at(kInfinity, 2.5) == QTRAJ_OK);
  for (const double bad : {-1.0, kNaN, -kInfinity})
    CHECK(qtraj_options_set_longest_gap(options.get(), bad) == QTRAJ_E_VALUE);
  // outside, the extrapolation decides; a repeated time may be in the gap
  CHECK(at(1.5, 4.0) == QTRAJ_E_TIME_RANGE);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
          QTRAJ_OK);
  CHECK(at(1.5, 3.5) == QTRAJ_OK);
  CHECK(at(1.5, 5.5) == QTRAJ_E_GAP);
}

// ---- Ends of even grids ----

TEST_CASE("C API: the last sample of an even grid is one", "[capi][grid]") {
  const Keyframes<double> keys = {{0, 0.35, 0.6}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0, 1, 0, 0}};
  for (const Variant& variant : variants()) {
    if (variant.end == QTRAJ_END_PERIODIC) continue;
    for (const int32_t rule : {QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE}) {
      CAPTURE(variant.name, rule);
      const Options options = make_options(variant);
      REQUIRE(qtraj_options_set_extrapolation(options.get(), rule, rule) == QTRAJ_OK);
      const Trajectory curve = must_build(options.get(), keys, rates_for<double>(variant, 3));
      double q[28], last[4];
      CHECK(0.1 * 6 > 0.6);
      CHECK(qtraj_sample_uniform(curve.get(), 0, 0.1, 7, q, nullptr) == QTRAJ_OK);
      CHECK(qtraj_sample_at(curve.get(), 0.6, nullptr, last) == QTRAJ_OK);
      CHECK(difference(q + 24, last, 4) == 0);
      // all functions, both ends, the very limit
      const Sample first = sample_of(curve.get(), 0.0), end = sample_of(curve.get(), 0.6);
      const double reach = test::reach_of(0, 0.6);
      for (const double off : {0.25, 0.75, 1.0}) {
        CHECK(difference(sample_of(curve.get(), -off * reach).omega, first.omega, 3) == 0);
        CHECK(difference(sample_of(curve.get(), 0.6 + off * reach).alpha, end.alpha, 3) == 0);
      }
      if (rule != QTRAJ_EXTRAPOLATE_ERROR) continue;
      CHECK(sample_of(curve.get(), test::before_all(0, 0.6)).status == QTRAJ_E_TIME_RANGE);
      CHECK(sample_of(curve.get(), test::after_all(0, 0.6)).status == QTRAJ_E_TIME_RANGE);
    }
  }
}

TEST_CASE("C API: uniform_count counts the samples within the knots", "[capi][grid]") {
  const Keyframes<double> keys = {{0, 0.35, 0.6}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0, 1, 0, 0}};
  const Trajectory curve = must_build(make_options({"", QTRAJ_SLERP}).get(), keys);
  const auto count_of = [&](double start, double step) {
    size_t count = 7;
    const qtraj_status status = qtraj_uniform_count(curve.get(), start, step, &count);
    CHECK((status == QTRAJ_OK) == (count > 0));
    return count;
  };
  CHECK(count_of(0, 0.1) == 7);
  CHECK(count_of(0.6, -0.1) == 7);
  CHECK(count_of(0.05, 0.1) == 6);
  CHECK(count_of(0, 0.7) == 1);
  CHECK(count_of(0.6, 0.1) == 1);
  CHECK(count_of(0, 5e-324) == 0);                 // SIZE
  CHECK(count_of(0.6, 1e-30) > 100000000000000u);  // rounded times stay near the start for so long
  CHECK(count_of(0.6, 1e-17) > 40);
  size_t count = 7;
  CHECK(qtraj_uniform_count(curve.get(), 0, 0, &count) == QTRAJ_E_VALUE);
  CHECK(qtraj_uniform_count(curve.get(), -1, 0.1, &count) == QTRAJ_E_TIME_RANGE);
  CHECK(qtraj_uniform_count(curve.get(), 0.7, -0.1, &count) == QTRAJ_E_TIME_RANGE);
  CHECK(qtraj_uniform_count(curve.get(), kNaN, 0.1, &count) == QTRAJ_E_NOT_FINITE);
  CHECK(qtraj_uniform_count(curve.get(), 0, kInfinity, &count) == QTRAJ_E_NOT_FINITE);
  CHECK(qtraj_uniform_count(curve.get(), 0, 1e-17, &count) == QTRAJ_E_SIZE);
  CHECK(count == 0);
  CHECK(qtraj_uniform_count(curve.get(), 0, 1, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_uniform_count(nullptr, 0, 1, &count) == QTRAJ_E_NULL);
  // times that overflow are outside
  const Keyframes<double> wide = {{-1e308, 0}, {1, 0, 0, 0, 0.8, 0.6, 0, 0}};
  const Trajectory far = must_build(make_options({"", QTRAJ_SLERP}).get(), wide);
  CHECK(qtraj_uniform_count(far.get(), -1e308, -1e308, &count) == QTRAJ_OK);
  CHECK(count == 1);
  CHECK(qtraj_uniform_count(far.get(), -1e308, 0.6e308, &count) == QTRAJ_OK);
  CHECK(count == 2);
}

TEST_CASE("C API: as many samples as uniform_count says are within the knots, and no more", "[capi][grid]") {
  test::Random random(4);
  for (int run = 0; run < 2000; ++run) {
    const double first = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-3, 9)),
                 span = std::pow(10.0, random.uniform(-2, 4));
    const Keyframes<double> keys = {{first, first + span}, {1, 0, 0, 0, 0.8, 0.6, 0, 0}};
    const Trajectory curve = must_build(make_options({"", QTRAJ_SLERP}).get(), keys);
    // steps that divide the span, to rounding, and others
    const double steps = std::floor(random.uniform(1, 300));
    const double step = run % 2 ? span / steps : span * random.uniform(0.003, 1.2);
    size_t count = 0;
    REQUIRE(qtraj_uniform_count(curve.get(), first, step, &count) == QTRAJ_OK);
    std::vector<double> q(4 * (count + 1));
    size_t bad = 0;
    CAPTURE(first, span, step, count);
    CHECK(qtraj_sample_uniform(curve.get(), first, step, count, q.data(), &bad) == QTRAJ_OK);
    CHECK(qtraj_sample_uniform(curve.get(), first, step, count + 1, q.data(), &bad) == QTRAJ_E_TIME_RANGE);
    CHECK(bad == count);
  }
}

}  // namespace
