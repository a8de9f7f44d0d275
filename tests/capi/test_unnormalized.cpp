// The curve in R^4: it normalises to the samples, its derivatives are derivatives and make the rates; outside the keys
// it follows the samplers; and its statuses.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

struct Curve4 {
  std::vector<double> p, dp, ddp;
};
Curve4 must_sample_unnormalized(const qtraj_trajectory* curve, const std::vector<double>& times) {
  Curve4 samples = {std::vector<double>(4 * times.size()), std::vector<double>(4 * times.size()),
                    std::vector<double>(4 * times.size())};
  REQUIRE(qtraj_sample_unnormalized(curve, times.data(), times.size(), samples.p.data(), samples.dp.data(),
                                    samples.ddp.data(), nullptr) == QTRAJ_OK);
  return samples;
}

Options options_of(int32_t method, int32_t extrapolation = QTRAJ_EXTRAPOLATE_ERROR) {
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(method, &options) == QTRAJ_OK);
  Options owner(options);
  REQUIRE(qtraj_options_set_extrapolation(options, extrapolation, extrapolation) == QTRAJ_OK);
  return owner;
}

constexpr int32_t kMethods[] = {QTRAJ_NLERP, QTRAJ_QUATERNION_QUINTIC};

// A closed tour of either method.
template <class Real>
Trajectory tour_of(int32_t method, int32_t extrapolation, Keyframes<Real>& keys) {
  keys = closed_tour<Real>(12);
  Rates<Real> rates;
  if (method == QTRAJ_QUATERNION_QUINTIC)
    for (size_t i = 0; i < 3 * keys.count(); ++i) {
      // the last key's rates are the first's
      const auto at = static_cast<double>(i < 33 ? i : i - 33);
      rates.omega.push_back(static_cast<Real>(0.4 * std::sin(at)));
      rates.alpha.push_back(static_cast<Real>(0.3 * std::cos(2 * at)));
    }
  return must_build(options_of(method, extrapolation).get(), keys, rates);
}

TEST_CASE("C API: the curve in R^4 normalises to the samples, and its derivatives make the rates",
          "[capi][unnormalized]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const int32_t method : kMethods) {
      Keyframes<Real> keys;
      const Trajectory curve = tour_of<Real>(method, QTRAJ_EXTRAPOLATE_ERROR, keys);
      const std::vector<double> times = times_in(keys.times, 40);
      const Curve4 samples = must_sample_unnormalized(curve.get(), times);
      std::vector<double> unit(4 * times.size()), omega(3 * times.size()), alpha(3 * times.size());
      REQUIRE(qtraj_normalize(samples.p.data(), times.size(), unit.data(), nullptr) == QTRAJ_OK);
      REQUIRE(qtraj_rates_from_derivatives(QTRAJ_FRAME_WORLD, samples.p.data(), samples.dp.data(), samples.ddp.data(),
                                           times.size(), omega.data(), alpha.data(), nullptr) == QTRAJ_OK);
      const Motion<double> motion = must_sample_rates<double>(curve.get(), QTRAJ_FRAME_WORLD, times);
      double q_error = 0, omega_error = 0, alpha_error = 0;
      for (size_t k = 0; k < unit.size(); ++k) test::raise_to(q_error, std::abs(unit[k] - motion.q[k]));
      for (size_t k = 0; k < omega.size(); ++k) {
        test::raise_to(omega_error, std::abs(omega[k] - motion.omega[k]));
        test::raise_to(alpha_error, std::abs(alpha[k] - motion.alpha[k]));
      }
      CHECK(q_error <= 8e-16);
      CHECK(omega_error <= 1e-13);
      CHECK(alpha_error <= 1e-11);
    }
  });
}

TEST_CASE("C API: at the knots the curve in R^4 is the key", "[capi][unnormalized]") {
  for (const int32_t method : kMethods) {
    Keyframes<double> keys;
    const Trajectory curve = tour_of<double>(method, QTRAJ_EXTRAPOLATE_ERROR, keys);
    std::vector<double> q(4 * keys.count());
    REQUIRE(qtraj_keys(curve.get(), nullptr, q.data()) == QTRAJ_OK);
    const Curve4 samples = must_sample_unnormalized(curve.get(), keys.times);
    for (size_t k = 0; k < q.size(); ++k) CHECK(std::abs(samples.p[k] - q[k]) <= 4 * DBL_EPSILON);
  }
}

TEST_CASE("C API: derivatives of the curve in R^4 are those of its values, outside the keys too",
          "[capi][unnormalized]") {
  for (const int32_t method : kMethods)
    for (const int32_t rule : {QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
                               QTRAJ_EXTRAPOLATE_PERIODIC}) {
      Keyframes<double> keys;
      const Trajectory curve = tour_of<double>(method, rule, keys);
      test::Random random(121);
      const bool has_outside = rule != QTRAJ_EXTRAPOLATE_ERROR;
      const double first = keys.times.front(), last = keys.times.back(), span = last - first, step = 1e-4;
      double first_error = 0, second_error = 0;
      for (int i = 0; i < 2000; ++i) {
        const double t =
            has_outside ? random.uniform(first - 3 * span, last + 3 * span) : random.uniform(first + step, last - step);
        // not across a knot, of any round
        bool is_inside_segment = true;
        for (const double knot : keys.times)
          for (int round = -4; round <= 4; ++round)
            is_inside_segment = is_inside_segment && std::abs(t - knot - round * span) > 2 * step;
        if (!is_inside_segment) continue;
        const Curve4 at = must_sample_unnormalized(curve.get(), {t - step, t, t + step});
        for (size_t k = 0; k < 4; ++k) {
          const double below = at.p[k], middle = at.p[4 + k], above = at.p[8 + k];
          test::raise_to(first_error, std::abs((above - below) / (2 * step) - at.dp[4 + k]));
          test::raise_to(second_error, std::abs((at.dp[8 + k] - at.dp[k]) / (2 * step) - at.ddp[4 + k]));
          test::raise_to(second_error, 1e-2 * std::abs((above - 2 * middle + below) / (step * step) - at.ddp[4 + k]));
        }
      }
      CAPTURE(method, rule);
      CHECK(first_error <= 1e-6);
      CHECK(second_error <= 1e-5);
    }
}

TEST_CASE("C API: outside the keys the curve in R^4 is what samplers give", "[capi][unnormalized]") {
  for (const int32_t method : kMethods)
    for (const int32_t rule : {QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_PERIODIC}) {
      Keyframes<double> keys;
      const Trajectory curve = tour_of<double>(method, rule, keys);
      std::vector<double> times;
      for (int i = -50; i < 100; ++i) times.push_back(keys.times.front() + 0.37 * i);
      times.insert(times.end(), {-1e9, 1e9, -1e300, 1e300});
      const Curve4 samples = must_sample_unnormalized(curve.get(), times);
      const std::vector<double> q = must_sample<double>(curve.get(), times);
      std::vector<double> unit(q.size());
      REQUIRE(qtraj_normalize(samples.p.data(), times.size(), unit.data(), nullptr) == QTRAJ_OK);
      for (size_t row = 0; row < times.size(); ++row) {
        CAPTURE(method, rule, times[row]);
        for (size_t k = 0; k < 4; ++k) CHECK(std::abs(unit[4 * row + k] - q[4 * row + k]) <= 8e-16);
        const bool is_outside = times[row] < keys.times.front() || times[row] > keys.times.back();
        if (!is_outside || rule != QTRAJ_EXTRAPOLATE_HOLD) continue;
        for (size_t k = 4 * row; k < 4 * row + 4; ++k) CHECK((samples.dp[k] == 0 && samples.ddp[k] == 0));
      }
    }
}

TEST_CASE("C API: rows of the curve in R^4 at fault are NaN in every output, all others right",
          "[capi][unnormalized][errors]") {
  for (const int32_t method : kMethods) {
    Keyframes<double> keys;
    const Trajectory curve = tour_of<double>(method, QTRAJ_EXTRAPOLATE_ERROR, keys);
    std::vector<double> times = {keys.times[0], 0, keys.times[3], keys.times[0] - 1, 1, keys.times.back() + 1e-9, 0.5};
    set_signalling_nan(times[1]);
    const Curve4 good = must_sample_unnormalized(curve.get(), {keys.times[0], keys.times[3], 1.0, 0.5});
    Curve4 found = {std::vector<double>(28, 7.0), std::vector<double>(28, 7.0), std::vector<double>(28, 7.0)};
    size_t bad_index = 7;
    qtraj_status status = QTRAJ_OK;
    const auto call = [&](const double* from, size_t count) {
      status = qtraj_sample_unnormalized(curve.get(), from, count, found.p.data(), found.dp.data(), found.ddp.data(),
                                         &bad_index);
    };
    CHECK(std::string(disturbance([&] { call(times.data(), 7); })) == "nothing");
    CHECK((status == QTRAJ_E_NOT_FINITE && bad_index == 1));
    const size_t of_good[7] = {0, 9, 1, 9, 2, 9, 3};
    for (const auto array : {&Curve4::p, &Curve4::dp, &Curve4::ddp})
      for (size_t k = 0; k < 28; ++k) {
        const size_t row = of_good[k / 4];
        const double value = (found.*array)[k];
        CHECK((row == 9 ? std::isnan(value) : value == (good.*array)[4 * row + k % 4]));
      }
    call(times.data() + 2, 5);
    CHECK((status == QTRAJ_E_TIME_RANGE && bad_index == 1));
  }
}

TEST_CASE("C API: a derivative of the curve in R^4 that overflows is NOT_FINITE where it is asked for",
          "[capi][unnormalized][errors]") {
  const double times[2] = {0, 1e-154}, q[8] = {1, 0, 0, 0, 0.6, 0.8, 0, 0}, middle = 0.5e-154;
  qtraj_trajectory* handle = nullptr;
  REQUIRE(qtraj_create(QTRAJ_NLERP, times, q, 2, &handle, nullptr) == QTRAJ_OK);
  const Trajectory short_step(handle);
  double p[4], dp[4], ddp[4];
  // a polynomial of degree 1 has none to overflow
  CHECK(qtraj_sample_unnormalized(handle, &middle, 1, p, dp, ddp, nullptr) == QTRAJ_OK);
  CHECK((std::abs(dp[1] - 0.8e154) < 1e139 && ddp[1] == 0));

  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(QTRAJ_QUATERNION_QUINTIC, &options) == QTRAJ_OK);
  const Options owner(options);
  double omega[6] = {}, alpha[6] = {1e300, 0, 0, 0, 0, 0};
  const double at[2] = {0, 1e-149};
  REQUIRE(qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, at, q, omega, alpha, 2, &handle, nullptr) == QTRAJ_OK);
  const Trajectory fast(handle);
  const double inside = 0.25e-149;
  CHECK(qtraj_sample_unnormalized(handle, &inside, 1, p, dp, ddp, nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, q, omega, alpha, 2, &handle, nullptr) == QTRAJ_OK);
  const Trajectory fastest(handle);
  const double early = 0.25e-154;
  size_t bad_index = 7;
  qtraj_status status = QTRAJ_OK;
  CHECK(std::string(disturbance([&] {
          status = qtraj_sample_unnormalized(fastest.get(), &early, 1, p, dp, ddp, &bad_index);
        })) == "nothing");
  CHECK((status == QTRAJ_E_NOT_FINITE && bad_index == 0));
  for (size_t k = 0; k < 4; ++k) CHECK((std::isnan(p[k]) && std::isnan(dp[k]) && std::isnan(ddp[k])));
  CHECK(qtraj_sample_unnormalized(fastest.get(), &early, 1, p, dp, nullptr, nullptr) == QTRAJ_OK);
}

TEST_CASE("C API: arguments of sample_unnormalized are judged in order, and then outputs left alone",
          "[capi][unnormalized][errors]") {
  Keyframes<double> keys;
  const Trajectory curve = tour_of<double>(QTRAJ_NLERP, QTRAJ_EXTRAPOLATE_HOLD, keys);
  qtraj_trajectory* handle = nullptr;
  REQUIRE(qtraj_create(QTRAJ_SLERP, keys.times.data(), keys.q.data(), keys.count(), &handle, nullptr) == QTRAJ_OK);
  const Trajectory slerp(handle);
  uint64_t other[64] = {};
  const auto* no_curve = reinterpret_cast<const qtraj_trajectory*>(other);
  std::vector<double> times(64, 0.0), out(64, 7.0);
  const auto refused = [&](qtraj_status expected, const qtraj_trajectory* trajectory, const double* from, size_t count,
                           double* p, double* dp, double* ddp) {
    size_t bad_index = 7;
    CHECK(qtraj_sample_unnormalized(trajectory, from, count, p, dp, ddp, &bad_index) == expected);
    CHECK(bad_index == SIZE_MAX);
    for (const double number : out) CHECK(number == 7);
  };
  double *p = out.data(), *dp = p + 16, *ddp = p + 32;
  refused(QTRAJ_E_NULL, no_curve, nullptr, 4, p, dp, ddp);
  refused(QTRAJ_E_NULL, no_curve, times.data(), 4, nullptr, nullptr, nullptr);
  refused(QTRAJ_E_NULL, nullptr, times.data(), 4, p, dp, ddp);
  refused(QTRAJ_E_HANDLE, no_curve, times.data(), SIZE_MAX, p, dp, ddp);
  refused(QTRAJ_E_SIZE, slerp.get(), times.data(), SIZE_MAX / 32 + 1, p, dp, ddp);
  refused(QTRAJ_E_SETTING, slerp.get(), times.data(), 4, p, p, ddp);
  refused(QTRAJ_E_OVERLAP, curve.get(), times.data(), 4, p, p + 15, ddp);
  refused(QTRAJ_E_OVERLAP, curve.get(), times.data(), 4, p, dp, dp);
  refused(QTRAJ_E_OVERLAP, curve.get(), p + 3, 4, p, nullptr, nullptr);
  CHECK(qtraj_sample_unnormalized(curve.get(), nullptr, 0, nullptr, nullptr, nullptr, nullptr) == QTRAJ_OK);
  CHECK(qtraj_sample_unnormalized(slerp.get(), nullptr, 0, nullptr, nullptr, nullptr, nullptr) == QTRAJ_E_SETTING);
  CHECK(qtraj_sample_unnormalized(nullptr, nullptr, 0, nullptr, nullptr, nullptr, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_sample_unnormalized(curve.get(), times.data(), 4, nullptr, dp, nullptr, nullptr) == QTRAJ_OK);
}

}  // namespace
