// Slerp and nlerp of pairs whose ends have times: bounds, statuses, counts, and that one row is one pair's.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/pair_functions.hpp"
#include "support/wide_pair.hpp"
#include "support/worst.hpp"

using namespace capi;
using pairs::kPaths;
using test::Random;

namespace {

template <class Real>
struct Functions {
  qtraj_status (*between)(const Real*, const double*, size_t, const Real*, const double*, size_t, const double*, size_t,
                          size_t, int32_t, Real*, size_t*);
  qtraj_status (*pairs)(const Real*, size_t, const Real*, size_t, const Real*, size_t, size_t, int32_t, Real*, size_t*);
};
std::vector<Functions<double>> functions(double) {
  return {{qtraj_slerp_pairs_between, qtraj_slerp_pairs}, {qtraj_nlerp_pairs_between, qtraj_nlerp_pairs}};
}
std::vector<Functions<float>> functions(float) {
  return {{qtraj_slerp_pairs_between_f32, qtraj_slerp_pairs_f32},
          {qtraj_nlerp_pairs_between_f32, qtraj_nlerp_pairs_f32}};
}

// Pairs of `count` rows, with times.
template <class Real>
struct TimedPairs {
  std::vector<Real> a, b;
  std::vector<double> time_a, time_b, times;
  size_t a_count, b_count, times_count, count;
  int32_t path = QTRAJ_PATH_SHORTEST;

  qtraj_status operator()(const Functions<Real>& f, std::vector<Real>& q, size_t* bad_index) const {
    return f.between(a.data(), time_a.data(), a_count, b.data(), time_b.data(), b_count, times.data(), times_count,
                     count, path, q.data(), bad_index);
  }
};
// Ends on 128ths, so that fractions are exact, from outside too.
template <class Real>
TimedPairs<Real> even_pairs(size_t count, bool spread) {
  Random random(count);
  TimedPairs<Real> pairs;
  pairs.count = pairs.a_count = pairs.b_count = pairs.times_count = count;
  for (size_t row = 0; row < count; ++row) {
    const test::Quaternion a = random.orientation(),
                           b = spread ? random.orientation() : test::multiply(a, test::turn_within(random, 1.0));
    for (const double component : a) pairs.a.push_back(static_cast<Real>(component));
    for (const double component : b) pairs.b.push_back(static_cast<Real>(component));
    const double start = std::floor(random.uniform(-5, 5));
    pairs.time_a.push_back(start);
    pairs.time_b.push_back(start + 2);
    pairs.times.push_back(start + std::floor(random.uniform(spread ? -40 : 1, spread ? 160 : 128)) / 64);
  }
  return pairs;
}

TEST_CASE("C API: pairs between times are pairs at the fractions of the times", "[capi][pairs_between]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Functions<Real>& f : functions(zero))
      for (const size_t count : {1u, 2u, 31u, 32u, 33u, 200u})
        for (const bool spread : {true, false})
          for (const int32_t path : kPaths)
            for (int broadcast = 0; broadcast < 8; ++broadcast) {
              TimedPairs<Real> pairs = even_pairs<Real>(count, spread);
              pairs.path = path;
              if (broadcast & 1) pairs.a_count = 1;
              if (broadcast & 2) pairs.b_count = 1;
              if (broadcast & 4) pairs.times_count = 1;
              // where an end serves all rows, so does its time
              std::vector<Real> fractions;
              bool in_order = true;
              for (size_t row = 0; row < count; ++row) {
                const double start = pairs.time_a[pairs.a_count == 1 ? 0 : row];
                const double end = pairs.time_b[pairs.b_count == 1 ? 0 : row];
                in_order = in_order && start < end;
                fractions.push_back(
                    static_cast<Real>((pairs.times[pairs.times_count == 1 ? 0 : row] - start) / (end - start)));
              }
              if (!in_order) continue;
              if (sizeof(Real) == 4 && pairs.a_count != pairs.b_count) continue;  // fractions are no floats then
              std::vector<Real> q(4 * count), expected(4 * count);
              REQUIRE(pairs(f, q, nullptr) == QTRAJ_OK);
              REQUIRE(f.pairs(pairs.a.data(), pairs.a_count, pairs.b.data(), pairs.b_count, fractions.data(), count,
                              count, path, expected.data(), nullptr) == QTRAJ_OK);
              REQUIRE(q == expected);
            }
  });
}

TEST_CASE("C API: pairs between times stay within their bounds, at times of 1.7e9 s too", "[capi][pairs_between]") {
  Random random(91);
  double worst_slerp = 0, worst_nlerp = 0;
  for (int block = 0; block < 400; ++block) {
    constexpr size_t kRows = 250;
    TimedPairs<double> pairs;
    pairs.count = pairs.a_count = pairs.b_count = pairs.times_count = kRows;
    for (size_t row = 0; row < kRows; ++row) {
      const pairs::Ends ends = pairs::hard_ends(random, 160);
      pairs.a.insert(pairs.a.end(), ends.a.begin(), ends.a.end());
      pairs.b.insert(pairs.b.end(), ends.b.begin(), ends.b.end());
      const double start = row % 2 == 0 ? 1.7e9 + random.uniform(0, 1e6) : random.uniform(-1, 1);
      const double end = start + std::pow(10.0, random.uniform(-5, 5)), step = end - start;
      pairs.time_a.push_back(start);
      pairs.time_b.push_back(end);
      const double kind = random.uniform(0, 4);
      pairs.times.push_back(kind < 2   ? start + random.uniform(0, 1) * step
                            : kind < 3 ? start + random.uniform(-3, 4) * step
                                       : end + std::pow(10.0, random.uniform(0, 5)) * step);
    }
    std::vector<double> slerps(4 * kRows), nlerps(4 * kRows);
    REQUIRE(pairs(functions(0.0)[0], slerps, nullptr) == QTRAJ_OK);
    REQUIRE(pairs(functions(0.0)[1], nlerps, nullptr) == QTRAJ_OK);
    for (size_t row = 0; row < kRows; ++row) {
      const wide::Pair pair = wide::pair(&pairs.a[4 * row], &pairs.b[4 * row], true);
      if (pair.is_tie) continue;
      const wide::Real fraction =
          (wide::Real(pairs.times[row]) - pairs.time_a[row]) / (wide::Real(pairs.time_b[row]) - pairs.time_a[row]);
      const double theta = std::abs(static_cast<double>(fraction * pair.angle));
      if (theta > 1e6) continue;
      test::raise_to(worst_slerp, wide::error(&slerps[4 * row], wide::slerp(pair, fraction)) / (6e-16 + 1e-15 * theta));
      const wide::Chord chord = wide::nlerp(pair, fraction);
      const wide::Real length = 2 * std::sin(pair.angle / 2);
      const double turn = static_cast<double>(std::abs(fraction) * length / chord.norm);
      test::raise_to(worst_nlerp, wide::error(&nlerps[4 * row], chord.q) / (7e-16 + 4e-16 * turn));
    }
  }
  CAPTURE(worst_slerp, worst_nlerp);
  CHECK(worst_slerp <= 1);
  CHECK(worst_nlerp <= 1);
}

TEST_CASE("C API: float pairs between times are the double ones rounded once", "[capi][pairs_between]") {
  Random random(92);
  for (int i = 0; i < 2; ++i) {
    const TimedPairs<float> pairs = even_pairs<float>(500, true);
    TimedPairs<double> same;
    same.a.assign(pairs.a.begin(), pairs.a.end());
    same.b.assign(pairs.b.begin(), pairs.b.end());
    same.time_a = pairs.time_a, same.time_b = pairs.time_b, same.times = pairs.times;
    for (double& time : same.times) time += 1e-9 * random.uniform(-1, 1);  // fractions that float does not have
    TimedPairs<float> moved = pairs;
    moved.times = same.times;
    same.count = same.a_count = same.b_count = same.times_count = 500;
    std::vector<float> q(2000);
    std::vector<double> exact(2000);
    REQUIRE(moved(functions(0.0f)[i], q, nullptr) == QTRAJ_OK);
    REQUIRE(same(functions(0.0)[i], exact, nullptr) == QTRAJ_OK);
    for (size_t k = 0; k < q.size(); ++k) REQUIRE(q[k] == static_cast<float>(exact[k]));
  }
}

TEST_CASE("C API: rows of pairs between times at fault are NaN, all others right", "[capi][pairs_between][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Functions<Real>& f : functions(zero)) {
      const TimedPairs<Real> good = even_pairs<Real>(100, false);
      std::vector<Real> expected(400), q(400);
      REQUIRE(good(f, expected, nullptr) == QTRAJ_OK);
      const auto check = [&](size_t row, qtraj_status status, auto&& spoil) {
        TimedPairs<Real> pairs = good;
        spoil(pairs);
        size_t bad_index = 7;
        CHECK(std::string(disturbance([&] { (void)pairs(f, q, nullptr); })) == "nothing");
        CHECK(pairs(f, q, &bad_index) == status);
        CHECK(bad_index == row);
        for (size_t k = 0; k < 400; ++k) CHECK((k / 4 == row ? std::isnan(q[k]) : q[k] == expected[k]));
      };
      double signalling;
      Real signalling_q;
      set_signalling_nan(signalling);
      set_signalling_nan(signalling_q);
      for (const size_t row : {0u, 31u, 32u, 50u, 99u}) {
        for (const auto array : {&TimedPairs<Real>::time_a, &TimedPairs<Real>::time_b, &TimedPairs<Real>::times}) {
          check(row, QTRAJ_E_NOT_FINITE, [&](auto& pairs) { std::memcpy(&(pairs.*array)[row], &signalling, 8); });
          check(row, QTRAJ_E_NOT_FINITE, [&](auto& pairs) { (pairs.*array)[row] = HUGE_VAL; });
        }
        for (const auto array : {&TimedPairs<Real>::a, &TimedPairs<Real>::b}) {
          check(row, QTRAJ_E_NOT_FINITE,
                [&](auto& pairs) { std::memcpy(&(pairs.*array)[4 * row + 2], &signalling_q, sizeof(Real)); });
          check(row, QTRAJ_E_ZERO_NORM, [&](auto& pairs) {
            std::fill_n(&(pairs.*array)[4 * row], 4, Real(0));
            pairs.time_b[row] = pairs.time_a[row];  // after the norm
          });
        }
        check(row, QTRAJ_E_TIME_ORDER, [&](auto& pairs) { pairs.time_b[row] = pairs.time_a[row]; });
        check(row, QTRAJ_E_TIME_ORDER, [&](auto& pairs) { pairs.time_a[row] = 0, pairs.time_b[row] = 1e-160; });
        check(row, QTRAJ_E_TIME_SPAN, [&](auto& pairs) { pairs.time_a[row] = -1e308, pairs.time_b[row] = 1e308; });
      }
    }
  });
}

TEST_CASE("C API: opposite ends between times are AMBIGUOUS to slerp and through 0 to nlerp",
          "[capi][pairs_between][errors]") {
  const double a[8] = {1, 0, 0, 0, 0, 1, 0, 0}, b[8] = {1, 1, 0, 0, 0, -1, 0, 0}, start = 0, end = 2, time = 1;
  double q[8];
  size_t bad_index = 7;
  CHECK(qtraj_slerp_pairs_between(a, &start, 1, b, &end, 1, &time, 1, 1, QTRAJ_PATH_AS_GIVEN, q, &bad_index) ==
        QTRAJ_OK);
  const double starts[2] = {0, 0}, ends[2] = {2, 2};
  CHECK(qtraj_slerp_pairs_between(a, starts, 2, b, ends, 2, &time, 1, 2, QTRAJ_PATH_AS_GIVEN, q, &bad_index) ==
        QTRAJ_E_AMBIGUOUS);
  CHECK((bad_index == 1 && std::abs(pairs::norm_of(q + 4) - 1) < 1e-15));
  CHECK(qtraj_nlerp_pairs_between(a, starts, 2, b, ends, 2, &time, 1, 2, QTRAJ_PATH_AS_GIVEN, q, &bad_index) ==
        QTRAJ_E_ZERO_NORM);
  CHECK((bad_index == 1 && std::isnan(q[4])));
}

TEST_CASE("C API: arguments of pairs between times are judged in order, and then outputs left alone",
          "[capi][pairs_between][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Functions<Real>& f : functions(zero)) {
      const TimedPairs<Real> good = even_pairs<Real>(3, true);
      const std::vector<Real> untouched(12, Real(7));
      std::vector<Real> q = untouched;
      const auto call = [&](int missing, size_t a_count, size_t b_count, size_t times_count, size_t count, int32_t path,
                            Real* out) {
        size_t bad_index = 7;
        const qtraj_status status =
            f.between(missing == 0 ? nullptr : good.a.data(), missing == 1 ? nullptr : good.time_a.data(), a_count,
                      missing == 2 ? nullptr : good.b.data(), missing == 3 ? nullptr : good.time_b.data(), b_count,
                      missing == 4 ? nullptr : good.times.data(), times_count, count, path, out, &bad_index);
        CHECK(bad_index == SIZE_MAX);
        CHECK(q == untouched);
        return status;
      };
      for (int missing = 0; missing < 5; ++missing) CHECK(call(missing, 3, 3, 3, 3, 0, q.data()) == QTRAJ_E_NULL);
      CHECK(call(-1, 3, 3, 3, 3, 0, nullptr) == QTRAJ_E_NULL);
      CHECK(call(-1, 2, 3, 3, 3, 0, q.data()) == QTRAJ_E_COUNT);
      CHECK(call(-1, 3, 0, 3, 3, 0, q.data()) == QTRAJ_E_COUNT);
      CHECK(call(-1, 3, 3, 4, 3, 0, q.data()) == QTRAJ_E_COUNT);
      CHECK(call(-1, 1, 1, 1, SIZE_MAX / 8, 0, q.data()) == QTRAJ_E_SIZE);
      CHECK(call(-1, 3, 3, 3, 3, 0, q.data()) == QTRAJ_E_VALUE);
      CHECK(call(-1, 3, 3, 3, 3, QTRAJ_FRAME_BODY, q.data()) == QTRAJ_E_VALUE);
      CHECK(f.between(nullptr, nullptr, 1, nullptr, nullptr, 0, nullptr, 1, 0, QTRAJ_PATH_SHORTEST, nullptr, nullptr) ==
            QTRAJ_OK);
      // in place of an end of as many rows, of nothing else
      TimedPairs<Real> moved = good;
      std::vector<Real> expected(12);
      REQUIRE(good(f, expected, nullptr) == QTRAJ_OK);
      CHECK(moved(f, moved.a, nullptr) == QTRAJ_OK);
      CHECK(moved.a == expected);
      moved = good;
      moved.b_count = 1;
      CHECK(moved(f, moved.b, nullptr) == QTRAJ_E_OVERLAP);
      CHECK(moved.b == good.b);
      std::vector<double> times(12, 1.0);
      CHECK(f.between(good.a.data(), good.time_a.data(), 3, good.b.data(), good.time_b.data(), 3, times.data(), 3, 3,
                      QTRAJ_PATH_SHORTEST, reinterpret_cast<Real*>(times.data()), nullptr) == QTRAJ_E_OVERLAP);
    }
  });
}

}  // namespace
