// Loops as files have them, gaps in recordings, and the ends of even grids.
#include <qtraj.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"
#include "support/catch.hpp"
#include "support/ends.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

Options repeating(const Variant& variant) {
  Options options = make_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
          QTRAJ_OK);
  return options;
}

// All of a sample in double.
struct Sample {
  double q[4], omega[3], alpha[3];
  qtraj_status status;
};
Sample sample_of(const qtraj_trajectory* curve, double time) {
  Sample s;
  s.status = qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, time, nullptr, s.q, s.omega, s.alpha);
  return s;
}
double difference(const double* a, const double* b, size_t count, double sign = 1) {
  double worst = 0;
  for (size_t k = 0; k < count; ++k) worst = std::max(worst, std::abs(a[k] - sign * b[k]));
  return worst;
}

// closed_tour without its closing key, starting at 0, and the period.
template <class Real>
Keyframes<Real> open_loop(size_t count, double& period) {
  Keyframes<Real> keys = closed_tour<Real>(count);
  const double first = keys.times.front();
  for (double& time : keys.times) time -= first;
  period = keys.times.back();
  keys.times.pop_back();
  keys.q.resize(4 * keys.times.size());
  return keys;
}

// ---- PERIODIC ----

TEST_CASE("C API: a curve that repeats does so to the last bit, however far away", "[capi][periodic]") {
  // times about 0, so that fmod itself is exact
  const double knots[] = {0, 0.175, 0.35, 0.525, 0.7};
  const double h = 0.70710678118654752;
  const double q[] = {1, 0, 0, 0, h, 0, 0, h, 0, 0, 0, 1, -h, 0, 0, h, -1, 0, 0, 0};
  const Keyframes<double> keys = {std::vector<double>(knots, knots + 5), std::vector<double>(q, q + 20)};
  for (const int32_t method : {QTRAJ_SLERP, QTRAJ_SQUAD, QTRAJ_ROTATION_SPLINE, QTRAJ_LOG_SPLINE}) {
    const Trajectory curve = must_build(repeating({"", method}).get(), keys);
    for (double far = 1.3; far < 2e9; far *= 17.1)
      for (int i = -40; i < 40; ++i) {
        const double time = i < 0 ? -far + 0.01 * i : far + 0.01 * i;
        double phase = std::fmod(time, 0.7);
        const bool odd = (static_cast<int64_t>(std::floor(time / 0.7)) & 1) != 0;
        if (phase < 0) phase += 0.7;
        CAPTURE(method, time, phase);
        const Sample there = sample_of(curve.get(), time), here = sample_of(curve.get(), phase);
        // where a negative remainder was rounded the samples differ by an ulp of the time
        CHECK(difference(there.q, here.q, 4, odd ? -1 : 1) <= 1e-15);
        CHECK(difference(there.omega, here.omega, 3) <= 1e-14);
      }
  }
}

TEST_CASE("C API: a period that is no double is repeated exactly too", "[capi][periodic]") {
  // 1.3 - 0.1 is no double; times in units of 2^-60, in which all are integers
  __extension__ using Integer = __int128;
  constexpr double kUnits = 0x1p60;
  const double first = 0.1, last = 1.3;
  const auto in_units = [&](double time) { return static_cast<Integer>(static_cast<long double>(time) * kUnits); };
  const Integer period = in_units(last) - in_units(first);
  CHECK(period != in_units(last - first));
  const Keyframes<double> keys = {{first, 0.5, last}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 1, 0, 0, 0}};
  const Trajectory curve = must_build(repeating({"", QTRAJ_SLERP}).get(), keys);
  for (double far = 3.7; far < 3e9; far *= 1.9)
    for (const double time : {far, -far}) {
      Integer phase = (in_units(time) - in_units(first)) % period;
      if (phase < 0) phase += period;
      const double inside = static_cast<double>(static_cast<long double>(phase + in_units(first)) / kUnits);
      CAPTURE(time, inside);
      CHECK(difference(sample_of(curve.get(), time).q, sample_of(curve.get(), inside).q, 4) <= 2e-15);
    }
}

TEST_CASE("C API: at the end of a curve that repeats, all is as at its start", "[capi][periodic]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Keyframes<double> keys = closed_tour<double>(6);
    const Trajectory curve = must_build(repeating(variant).get(), keys, rates_for<double>(variant, 6));
    const double first = keys.times.front(), last = keys.times.back();
    const Sample start = sample_of(curve.get(), first);
    double keys_out[24];
    REQUIRE(qtraj_keys(curve.get(), nullptr, keys_out) == QTRAJ_OK);
    for (const double end : {last, std::nextafter(last, DBL_MAX), last + (last - first)}) {
      const Sample at_end = sample_of(curve.get(), end);
      CHECK(at_end.status == QTRAJ_OK);
      if (end == last) CHECK(difference(at_end.q, keys_out + 20, 4) <= 4e-16);
      CHECK(difference(at_end.omega, start.omega, 3) <= 1e-14 * (end > last + 1 ? 10 : 0));
      CHECK(difference(at_end.alpha, start.alpha, 3) <= 1e-13 * (end > last + 1 ? 10 : 0));
    }
    // in a batch, too
    const Motion<double> batch = must_sample_rates<double>(curve.get(), QTRAJ_FRAME_BODY, std::vector<double>(9, last));
    CHECK(difference(batch.omega.data() + 24, start.omega, 3) == 0);
  }
}

// ---- Period and closure ----

TEST_CASE("C API: with a period the first key is repeated at its end", "[capi][period]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      double period = 0;
      const Keyframes<Real> open = open_loop<Real>(6, period);
      Keyframes<Real> closed = open;
      closed.times.push_back(open.times.front() + period);
      for (size_t k = 0; k < 4; ++k) closed.q.push_back(open.q[k]);
      const Rates<Real> rates = rates_for<Real>(variant, 5);
      Rates<Real> closed_rates = rates;
      for (auto* values : {&closed_rates.omega, &closed_rates.alpha})
        if (!values->empty()) values->insert(values->end(), values->begin(), values->begin() + 3);

      const Options options = repeating(variant), with_period = repeating(variant);
      REQUIRE(qtraj_options_set_period(with_period.get(), period) == QTRAJ_OK);
      const Trajectory expected = must_build(options.get(), closed, closed_rates),
                       curve = must_build(with_period.get(), open, rates);
      CHECK(qtraj_key_count(curve.get()) == 6);
      CHECK(qtraj_end_time(curve.get()) == closed.times.back());
      CHECK(qtraj_sign_flips(curve.get()) <= qtraj_sign_flips(expected.get()));
      const std::vector<double> times = times_in(closed.times, 7);
      CHECK(same_bits(must_sample<Real>(curve.get(), times), must_sample<Real>(expected.get(), times)));
      CHECK(same_bits(must_sample_rates<Real>(curve.get(), QTRAJ_FRAME_WORLD, times),
                      must_sample_rates<Real>(expected.get(), QTRAJ_FRAME_WORLD, times)));

      // in the caller's memory, which has room for one key more
      size_t bytes = 0, plain_bytes = 0;
      REQUIRE(qtraj_init_size(with_period.get(), 5, &bytes) == QTRAJ_OK);
      REQUIRE(qtraj_init_size(options.get(), 6, &plain_bytes) == QTRAJ_OK);
      CHECK(bytes == plain_bytes);
      std::vector<double> memory(bytes / 8);
      qtraj_trajectory* here = nullptr;
      REQUIRE(init(memory.data(), bytes, with_period.get(), QTRAJ_FRAME_BODY, open.times.data(), open.q.data(),
                   rates.omega_or_null(), rates.alpha_or_null(), 5, &here, nullptr) == QTRAJ_OK);
      CHECK(same_bits(must_sample<Real>(here, times), must_sample<Real>(expected.get(), times)));
    }
  });
}

TEST_CASE("C API: periods that are none, too short or too long", "[capi][period][errors]") {
  double period = 0;
  const Keyframes<double> open = open_loop<double>(6, period);
  const Options options = make_options({"", QTRAJ_SLERP});
  for (const double bad : {-1.0, -DBL_MIN, kNaN, kInfinity, -kInfinity})
    CHECK(qtraj_options_set_period(options.get(), bad) == QTRAJ_E_VALUE);
  CHECK(build(options.get(), open).status == QTRAJ_OK);  // and had no effect
  CHECK(qtraj_key_count(build(options.get(), open).trajectory.get()) == 5);
  const double last = open.times.back();
  for (const double bad : {1e-3, last, 0.5 * last}) {
    REQUIRE(qtraj_options_set_period(options.get(), bad) == QTRAJ_OK);
    const Built built = build(options.get(), open);
    CHECK(built.status == QTRAJ_E_TIME_ORDER);
    CHECK(built.bad_index == 4);
  }
  REQUIRE(qtraj_options_set_period(options.get(), DBL_MAX) == QTRAJ_OK);
  Keyframes<double> late = open;
  for (double& time : late.times) time += 1e300;
  late.times = {1e300, 1.1e300, 1.2e300, 1.3e300, 1.4e300};
  CHECK(build(options.get(), late).status == QTRAJ_E_TIME_SPAN);
  REQUIRE(qtraj_options_set_period(options.get(), 0) == QTRAJ_OK);
  CHECK(qtraj_key_count(build(options.get(), open).trajectory.get()) == 5);
}

TEST_CASE("C API: the last knot of a period is the first, also where their times are rounded", "[capi][period]") {
  test::Random random(8);
  for (int run = 0; run < 300; ++run) {
    const double first = run % 3 == 0 ? 1e9 + random.uniform(0, 1) : random.uniform(0.1, 100);
    const double period = random.uniform(0.7, 14);
    const Keyframes<double> keys = {{first, first + 0.2 * period, first + 0.5 * period},
                                    {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0.6, 0, 0.8, 0}};
    const Options options = repeating({"", QTRAJ_SLERP});
    REQUIRE(qtraj_options_set_period(options.get(), period) == QTRAJ_OK);
    REQUIRE(qtraj_options_set_longest_gap(options.get(), 0.4 * period) == QTRAJ_OK);
    const Trajectory curve = must_build(options.get(), keys);
    const double last = qtraj_end_time(curve.get());
    const Sample start = sample_of(curve.get(), first);
    CAPTURE(first, period);
    for (const double end : {last, std::nextafter(last, DBL_MAX)}) {
      const Sample at_end = sample_of(curve.get(), end);
      CHECK(at_end.status == QTRAJ_OK);
      CHECK(difference(at_end.omega, start.omega, 3) == 0);
    }
  }
}

TEST_CASE("C API: what is wrong with a key that a period adds is said of the last key before it",
          "[capi][period][errors]") {
  // wound round: the spline of logs does not come back by the way it went
  Keyframes<double> keys;
  for (int i = 0; i < 4; ++i) {
    const double half = 0.8 * i;
    keys.times.push_back(i);
    for (const double component : {std::cos(half), std::sin(half), 0.0, 0.0}) keys.q.push_back(component);
  }
  const Options log = make_options({"", QTRAJ_LOG_SPLINE, QTRAJ_END_PERIODIC});
  REQUIRE(qtraj_options_set_period(log.get(), 4) == QTRAJ_OK);
  const Built wound = build(log.get(), keys);
  CHECK(wound.status == QTRAJ_E_NOT_CLOSED);
  CHECK(wound.bad_index == 3);

  const Options turning = make_options({"", QTRAJ_SLERP});
  REQUIRE(qtraj_options_set_turns(turning.get(), QTRAJ_TURNS_GIVEN) == QTRAJ_OK);
  REQUIRE(qtraj_options_set_period(turning.get(), 3) == QTRAJ_OK);
  const Keyframes<double> still = {{0, 1}, {1, 0, 0, 0, 1, 0, 0, 0}};
  const int32_t turns[2] = {0, 1};
  qtraj_trajectory* out = nullptr;
  size_t bad = 7;
  CHECK(qtraj_create_with_turns(turning.get(), 0, still.times.data(), still.q.data(), nullptr, nullptr, turns, 2, &out,
                                &bad) == QTRAJ_E_AMBIGUOUS);
  CHECK(bad == 1);
}

TEST_CASE("C API: a closing key that is moved far keeps the shorter step and is in least_dot", "[capi][closure]") {
  Keyframes<double> keys;
  for (const double degrees : {0.0, 40.0, 80.0, 95.0}) {
    const double half = degrees * 3.14159265358979 / 180;
    keys.times.push_back(degrees);
    for (const double component : {std::cos(half), std::sin(half), 0.0, 0.0}) keys.q.push_back(component);
  }
  const Options options = repeating({"", QTRAJ_SLERP});
  REQUIRE(qtraj_options_set_closure(options.get(), 3.14) == QTRAJ_OK);
  const Trajectory curve = must_build(options.get(), keys);
  double q[16];
  REQUIRE(qtraj_keys(curve.get(), nullptr, q) == QTRAJ_OK);
  double last_dot = 0;
  for (int k = 0; k < 4; ++k) last_dot += q[8 + k] * q[12 + k];
  CHECK(last_dot > 0);
  CHECK(std::abs(qtraj_least_dot(curve.get()) - last_dot) <= 1e-15);
}

TEST_CASE("C API: a given rate too fast for the closing interval names the first key", "[capi][period][errors]") {
  const Options options = make_options({"", QTRAJ_HERMITE});
  REQUIRE(qtraj_options_set_period(options.get(), 1e200) == QTRAJ_OK);
  const Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, 1, 0, 0, 0}};
  const Rates<double> rates = {{0x1p490, 0, 0, 0, 0, 0}, {}};
  const Built built = build(options.get(), keys, rates);
  CHECK(built.status == QTRAJ_E_RATE_TOO_FAST);
  CHECK(built.bad_index == 0);
}

TEST_CASE("C API: the period given is the one that repeats, not that of the rounded knots", "[capi][period]") {
  // seconds since 1970: the last knot is rounded to 2.4e-7 s
  const double first = 1.7e9, period = 0.7;
  const Keyframes<double> keys = {{first, first + 0.25, first + 0.5}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0.8, -0.6, 0, 0}};
  const Options options = repeating({"", QTRAJ_ROTATION_SPLINE});
  REQUIRE(qtraj_options_set_period(options.get(), period) == QTRAJ_OK);
  const Trajectory curve = must_build(options.get(), keys);
  const double later = first + 7e6;  // 1e7 periods, whole seconds
  const double phase = std::fmod(7e6, period);
  CHECK(difference(sample_of(curve.get(), later).q, sample_of(curve.get(), first + phase).q, 4) <= 1e-6);
}

TEST_CASE("C API: the closure angle decides what counts as closed", "[capi][closure]") {
  for (const double angle : {1e-9, 9e-7, 2e-5, 0.1}) {
    Keyframes<double> keys = closed_tour<double>(6);
    keys.q[20] = std::cos(angle / 2), keys.q[21] = std::sin(angle / 2), keys.q[22] = keys.q[23] = 0;
    const Options options = repeating({"", QTRAJ_SQUAD});
    CHECK(build(options.get(), keys).status == (angle < 1e-6 ? QTRAJ_OK : QTRAJ_E_NOT_CLOSED));
    REQUIRE(qtraj_options_set_closure(options.get(), 1.01 * angle) == QTRAJ_OK);
    const Trajectory curve = must_build(options.get(), keys);
    double q[24];
    REQUIRE(qtraj_keys(curve.get(), nullptr, q) == QTRAJ_OK);
    CHECK(difference(q, q + 20, 4, q[0] * q[20] < 0 ? -1 : 1) == 0);
    REQUIRE(qtraj_options_set_closure(options.get(), 0.99 * angle) == QTRAJ_OK);
    const Built refused = build(options.get(), keys);
    CHECK(refused.status == QTRAJ_E_NOT_CLOSED);
    CHECK(refused.bad_index == 5);
    for (const double bad : {-1e-9, 3.15, kNaN, kInfinity})
      CHECK(qtraj_options_set_closure(options.get(), bad) == QTRAJ_E_VALUE);
    CHECK(build(options.get(), keys).status == QTRAJ_E_NOT_CLOSED);
  }
}

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
