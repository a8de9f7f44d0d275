// slerp_between: its bound, its times, its statuses.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/pair_functions.hpp"
#include "support/wide_pair.hpp"

using test::Quaternion;
using test::Random;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

struct Called {
  qtraj_status status;
  size_t bad_index;
  std::vector<double> q;

  bool row_is_nan(size_t row) const {
    return std::all_of(q.begin() + 4 * row, q.begin() + 4 * row + 4, [](double value) { return std::isnan(value); });
  }
};
Called slerp_between(const Quaternion& a, double time_a, const Quaternion& b, double time_b,
                     const std::vector<double>& times, int32_t path = QTRAJ_PATH_SHORTEST) {
  Called called{QTRAJ_OK, 7, std::vector<double>(4 * times.size(), 7.0)};
  called.status = qtraj_slerp_between(a.data(), time_a, b.data(), time_b, times.data(), times.size(), path,
                                      called.q.data(), &called.bad_index);
  return called;
}

TEST_CASE("C API: slerp_between stays within its bound, at times of 1.7e9 s too", "[capi][slerp_between]") {
  Random random(21);
  double worst = 0;
  bool all_ok = true;
  for (int i = 0; i < 150000; ++i) {  // of seven times each
    const pairs::Ends ends = pairs::hard_ends(random, 160);
    const wide::Pair pair = wide::pair(ends.a.data(), ends.b.data(), true);
    const double time_a = i % 2 == 0 ? 1.7e9 + random.uniform(0, 1e6) : random.uniform(-1, 1);
    const double time_b = time_a + std::pow(10.0, random.uniform(-5, 5));
    const double step = time_b - time_a;
    if (step == 0 || pair.is_tie) continue;
    const std::vector<double> times = {time_a,
                                       time_b,
                                       time_a + 0.5 * step,
                                       time_a + random.uniform(0, 1) * step,
                                       time_a + random.uniform(-3, 4) * step,
                                       time_a - std::pow(10.0, random.uniform(0, 6)) * step,
                                       time_a + std::pow(10.0, random.uniform(0, 20)) * step};
    const Called called = slerp_between(ends.a, time_a, ends.b, time_b, times);
    all_ok = all_ok && called.status == QTRAJ_OK && called.bad_index == SIZE_MAX;
    for (size_t k = 0; k < times.size(); ++k) {
      const wide::Real fraction = (wide::Real(times[k]) - time_a) / (wide::Real(time_b) - time_a);
      const double theta = std::abs(static_cast<double>(fraction * pair.angle));
      if (theta > 1e6) continue;
      worst = std::max(worst, wide::error(&called.q[4 * k], wide::slerp(pair, fraction)) / (6e-16 + 1e-15 * theta));
    }
  }
  CAPTURE(worst);
  CHECK(worst <= 1);
  CHECK(all_ok);
}

TEST_CASE("C API: slerp_between is slerp at the fraction of the time", "[capi][slerp_between]") {
  Random random(22);
  const Quaternion a = random.orientation(), b = random.orientation();
  for (const int32_t path : pairs::kPaths) {
    // 128ths: exact in both
    constexpr size_t kCount = 257;
    std::vector<double> times, fractions, q(4 * kCount);
    for (int i = -64; i <= 192; ++i) times.push_back(3.0 + i / 64.0), fractions.push_back(i / 128.0);
    REQUIRE(qtraj_slerp(a.data(), b.data(), fractions.data(), kCount, path, q.data(), nullptr) == QTRAJ_OK);
    CHECK(slerp_between(a, 3.0, b, 5.0, times, path).q == q);

    // a time at fault spoils its own row only
    for (const size_t row : {66u, 127u, 128u, 129u, 160u}) {
      std::vector<double> with_fault = times;
      with_fault[row] = kNaN;
      const Called called = slerp_between(a, 3.0, b, 5.0, with_fault, path);
      CHECK((called.status == QTRAJ_E_NOT_FINITE && called.bad_index == row && called.row_is_nan(row)));
      CHECK(std::equal(q.begin(), q.begin() + 4 * row, called.q.begin()));
      CHECK(std::equal(q.begin() + 4 * row + 4, q.end(), called.q.begin() + 4 * row + 4));
    }
  }
}

TEST_CASE("C API: slerp_between wants its end times in order, apart, and no more than DBL_MAX apart",
          "[capi][slerp_between][errors]") {
  const struct {
    double time_a, time_b;
    qtraj_status status;
  } cases[] = {{1, 1, QTRAJ_E_TIME_ORDER},         {1, 0, QTRAJ_E_TIME_ORDER},
               {0, 1e-160, QTRAJ_E_TIME_ORDER},    {0, -0.0, QTRAJ_E_TIME_ORDER},
               {-1e308, 1e308, QTRAJ_E_TIME_SPAN}, {kNaN, 1, QTRAJ_E_NOT_FINITE},
               {0, kNaN, QTRAJ_E_NOT_FINITE},      {-kInfinity, 0, QTRAJ_E_NOT_FINITE},
               {0, kInfinity, QTRAJ_E_NOT_FINITE}, {0, 1e-150, QTRAJ_OK},
               {-8e307, 8e307, QTRAJ_OK}};
  const Quaternion a = {1, 0, 0, 0}, b = {0, 1, 0, 0}, zero = {}, bad = {kNaN, 0, 0, 0};
  for (const auto& at : cases) {
    CAPTURE(at.time_a, at.time_b);
    const Called called = slerp_between(a, at.time_a, b, at.time_b, {0.0, 0.5});
    CHECK(called.status == at.status);
    const bool is_ok = at.status == QTRAJ_OK;
    CHECK(called.bad_index == (is_ok ? SIZE_MAX : 0));
    CHECK(called.row_is_nan(0) == !is_ok);
    CHECK(called.row_is_nan(1) == !is_ok);

    // at one row the order is NOT_FINITE, ZERO_NORM, times
    CHECK(slerp_between(bad, at.time_a, zero, at.time_b, {0.5}).status == QTRAJ_E_NOT_FINITE);
    CHECK(slerp_between(a, at.time_a, b, at.time_b, {kInfinity}).status == QTRAJ_E_NOT_FINITE);
    const bool is_finite = at.status != QTRAJ_E_NOT_FINITE;
    CHECK(slerp_between(zero, at.time_a, b, at.time_b, {0.5}).status ==
          (is_finite ? QTRAJ_E_ZERO_NORM : QTRAJ_E_NOT_FINITE));
  }
}

TEST_CASE("C API: a faulty time of slerp_between spoils its own row only", "[capi][slerp_between][errors]") {
  const Quaternion a = {1, 0, 0, 0}, b = {0, 1, 0, 0};
  const Called good = slerp_between(a, 0, b, 1, {0.25, 0.5, 0.75});
  const Called called = slerp_between(a, 0, b, 1, {0.25, kNaN, 0.75});
  CHECK(called.status == QTRAJ_E_NOT_FINITE);
  CHECK(called.bad_index == 1);
  CHECK(called.row_is_nan(1));
  for (const size_t k : {0, 1, 2, 3, 8, 9, 10, 11}) CHECK(called.q[k] == good.q[k]);
}

TEST_CASE("C API: slerp_between takes any times without raising anything", "[capi][slerp_between][floating]") {
  double signalling;
  capi::set_signalling_nan(signalling);
  const double all[] = {0,       -0.0, 5e-324, 1e-300,   1e-154, 1.0,       1.7e9,      1e154,     1e308,
                        DBL_MAX, -1.0, -1e308, -DBL_MAX, kNaN,   kInfinity, -kInfinity, signalling};
  const std::vector<double> times(std::begin(all), std::end(all));
  std::vector<double> q(4 * times.size());
  const Quaternion a = {1, 0, 0, 0}, near = {1, 1e-100, 0, 0}, far = {0.1, 0.2, 0.3, 0.4};
  for (const double& time_a : all)
    for (const double& time_b : all)
      for (const Quaternion& b : {near, far}) {
        const std::string found = capi::disturbance([&] {
          qtraj_slerp_between(a.data(), time_a, b.data(), time_b, times.data(), times.size(), QTRAJ_PATH_SHORTEST,
                              q.data(), nullptr);
        });
        if (found != "nothing") FAIL(found << " at " << time_a << ", " << time_b);
        for (size_t row = 0; row < times.size(); ++row)
          if (!std::isnan(q[4 * row]) && !(std::abs(pairs::norm_of(&q[4 * row]) - 1) <= 4 * DBL_EPSILON))
            FAIL("norm " << pairs::norm_of(&q[4 * row]));
      }
}

}  // namespace
