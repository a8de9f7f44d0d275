// Rates and derivatives over rows are the same bits in every kernel, wherever a row stands and whatever is beside it.
#include <qtraj.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>

#include "support/catch.hpp"
#include "support/forced_kernel.hpp"
#include "support/kernel_curves.hpp"
#include "support/random.hpp"

namespace {

using test::Random;

constexpr size_t kRows = 203;
constexpr int32_t kFrames[] = {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  for (size_t k = 0; k < a.size(); ++k)
    if (!(std::isnan(a[k]) && std::isnan(b[k])) && std::memcmp(&a[k], &b[k], sizeof(double)) != 0) return false;
  return a.size() == b.size();
}

// What a call gives: its outputs, one after the other, and its outcome.
struct Result {
  std::vector<double> numbers;
  qtraj_status status = QTRAJ_OK;
  size_t bad_index = 7;
  bool raised = false;
};

template <class Call>
Result result_of(size_t numbers, const Call& call) {
  Result result;
  result.numbers.assign(numbers, 7.0);
  std::feclearexcept(FE_ALL_EXCEPT);
  result.status = call(result.numbers.data(), &result.bad_index);
  result.raised = std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) != 0;
  return result;
}

void check_same(const Result& expected, const Result& found) {
  CHECK(same_bits(expected.numbers, found.numbers));
  CHECK(found.status == expected.status);
  CHECK(found.bad_index == expected.bad_index);
  CHECK_FALSE(found.raised);
}

// Calls check(call()) with every kernel, against what the first of them gives.
template <class Call>
void check_in_every_kernel(const Call& call) {
  Result expected;
  bool has_expected = false;
  test::for_every_kernel([&](const char*) {
    const Result found = call();
    if (!has_expected) expected = found;
    has_expected = true;
    check_same(expected, found);
  });
}

// ---- Rates between samples ----

// A recording in which one sample in `rare` is of another kind: of any norm and sign, half a turn from the one before,
// equal to it, not finite, 0, or with a time that repeats, steps back or is extreme.
struct Recording {
  std::vector<double> times, q;
};
Recording recording(int rare) {
  Random random(static_cast<uint64_t>(rare));
  Recording made;
  test::Quaternion q = random.orientation();
  double time = -1.0;
  for (size_t k = 0; k < kRows; ++k) {
    time += random.uniform(0.001, 0.1);
    q = test::multiply(q, test::turn_within(random, 1.0));
    const double norm = k % 2 == 0 ? 1.0 : -1.0;
    made.times.push_back(time);
    for (const double component : q) made.q.push_back(norm * component);
    if (random.uniform(0, rare) >= 1) continue;
    double *const at = &made.q[4 * k], *const moment = &made.times[k];
    const double odd_times[] = {time - 0.1, time, std::nan(""), 1e300, time};
    const double scales[] = {3.0, 0x1p-130, 0x1p130, 1e-310, 0.0, HUGE_VAL, std::nan("")};
    switch (k % 4) {
      case 0:
        *moment = odd_times[k / 4 % 5];
        break;
      case 1:
        for (size_t c = 0; c < 4; ++c) at[c] = k == 0 ? at[c] : made.q[4 * k + c - 4];
        break;
      case 2:
        if (k > 0) at[0] = -at[-3], at[1] = at[-4], at[2] = -at[-1], at[3] = at[-2];  // half a turn on
        break;
      default:
        for (size_t c = 0; c < 4; ++c) at[c] *= scales[k / 4 % 7];
    }
  }
  return made;
}

qtraj_status rates_between(int32_t frame, const Recording& samples, size_t first, size_t count, double* out,
                           size_t* bad_index) {
  return qtraj_estimate_omega(frame, &samples.times[first], &samples.q[4 * first], count, out, out + count - 1,
                              bad_index);
}

TEST_CASE("rates between samples are the same bits in every kernel", "[rate_kernels]") {
  for (const int rare : {1, 4, 30, 1000000})
    for (const int32_t frame : kFrames) {
      CAPTURE(rare, frame);
      const Recording samples = recording(rare);
      check_in_every_kernel([&] {
        return result_of(4 * (kRows - 1), [&](double* out, size_t* bad_index) {
          return rates_between(frame, samples, 0, kRows, out, bad_index);
        });
      });
    }
}

TEST_CASE("a rate between two samples depends on these two alone", "[rate_kernels]") {
  test::for_every_kernel([](const char*) {
    for (const int32_t frame : kFrames) {
      const Recording samples = recording(1000000);
      std::vector<double> all(4 * (kRows - 1)), one(4);
      REQUIRE(rates_between(frame, samples, 0, kRows, all.data(), nullptr) == QTRAJ_OK);
      size_t wrong = 0;
      for (size_t k = 0; k + 1 < kRows; ++k) {
        REQUIRE(rates_between(frame, samples, k, 2, one.data(), nullptr) == QTRAJ_OK);
        wrong += one[0] != all[k] || std::memcmp(&one[1], &all[kRows - 1 + 3 * k], 3 * sizeof(double)) != 0;
      }
      CHECK(wrong == 0);
    }
  });
}

// ---- Derivatives and rates ----

// Rows of which one in `rare` is 0, huge, tiny or not finite.
std::vector<double> rows(size_t width, int rare, uint64_t seed) {
  Random random(seed);
  const double odd[] = {0.0, 0x1p125, -0x1p-125, 1e-320, 1e200, std::nan(""), HUGE_VAL};
  std::vector<double> all;
  for (size_t row = 0; row < kRows; ++row) {
    const double scale = random.uniform(0, rare) < 1 ? odd[row % 7] : 1.0;
    for (size_t k = 0; k < width; ++k) all.push_back(scale * random.uniform(-2, 2));
  }
  return all;
}

TEST_CASE("derivatives and rates are the same bits in every kernel, with second ones and without", "[rate_kernels]") {
  for (const int rare : {2, 20, 1000000})
    for (const int32_t frame : kFrames)
      for (const bool twice : {false, true}) {
        CAPTURE(rare, frame, twice);
        const std::vector<double> q = rows(4, rare, 1), omega = rows(3, rare, 2), alpha = rows(3, rare, 3),
                                  dq = rows(4, rare, 4), ddq = rows(4, rare, 5);
        check_in_every_kernel([&] {
          return result_of((twice ? 8 : 4) * kRows, [&](double* out, size_t* bad_index) {
            return qtraj_derivatives_from_rates(frame, q.data(), omega.data(), twice ? alpha.data() : nullptr, kRows,
                                                out, twice ? out + 4 * kRows : nullptr, bad_index);
          });
        });
        check_in_every_kernel([&] {
          return result_of((twice ? 6 : 3) * kRows, [&](double* out, size_t* bad_index) {
            return qtraj_rates_from_derivatives(frame, q.data(), dq.data(), twice ? ddq.data() : nullptr, kRows, out,
                                                twice ? out + 3 * kRows : nullptr, bad_index);
          });
        });
      }
}

}  // namespace
