// Rates past the range of their type: NaN rows and NOT_FINITE, without a flag; and no NaN from finite input otherwise.
#include <cfloat>
#include <string>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

const std::string kNothing = "nothing";
const int32_t kFrames[] = {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD};

template <class Real>
size_t not_finite(const std::vector<Real>& rows, size_t from, size_t count) {
  size_t found = 0;
  for (size_t k = from; k < from + count; ++k) found += !std::isfinite(rows[k]);
  return found;
}

// Samples all times watching the floating-point environment. Rows are right: finite throughout, or NaN throughout and
// then NOT_FINITE; the status is that of the first. Gives which rows are finite.
template <class Real>
std::vector<bool> sampled(const qtraj_trajectory* curve, int32_t frame, const std::vector<double>& times) {
  Motion<Real> motion(times.size());
  qtraj_status status = QTRAJ_E_INTERNAL;
  size_t bad_index = 0;
  CHECK(disturbance([&] {
          status = sample_rates(curve, frame, times.data(), times.size(), motion.q.data(), motion.omega.data(),
                                motion.alpha.data(), &bad_index);
        }) == kNothing);
  std::vector<bool> finite(times.size());
  size_t first = SIZE_MAX;
  bool rows_whole = true;
  for (size_t i = 0; i < times.size(); ++i) {
    const size_t faults =
        not_finite(motion.q, 4 * i, 4) + not_finite(motion.omega, 3 * i, 3) + not_finite(motion.alpha, 3 * i, 3);
    rows_whole = rows_whole && (faults == 0 || faults == 10) && (faults == 0) == !std::isnan(motion.q[4 * i]);
    finite[i] = faults == 0;
    if (faults > 0) first = std::min(first, i);
  }
  CHECK(rows_whole);
  CHECK(status == (first == SIZE_MAX ? QTRAJ_OK : QTRAJ_E_NOT_FINITE));
  CHECK(bad_index == first);
  return finite;
}

// Slow, then fast for one interval, then slow.
template <class Real>
Keyframes<Real> fast_between(double shortest) {
  Keyframes<Real> keys = {{-2, -1, 0, shortest, 1, 2}, closed_tour<Real>(6).q};
  return keys;
}

TEST_CASE("C API: rates past the range of float are NaN rows in float and right in double", "[capi][rates][extremes]") {
  // an interval of 1e-39 s: omega is past 3.4e38; of 1e-25 s: only alpha is
  for (const double shortest : {1e-39, 1e-25})
    for (const Variant& variant : variants()) {
      // one is thrown far by such knots everywhere, the other does not converge
      if (variant.method == QTRAJ_LOG_SPLINE || variant.method == QTRAJ_ROTATION_SPLINE) continue;
      if (!variant.is_continuous()) continue;
      const Built built =
          build(make_options(variant, 0.0).get(), fast_between<float>(shortest), rates_for<float>(variant, 6, 0.0));
      CAPTURE(variant.name, shortest);
      REQUIRE(built.status == QTRAJ_OK);
      const bool curved = variant.method != QTRAJ_SLERP && variant.method != QTRAJ_NLERP;
      for (const int32_t frame : kFrames) {
        const std::vector<double> fast = {0.25 * shortest, 0.5 * shortest, 0.75 * shortest};
        const std::vector<bool> in_double = sampled<double>(built.trajectory.get(), frame, fast),
                                in_float = sampled<float>(built.trajectory.get(), frame, fast);
        CHECK((in_double[0] && in_double[1] && in_double[2]));
        if (shortest < 1e-30) CHECK(!(in_float[0] || in_float[1] || in_float[2]));
        // somewhere alpha is past it; at a point of symmetry it may be 0
        if (curved && variant.method != QTRAJ_SQUAD) CHECK(!(in_float[0] && in_float[2]));
        // the slow segments at both ends, among fast rows
        const std::vector<bool> mixed =
            sampled<float>(built.trajectory.get(), frame, {-1.5, 0.25 * shortest, 1.5, 0.75 * shortest, -1.25});
        CHECK((mixed[0] && mixed[2] && mixed[4]));
      }
    }
}

TEST_CASE("C API: rates past the range of double are NaN rows without a flag", "[capi][rates][extremes]") {
  size_t overflowed = 0;
  for (const double shortest : {7.5e-155, 1e-154, 1.5e-154, 3e-154, 1e-153, 1e-150})
    for (const Variant& variant : variants())
      for (const bool only : {false, true}) {
        CAPTURE(variant.name, shortest, only);
        Keyframes<double> keys = fast_between<double>(shortest);
        if (only)
          for (size_t i = 0; i < 6; ++i) keys.times[i] = static_cast<double>(i) * shortest;
        const Built built = build(make_options(variant, 0.0).get(), keys, rates_for<double>(variant, 6, 0.0));
        if (built.status != QTRAJ_OK) {
          CHECK((variant.method == QTRAJ_LOG_SPLINE || built.status == QTRAJ_E_NO_CONVERGENCE));
          continue;
        }
        for (const int32_t frame : kFrames) {
          const std::vector<bool> finite = sampled<double>(built.trajectory.get(), frame, times_in(keys.times, 8));
          overflowed += static_cast<size_t>(std::count(finite.begin(), finite.end(), false));
          sampled<float>(built.trajectory.get(), frame, times_in(keys.times, 8));
          if (only || (variant.method != QTRAJ_SLERP && variant.method != QTRAJ_NLERP)) continue;
          CHECK(std::count(finite.begin(), finite.end(), false) == 0);  // 1/h is in range, and alpha is small
        }
      }
  CHECK(overflowed > 100);
}

TEST_CASE("C API: rates near the largest number never give infinity or a flag", "[capi][rates][extremes]") {
  // given rates as fast as their interval allows, in every direction
  test::Random random(5);
  for (const Variant& variant : variants()) {
    if (!always_needs_rates(variant.method) && !variant.needs_tangents()) continue;
    const double most = variant.needs_tangents() ? 0x1p199 : variant.method == QTRAJ_HERMITE ? 0x1p499 : 0x1p239;
    for (int round = 0; round < 60; ++round) {
      const double h = std::exp(random.uniform(std::log(1e-154), std::log(1e150)));
      const Keyframes<double> keys = {{0, h, 2 * h}, closed_tour<double>(3).q};
      const double share = round % 3 == 0 ? 1.0 : std::exp(random.uniform(std::log(1e-120), 0.0));
      Rates<double> rates;
      for (int k = 0; k < 9; ++k) {
        const double rate = std::max(-DBL_MAX, std::min(DBL_MAX, random.uniform(-1, 1) * most * share / h));
        if (variant.needs_rates()) rates.omega.push_back(rate);
        const double bend = random.uniform(-1, 1) * most * share / h / h;
        if (variant.needs_alpha()) rates.alpha.push_back(std::max(-DBL_MAX, std::min(DBL_MAX, bend)));
      }
      for (size_t k = 0; variant.needs_tangents() && k < 12; ++k) {
        rates.in_tangents.push_back(random.uniform(-1, 1) * most * share / h);
        rates.out_tangents.push_back(random.uniform(-1, 1) * most * share / h);
      }
      std::feclearexcept(FE_ALL_EXCEPT);
      for (const int32_t frame : kFrames) {
        CAPTURE(variant.name, round, h, share, frame);
        const Options options = make_options(variant);
        REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
                                                QTRAJ_EXTRAPOLATE_CONSTANT_RATE) == QTRAJ_OK);
        Built built{};
        CHECK(disturbance([&] { built = build(options.get(), keys, rates, frame); }) == kNothing);
        REQUIRE(built.status == QTRAJ_OK);
        std::vector<double> times = times_in(keys.times, 16);
        times.insert(times.end(), {-h, -1e300, 3 * h, 1e300});
        sampled<double>(built.trajectory.get(), frame, times);
        sampled<float>(built.trajectory.get(), frame, times);
      }
    }
  }
}

TEST_CASE("C API: intervals of any size give finite rows or NOT_FINITE, without a flag", "[capi][rates][extremes]") {
  test::Random random(11);
  for (int round = 0; round < 40; ++round) {
    const test::Keys walk = test::random_walk(random, 6, 3.1, 1, 2);
    Keyframes<double> keys = {walk.times, walk.q};
    const double shortest = std::exp(random.uniform(std::log(1e-153), 0.0)), longest = random.uniform(1.0, 1e3);
    for (size_t i = 1; i < 6; ++i)
      keys.times[i] = std::max(keys.times[i - 1] + std::exp(random.uniform(std::log(shortest), std::log(longest))),
                               std::nextafter(keys.times[i - 1], DBL_MAX));
    if (round % 2 == 0)  // from 0: gaps are not rounded to those of larger times
      for (size_t i = 0; i < 6; ++i)
        keys.times[i] = i == 0 ? 0.0 : shortest * std::pow(10.0, static_cast<double>(i * 7));
    for (const Variant& variant : variants()) {
      if (variant.end == QTRAJ_END_PERIODIC) continue;
      CAPTURE(variant.name, round);
      Built built{};
      CHECK(disturbance([&] {
              built = build(make_options(variant, 0.0).get(), keys, rates_for<double>(variant, 6, 0.0));
            }) == kNothing);
      if (built.status != QTRAJ_OK) {
        CHECK((variant.method == QTRAJ_LOG_SPLINE || built.status == QTRAJ_E_NO_CONVERGENCE));
        continue;
      }
      for (const int32_t frame : kFrames) {
        sampled<double>(built.trajectory.get(), frame, times_in(keys.times, 5));
        sampled<float>(built.trajectory.get(), frame, times_in(keys.times, 5));
      }
    }
  }
}

}  // namespace
