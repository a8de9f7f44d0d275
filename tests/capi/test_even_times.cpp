// Even times: exact ends, rounding, order, faulty arguments.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

std::vector<double> even_times(double first, double last, size_t count) {
  std::vector<double> times(count, 7.0);
  REQUIRE(qtraj_even_times(first, last, count, times.data()) == QTRAJ_OK);
  return times;
}

TEST_CASE("C API: even times are the same numbers as decimal literals and quotients", "[capi][even_times]") {
  CHECK(even_times(0, 1, 11) == std::vector<double>{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1});
  CHECK(even_times(-2, 4, 7) == std::vector<double>{-2, -1, 0, 1, 2, 3, 4});
  size_t wrong = 0;
  for (size_t count = 2; count <= 1500; ++count) {
    const std::vector<double> times = even_times(0, 1, count);
    for (size_t i = 0; i < count; ++i)
      if (times[i] != static_cast<double>(i) / static_cast<double>(count - 1)) ++wrong;
  }
  CHECK(wrong == 0);
}

// Distance of neighbouring doubles at a number of this size.
long double ulp(long double size) {
  int exponent;
  std::frexp(size, &exponent);
  return std::ldexp(1.0L, std::max(exponent - DBL_MANT_DIG, -1074));
}

TEST_CASE("C API: even times are within 0.51 ulp, 0.75 where subnormal, never decrease and never pass the last",
          "[capi][even_times]") {
  test::Random random(21);
  double worst = 0, worst_subnormal = 0;
  size_t disordered = 0, compared = 0;
  while (compared < 1000000) {
    // ends of 40 bits and up to 2^20 intervals: the exact numerators are whole numbers
    const double limit = std::ldexp(1.0, static_cast<int>(random.uniform(1, 41)));
    int64_t ends[2];
    for (int64_t& end : ends) end = static_cast<int64_t>(random.uniform(-limit, limit));
    if (random.uniform(0, 1) < 0.2) ends[1] = ends[0] + static_cast<int64_t>(random.uniform(0, 4));
    if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
    const auto intervals = static_cast<int64_t>(std::exp2(random.uniform(0, random.uniform(0, 1) < 0.01 ? 20 : 11)));
    const int exponent = static_cast<int>(random.uniform(-1080, 984));
    const double first = std::ldexp(static_cast<double>(ends[0]), exponent);
    const double last = std::ldexp(static_cast<double>(ends[1]), exponent);
    // an end in the subnormal range may have been rounded
    if (std::ldexp(first, -exponent) != static_cast<double>(ends[0])) continue;
    if (std::ldexp(last, -exponent) != static_cast<double>(ends[1])) continue;

    const std::vector<double> times = even_times(first, last, static_cast<size_t>(intervals) + 1);
    if (times.front() != first || times.back() != last) ++disordered;
    for (int64_t i = 0; i <= intervals; ++i) {
      const double time = times[static_cast<size_t>(i)];
      if (i > 0 && time < times[static_cast<size_t>(i) - 1]) ++disordered;
      const int64_t numerator = ends[0] * (intervals - i) + ends[1] * i;
      const long double whole = static_cast<long double>(numerator / intervals);
      const long double part = static_cast<long double>(numerator % intervals) / static_cast<long double>(intervals);
      const long double exact = std::ldexp(whole + part, exponent);
      double& worst_here = std::abs(exact) < DBL_MIN ? worst_subnormal : worst;
      test::raise_to(worst_here, std::abs(time - exact) / ulp(exact));
      ++compared;
    }
  }
  CHECK(disordered == 0);
  CHECK(worst <= 0.51);
  CHECK(worst_subnormal <= 0.75);
}

TEST_CASE("C API: even times over all of double's range are symmetric and overflow nowhere", "[capi][even_times]") {
  for (const size_t count : {size_t{2}, size_t{3}, size_t{4}, size_t{101}, size_t{1000}}) {
    CAPTURE(count);
    const std::vector<double> times = even_times(-DBL_MAX, DBL_MAX, count);
    CHECK(times.front() == -DBL_MAX);
    CHECK(times.back() == DBL_MAX);
    for (size_t i = 0; i < count; ++i) CHECK(times[i] == -times[count - 1 - i]);
    for (size_t i = 1; i < count; ++i) CHECK(times[i - 1] < times[i]);
  }
  CHECK(even_times(-DBL_MAX, DBL_MAX, 3)[1] == 0);
  CHECK(even_times(-DBL_MAX, DBL_MAX, 5)[3] == DBL_MAX / 2);
  CHECK(even_times(0, DBL_MAX, 3)[1] == DBL_MAX / 2);
  CHECK(even_times(0, 4 * kSmallest, 5) ==
        std::vector<double>{0, kSmallest, 2 * kSmallest, 3 * kSmallest, 4 * kSmallest});
}

TEST_CASE("C API: even times between neighbouring doubles are one of the two", "[capi][even_times]") {
  for (const double first : {1.0, -1.0, 1e300, -2e-307, 0.0, 1.7e9}) {
    CAPTURE(first);
    const double last = std::nextafter(first, kInfinity);
    const std::vector<double> times = even_times(first, last, 1001);
    size_t wrong = 0;
    for (size_t i = 0; i < times.size(); ++i)
      if (times[i] != (2 * i < times.size() - 1 ? first : last) && 2 * i != times.size() - 1) ++wrong;
    CHECK(wrong == 0);
    CHECK((times[500] == first || times[500] == last));
  }
}

TEST_CASE("C API: one even time is the first, equal ends repeat and none at all is OK with NULL",
          "[capi][even_times]") {
  CHECK(even_times(3, 8, 1) == std::vector<double>{3});
  CHECK(even_times(-0.7, -0.7, 5) == std::vector<double>(5, -0.7));
  CHECK(even_times(0, 0, 3) == std::vector<double>(3, 0.0));
  for (const double end : {0.0, kNaN, -kInfinity, -5.0}) CHECK(qtraj_even_times(1, end, 0, nullptr) == QTRAJ_OK);
}

TEST_CASE("C API: even times are NaN where an end is not finite or the last comes before the first",
          "[capi][even_times][errors]") {
  struct Ends {
    double first, last;
    qtraj_status status;
  };
  for (const Ends& ends : {Ends{kNaN, 1, QTRAJ_E_NOT_FINITE}, Ends{0, kNaN, QTRAJ_E_NOT_FINITE},
                           Ends{-kInfinity, 1, QTRAJ_E_NOT_FINITE}, Ends{0, kInfinity, QTRAJ_E_NOT_FINITE},
                           Ends{1, 0, QTRAJ_E_TIME_ORDER}, Ends{DBL_MAX, -DBL_MAX, QTRAJ_E_TIME_ORDER}})
    for (const size_t count : {size_t{1}, size_t{2}, size_t{5}}) {
      CAPTURE(ends.first, ends.last, count);
      std::vector<double> times(count, 7.0);
      CHECK(qtraj_even_times(ends.first, ends.last, count, times.data()) == ends.status);
      CHECK(std::all_of(times.begin(), times.end(), [](double time) { return std::isnan(time); }));
    }
}

TEST_CASE("C API: even times without an array are NULL and more than memory holds are SIZE",
          "[capi][even_times][errors]") {
  double time = 7;
  CHECK(qtraj_even_times(0, 1, 3, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_even_times(kNaN, 1, SIZE_MAX, nullptr) == QTRAJ_E_NULL);
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 8 + 2, static_cast<size_t>(PTRDIFF_MAX) / 8 + 1})
    CHECK(qtraj_even_times(kNaN, 1, count, &time) == QTRAJ_E_SIZE);
  CHECK(time == 7);
}

TEST_CASE("C API: even times disturb nothing", "[capi][even_times][floating]") {
  double signalling;
  set_signalling_nan(signalling);
  const double values[] = {0.0,       -0.0,       1.0,   -1.0, DBL_MAX,   -DBL_MAX,   DBL_MIN,
                           kSmallest, -kSmallest, 1e308, kNaN, kInfinity, -kInfinity, signalling};
  double times[7];
  for (const double& first : values)
    for (const double& last : values)
      for (const size_t count : {size_t{1}, size_t{2}, size_t{7}}) {
        CAPTURE(first, last, count);
        CHECK(disturbance([&] { qtraj_even_times(first, last, count, times); }) == std::string("nothing"));
      }
}

}  // namespace
