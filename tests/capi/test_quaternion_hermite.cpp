// QUATERNION_HERMITE: it goes through keys as they are written, with their norms and signs; what settings, diagnostics
// and extrapolation make of it.
#include <cfloat>

#include "support/capi_variants.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

using Rows = std::vector<double>;

struct TangentKeys {
  Keyframes<double> keys;
  Rates<double> tangents;
};

// A walk, its norms between 0.5 and 2, signs continuous, with tangents of both sides.
TangentKeys random_keys(uint64_t seed, size_t count, double step = 1.0) {
  test::Random random(seed);
  const test::Keys walk = random_walk(random, count, step, 0.2, 2.0);
  TangentKeys all;
  all.keys.times = walk.times;
  all.keys.q.resize(4 * count);
  REQUIRE(qtraj_make_continuous(walk.q.data(), 1, count, all.keys.q.data(), nullptr, nullptr) == QTRAJ_OK);
  for (size_t key = 0; key < count; ++key) {
    const double norm = random.uniform(0.5, 2.0);
    for (size_t k = 4 * key; k < 4 * key + 4; ++k) {
      all.keys.q[k] *= norm;
      all.tangents.in_tangents.push_back(norm * random.uniform(-0.5, 0.5));
      all.tangents.out_tangents.push_back(norm * random.uniform(-0.5, 0.5));
    }
  }
  return all;
}

Options options_with(int32_t turns, int32_t extrapolation = QTRAJ_EXTRAPOLATE_ERROR) {
  Options options = make_options({"", QTRAJ_QUATERNION_HERMITE});
  REQUIRE(qtraj_options_set_turns(options.get(), turns) == QTRAJ_OK);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), extrapolation, extrapolation) == QTRAJ_OK);
  return options;
}

struct Polynomial {
  Rows p, dp, ddp;
};
Polynomial polynomial_at(const qtraj_trajectory* curve, const Rows& times) {
  Polynomial at = {Rows(4 * times.size()), Rows(4 * times.size()), Rows(4 * times.size())};
  REQUIRE(qtraj_sample_unnormalized(curve, times.data(), times.size(), at.p.data(), at.dp.data(), at.ddp.data(),
                                    nullptr) == QTRAJ_OK);
  return at;
}

double largest_difference(const double* a, const double* b, size_t count, double factor = 1.0) {
  double worst = 0;
  for (size_t k = 0; k < count; ++k) test::raise_to(worst, std::abs(a[k] - factor * b[k]));
  return worst;
}
double largest_difference(const Rows& a, const Rows& b, double factor = 1.0) {
  REQUIRE(a.size() == b.size());
  return largest_difference(a.data(), b.data(), a.size(), factor);
}

TEST_CASE("C API: the cubic goes through keys as written, with their norms, by their tangents",
          "[capi][quaternion_hermite]") {
  for (const double scale : {1.0, 0x1p90, 0x1p-90}) {
    TangentKeys all = random_keys(5, 9);
    for (Rows* rows : {&all.keys.q, &all.tangents.in_tangents, &all.tangents.out_tangents})
      for (double& number : *rows) number *= scale;
    const Trajectory curve = must_build(options_with(QTRAJ_TURNS_DEFAULT).get(), all.keys, all.tangents);
    const Polynomial right = polynomial_at(curve.get(), all.keys.times);
    CHECK(largest_difference(right.p, all.keys.q) <= 4 * DBL_EPSILON * scale);
    CHECK(largest_difference(right.dp.data(), all.tangents.out_tangents.data(), 4 * 8) <= 1e-14 * scale);
    // at the last knot the left-hand one
    CHECK(largest_difference(&right.dp[4 * 8], &all.tangents.in_tangents[4 * 8], 4) <= 1e-14 * scale);
    Rows before = all.keys.times;
    for (double& time : before) time = std::nextafter(time, -10.0);
    before[0] = all.keys.times[0];
    const Polynomial left = polynomial_at(curve.get(), before);
    CHECK(largest_difference(&left.dp[4], &all.tangents.in_tangents[4], 4 * 8) <= 1e-13 * scale);
    CHECK(qtraj_worst_norm_error(curve.get()) > 0.1);
  }
}

TEST_CASE("C API: a cubic about one key, and the rates of its formula", "[capi][quaternion_hermite]") {
  // p = (1, u^2 (3 - 2u), 0, 0): a turn about x by 2 atan of the second component
  const Keyframes<double> keys = {{0, 2}, {1, 0, 0, 0, 1, 1, 0, 0}};
  Rates<double> still;
  still.in_tangents.assign(8, 0.0), still.out_tangents.assign(8, 0.0);
  const Trajectory curve = must_build(options_with(QTRAJ_TURNS_DEFAULT).get(), keys, still);
  for (const double u : {0.0, 0.125, 0.5, 0.7, 1.0}) {
    double q[4], omega[3], alpha[3];
    REQUIRE(qtraj_sample_rates_at(curve.get(), QTRAJ_FRAME_BODY, 2 * u, nullptr, q, omega, alpha) == QTRAJ_OK);
    const double v = u * u * (3 - 2 * u), dv = 3 * u * (1 - u), ddv = 1.5 * (1 - 2 * u);  // per s
    CHECK(std::abs(q[1] / q[0] - v) <= 4e-16);
    CHECK(std::abs(omega[0] - 2 * dv / (1 + v * v)) <= 1e-15);
    CHECK(std::abs(alpha[0] - (2 * ddv / (1 + v * v) - 4 * v * dv * dv / (1 + v * v) / (1 + v * v))) <= 4e-15);
    CHECK((omega[1] == 0 && omega[2] == 0 && alpha[1] == 0 && alpha[2] == 0));
  }
}

TEST_CASE("C API: tangents that are the same on both sides make it C1", "[capi][quaternion_hermite]") {
  TangentKeys all = random_keys(6, 9);
  qtraj_trajectory* out = nullptr;
  REQUIRE(qtraj_create_with_tangents(options_with(QTRAJ_TURNS_DEFAULT).get(), all.keys.times.data(), all.keys.q.data(),
                                     all.tangents.in_tangents.data(), nullptr, 9, &out, nullptr) == QTRAJ_OK);
  const Trajectory curve(out);
  Rows jumps(27);
  REQUIRE(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_WORLD, jumps.data(), nullptr) == QTRAJ_OK);
  CHECK(largest_difference(jumps, Rows(27)) <= 1e-14);
  const Trajectory sharp = must_build(options_with(QTRAJ_TURNS_DEFAULT).get(), all.keys, all.tangents);
  REQUIRE(qtraj_curve_jumps(sharp.get(), QTRAJ_FRAME_WORLD, jumps.data(), nullptr) == QTRAJ_OK);
  CHECK(largest_difference(jumps, Rows(27)) > 0.1);
}

// Keys whose signs change, with tangents that change along.
TangentKeys flipped(TangentKeys all) {
  for (const size_t key : {size_t{1}, size_t{2}, size_t{5}})
    for (Rows* rows : {&all.keys.q, &all.tangents.in_tangents, &all.tangents.out_tangents})
      for (size_t k = 4 * key; k < 4 * key + 4; ++k) (*rows)[k] = -(*rows)[k];
  return all;
}

TEST_CASE("C API: signs are prescribed, by SHORTEST they are continued with their tangents",
          "[capi][quaternion_hermite]") {
  const TangentKeys all = random_keys(7, 8), changed = flipped(all);
  const Rows times = times_in(all.keys.times, 20);
  const Trajectory expected = must_build(options_with(QTRAJ_TURNS_DEFAULT).get(), all.keys, all.tangents);
  const Trajectory shortest = must_build(options_with(QTRAJ_TURNS_SHORTEST).get(), changed.keys, changed.tangents);
  CHECK(must_sample<double>(shortest.get(), times) == must_sample<double>(expected.get(), times));
  CHECK(qtraj_sign_flips(shortest.get()) == 3);
  CHECK(qtraj_sign_flips(expected.get()) == 0);

  const Trajectory as_given = must_build(options_with(QTRAJ_TURNS_DEFAULT).get(), changed.keys, changed.tangents);
  CHECK(qtraj_sign_flips(as_given.get()) == 0);
  const Polynomial at = polynomial_at(as_given.get(), changed.keys.times);
  CHECK(largest_difference(at.p, changed.keys.q) <= 4 * DBL_EPSILON);
  // a step between keys whose dot product is negative goes the other way round, over more than half a turn
  double angle = 0, shorter = 0;
  REQUIRE(qtraj_curve_total_angle(as_given.get(), &angle) == QTRAJ_OK);
  REQUIRE(qtraj_curve_total_angle(expected.get(), &shorter) == QTRAJ_OK);
  CHECK(angle > shorter + 4 * 3.14);
}

TEST_CASE("C API: keys of extreme size are scaled together", "[capi][quaternion_hermite]") {
  const TangentKeys all = random_keys(8, 6);
  const Rows times = times_in(all.keys.times, 20);
  const Trajectory ordinary = must_build(options_with(QTRAJ_TURNS_DEFAULT).get(), all.keys, all.tangents);
  const Motion<double> expected = must_sample_rates<double>(ordinary.get(), QTRAJ_FRAME_BODY, times);
  const Motion<float> expected_f32 = must_sample_rates<float>(ordinary.get(), QTRAJ_FRAME_BODY, times);
  for (const double scale : {0x1p-1000, 0x1p-400, 0x1p-30, 0x1p30, 0x1p99, 0x1p400, 0x1p1020}) {
    CAPTURE(scale);
    TangentKeys scaled = all;
    for (Rows* rows : {&scaled.keys.q, &scaled.tangents.in_tangents, &scaled.tangents.out_tangents})
      for (double& number : *rows) number *= scale;
    const Trajectory curve = must_build(options_with(QTRAJ_TURNS_DEFAULT).get(), scaled.keys, scaled.tangents);
    // a power of two changes no bit, but that float samples are then taken in double
    CHECK(same_bits(must_sample_rates<double>(curve.get(), QTRAJ_FRAME_BODY, times), expected));
    const Motion<float> single = must_sample_rates<float>(curve.get(), QTRAJ_FRAME_BODY, times);
    for (size_t k = 0; k < single.q.size(); ++k) CHECK(std::abs(single.q[k] - expected_f32.q[k]) <= 1e-6f);
    double peak = 0, peak_before = 0, energy = 0, energy_before = 0;
    REQUIRE(qtraj_curve_peak_rates(ordinary.get(), &peak_before, nullptr, nullptr, nullptr) == QTRAJ_OK);
    REQUIRE(qtraj_curve_peak_rates(curve.get(), &peak, nullptr, nullptr, nullptr) == QTRAJ_OK);
    REQUIRE(qtraj_curve_energy(ordinary.get(), &energy_before) == QTRAJ_OK);
    REQUIRE(qtraj_curve_energy(curve.get(), &energy) == QTRAJ_OK);
    CHECK(std::abs(peak - peak_before) <= 1e-9 * peak_before);
    CHECK(std::abs(energy - energy_before) <= 1e-8 * energy_before);
  }
}

TEST_CASE("C API: keys of different size are one curve, and the smaller have the digits that are left",
          "[capi][quaternion_hermite]") {
  for (const double ratio : {0.5, 1e-3, 1e-7, 1e-12}) {
    Keyframes<double> keys = {{0, 1, 2}, {1, 0, 0, 0, 0, ratio, 0, 0, 0, 0, 1, 0}};
    Rates<double> still;
    still.in_tangents.assign(12, 0.0), still.out_tangents.assign(12, 0.0);
    const Trajectory curve = must_build(options_with(QTRAJ_TURNS_DEFAULT).get(), keys, still);
    const double rounding = 4 * DBL_EPSILON / ratio;
    CHECK(largest_difference(must_sample<double>(curve.get(), {1}), {0, 1, 0, 0}) <= rounding);
    const std::vector<float> single = must_sample<float>(curve.get(), {1});
    CHECK(std::abs(single[1] - 1) <= static_cast<float>(ratio < 0x1p-20 ? rounding : 1e-6 / ratio) + 1e-7f);
    double norm = 0, time = 0;
    REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, &time) == QTRAJ_OK);
    CHECK(norm <= ratio + 4 * DBL_EPSILON);
  }
}

TEST_CASE("C API: a cubic through 0 is the identity there, with rates 0", "[capi][quaternion_hermite]") {
  const Keyframes<double> keys = {{0, 2}, {0, 1, 0, 0, 0, -1, 0, 0}};
  Rates<double> still;
  still.in_tangents.assign(8, 0.0), still.out_tangents.assign(8, 0.0);
  const Trajectory curve = must_build(options_with(QTRAJ_TURNS_AS_GIVEN).get(), keys, still);
  const Motion<double> at = must_sample_rates<double>(curve.get(), QTRAJ_FRAME_BODY, {1});
  CHECK(at.q == Rows{1, 0, 0, 0});
  CHECK((at.omega == Rows(3) && at.alpha == Rows(3)));
  CHECK(must_sample<float>(curve.get(), {1}) == std::vector<float>{1, 0, 0, 0});
  double norm = 1, time = 0;
  REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, &time) == QTRAJ_OK);
  CHECK((norm == 0 && time == 1));
  CHECK(qtraj_curve_energy(curve.get(), &norm) == QTRAJ_E_NO_CONVERGENCE);
}

TEST_CASE("C API: a period adds the first key with its tangents", "[capi][quaternion_hermite]") {
  const TangentKeys all = random_keys(9, 6);
  const Options options = options_with(QTRAJ_TURNS_DEFAULT, QTRAJ_EXTRAPOLATE_PERIODIC);
  const double period = all.keys.times.back() - all.keys.times.front() + 1.5;
  REQUIRE(qtraj_options_set_period(options.get(), period) == QTRAJ_OK);
  const Trajectory curve = must_build(options.get(), all.keys, all.tangents);
  REQUIRE(qtraj_key_count(curve.get()) == 7);

  // what is meant, written out; the step that is added is the shorter turn
  TangentKeys closed = all;
  closed.keys.times.push_back(all.keys.times.front() + period);
  double product = 0;
  for (size_t k = 0; k < 4; ++k) product += all.keys.q[k] * all.keys.q[20 + k];
  const double sign = product < 0 ? -1 : 1;
  for (size_t k = 0; k < 4; ++k) {
    closed.keys.q.push_back(sign * all.keys.q[k]);
    closed.tangents.in_tangents.push_back(sign * all.tangents.in_tangents[k]);
    closed.tangents.out_tangents.push_back(sign * all.tangents.out_tangents[k]);
  }
  const Trajectory expected =
      must_build(options_with(QTRAJ_TURNS_DEFAULT, QTRAJ_EXTRAPOLATE_PERIODIC).get(), closed.keys, closed.tangents);
  const Rows times = times_in(closed.keys.times, 20);
  CHECK(must_sample<double>(curve.get(), times) == must_sample<double>(expected.get(), times));
  Rows later = times;
  for (double& time : later) time += 4 * period;
  CHECK(largest_difference(must_sample<double>(curve.get(), later), must_sample<double>(curve.get(), times)) <= 1e-13);
}

TEST_CASE("C API: the last key of a curve that repeats has the direction of the first and its own norm",
          "[capi][quaternion_hermite]") {
  for (const double sign : {1.0, -1.0}) {
    TangentKeys all = random_keys(10, 5);
    for (size_t k = 0; k < 4; ++k) all.keys.q[16 + k] = sign * 1.75 * all.keys.q[k];
    all.keys.q[17] += 1e-7;  // within the closure angle
    const Trajectory curve =
        must_build(options_with(QTRAJ_TURNS_DEFAULT, QTRAJ_EXTRAPOLATE_PERIODIC).get(), all.keys, all.tangents);
    const Rows ends = {all.keys.times.front(), std::nextafter(all.keys.times.back(), 0.0)};
    const Polynomial at = polynomial_at(curve.get(), ends);
    CHECK(largest_difference(&at.p[4], at.p.data(), 4, sign * 1.75) <= 1e-6);
    Rows unit(8);
    REQUIRE(qtraj_normalize(at.p.data(), 2, unit.data(), nullptr) == QTRAJ_OK);
    CHECK(largest_difference(&unit[4], unit.data(), 4, sign) <= 1e-15);
    CHECK(largest_difference(&at.dp[4], &all.tangents.in_tangents[16], 4) <= 1e-13);
  }
}

TEST_CASE("C API: beyond the keys CONSTANT_RATE goes on with the rates of the tangents", "[capi][quaternion_hermite]") {
  const TangentKeys all = random_keys(11, 5);
  const Trajectory curve =
      must_build(options_with(QTRAJ_TURNS_DEFAULT, QTRAJ_EXTRAPOLATE_CONSTANT_RATE).get(), all.keys, all.tangents);
  const double first = all.keys.times.front(), last = all.keys.times.back();
  const Motion<double> at =
      must_sample_rates<double>(curve.get(), QTRAJ_FRAME_BODY, {first - 1, first, last, last + 1});
  CHECK(largest_difference(&at.omega[0], &at.omega[3], 3) <= 1e-15);
  CHECK(largest_difference(&at.omega[9], &at.omega[6], 3) <= 1e-14);
}

TEST_CASE("C API: least norm, mismatch and gaps of a QUATERNION_HERMITE", "[capi][quaternion_hermite]") {
  const TangentKeys all = random_keys(12, 7, 2.5);
  const Options options = options_with(QTRAJ_TURNS_DEFAULT);
  const Trajectory curve = must_build(options.get(), all.keys, all.tangents);
  double dense = 1e300, norm = 0, time = 0;
  const Polynomial at = polynomial_at(curve.get(), times_in(all.keys.times, 2000));
  for (size_t i = 0; i < at.p.size(); i += 4)
    dense = std::min(dense, std::sqrt(at.p[i] * at.p[i] + at.p[i + 1] * at.p[i + 1] + at.p[i + 2] * at.p[i + 2] +
                                      at.p[i + 3] * at.p[i + 3]));
  REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, &time) == QTRAJ_OK);
  CHECK(norm <= dense * (1 + 1e-15));
  CHECK(norm >= dense * (1 - 1e-5));
  CHECK((time >= all.keys.times.front() && time <= all.keys.times.back()));

  // tangents that turn a step of 0.2 rad by as much, and world axes for body ones: exp(u w) between two keys
  const double half = 0.1;
  const Keyframes<double> two = {{0, 1}, {1, 0, 0, 0, std::cos(half), 0, std::sin(half), 0}};
  Rates<double> fitting;
  fitting.in_tangents = {0, 0, half, 0, -half * std::sin(half), 0, half * std::cos(half), 0};
  fitting.out_tangents = fitting.in_tangents;
  double angle = 1;
  size_t segment = 1;
  REQUIRE(qtraj_rate_mismatch(must_build(options.get(), two, fitting).get(), &angle, &segment) == QTRAJ_OK);
  CHECK(angle <= 1e-15);
  fitting.out_tangents = {0, half, 0, 0, 0, 0, 0, 0};
  REQUIRE(qtraj_rate_mismatch(must_build(options.get(), two, fitting).get(), &angle, &segment) == QTRAJ_OK);
  CHECK(angle > 0.1);
  // AS_GIVEN, the same step the other way round
  const Keyframes<double> longer = {{0, 1}, {1, 0, 0, 0, -std::cos(half), 0, -std::sin(half), 0}};
  REQUIRE(qtraj_rate_mismatch(must_build(options.get(), longer, fitting).get(), &angle, &segment) == QTRAJ_OK);
  CHECK(angle > 5);

  REQUIRE(qtraj_options_set_longest_gap(options.get(), 0.5) == QTRAJ_OK);
  double q[4];
  CHECK(qtraj_sample_at(must_build(options.get(), two, fitting).get(), 0.5, nullptr, q) == QTRAJ_E_GAP);
}

TEST_CASE("C API: float keys and tangents are the same curve as their values in double", "[capi][quaternion_hermite]") {
  const TangentKeys all = random_keys(13, 6);
  const auto rounded = [](const Rows& rows) { return std::vector<float>(rows.begin(), rows.end()); };
  const auto widened = [](const std::vector<float>& rows) { return Rows(rows.begin(), rows.end()); };
  const Keyframes<float> keys = {all.keys.times, rounded(all.keys.q)};
  Rates<float> tangents;
  tangents.in_tangents = rounded(all.tangents.in_tangents), tangents.out_tangents = rounded(all.tangents.out_tangents);
  Rates<double> wide;
  wide.in_tangents = widened(tangents.in_tangents), wide.out_tangents = widened(tangents.out_tangents);
  const Options options = options_with(QTRAJ_TURNS_DEFAULT);
  const Rows times = times_in(keys.times, 20);
  CHECK(must_sample<double>(must_build(options.get(), keys, tangents).get(), times) ==
        must_sample<double>(must_build(options.get(), Keyframes<double>{keys.times, widened(keys.q)}, wide).get(),
                            times));
}

}  // namespace
