// Many curves in one call: the same as one after the other, whatever the settings, the memory and the place in a table.
#include <qtraj.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/capi_batches.hpp"
#include "support/catch.hpp"
#include "support/guarded.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Calls body(real zero, variant, with_rates) for every setting of every method that the call takes, which has no
// tangents.
template <class Body>
void for_every_batch(const Body& body) {
  for_double_and_float([&](auto zero) {
    for (const Variant& variant : variants())
      for (const bool with_rates : {false, true}) {
        if ((variant.needs_rates() && !with_rates) || variant.needs_tangents()) continue;
        CAPTURE(variant.name, sizeof zero, with_rates);
        body(zero, variant, with_rates);
      }
  });
}

template <class Real>
void check_as_expected(const BatchCall<Real>& call, const Motion<Real>& out) {
  const Expected<Real> expected(call);
  std::vector<int32_t> statuses(call.count, -77);
  BatchCall<Real> with_statuses = call;
  with_statuses.status_out = statuses.data();
  size_t bad_index = 12345, first = 0;
  const qtraj_status status = with_statuses(&bad_index);
  CHECK(status == expected.first(first));
  CHECK(bad_index == first);
  CHECK(statuses == expected.statuses);
  CHECK(same_rows(out, expected.out, call.with_rates));
}

TEST_CASE("C API: a batch has the bits of one curve after the other", "[capi][batches]") {
  for_every_batch([](auto zero, const Variant& variant, bool with_rates) {
    using Real = decltype(zero);
    const Table<Real> table(30, variant);
    const Options options = make_options(variant);
    for (const bool evenly : {false, true}) {
      Motion<Real> out(table.rows());
      BatchCall<Real> call = table.call(options.get(), out, with_rates);
      if (evenly) call.sample_times = nullptr;
      check_as_expected(call, out);
      // in memory of the caller, as little as will do, and some more
      size_t bytes = 0;
      REQUIRE(qtraj_init_size(options.get(), table.longest(), &bytes) == QTRAJ_OK);
      for (const size_t more : {0, 40, 100000}) {
        Motion<Real> again(table.rows());
        test::Guarded<double> memory((bytes + more) / sizeof(double) + 1);
        call = table.call(options.get(), again, with_rates);
        if (evenly) call.sample_times = nullptr;
        call.bytes = bytes + more;
        memory.fill(0x5a);
        call.memory = memory.array(call.bytes / sizeof(double), false);
        CHECK(call(nullptr) == QTRAJ_OK);
        CHECK(same_rows(out, again, with_rates));
        CHECK(memory.holds_around(static_cast<double*>(call.memory), std::min(call.bytes, bytes + 4096) / 8, 0x5a));
      }
    }
  });
}

TEST_CASE("C API: a slice of a table is a call of its own, and nothing outside of it is touched", "[capi][batches]") {
  for_every_batch([](auto zero, const Variant& variant, bool with_rates) {
    using Real = decltype(zero);
    const Table<Real> table(20, variant);
    const Options options = make_options(variant);
    Motion<Real> all(table.rows());
    REQUIRE(table.call(options.get(), all, with_rates)(nullptr) == QTRAJ_OK);
    // arrays of the slice alone, against pages that may not be touched
    const size_t from = 7, count = 9;
    const auto key = static_cast<size_t>(table.key_offsets[from]),
               row = static_cast<size_t>(table.sample_offsets[from]);
    const auto keys = static_cast<size_t>(table.key_offsets[from + count]) - key,
               rows = static_cast<size_t>(table.sample_offsets[from + count]) - row;
    for (const bool at_end : {false, true}) {
      test::Guarded<double> times_room(keys), samples_room(rows);
      test::Guarded<Real> q_room(4 * keys), omega_room(3 * keys), alpha_room(3 * keys);
      test::Guarded<Real> q_out_room(4 * rows), omega_out_room(3 * rows), alpha_out_room(3 * rows);
      const auto place = [&](auto& room, const auto& source, size_t first, size_t size) {
        auto* const to = room.array(size, at_end);
        if (source.size() >= first + size) std::copy_n(source.begin() + static_cast<ptrdiff_t>(first), size, to);
        return to - first;
      };
      Motion<Real> unused(0);
      BatchCall<Real> call = table.call(options.get(), unused, with_rates);
      call.key_offsets += from, call.sample_offsets += from, call.count = count;
      call.key_times = place(times_room, table.key_times, key, keys);
      call.key_q = place(q_room, table.key_q, 4 * key, 4 * keys);
      if (call.key_omega) call.key_omega = place(omega_room, table.omega, 3 * key, 3 * keys);
      if (call.key_alpha) call.key_alpha = place(alpha_room, table.alpha, 3 * key, 3 * keys);
      call.sample_times = place(samples_room, table.sample_times, row, rows);
      call.q_out = q_out_room.array(4 * rows, at_end) - 4 * row;
      if (with_rates) {
        call.omega_out = omega_out_room.array(3 * rows, at_end) - 3 * row;
        call.alpha_out = alpha_out_room.array(3 * rows, at_end) - 3 * row;
      }
      size_t bad_index = 12345;
      CHECK(call(&bad_index) == QTRAJ_OK);
      CHECK(bad_index == SIZE_MAX);
      const auto same = [&](const Real* a, const std::vector<Real>& b, size_t width) {
        return std::memcmp(a + width * row, b.data() + width * row, width * rows * sizeof(Real)) == 0;
      };
      CHECK(same(call.q_out, all.q, 4));
      if (with_rates) CHECK((same(call.omega_out, all.omega, 3) && same(call.alpha_out, all.alpha, 3)));
    }
  });
}

TEST_CASE("C API: a batch writes only the outputs that are asked for", "[capi][batches]") {
  const Variant hermite = {"HERMITE", QTRAJ_HERMITE};
  const Table<double> table(10, hermite);
  const Options options = make_options(hermite);
  Motion<double> all(table.rows());
  REQUIRE(table.call(options.get(), all, true)(nullptr) == QTRAJ_OK);
  for (int which = 1; which < 8; ++which) {
    Motion<double> some(table.rows());
    BatchCall<double> call = table.call(options.get(), some, true);
    if (!(which & 1)) call.q_out = nullptr;
    if (!(which & 2)) call.omega_out = nullptr;
    if (!(which & 4)) call.alpha_out = nullptr;
    CHECK(call(nullptr) == QTRAJ_OK);
    CHECK(((which & 1) == 0 || same_bits(some.q, all.q)));
    CHECK(((which & 2) == 0 || same_bits(some.omega, all.omega)));
    CHECK(((which & 4) == 0 || same_bits(some.alpha, all.alpha)));
  }
}

TEST_CASE("C API: settings of a batch are those of its curves", "[capi][batches]") {
  const Table<double> table(12);
  Motion<double> out(table.rows());
  // a loop that is closed by a period, longer than any tour: evenly means to its closing key
  Options loop = make_options({"", QTRAJ_ROTATION_SPLINE, QTRAJ_END_PERIODIC});
  REQUIRE(qtraj_options_set_period(loop.get(), 100) == QTRAJ_OK);
  REQUIRE(qtraj_options_set_extrapolation(loop.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
          QTRAJ_OK);
  BatchCall<double> call = table.call(loop.get(), out, true);
  check_as_expected(call, out);
  call.sample_times = nullptr;
  check_as_expected(call, out);
  // gaps: only samples inside them are at fault
  Options gaps = make_options({"", QTRAJ_SQUAD});
  REQUIRE(qtraj_options_set_longest_gap(gaps.get(), 1.0) == QTRAJ_OK);
  call = table.call(gaps.get(), out, true);
  check_as_expected(call, out);
  CHECK(call(nullptr) == QTRAJ_E_GAP);
  call.sample_times = nullptr;
  check_as_expected(call, out);
}

TEST_CASE("C API: every series of a batch has its own status, and is no harm to the others", "[capi][batches]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    struct Fault {
      qtraj_status status;
      void (*spoil)(double* times, Real* q, size_t keys, double* samples);
    };
    const Fault faults[] = {
        {QTRAJ_E_NOT_FINITE, [](double*, Real* q, size_t, double*) { q[5] = std::numeric_limits<Real>::infinity(); }},
        {QTRAJ_E_NOT_FINITE, [](double* times, Real*, size_t, double*) { times[1] = kNaN; }},
        {QTRAJ_E_ZERO_NORM, [](double*, Real* q, size_t, double*) { std::fill_n(q + 4, 4, Real(0)); }},
        {QTRAJ_E_TIME_ORDER, [](double* times, Real*, size_t, double*) { times[2] = times[1]; }},
        {QTRAJ_E_TIME_SPAN,
         [](double* times, Real*, size_t keys, double*) { times[0] = -1.7e308, times[keys - 1] = 1e308; }},
        {QTRAJ_E_AMBIGUOUS,
         [](double*, Real* q, size_t, double*) {
           for (size_t k = 0; k < 4; ++k) q[4 + k] = -q[k];
         }},
        {QTRAJ_E_TIME_RANGE, [](double*, Real*, size_t, double* samples) { samples[3] = 1e9; }},
        {QTRAJ_E_NOT_FINITE, [](double*, Real*, size_t, double* samples) { samples[2] = kNaN; }},
    };
    // SLERP by the signs of the keys knows AMBIGUOUS
    const Options options = make_options({"", QTRAJ_SLERP});
    REQUIRE(qtraj_options_set_turns(options.get(), QTRAJ_TURNS_AS_GIVEN) == QTRAJ_OK);
    for (const Fault& fault : faults)
      for (const size_t at : {size_t{2}, size_t{9}, size_t{13}}) {
        Table<Real> table(14);
        Motion<Real> good(table.rows()), out(table.rows());
        REQUIRE(table.call(options.get(), good, true)(nullptr) == QTRAJ_OK);
        const auto key = static_cast<size_t>(table.key_offsets[at]),
                   row = static_cast<size_t>(table.sample_offsets[at]);
        REQUIRE(table.samples_of(at) > 4);
        fault.spoil(&table.key_times[key], &table.key_q[4 * key], table.keys_of(at), &table.sample_times[row]);
        const BatchCall<Real> call = table.call(options.get(), out, true);
        CAPTURE(fault.status, at);
        size_t bad_index = 12345;
        CHECK(call(&bad_index) == fault.status);
        CHECK(bad_index == at);
        check_as_expected(call, out);
        for (size_t i = 0; i < table.rows(); ++i) {
          if (i >= row && i < row + table.samples_of(at)) continue;
          CHECK(std::memcmp(&out.q[4 * i], &good.q[4 * i], 4 * sizeof(Real)) == 0);
        }
      }
  });
}

TEST_CASE("C API: a series of fewer than 2 keys is TOO_FEW in a batch, empty ones among them", "[capi][batches]") {
  const Table<double> table(6);
  const Options options = make_options({"", QTRAJ_SQUAD});
  // series 1 has one key, series 2 none; the third begins where they end
  std::vector<int64_t> offsets = table.key_offsets;
  offsets[2] = offsets[3] = offsets[1] + 1;
  Motion<double> out(table.rows());
  BatchCall<double> call = table.call(options.get(), out, false);
  call.key_offsets = offsets.data();
  std::vector<int32_t> statuses(6, -77);
  call.status_out = statuses.data();
  size_t bad_index = 12345;
  CHECK(call(&bad_index) == QTRAJ_E_TOO_FEW);
  CHECK(bad_index == 1);
  CHECK(statuses[0] == QTRAJ_OK);
  CHECK((statuses[1] == QTRAJ_E_TOO_FEW && statuses[2] == QTRAJ_E_TOO_FEW));
  for (size_t row = 0; row < table.rows(); ++row) {
    const auto at = static_cast<int64_t>(row);
    const bool is_missing = at >= table.sample_offsets[1] && at < table.sample_offsets[3];
    if (is_missing) CHECK((std::isnan(out.q[4 * row]) && std::isnan(out.q[4 * row + 3])));
  }
  // all of them: no memory is asked for, no rates, no arrays of keys
  const int64_t none[] = {5, 5, 5, 5};
  const Options hermite = make_options({"", QTRAJ_HERMITE});
  call = {};
  call.options = hermite.get(), call.count = 3, call.with_rates = true;
  call.key_offsets = none, call.sample_offsets = none;
  CHECK(call(&bad_index) == QTRAJ_E_TOO_FEW);
  CHECK(bad_index == 0);
  call.sample_offsets = table.sample_offsets.data(), call.q_out = out.q.data();
  CHECK(call(&bad_index) == QTRAJ_E_TOO_FEW);
  CHECK(std::isnan(out.q[0]));
}

TEST_CASE("C API: one fault among 1e5 series leaves the others bit for bit", "[capi][batches]") {
  constexpr size_t kCount = 100000, kAt = 77777;
  Table<double> table(kCount, {"", QTRAJ_SLERP}, 3);
  const Options options = make_options({"", QTRAJ_SLERP});
  Motion<double> good(table.rows()), out(table.rows());
  REQUIRE(table.call(options.get(), good, false)(nullptr) == QTRAJ_OK);
  table.key_q[4 * static_cast<size_t>(table.key_offsets[kAt]) + 2] = kNaN;
  std::vector<int32_t> statuses(kCount, -77);
  BatchCall<double> call = table.call(options.get(), out, false);
  call.status_out = statuses.data();
  size_t bad_index = 12345;
  CHECK(call(&bad_index) == QTRAJ_E_NOT_FINITE);
  CHECK(bad_index == kAt);
  CHECK(statuses[kAt] == QTRAJ_E_NOT_FINITE);
  CHECK(std::count(statuses.begin(), statuses.end(), QTRAJ_OK) == static_cast<ptrdiff_t>(kCount - 1));
  const auto row = static_cast<size_t>(table.sample_offsets[kAt]), end = row + table.samples_of(kAt);
  REQUIRE(row < end);
  CHECK(std::all_of(out.q.begin() + static_cast<ptrdiff_t>(4 * row), out.q.begin() + static_cast<ptrdiff_t>(4 * end),
                    [](double x) { return std::isnan(x); }));
  CHECK(std::memcmp(out.q.data(), good.q.data(), 4 * row * sizeof(double)) == 0);
  CHECK(std::memcmp(&out.q[4 * end], &good.q[4 * end], (out.q.size() - 4 * end) * sizeof(double)) == 0);
}

TEST_CASE("C API: even times of a batch are those of even_times between the first and the last key",
          "[capi][batches]") {
  const Table<double> table(9);
  const Options options = make_options({"", QTRAJ_ROTATION_SPLINE});
  for (const size_t samples : {1, 2, 5, 511, 512, 513, 1500}) {
    std::vector<int64_t> offsets;
    for (size_t k = 0; k <= 9; ++k) offsets.push_back(static_cast<int64_t>(k * samples));
    Motion<double> out(9 * samples);
    BatchCall<double> call = table.call(options.get(), out, false);
    call.sample_offsets = offsets.data(), call.sample_times = nullptr;
    check_as_expected(call, out);
  }
}

}  // namespace
