// Seconds of nanosecond stamps: the nearest double of the exact quotient, by arithmetic on whole numbers.
#include <cmath>
#include <cstring>
#include <vector>

#include "support/capi_floating.hpp"
#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

__extension__ typedef __int128 Whole;

double seconds(int64_t ns, int64_t origin) {
  double result = NAN;
  REQUIRE(qtraj_seconds_from_ns(&ns, 1, origin, &result) == QTRAJ_OK);
  return result;
}

// Whether no double is nearer to difference / 10^9. With seconds = m 2^e, |m| < 2^53 and no smaller exponent possible,
// that is |m 10^9 - difference 2^-e| <= 10^9 / 2; below 2^84, all of it.
bool is_nearest(double result, Whole difference) {
  if (difference == 0) return result == 0 && !std::signbit(result);
  int exponent;
  const auto mantissa = static_cast<Whole>(std::ldexp(std::frexp(result, &exponent), 53));
  exponent -= 53;
  if (exponent > 0) return false;
  const Whole above = (mantissa * 1000000000 - (difference << -exponent)) * (mantissa < 0 ? -1 : 1);
  if (above < 0) return -2 * above <= 1000000000;
  // below a power of two doubles are twice as dense
  const bool is_power = mantissa == Whole{1} << 52 || -mantissa == Whole{1} << 52;
  return (is_power ? 4 : 2) * above <= 1000000000;
}

uint64_t random_bits(test::Random& random) {
  const auto high = static_cast<uint64_t>(random.uniform(0, 0x1p32)),
             low = static_cast<uint64_t>(random.uniform(0, 0x1p32));
  return high << 32 | low;
}

TEST_CASE("C API: seconds of nanoseconds are the exact quotient rounded once", "[capi][nanoseconds]") {
  test::Random random(81);
  size_t wrong = 0;
  for (int repetition = 0; repetition < 300000; ++repetition) {
    // differences of every size up to 2^64 - 1
    const auto shift = static_cast<int>(random.uniform(0, 64));
    const uint64_t size = random_bits(random) >> shift;
    const auto origin = static_cast<int64_t>(random_bits(random));
    const auto ns = static_cast<int64_t>(static_cast<uint64_t>(origin) + size);
    if (!is_nearest(seconds(ns, origin), Whole{ns} - Whole{origin})) ++wrong;
    if (!is_nearest(seconds(origin, ns), Whole{origin} - Whole{ns})) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("C API: seconds next to the middle of two doubles are rounded the right way", "[capi][nanoseconds]") {
  test::Random random(82);
  size_t wrong = 0;
  for (int repetition = 0; repetition < 100000; ++repetition) {
    // a number of 54 bits, the last one set, times a power of two is a middle; whole nanoseconds beside it
    const Whole middle = ((Whole{1} << 53) + static_cast<Whole>(random_bits(random) >> 11)) | 1;
    const auto places = static_cast<int>(random.uniform(19, 31));
    const Whole ns = (middle * 1000000000) >> places;
    for (Whole beside = ns - 1; beside <= ns + 2; ++beside) {
      if (beside > INT64_MAX) continue;
      if (!is_nearest(seconds(static_cast<int64_t>(beside), 0), beside)) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("C API: seconds at the limits of int64_t and at those of whole doubles", "[capi][nanoseconds]") {
  const int64_t first = INT64_MIN, last = INT64_MAX, exact = int64_t{1} << 53;
  CHECK(seconds(last, first) == 18446744073.709551615);
  CHECK(seconds(first, last) == -18446744073.709551615);
  CHECK(seconds(first, 0) == -9223372036.854775808);
  CHECK(seconds(last, 0) == 9223372036.854775807);
  CHECK(seconds(last, -1) == 9223372036.854775808);
  for (const int64_t ns : {exact - 1, exact, exact + 1, exact + 3}) {
    CHECK(is_nearest(seconds(ns, 0), ns));
    CHECK(is_nearest(seconds(-ns, 0), -ns));
  }
  CHECK(seconds(5, 5) == 0);
  CHECK(!std::signbit(seconds(5, 5)));
  CHECK(seconds(1700000000005000000, 1700000000000000000) == 0.005);
  CHECK(seconds(1700000000123456789, 0) == 1700000000.123456789);
}

TEST_CASE("C API: seconds of a stamp are the same alone and among others, past whole doubles too",
          "[capi][nanoseconds]") {
  const int64_t origins[] = {0, 1, -(int64_t{1} << 62) - 1, INT64_MIN, INT64_MAX};
  std::vector<int64_t> stamps;
  for (int64_t k = 0; k < 200; ++k) {
    const int64_t past = (int64_t{1} << 53) + 2 * k + 1, near = 1000000007 * k;
    for (const int64_t stamp : {past, -past, 512 * past + k, near, INT64_MAX - k, INT64_MIN + k})
      stamps.push_back(stamp);
  }
  // stretches of one size, which vectors see alone, after the mixture of all
  const std::vector<int64_t> mixed = stamps;
  for (size_t kind = 0; kind < 6; ++kind)
    for (size_t k = kind; k < mixed.size(); k += 6) stamps.push_back(mixed[k]);
  for (const int64_t origin : origins) {
    std::vector<double> seconds(stamps.size());
    REQUIRE(qtraj_seconds_from_ns(stamps.data(), stamps.size(), origin, seconds.data()) == QTRAJ_OK);
    size_t wrong = 0;
    for (size_t k = 0; k < stamps.size(); ++k) {
      double alone = 0;
      qtraj_seconds_from_ns(&stamps[k], 1, origin, &alone);
      wrong += alone != seconds[k];
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("C API: arguments of seconds_from_ns that are wrong write nothing", "[capi][nanoseconds][errors]") {
  int64_t ns[4] = {1, 2, 3, 4};
  double out[4] = {7, 7, 7, 7};
  CHECK(qtraj_seconds_from_ns(nullptr, 0, 0, nullptr) == QTRAJ_OK);
  CHECK(qtraj_seconds_from_ns(nullptr, 4, 0, out) == QTRAJ_E_NULL);
  CHECK(qtraj_seconds_from_ns(ns, 4, 0, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_seconds_from_ns(ns, SIZE_MAX / 8 + 2, 0, out) == QTRAJ_E_SIZE);
  // in place too: the arrays are of different types
  CHECK(qtraj_seconds_from_ns(ns, 4, 0, reinterpret_cast<double*>(ns)) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_seconds_from_ns(ns, 2, 0, reinterpret_cast<double*>(ns + 1)) == QTRAJ_E_OVERLAP);
  for (size_t k = 0; k < 4; ++k) CHECK((ns[k] == static_cast<int64_t>(k) + 1 && out[k] == 7));
  CHECK(std::string(capi::disturbance([&] { (void)qtraj_seconds_from_ns(ns, 4, INT64_MIN, out); })) == "nothing");
}

}  // namespace
