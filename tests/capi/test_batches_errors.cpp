// Batches with arguments at fault: the order of statuses, hostile offsets, memory, overlap, untouched outputs.
#include <qtraj.h>

#include <algorithm>
#include <limits>
#include <string>

#include "support/capi_batches.hpp"
#include "support/capi_floating.hpp"
#include "support/catch.hpp"

using namespace capi;

namespace {

constexpr size_t kCount = 5;
constexpr int64_t kMost = INT64_MAX;
const Variant kHermite = {"HERMITE", QTRAJ_HERMITE};

// A good call with rates, its outputs full of sevens.
template <class Real>
struct Arguments {
  Table<Real> table = Table<Real>(kCount, kHermite);
  Options options = make_options(kHermite);
  Motion<Real> out = Motion<Real>(table.rows());
  std::vector<int32_t> statuses = std::vector<int32_t>(kCount, 7);
  std::vector<double> memory;
  BatchCall<Real> call;

  Arguments() {
    std::fill(out.q.begin(), out.q.end(), Real(7));
    std::fill(out.omega.begin(), out.omega.end(), Real(7));
    std::fill(out.alpha.begin(), out.alpha.end(), Real(7));
    size_t bytes = 0;
    REQUIRE(qtraj_init_size(options.get(), table.longest(), &bytes) == QTRAJ_OK);
    memory.assign(bytes / sizeof(double), 7.0);
    call = table.call(options.get(), out, true);
    call.memory = memory.data(), call.bytes = bytes;
    call.status_out = statuses.data();
  }
  bool untouched() const {
    const auto full = [](const auto& values) {
      return std::all_of(values.begin(), values.end(), [](auto value) { return value == 7; });
    };
    return full(out.q) && full(out.omega) && full(out.alpha) && full(statuses) && full(memory);
  }
};

template <class Real, class Change>
void check_refused(qtraj_status expected, size_t expected_index, const Change& change) {
  Arguments<Real> arguments;
  BatchCall<Real> call = arguments.call;
  change(call, arguments);
  size_t bad_index = 12345;
  CHECK(call(&bad_index) == expected);
  CHECK(bad_index == expected_index);
  CHECK(call(nullptr) == expected);
  CHECK(arguments.untouched());
}

TEST_CASE("C API: a batch judges its arguments in the order of the statuses and then leaves outputs alone",
          "[capi][batches][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const auto check = [](qtraj_status expected, auto&& change) {
      check_refused<Real>(expected, SIZE_MAX, [&](BatchCall<Real>& call, Arguments<Real>& a) { change(call, a); });
    };
    // NULL, whatever else is wrong
    check(QTRAJ_E_NULL, [](auto& call, auto&) { call.options = nullptr; });
    check(QTRAJ_E_NULL, [](auto& call, auto&) { call.options = nullptr, call.count = 0; });
    check(QTRAJ_E_NULL, [](auto& call, auto&) { call.key_offsets = nullptr, call.frame = 0; });
    check(QTRAJ_E_NULL, [](auto& call, auto&) { call.sample_offsets = nullptr, call.count = SIZE_MAX; });
    check(QTRAJ_E_NULL, [](auto& call, auto&) { call.key_times = nullptr; });
    check(QTRAJ_E_NULL, [](auto& call, auto&) { call.key_q = nullptr, call.bytes = 0; });
    check(QTRAJ_E_NULL, [](auto& call, auto&) { call.q_out = call.omega_out = call.alpha_out = nullptr; });
    check(QTRAJ_E_NULL, [](auto& call, auto&) { call.q_out = nullptr, call.with_rates = false; });
    // HANDLE
    static const double no_options[8] = {};
    check(QTRAJ_E_HANDLE, [](auto& call, auto&) {
      call.options = reinterpret_cast<const qtraj_options*>(no_options), call.count = SIZE_MAX;
    });
    // SIZE: offsets, rows, a trajectory
    for (const size_t count : {SIZE_MAX, SIZE_MAX / 8, static_cast<size_t>(PTRDIFF_MAX) / 8})
      check(QTRAJ_E_SIZE, [&](auto& call, auto&) { call.count = count, call.frame = 0; });
    static const int64_t far[] = {kMost / 16 + 1, kMost / 16 + 1}, most[] = {0, kMost / (4 * sizeof(Real))};
    check(QTRAJ_E_SIZE, [](auto& call, auto&) { call.key_offsets = far, call.count = 1; });
    check(QTRAJ_E_SIZE, [](auto& call, auto&) { call.sample_offsets = far, call.count = 1, call.frame = 0; });
    check(QTRAJ_E_SIZE, [](auto& call, auto&) { call.key_offsets = most, call.count = 1, call.frame = 0; });
    // VALUE
    for (const int32_t frame : kUnknown) check(QTRAJ_E_VALUE, [&](auto& call, auto&) { call.frame = frame; });
    check(QTRAJ_E_VALUE, [](auto& call, auto&) { call.frame = QTRAJ_SLERP, call.key_omega = nullptr; });
    // INPUT_MISSING, INPUT_UNWANTED
    check(QTRAJ_E_INPUT_MISSING, [](auto& call, auto&) { call.key_omega = nullptr, call.bytes = 0; });
    check(QTRAJ_E_INPUT_MISSING, [](auto& call, auto&) { call.with_rates = false, call.bytes = 0; });
    check(QTRAJ_E_INPUT_UNWANTED, [](auto& call, auto&) { call.key_alpha = call.key_omega, call.bytes = 0; });
    check(QTRAJ_E_INPUT_MISSING, [](auto& call, auto& a) {
      REQUIRE(qtraj_options_set_turns(a.options.get(), QTRAJ_TURNS_GIVEN) == QTRAJ_OK);
      call.bytes = 0;
    });
    static const Options squad = [] {
      Options options = make_options({"", QTRAJ_SQUAD});
      REQUIRE(qtraj_options_set_ends(options.get(), QTRAJ_END_GIVEN, QTRAJ_END_GIVEN) == QTRAJ_OK);
      return options;
    }();
    check(QTRAJ_E_INPUT_MISSING,
          [](auto& call, auto&) { call.options = squad.get(), call.key_omega = nullptr, call.bytes = 0; });
    // BUFFER
    check(QTRAJ_E_BUFFER, [](auto& call, auto&) { call.bytes -= 1; });
    check(QTRAJ_E_BUFFER, [](auto& call, auto&) { call.bytes = 0, call.q_out = const_cast<Real*>(call.key_q); });
    check(QTRAJ_E_BUFFER, [](auto& call, auto&) {
      call.memory = static_cast<char*>(call.memory) + 4, call.q_out = const_cast<Real*>(call.key_q);
    });
  });
}

TEST_CASE("C API: offsets of a batch that are negative or decrease are COUNT, with the index of their series",
          "[capi][batches][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    struct Hostile {
      std::vector<int64_t> offsets;
      size_t index;
    };
    const Hostile all[] = {{{-1, 4, 9, 12, 20, 30}, 0},          {{INT64_MIN, 4, 9, 12, 20, 30}, 0},
                           {{0, -4, 9, 12, 20, 30}, 0},          {{0, 9, 4, 12, 20, 30}, 1},
                           {{0, 4, 9, INT64_MIN, 20, 30}, 2},    {{0, 4, 9, 12, 30, 20}, 4},
                           {{0, 4, 9, 12, 20, -1}, 4},           {{0, 4, 9, 12, 20, 0}, 4},
                           {{0, kMost, 9, 12, 20, 30}, 1},       {{kMost, 4, 9, 12, 20, 30}, 0},
                           {{0, 4, kMost, INT64_MIN, 20, 30}, 2}};
    for (const Hostile& hostile : all) {
      const auto change_keys = [&](auto& call, auto&) { call.key_offsets = hostile.offsets.data(), call.frame = 0; };
      const auto change_samples = [&](auto& call, auto&) {
        call.sample_offsets = hostile.offsets.data(), call.frame = 0;
      };
      check_refused<Real>(QTRAJ_E_COUNT, hostile.index, change_keys);
      check_refused<Real>(QTRAJ_E_COUNT, hostile.index, change_samples);
    }
    // of both the lower index
    const int64_t first[] = {0, -1, 9, 12, 20, 30}, later[] = {0, 4, 9, 8, 20, 30};
    check_refused<Real>(QTRAJ_E_COUNT, 0,
                        [&](auto& call, auto&) { call.key_offsets = later, call.sample_offsets = first; });
    check_refused<Real>(QTRAJ_E_COUNT, 0,
                        [&](auto& call, auto&) { call.key_offsets = first, call.sample_offsets = later; });
  });
}

TEST_CASE("C API: outputs and memory of a batch may be no other array", "[capi][batches][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const auto check = [](auto&& change) {
      check_refused<Real>(QTRAJ_E_OVERLAP, SIZE_MAX,
                          [&](BatchCall<Real>& call, Arguments<Real>& a) { change(call, a); });
    };
    const auto real = [](const void* at) { return static_cast<Real*>(const_cast<void*>(at)); };
    // each output and the memory onto each other array
    const auto onto_all = [&](auto&& place) {
      check([&](auto& call, auto&) { place(call, call.options); });
      check([&](auto& call, auto&) { place(call, call.key_offsets + kCount); });
      check([&](auto& call, auto&) { place(call, call.sample_offsets); });
      check([&](auto& call, auto&) { place(call, call.key_times); });
      check([&](auto& call, auto&) { place(call, call.key_q); });
      check([&](auto& call, auto&) { place(call, call.key_omega); });
      check([&](auto& call, auto&) { place(call, call.sample_times); });
    };
    onto_all([&](auto& call, const void* at) { call.q_out = real(at); });
    onto_all([&](auto& call, const void* at) { call.omega_out = real(at); });
    onto_all([&](auto& call, const void* at) { call.alpha_out = real(at); });
    onto_all([&](auto& call, const void* at) { call.status_out = static_cast<int32_t*>(const_cast<void*>(at)); });
    onto_all([&](auto& call, const void* at) { call.memory = const_cast<void*>(at); });
    check([&](auto& call, auto& a) { call.q_out = real(&a.memory.back()); });
    check([&](auto& call, auto&) { call.omega_out = call.q_out; });
    check([&](auto& call, auto&) { call.alpha_out = call.omega_out; });
    check([&](auto& call, auto&) { call.status_out = reinterpret_cast<int32_t*>(call.alpha_out); });
  });
}

TEST_CASE("C API: a batch of no series is OK with NULL arrays", "[capi][batches]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Options options = make_options(kHermite);
    BatchCall<Real> call;
    call.options = options.get();
    for (const bool with_rates : {false, true}) {
      call.with_rates = with_rates;
      size_t bad_index = 12345;
      CHECK(call(&bad_index) == QTRAJ_OK);
      CHECK(bad_index == SIZE_MAX);
    }
    call.frame = 1;
    CHECK(call(nullptr) == QTRAJ_E_VALUE);
  });
}

TEST_CASE("C API: a batch leaves the floating-point environment and errno alone", "[capi][batches][errors]") {
  const std::string nothing = "nothing";
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    Arguments<Real> arguments;
    for (const bool evenly : {false, true}) {
      BatchCall<Real> call = arguments.call;
      if (evenly) call.sample_times = nullptr, call.memory = nullptr;
      CHECK(disturbance([&] { call(nullptr); }) == nothing);
      // faults of every kind
      Table<Real>& table = arguments.table;
      set_signalling_nan(table.key_q[5]);
      set_signalling_nan(table.key_times[static_cast<size_t>(table.key_offsets[2])]);
      set_signalling_nan(table.omega[3 * static_cast<size_t>(table.key_offsets[3])]);
      set_signalling_nan(table.sample_times[static_cast<size_t>(table.sample_offsets[1])]);
      CHECK(disturbance([&] { call(nullptr); }) == nothing);
    }
  });
}

}  // namespace
