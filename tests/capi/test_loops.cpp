// Curves that repeat, and loops as files have them.
#include <qtraj.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

#include "support/capi_floating.hpp"
#include "support/capi_one_sample.hpp"
#include "support/capi_variants.hpp"
#include "support/catch.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

Options repeating(const Variant& variant) {
  Options options = make_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
          QTRAJ_OK);
  return options;
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
      for (auto* values : {&closed_rates.in_tangents, &closed_rates.out_tangents})
        if (!values->empty()) values->insert(values->end(), values->begin(), values->begin() + 4);

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
      REQUIRE(build_in(memory.data(), bytes, with_period.get(), open, rates, &here) == QTRAJ_OK);
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

}  // namespace
