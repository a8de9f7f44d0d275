// Sampling and faulty arguments or times: statuses, rows, untouched outputs.
#include <cfloat>
#include <limits>

#include "support/capi_variants.hpp"
#include "support/ends.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

template <class Real>
Trajectory tour(const Variant& variant) {
  const Keyframes<Real> keys = closed_tour<Real>(8);
  return must_build(make_options(variant).get(), keys, rates_for<Real>(variant, 8));
}

template <class Real>
bool row_is_nan(const std::vector<Real>& q, size_t row) {
  return std::isnan(q[4 * row]) && std::isnan(q[4 * row + 1]) && std::isnan(q[4 * row + 2]) &&
         std::isnan(q[4 * row + 3]);
}

TEST_CASE("C API: sampling nothing is OK with NULL arrays", "[capi][sample]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      const Trajectory curve = tour<Real>(variant);
      size_t bad_index = 0;
      CHECK(sample(curve.get(), nullptr, 0, static_cast<Real*>(nullptr), &bad_index) == QTRAJ_OK);
      CHECK(bad_index == SIZE_MAX);
      CHECK(sample(curve.get(), nullptr, 0, static_cast<Real*>(nullptr), nullptr) == QTRAJ_OK);
      bad_index = 0;
      CHECK(sample_uniform(curve.get(), kNaN, kInfinity, 0, static_cast<Real*>(nullptr), &bad_index) == QTRAJ_OK);
      CHECK(bad_index == SIZE_MAX);
      double time = 0;
      CHECK(sample(curve.get(), &time, 0, reinterpret_cast<Real*>(&time), nullptr) == QTRAJ_OK);
    }
  });
}

TEST_CASE("C API: sampling judges arguments in the order NULL, SIZE, OVERLAP and then leaves outputs alone",
          "[capi][sample][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Trajectory curve = tour<Real>({"", QTRAJ_SQUAD});
    const qtraj_trajectory* none = nullptr;
    const double times[3] = {-1.5, -1.0, 0.0};
    const std::vector<Real> untouched(12, Real(7));
    std::vector<Real> q = untouched;
    Real* no_rows = nullptr;

    const auto check = [&](qtraj_status expected, auto&& call) {
      size_t bad_index = 12345;
      CHECK(call(&bad_index) == expected);
      CHECK(bad_index == SIZE_MAX);
      CHECK(call(nullptr) == expected);
      CHECK(q == untouched);
    };
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample(none, times, 3, q.data(), bad); });
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample(none, nullptr, 0, no_rows, bad); });
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample(curve.get(), nullptr, 3, q.data(), bad); });
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample(curve.get(), times, 3, no_rows, bad); });
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample(curve.get(), nullptr, SIZE_MAX, q.data(), bad); });
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample_uniform(none, 0, 0.1, 3, q.data(), bad); });
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample_uniform(none, 0, 0.1, 0, no_rows, bad); });
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample_uniform(curve.get(), 0, 0.1, 3, no_rows, bad); });
    check(QTRAJ_E_NULL, [&](size_t* bad) { return sample_uniform(curve.get(), 0, 0.1, SIZE_MAX, no_rows, bad); });

    constexpr size_t kMost = PTRDIFF_MAX;
    for (const size_t count : {SIZE_MAX, SIZE_MAX / 4 + 2, SIZE_MAX / 32 + 2, kMost / (4 * sizeof(Real)) + 1}) {
      CAPTURE(count);
      check(QTRAJ_E_SIZE, [&](size_t* bad) { return sample(curve.get(), times, count, q.data(), bad); });
      check(QTRAJ_E_SIZE, [&](size_t* bad) { return sample_uniform(curve.get(), 0, 0.1, count, q.data(), bad); });
    }
    // SIZE before OVERLAP
    const double* in_q = reinterpret_cast<const double*>(q.data());
    check(QTRAJ_E_SIZE, [&](size_t* bad) { return sample(curve.get(), in_q, SIZE_MAX, q.data(), bad); });

    CHECK(sample_at(none, 0, nullptr, q.data()) == QTRAJ_E_NULL);
    CHECK(sample_at(curve.get(), 0, nullptr, no_rows) == QTRAJ_E_NULL);
    CHECK(sample_at(none, kNaN, nullptr, no_rows) == QTRAJ_E_NULL);
    CHECK(q == untouched);
  });
}

TEST_CASE("C API: rows that overlap the times are OVERLAP, rows right beside them are fine", "[capi][sample][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Trajectory curve = tour<Real>({"", QTRAJ_LOG_SPLINE});
    constexpr size_t kCount = 3, kTimeBytes = kCount * sizeof(double), kRowBytes = 4 * kCount * sizeof(Real);
    // times stay, rows move across them
    for (size_t offset = 0; offset + kRowBytes <= 256; offset += sizeof(Real)) {
      CAPTURE(offset);
      alignas(double) unsigned char block[256] = {};
      const size_t times_at = 104;
      double* times = reinterpret_cast<double*>(block + times_at);
      for (size_t i = 0; i < kCount; ++i) times[i] = -1.5 + static_cast<double>(i);
      unsigned char before[256];
      std::memcpy(before, block, sizeof block);

      const bool apart = offset + kRowBytes <= times_at || offset >= times_at + kTimeBytes;
      size_t bad_index = 0;
      CHECK(sample(curve.get(), times, kCount, reinterpret_cast<Real*>(block + offset), &bad_index) ==
            (apart ? QTRAJ_OK : QTRAJ_E_OVERLAP));
      CHECK(bad_index == SIZE_MAX);
      if (!apart) CHECK(std::memcmp(before, block, sizeof block) == 0);
    }
  });
}

TEST_CASE("C API: rows at fault are NaN, all others right, the status that of the first", "[capi][sample][errors]") {
  struct Fault {
    double time;
    qtraj_status status;
  };
  const Fault faults[] = {{kNaN, QTRAJ_E_NOT_FINITE},
                          {-kNaN, QTRAJ_E_NOT_FINITE},
                          {kInfinity, QTRAJ_E_NOT_FINITE},
                          {-kInfinity, QTRAJ_E_NOT_FINITE},
                          {-DBL_MAX, QTRAJ_E_TIME_RANGE},
                          {DBL_MAX, QTRAJ_E_TIME_RANGE},
                          {test::before_all(-2.0, closed_tour<double>(8).times.back()), QTRAJ_E_TIME_RANGE}};
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      const Trajectory curve = tour<Real>(variant);
      const std::vector<double> good = times_in(closed_tour<Real>(8).times, 3);
      const std::vector<Real> expected = must_sample<Real>(curve.get(), good);
      for (const Fault& first : faults)
        for (const Fault& second : faults)
          for (const size_t row : {size_t{0}, size_t{5}, good.size() - 2}) {
            CAPTURE(variant.name, first.time, second.time, row);
            std::vector<double> times = good;
            times[row] = first.time;
            times.back() = second.time;
            std::vector<Real> q(4 * times.size());
            size_t bad_index = 0;
            const qtraj_status status = sample(curve.get(), times.data(), times.size(), q.data(), &bad_index);
            std::vector<Real> patched = q;
            for (const size_t at : {row, times.size() - 1})
              std::copy_n(expected.begin() + static_cast<ptrdiff_t>(4 * at), 4,
                          patched.begin() + static_cast<ptrdiff_t>(4 * at));
            const bool rows_right =
                row_is_nan(q, row) && row_is_nan(q, times.size() - 1) && same_bits(patched, expected);
            CHECK((status == first.status && bad_index == row && rows_right));
          }
    }
  });
}

TEST_CASE("C API: sample_at treats a faulty time like a row", "[capi][sample][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Trajectory curve = tour<Real>({"", QTRAJ_SLERP});
    for (const double time : {kNaN, kInfinity, -kInfinity, -1e9, 1e9}) {
      CAPTURE(time);
      std::vector<Real> q(4, Real(7));
      size_t cursor = 3;
      const qtraj_status expected = std::isfinite(time) ? QTRAJ_E_TIME_RANGE : QTRAJ_E_NOT_FINITE;
      CHECK(sample_at(curve.get(), time, &cursor, q.data()) == expected);
      CHECK(row_is_nan(q, 0));
      CHECK(sample_at(curve.get(), -1.0, &cursor, q.data()) == QTRAJ_OK);
      CHECK(worst_norm_error(q) <= 4);
    }
  });
}

TEST_CASE("C API: sample_uniform gives each row the status of its time, start + (double)i * step",
          "[capi][sample][errors]") {
  struct Grid {
    double start, step;
  };
  const double third = std::nextafter(DBL_MAX / 3, kInfinity);  // 3 * third rounds to infinity, DBL_MAX / third to 3
  const Grid grids[] = {{kNaN, 0},           {0, kNaN},
                        {kInfinity, 1},      {0, kInfinity},
                        {-kInfinity, 1},     {kInfinity, -kInfinity},
                        {0, DBL_MAX},        {DBL_MAX, DBL_MAX},
                        {-DBL_MAX, DBL_MAX}, {-DBL_MAX, DBL_MAX / 2},
                        {-1e308, 5e307},     {-1.0, -DBL_MAX / 3},
                        {0, third},          {0, -third},
                        {-DBL_MAX, third},   {-2.0, 0.5},
                        {3.0, -0.25},        {1.0, 0.0},
                        {0.0, 5e-324},       {-1.0, 1e-17}};
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      const Trajectory curve = tour<Real>(variant);
      for (const Grid& grid : grids)
        for (const size_t count : {size_t{1}, size_t{9}}) {
          CAPTURE(variant.name, grid.start, grid.step, count);
          std::vector<double> times(count);
          for (size_t i = 0; i < count; ++i) {
            const double offset = static_cast<double>(i) * grid.step;
            times[i] = grid.start + offset;
          }
          std::vector<Real> q(4 * count), expected(4 * count);
          size_t bad_index = 0, expected_index = 0;
          const qtraj_status status = sample_uniform(curve.get(), grid.start, grid.step, count, q.data(), &bad_index);
          CHECK(status == sample(curve.get(), times.data(), count, expected.data(), &expected_index));
          CHECK(bad_index == expected_index);
          CHECK(same_bits(q, expected));
        }
    }
  });
}

TEST_CASE("C API: any cursor is a hint and the knots belong to the curve", "[capi][sample]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      const Trajectory curve = tour<Real>(variant);
      const std::vector<double> times = times_in(closed_tour<Real>(8).times, 4);
      const std::vector<Real> expected = must_sample<Real>(curve.get(), times);
      for (const size_t hint : {size_t{0}, size_t{3}, size_t{6}, size_t{7}, size_t{8}, SIZE_MAX, SIZE_MAX - 1,
                                SIZE_MAX / 8 + 1, SIZE_MAX / 80}) {
        std::vector<Real> q(expected.size());
        bool all_ok = true;
        for (size_t i = 0; i < times.size(); ++i) {
          size_t cursor = hint;
          all_ok = sample_at(curve.get(), times[i], &cursor, &q[4 * i]) == QTRAJ_OK && all_ok;
        }
        CHECK(all_ok);
        CHECK(same_bits(q, expected));
      }
    }
  });
}

TEST_CASE("C API: a time that is not finite is a fault also where the keys reach an end of the range of double",
          "[capi][sample][errors]") {
  constexpr double kMost = std::numeric_limits<double>::max(), kInfinite = std::numeric_limits<double>::infinity();
  for (const bool at_start : {true, false}) {
    Keyframes<double> keys = closed_tour<double>(5);
    at_start ? keys.times.front() = -kMost : keys.times.back() = kMost;
    for (const int32_t method : {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_SQUAD})
      for (const double fault : {kInfinite, -kInfinite, std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(at_start, method, fault);
        const Options options = make_options({"", method});
        REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD) ==
                QTRAJ_OK);
        const Trajectory curve = must_build(options.get(), keys);
        std::vector<double> times(40), q(160);
        for (size_t i = 0; i < times.size(); ++i) times[i] = keys.times[(7 * i) % 5];  // in no order
        times[17] = fault;
        size_t bad_index = 0;
        CHECK(qtraj_sample(curve.get(), times.data(), times.size(), q.data(), &bad_index) == QTRAJ_E_NOT_FINITE);
        CHECK(bad_index == 17);
        CHECK(std::isnan(q[4 * 17]));
      }
  }
}

}  // namespace
