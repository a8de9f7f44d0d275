// What curve diagnostics promise on curves made to deceive them: right, or NO_CONVERGENCE, at a bounded cost. Peaks are
// compared with dense samples, densest around the fastest; integrals with sums over pieces that shrink towards the
// keys.
#include <cfloat>
#include <ctime>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

double length(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

// ---- Curves ----

// Steps of any kind: random; half turns about x, to `off`; small ones.
struct Steps {
  const char* name;
  double off;    // 0: random
  double ratio;  // longest over shortest interval, at most
};
Keyframes<double> keys_with(const Steps& steps, size_t count, test::Random& random) {
  Keyframes<double> keys;
  double time = 0;
  test::Quaternion q = random.orientation();
  for (size_t key = 0; key < count; ++key) {
    keys.times.push_back(time);
    keys.q.insert(keys.q.end(), q.begin(), q.end());
    time += std::pow(steps.ratio, random.uniform(0, 1));
    const test::Quaternion other = random.orientation();
    if (steps.off == 0) {
      q = other;
      continue;
    }
    q = test::multiply(q, {0, 1, 0, 0});
    for (size_t k = 0; k < 4; ++k) q[k] += steps.off * other[k];
  }
  return keys;
}
Rates<double> random_rates(const Variant& variant, size_t count, double rate, test::Random& random) {
  Rates<double> rates;
  for (size_t i = 0; i < 3 * count; ++i) {
    if (variant.needs_rates()) rates.omega.push_back(random.uniform(-rate, rate));
    if (variant.needs_alpha()) rates.alpha.push_back(random.uniform(-rate, rate));
  }
  for (size_t i = 0; variant.needs_tangents() && i < 4 * count; ++i) {
    rates.in_tangents.push_back(0.5 * random.uniform(-rate, rate));
    rates.out_tangents.push_back(0.5 * random.uniform(-rate, rate));
  }
  return rates;
}

// ---- Samples ----

struct Largest {
  double value = 0, time = 0;
};
struct Samples {
  Largest omega, alpha;
};
void sample_between(const qtraj_trajectory* curve, double from, double to, size_t count, Samples& found) {
  std::vector<double> times(count);
  for (size_t i = 0; i < count; ++i)
    times[i] = std::min(from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1), to);
  const Motion<double> motion = must_sample_rates<double>(curve, QTRAJ_FRAME_BODY, times);
  for (size_t i = 0; i < count; ++i) {
    const double omega = length(&motion.omega[3 * i]), alpha = length(&motion.alpha[3 * i]);
    if (omega > found.omega.value) found.omega = {omega, times[i]};
    if (alpha > found.alpha.value) found.alpha = {alpha, times[i]};
  }
}
// The largest |omega| and |alpha| among samples: everywhere, then again and again around the largest of each segment.
// `unit` is the largest |omega|/h, h the length of the segment.
Samples dense_samples(const qtraj_trajectory* curve, const std::vector<double>& knots, double& unit) {
  Samples all;
  unit = 0;
  for (size_t i = 0; i + 1 < knots.size(); ++i) {
    const double from = knots[i], to = std::nextafter(knots[i + 1], from), h = knots[i + 1] - knots[i];
    Samples found;
    sample_between(curve, from, to, 600, found);
    for (Largest Samples::*which : {&Samples::omega, &Samples::alpha}) {
      double reach = h / 600;
      for (int zoom = 0; zoom < 4; ++zoom, reach /= 15) {
        const double at = (found.*which).time;
        sample_between(curve, std::max(from, at - reach), std::min(to, at + reach), 40, found);
      }
    }
    unit = std::max(unit, found.omega.value / h);
    if (found.omega.value > all.omega.value) all.omega = found.omega;
    if (found.alpha.value > all.alpha.value) all.alpha = found.alpha;
  }
  return all;
}

// Checks a curve; whether its peaks are proven.
bool check_peaks(const qtraj_trajectory* curve, const std::vector<double>& knots) {
  constexpr double kUntouched = -7;
  double omega = kUntouched, omega_time = 0, alpha = kUntouched, alpha_time = 0;
  double omega_bound = kUntouched, alpha_bound = kUntouched;
  const qtraj_status status = qtraj_curve_peak_rates(curve, &omega, &omega_time, &alpha, &alpha_time);
  CHECK(qtraj_rate_bounds(curve, &omega_bound, &alpha_bound) == status);
  if (status != QTRAJ_OK) {
    CHECK(status == QTRAJ_E_NO_CONVERGENCE);
    CHECK((omega == kUntouched && alpha == kUntouched && omega_bound == kUntouched && alpha_bound == kUntouched));
    return false;
  }
  double unit = 0;
  const Samples dense = dense_samples(curve, knots, unit);
  // bounds are never below, and close to the peaks, which are samples themselves: no larger than the true ones
  CHECK(dense.omega.value <= omega_bound);
  CHECK(dense.alpha.value <= alpha_bound);
  CHECK((omega_bound >= omega && alpha_bound >= alpha));
  CHECK(omega_bound <= omega * (1 + 1e-6));
  CHECK(alpha_bound <= alpha * (1 + 1e-6) + 1e-12 * unit);
  CHECK(dense.omega.value <= omega * (1 + 5e-7));
  CHECK(dense.alpha.value <= alpha * (1 + 5e-7) + 1e-12 * unit);
  // a peak is the rate at its time, or just before it where it jumps there
  double most_omega = 0, most_alpha = 0;
  for (const double time :
       {omega_time, std::nextafter(omega_time, -DBL_MAX), alpha_time, std::nextafter(alpha_time, -DBL_MAX)}) {
    double w[3], a[3];
    if (time < knots[0]) continue;
    REQUIRE(qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, time, nullptr, nullptr, w, a) == QTRAJ_OK);
    most_omega = std::max(most_omega, length(w));
    most_alpha = std::max(most_alpha, length(a));
  }
  CHECK(most_omega >= omega * (1 - 1e-3));
  CHECK(most_alpha >= alpha * (1 - 1e-3) - 1e-12 * unit);
  return true;
}

TEST_CASE("C API: no dense sample exceeds the peaks or their bounds, whatever keys and intervals",
          "[capi][diagnostics][peaks]") {
  const Steps all_steps[] = {{"random", 0, 1},
                             {"random, 1:100", 0, 100},
                             {"random, 1:10000", 0, 1e4},
                             {"half turns", 1e-3, 1},
                             {"half turns, 1:100", 1e-3, 100},
                             {"half turns to 1e-8", 1e-8, 10},
                             {"half turns to 1e-8, 1:10000", 1e-8, 1e4}};
  for (const Steps& steps : all_steps)
    for (const Variant& variant : variants()) {
      if (variant.end == QTRAJ_END_PERIODIC) continue;
      for (int round = 0; round < 2; ++round) {
        CAPTURE(variant.name, steps.name, round);
        // the same keys for all variants, whatever others there are
        test::Random random(101 + static_cast<uint64_t>(round));
        const Keyframes<double> keys = keys_with(steps, 6, random);
        const double rate = 3.0 / steps.ratio;
        const Built built = build(make_options(variant, rate).get(), keys, random_rates(variant, 6, rate, random));
        if (built.status != QTRAJ_OK) continue;
        const bool proven = check_peaks(built.trajectory.get(), keys.times);
        // only SQUAD's arcs can be nearly opposite between such keys, and a quintic's norm nearly 0; LOG_SPLINE may
        // swing out by thousands of turns
        const bool is_tame = variant.method != QTRAJ_SQUAD && variant.method != QTRAJ_QUATERNION_QUINTIC &&
                             variant.method != QTRAJ_QUATERNION_HERMITE;
        if (steps.off == 0 ? variant.method != QTRAJ_LOG_SPLINE || steps.ratio < 1e4
                           : is_tame && variant.method != QTRAJ_LOG_SPLINE)
          CHECK(proven);
      }
    }
}

TEST_CASE("C API: no dense sample exceeds the peaks of curves with fast rates at their keys",
          "[capi][diagnostics][peaks]") {
  test::Random random(103);
  for (const Variant& variant : variants()) {
    if (!variant.needs_rates()) continue;
    for (const double rate : {10.0, 100.0, 1e3, 1e5, 1e9})
      for (int round = 0; round < 3; ++round) {
        CAPTURE(variant.name, rate, round);
        const Keyframes<double> keys = keys_with({"", 0, 10}, 4, random);
        const Built built = build(make_options(variant).get(), keys, random_rates(variant, 4, rate, random));
        if (built.status != QTRAJ_OK) continue;
        CHECK((check_peaks(built.trajectory.get(), keys.times) || rate > 10));
      }
  }
}

TEST_CASE("C API: peaks of a quintic that passes 0 closely are found or NO_CONVERGENCE",
          "[capi][diagnostics][peaks][least_norm]") {
  // through (1, 0, 0, 0) and (0, 1, 0, 0) with the rate at which the quintic about x would hit 0; a little off the axis
  for (const double aside : {1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12, 0.0}) {
    CAPTURE(aside);
    const Variant variant = {"", QTRAJ_QUATERNION_QUINTIC};
    Rates<double> rates = rates_for<double>(variant, 2, 0.0);
    rates.omega[0] = rates.omega[3] = 25.099668870541507;
    const Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, 0, 1, aside, 0}};
    const Trajectory curve = must_build(make_options(variant).get(), keys, rates);
    CHECK(check_peaks(curve.get(), keys.times) == (aside > 5e-7));
  }
}

TEST_CASE("C API: SQUAD between keys half a turn apart says NO_CONVERGENCE rather than a peak it passed by",
          "[capi][diagnostics][peaks][squad]") {
  // arcs that come within 1e-8 of opposite points: |omega| reaches some 1e7 rad/s for about 1e-8 s
  test::Random random(107);
  size_t unproven = 0;
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const Keyframes<double> keys = keys_with({"", 1e-8, 6}, 5, random);
    const Trajectory curve = must_build(make_options({"", QTRAJ_SQUAD}).get(), keys);
    unproven += check_peaks(curve.get(), keys.times) ? 0 : 1;
  }
  CHECK(unproven > 0);
  CHECK(unproven < 40);
}

// ---- Integrals ----

struct Integrals {
  double energy = 0, angle = 0;
};
// Sums over pieces that shrink geometrically towards both ends of every segment, in each Gauss's rule of 5 points.
Integrals graded_sums(const qtraj_trajectory* curve, const std::vector<double>& knots) {
  constexpr double kNodes[] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr double kWeights[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                 0.2369268850561891};
  std::vector<double> edges = {0.0};
  for (int k = 0; k <= 1600; ++k) edges.push_back(0.5 * std::pow(1e-12, 1 - k / 1600.0));
  for (size_t k = edges.size() - 1; k-- > 0;) edges.push_back(1.0 - edges[k]);
  Integrals sums;
  for (size_t i = 0; i + 1 < knots.size(); ++i) {
    const double h = knots[i + 1] - knots[i];
    std::vector<double> times;
    for (size_t k = 0; k + 1 < edges.size(); ++k)
      for (const double node : kNodes)
        times.push_back(knots[i] + h * (0.5 * (edges[k] + edges[k + 1]) + 0.5 * node * (edges[k + 1] - edges[k])));
    const Motion<double> motion = must_sample_rates<double>(curve, QTRAJ_FRAME_BODY, times);
    for (size_t j = 0; j < times.size(); ++j) {
      const double weight = 0.5 * h * (edges[j / 5 + 1] - edges[j / 5]) * kWeights[j % 5];
      sums.angle += weight * length(&motion.omega[3 * j]);
      sums.energy += weight * std::pow(length(&motion.alpha[3 * j]), 2);
    }
  }
  return sums;
}

TEST_CASE("C API: integrals of curves with fast ends are right or NO_CONVERGENCE", "[capi][diagnostics][integrals]") {
  test::Random random(109);
  const Variant variant = {"", QTRAJ_QUATERNION_QUINTIC};
  size_t proven = 0;
  for (double rate = 1; rate <= 1e9; rate *= 10)
    for (int round = 0; round < 4; ++round) {
      CAPTURE(rate, round);
      const Keyframes<double> keys = keys_with({"", 0, 1}, 2, random);
      Rates<double> rates = random_rates(variant, 2, rate, random);
      for (double& alpha : rates.alpha) alpha = 0;
      const Trajectory curve = must_build(make_options(variant).get(), keys, rates);
      const Integrals expected = graded_sums(curve.get(), keys.times);
      double energy = -7, angle = -7;
      const qtraj_status of_energy = qtraj_curve_energy(curve.get(), &energy),
                         of_angle = qtraj_curve_total_angle(curve.get(), &angle);
      CHECK((of_energy == QTRAJ_OK || (of_energy == QTRAJ_E_NO_CONVERGENCE && energy == -7)));
      CHECK((of_angle == QTRAJ_OK || (of_angle == QTRAJ_E_NO_CONVERGENCE && angle == -7)));
      if (of_energy == QTRAJ_OK) CHECK(std::abs(energy - expected.energy) <= 1e-8 * expected.energy);
      if (of_angle == QTRAJ_OK) CHECK(std::abs(angle - expected.angle) <= 1e-6 * expected.angle);
      proven += (of_energy == QTRAJ_OK) + (of_angle == QTRAJ_OK);
    }
  CHECK(proven >= 20);
}

// ---- Arguments and cost ----

TEST_CASE("C API: rate_bounds has one output or two, and leaves them alone on an error",
          "[capi][diagnostics][errors]") {
  const Trajectory curve = must_build(make_options({"", QTRAJ_SQUAD}).get(), closed_tour<double>(6));
  double omega = -7, alpha = -7, omega_alone = -7, alpha_alone = -7;
  CHECK(qtraj_rate_bounds(nullptr, &omega, &alpha) == QTRAJ_E_NULL);
  CHECK(qtraj_rate_bounds(curve.get(), nullptr, nullptr) == QTRAJ_E_NULL);
  CHECK((omega == -7 && alpha == -7));
  CHECK(qtraj_rate_bounds(curve.get(), &omega, &alpha) == QTRAJ_OK);
  CHECK(qtraj_rate_bounds(curve.get(), &omega_alone, nullptr) == QTRAJ_OK);
  CHECK(qtraj_rate_bounds(curve.get(), nullptr, &alpha_alone) == QTRAJ_OK);
  CHECK((omega_alone == omega && alpha_alone == alpha));
}

TEST_CASE("C API: bounds that overflow are NOT_FINITE, and rates past all digits NO_CONVERGENCE, without a flag",
          "[capi][diagnostics][errors][extremes]") {
  const Variant variant = {"", QTRAJ_HERMITE};
  for (const double gap : {1e-154, 1e-80, 1.0, 1e300})
    for (const double turning : {0.0, 1e9, 1e40, 1e140}) {
      if (turning == 1e9 && gap != 1.0) continue;  // takes all the pieces of a call
      CAPTURE(gap, turning);
      const Keyframes<double> keys = {{0, gap}, {1, 0, 0, 0, 1, 1, 1, 1}};
      Rates<double> rates = rates_for<double>(variant, 2, 0.0);
      if (gap >= 1e-80) rates.omega[0] = rates.omega[4] = turning / gap;
      const Trajectory curve = must_build(make_options(variant).get(), keys, rates);
      double omega = -7, alpha = -7, energy = -7, angle = -7;
      qtraj_status status[3];
      CHECK(disturbance([&] {
              status[0] = qtraj_rate_bounds(curve.get(), &omega, &alpha);
              status[1] = qtraj_curve_energy(curve.get(), &energy);
              status[2] = qtraj_curve_total_angle(curve.get(), &angle);
            }) == std::string("nothing"));
      const bool turns = turning > 0 && gap >= 1e-80;
      CHECK(status[0] == (turns ? QTRAJ_E_NO_CONVERGENCE : gap < 1e-150 ? QTRAJ_E_NOT_FINITE : QTRAJ_OK));
      CHECK(status[2] == (turns ? QTRAJ_E_NO_CONVERGENCE : QTRAJ_OK));
      CHECK((status[0] == QTRAJ_OK) == (omega > 0 && alpha > -7));
      CHECK((status[2] == QTRAJ_OK) == (angle > 0));
    }
}

TEST_CASE("C API: a quintic's least norm is at most that of its keys, 1, however fast its ends", "[capi][least_norm]") {
  test::Random random(113);
  const Variant variant = {"", QTRAJ_QUATERNION_QUINTIC};
  for (double rate = 1; rate <= 1e40; rate *= 100) {
    CAPTURE(rate);
    const Keyframes<double> keys = keys_with({"", 0, 1}, 3, random);
    const Trajectory curve = must_build(make_options(variant).get(), keys, random_rates(variant, 3, rate, random));
    double norm = 7, time = -7;
    REQUIRE(qtraj_curve_least_norm(curve.get(), &norm, &time) == QTRAJ_OK);
    CHECK((norm >= 0 && norm <= 1));
    CHECK((time >= keys.times.front() && time <= keys.times.back()));
  }
}

TEST_CASE("C API: peaks and length of steps whose squares vanish are their closed forms",
          "[capi][diagnostics][extremes]") {
  for (const double angle : {1e-100, 1e-170, 1e-250, 1e-290}) {
    CAPTURE(angle);
    const Keyframes<double> keys = {{0, 2}, {1, 0, 0, 0, 1, 0, 0.5 * angle, 0}};
    const Variant variant = {"", QTRAJ_ROTATION_QUINTIC};
    const Trajectory curve = must_build(make_options(variant).get(), keys, rates_for<double>(variant, 2, 0.0));
    double omega = 0, alpha = 0, omega_bound = 0, alpha_bound = 0, length = 0;
    REQUIRE(qtraj_curve_peak_rates(curve.get(), &omega, nullptr, &alpha, nullptr) == QTRAJ_OK);
    REQUIRE(qtraj_rate_bounds(curve.get(), &omega_bound, &alpha_bound) == QTRAJ_OK);
    REQUIRE(qtraj_curve_total_angle(curve.get(), &length) == QTRAJ_OK);
    const double expected_omega = 15.0 / 16.0 * angle, expected_alpha = 2.5 / std::sqrt(3.0) * angle;
    CHECK(std::abs(omega - expected_omega) <= 1e-9 * expected_omega);
    CHECK(std::abs(alpha - expected_alpha) <= 1e-9 * expected_alpha);
    CHECK((omega_bound >= expected_omega && omega_bound <= expected_omega * (1 + 1e-6)));
    CHECK((alpha_bound >= expected_alpha && alpha_bound <= expected_alpha * (1 + 1e-6)));
    CHECK(std::abs(length - angle) <= 1e-9 * angle);
  }
}

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TEST_CASE("C API: what a diagnostic costs is bounded by a number of samples, whatever the keys",
          "[capi][diagnostics][cost]") {
  // a call has at most 1e5 pieces and 300 more for each segment, a piece costs less than 60 samples of rates
  test::Random random(127);
  for (const int32_t method : {QTRAJ_SQUAD, QTRAJ_LOG_SPLINE, QTRAJ_HERMITE, QTRAJ_QUATERNION_QUINTIC})
    for (const double rate : {3.0, 3e6}) {
      const Variant variant = {"", method};
      CAPTURE(method, rate);
      const Keyframes<double> keys = keys_with({"", 1e-8, 1e4}, 30, random);
      const Built built = build(make_options(variant).get(), keys, random_rates(variant, 30, rate, random));
      if (built.status != QTRAJ_OK) continue;
      const qtraj_trajectory* curve = built.trajectory.get();
      double start = seconds(), sink = 0, w[3], a[3];
      constexpr int kSamples = 20000;
      for (int i = 0; i < kSamples; ++i) {
        const double time = keys.times.back() * i / kSamples;
        if (qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, time, nullptr, nullptr, w, a) == QTRAJ_OK) sink += w[0];
      }
      const double sample = (seconds() - start) / kSamples;
      start = seconds();
      double value[4];
      CHECK(qtraj_curve_peak_rates(curve, &value[0], &value[1], &value[2], &value[3]) != QTRAJ_E_NOT_FINITE);
      CHECK(qtraj_curve_energy(curve, &value[0]) != QTRAJ_E_NOT_FINITE);
      CHECK(qtraj_curve_total_angle(curve, &value[0]) != QTRAJ_E_NOT_FINITE);
      CHECK(std::isfinite(sink));
      CHECK(seconds() - start <= 4 * (1e5 + 300 * 29) * 60 * sample);
    }
}

}  // namespace
