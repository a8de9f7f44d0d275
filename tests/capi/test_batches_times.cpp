// Times at a fixed step for each of many series: how many there are, and which.
#include <qtraj.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

#include "support/capi_batches.hpp"
#include "support/capi_floating.hpp"
#include "support/catch.hpp"
#include "support/guarded.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

struct Steps {
  std::vector<int64_t> offsets;
  std::vector<int32_t> statuses;
  qtraj_status status;
  size_t bad_index = 12345;
};
Steps offsets_of(const std::vector<int64_t>& key_offsets, const std::vector<double>& key_times,
                 const std::vector<double>& step) {
  const size_t count = key_offsets.size() - 1;
  Steps steps = {std::vector<int64_t>(count + 1, -77), std::vector<int32_t>(count, -77), QTRAJ_E_INTERNAL};
  steps.status = qtraj_batch_step_offsets(count, key_offsets.data(), key_times.data(), step.data(), step.size(),
                                          steps.offsets.data(), steps.statuses.data(), &steps.bad_index);
  return steps;
}

TEST_CASE("C API: offsets at a fixed step count as uniform_count does, and their times are its rows",
          "[capi][batches][times]") {
  const Table<double> table(60);
  const Options options = make_options({"", QTRAJ_SLERP});
  std::vector<double> steps;
  test::Random random(3);
  for (size_t k = 0; k < 60; ++k) steps.push_back(k == 7 ? 1e9 : random.uniform(0.001, 0.7));
  for (const bool one_for_all : {false, true}) {
    const std::vector<double> step = one_for_all ? std::vector<double>{0.01} : steps;
    const Steps found = offsets_of(table.key_offsets, table.key_times, step);
    REQUIRE((found.status == QTRAJ_OK && found.bad_index == SIZE_MAX && found.offsets[0] == 0));
    test::Guarded<double> room(static_cast<size_t>(found.offsets.back()));
    double* const times = room.array(static_cast<size_t>(found.offsets.back()), true);
    std::vector<int32_t> statuses(60, -77);
    size_t bad_index = 12345;
    CHECK(qtraj_batch_times(60, table.key_offsets.data(), table.key_times.data(), step.data(), step.size(),
                            found.offsets.data(), times, statuses.data(), &bad_index) == QTRAJ_OK);
    CHECK(bad_index == SIZE_MAX);
    Motion<double> out(static_cast<size_t>(found.offsets.back()));
    BatchCall<double> call = table.call(options.get(), out, false);
    call.sample_offsets = found.offsets.data(), call.sample_times = times;
    CHECK(call(nullptr) == QTRAJ_OK);
    for (size_t k = 0; k < 60; ++k) {
      const auto key = static_cast<size_t>(table.key_offsets[k]), row = static_cast<size_t>(found.offsets[k]);
      const size_t keys = table.keys_of(k);
      qtraj_trajectory* made = nullptr;
      REQUIRE(qtraj_create(QTRAJ_SLERP, &table.key_times[key], &table.key_q[4 * key], keys, &made, nullptr) ==
              QTRAJ_OK);
      const Trajectory curve(made);
      const double first = table.key_times[key], of_series = step[one_for_all ? 0 : k];
      size_t count = 0;
      REQUIRE(qtraj_uniform_count(made, first, of_series, &count) == QTRAJ_OK);
      CHECK(static_cast<size_t>(found.offsets[k + 1]) == row + count);
      CHECK((found.statuses[k] == QTRAJ_OK && statuses[k] == QTRAJ_OK));
      for (size_t i = 0; i < count; ++i) CHECK(times[row + i] == first + static_cast<double>(i) * of_series);
      std::vector<double> q(4 * count);
      REQUIRE(qtraj_sample_uniform(made, first, of_series, count, q.data(), nullptr) == QTRAJ_OK);
      CHECK(std::memcmp(q.data(), &out.q[4 * row], q.size() * sizeof(double)) == 0);
    }
  }
}

TEST_CASE("C API: the last step of a series counts where rounding puts it past the last key",
          "[capi][batches][times]") {
  // 3 * 0.1 is an ulp past 0.3; a slice that begins at row 2
  const std::vector<double> times = {kNaN, kNaN, 0, 0.15, 0.3, 100, 100.5};
  const Steps found = offsets_of({2, 5, 7}, times, {0.1, 0.25});
  CHECK(found.status == QTRAJ_OK);
  CHECK(found.offsets == std::vector<int64_t>{0, 4, 7});
  double out[10];
  std::fill_n(out, 10, 7.0);
  const int64_t rows[] = {3, 7, 10};
  const double step[] = {0.1, 0.25};
  const int64_t keys[] = {2, 5, 7};
  CHECK(qtraj_batch_times(2, keys, times.data(), step, 2, rows, out, nullptr, nullptr) == QTRAJ_OK);
  CHECK((out[0] == 7 && out[2] == 7));
  CHECK((out[3] == 0 && out[6] == 3 * 0.1 && out[7] == 100 && out[9] == 100.5));
}

TEST_CASE("C API: each series has the status of its own keys and step", "[capi][batches][times]") {
  struct Case {
    qtraj_status status;
    double first, last, step;
  };
  const Case cases[] = {{QTRAJ_OK, 0, 1, 0.25},
                        {QTRAJ_E_NOT_FINITE, kNaN, 1, 0.25},
                        {QTRAJ_E_NOT_FINITE, 0, kInfinity, 0.25},
                        {QTRAJ_E_NOT_FINITE, 0, 1, kNaN},
                        {QTRAJ_E_NOT_FINITE, 0, 1, -kInfinity},
                        {QTRAJ_E_VALUE, 0, 1, 0},
                        {QTRAJ_E_VALUE, 0, 1, -0.25},
                        {QTRAJ_E_TIME_ORDER, 1, 1, 0.25},
                        {QTRAJ_E_TIME_ORDER, 1, 0, 0.25},
                        {QTRAJ_E_TIME_SPAN, -DBL_MAX, DBL_MAX, 0.25},
                        {QTRAJ_E_SIZE, 0, 1e300, 0.25},
                        {QTRAJ_E_SIZE, 0, 1e16, 1},
                        {QTRAJ_OK, -1, 3, 1e308}};
  std::vector<int64_t> key_offsets = {0};
  std::vector<double> times, steps;
  for (const Case& c : cases) {
    for (const double time : {c.first, 0.5, c.last}) times.push_back(time);
    steps.push_back(c.step);
    key_offsets.push_back(static_cast<int64_t>(times.size()));
  }
  // a series of one key, and one of none
  times.push_back(5);
  key_offsets.push_back(static_cast<int64_t>(times.size()));
  key_offsets.push_back(static_cast<int64_t>(times.size()));
  steps.push_back(1), steps.push_back(1);
  const size_t count = steps.size();
  const Steps found = offsets_of(key_offsets, times, steps);
  CHECK((found.status == QTRAJ_E_NOT_FINITE && found.bad_index == 1));
  for (size_t k = 0; k < count; ++k) {
    CAPTURE(k);
    CHECK(found.statuses[k] == (k < 13 ? cases[k].status : QTRAJ_E_TOO_FEW));
    CHECK(found.offsets[k + 1] - found.offsets[k] == (k == 0 ? 5 : k == 12 ? 1 : 0));
  }
  // times: rows of a series at fault are NaN, a series that only has too many rows for one array is none
  std::vector<int64_t> rows;
  for (size_t k = 0; k <= count; ++k) rows.push_back(static_cast<int64_t>(3 * k));
  std::vector<double> out(3 * count, 7.0);
  std::vector<int32_t> statuses(count, -77);
  size_t bad_index = 12345;
  CHECK(qtraj_batch_times(count, key_offsets.data(), times.data(), steps.data(), count, rows.data(), out.data(),
                          statuses.data(), &bad_index) == QTRAJ_E_NOT_FINITE);
  CHECK(bad_index == 1);
  for (size_t k = 0; k < count; ++k) {
    CAPTURE(k);
    const bool only_long = k == 10 || k == 11;
    // 2e308 is past the range
    const qtraj_status expected = k >= 13     ? QTRAJ_E_TOO_FEW
                                  : only_long ? QTRAJ_OK
                                  : k == 12   ? QTRAJ_E_NOT_FINITE
                                              : cases[k].status;
    CHECK(statuses[k] == expected);
    CHECK(std::isnan(out[3 * k]) == (expected != QTRAJ_OK && k != 12));
    CHECK(std::isnan(out[3 * k + 2]) == (expected != QTRAJ_OK));
  }
  // one step for all
  const double zero = 0;
  CHECK(qtraj_batch_step_offsets(2, key_offsets.data(), times.data(), &zero, 1, rows.data(), statuses.data(),
                                 &bad_index) == QTRAJ_E_VALUE);
  CHECK((bad_index == 0 && rows[1] == 0 && rows[2] == 0));
  // steps so short that no array has room
  const Steps short_steps = offsets_of({0, 3}, {0, 0.5, 1}, {1e-300});
  CHECK((short_steps.status == QTRAJ_E_SIZE && short_steps.offsets[1] == 0));
  // together: 2^51 rows each, of which 64 are 2^57 and 128 too many
  std::vector<int64_t> many = {0};
  std::vector<double> many_times;
  for (int k = 0; k < 200; ++k) many_times.insert(many_times.end(), {0.0, 0x1p51}), many.push_back(2 * k + 2);
  const Steps together = offsets_of(many, many_times, {1.0});
  CHECK(together.status == QTRAJ_E_SIZE);
  CHECK(static_cast<uint64_t>(together.offsets.back()) <= static_cast<uint64_t>(PTRDIFF_MAX) / 32);
  CHECK(together.offsets[together.bad_index] == together.offsets.back());
}

TEST_CASE("C API: steps judge their arguments in the order of the statuses and then leave outputs alone",
          "[capi][batches][times][errors]") {
  struct Arguments {
    size_t count = 2;
    int64_t key_offsets[3] = {0, 2, 4}, sample_offsets[3] = {0, 3, 5}, offsets_out[3] = {7, 7, 7};
    double times[4] = {0, 1, 2, 3}, step[2] = {0.5, 0.5}, times_out[5] = {7, 7, 7, 7, 7};
    int32_t statuses[2] = {7, 7};
    const int64_t *keys = key_offsets, *samples = sample_offsets;
    const double *key_times = times, *steps = step;
    size_t step_count = 2;
    int64_t* to_offsets = offsets_out;
    double* to_times = times_out;
    int32_t* status_out = statuses;
  };
  const auto check = [](qtraj_status expected, size_t index, bool of_offsets, bool of_times, auto&& change) {
    for (const bool for_times : {false, true}) {
      if (for_times ? !of_times : !of_offsets) continue;
      Arguments a;
      change(a);
      const Arguments before = a;
      size_t bad_index = 12345;
      const qtraj_status status = for_times
                                      ? qtraj_batch_times(a.count, a.keys, a.key_times, a.steps, a.step_count,
                                                          a.samples, a.to_times, a.status_out, &bad_index)
                                      : qtraj_batch_step_offsets(a.count, a.keys, a.key_times, a.steps, a.step_count,
                                                                 a.to_offsets, a.status_out, &bad_index);
      CAPTURE(for_times);
      CHECK(status == expected);
      CHECK(bad_index == index);
      if (expected != QTRAJ_OK)
        CHECK((std::equal(a.offsets_out, a.offsets_out + 3, before.offsets_out) &&
               std::equal(a.times_out, a.times_out + 5, before.times_out) &&
               std::equal(a.statuses, a.statuses + 2, before.statuses)));
    }
  };
  check(QTRAJ_OK, SIZE_MAX, true, true, [](auto&) {});
  check(QTRAJ_OK, SIZE_MAX, true, true, [](auto& a) { a.status_out = nullptr; });
  check(QTRAJ_E_NULL, SIZE_MAX, true, true, [](auto& a) { a.keys = nullptr, a.step_count = 9; });
  check(QTRAJ_E_NULL, SIZE_MAX, true, true, [](auto& a) { a.key_times = nullptr; });
  check(QTRAJ_E_NULL, SIZE_MAX, true, true, [](auto& a) { a.steps = nullptr; });
  check(QTRAJ_E_NULL, SIZE_MAX, true, false, [](auto& a) { a.to_offsets = nullptr; });
  check(QTRAJ_E_NULL, SIZE_MAX, false, true, [](auto& a) { a.samples = nullptr; });
  check(QTRAJ_E_NULL, SIZE_MAX, false, true, [](auto& a) { a.to_times = nullptr; });
  check(QTRAJ_E_COUNT, SIZE_MAX, true, true, [](auto& a) { a.step_count = 3; });
  check(QTRAJ_E_COUNT, SIZE_MAX, true, true, [](auto& a) { a.step_count = 0; });
  check(QTRAJ_E_COUNT, 1, true, true, [](auto& a) { a.key_offsets[2] = 1; });
  check(QTRAJ_E_COUNT, 0, true, true, [](auto& a) { a.key_offsets[0] = -1; });
  check(QTRAJ_E_COUNT, 1, false, true, [](auto& a) { a.sample_offsets[2] = 2; });
  check(QTRAJ_E_SIZE, SIZE_MAX, true, true, [](auto& a) { a.count = a.step_count = SIZE_MAX; });
  check(QTRAJ_E_SIZE, SIZE_MAX, true, true, [](auto& a) { a.key_offsets[2] = INT64_MAX; });
  check(QTRAJ_E_SIZE, SIZE_MAX, false, true, [](auto& a) { a.sample_offsets[2] = INT64_MAX; });
  check(QTRAJ_E_OVERLAP, SIZE_MAX, true, false, [](auto& a) { a.to_offsets = a.key_offsets; });
  check(QTRAJ_E_OVERLAP, SIZE_MAX, true, false, [](auto& a) { a.to_offsets = reinterpret_cast<int64_t*>(a.step); });
  check(QTRAJ_E_OVERLAP, SIZE_MAX, false, true, [](auto& a) { a.to_times = a.times; });
  check(QTRAJ_E_OVERLAP, SIZE_MAX, true, true, [](auto& a) { a.status_out = reinterpret_cast<int32_t*>(a.times + 3); });
  check(QTRAJ_OK, SIZE_MAX, true, true, [](auto& a) { a = {}, a.count = 0, a.step_count = 1; });
  // no series: offsets of an empty list, where there is room for them
  int64_t zero = 7;
  CHECK(qtraj_batch_step_offsets(0, nullptr, nullptr, nullptr, 0, &zero, nullptr, nullptr) == QTRAJ_OK);
  CHECK(zero == 0);
  CHECK(qtraj_batch_step_offsets(0, nullptr, nullptr, nullptr, 0, nullptr, nullptr, nullptr) == QTRAJ_OK);
  CHECK(qtraj_batch_times(0, nullptr, nullptr, nullptr, 0, nullptr, nullptr, nullptr, nullptr) == QTRAJ_OK);
}

TEST_CASE("C API: steps leave the floating-point environment and errno alone", "[capi][batches][times]") {
  const double extremes[] = {0, 5e-324, DBL_MIN, 1e-10, 1, 1e300, DBL_MAX, -DBL_MAX, kNaN, -kInfinity};
  double out[9];
  for (const double first : extremes)
    for (const double last : extremes)
      for (const double step : extremes) {
        const double times[] = {first, last};
        const int64_t offsets[] = {0, 2}, rows[] = {0, 9};
        int64_t found[2];
        CHECK(disturbance([&] {
                (void)qtraj_batch_step_offsets(1, offsets, times, &step, 1, found, nullptr, nullptr);
                (void)qtraj_batch_times(1, offsets, times, &step, 1, rows, out, nullptr, nullptr);
              }) == std::string("nothing"));
      }
}

}  // namespace
