// Diagnostics of samples and faulty arguments: what is judged before any sample is read.
#include <functional>

#include "support/capi_samples.hpp"

using namespace capi;

namespace {

constexpr size_t kMost = PTRDIFF_MAX;

// The status for a change to good arguments, no output being written.
void check_argument_error(SampleFunction function, qtraj_status expected,
                          const std::function<void(SampleArguments&)>& change) {
  CAPTURE(function);
  SampleArguments arguments;
  change(arguments);
  CHECK(call(function, arguments) == expected);
  CHECK(arguments.bad_index == SIZE_MAX);
  CHECK(arguments.outputs_untouched());
}

TEST_CASE("C API: diagnostics of good samples are OK and have no bad_index", "[capi][sample_diagnostics]") {
  for (int function = 0; function < kFunctions; ++function)
    for (const bool without_optional : {false, true}) {
      SampleArguments arguments;
      if (without_optional) {
        arguments.t_mid_out = nullptr;
        arguments.index_out = nullptr;
      }
      CHECK(call(static_cast<SampleFunction>(function), arguments) == QTRAJ_OK);
      CHECK(arguments.bad_index == SIZE_MAX);
      CHECK(!arguments.outputs_untouched());
    }
  SampleArguments a;
  CHECK(qtraj_estimate_omega(QTRAJ_FRAME_BODY, a.times, a.q, 8, a.t_mid_out, a.omega_out, nullptr) == QTRAJ_OK);
  CHECK(qtraj_estimate_energy(QTRAJ_FRAME_BODY, a.times, a.q, 8, a.energy, nullptr) == QTRAJ_OK);
  CHECK(qtraj_estimate_jumps(QTRAJ_FRAME_BODY, a.times, a.q, 8, a.knot_times, 6, a.jump_out, nullptr) == QTRAJ_OK);
  CHECK(qtraj_keyframe_errors(a.times, a.q, 8, a.times, a.q, 8, a.error_out, a.index_out, nullptr) == QTRAJ_OK);
  for (size_t k = 0; k < 8; ++k) CHECK((a.errors[k] == 0 && a.indices[k] == k));
}

TEST_CASE("C API: diagnostics without an array they need are NULL", "[capi][sample_diagnostics][errors]") {
  for (int k = 0; k < kFunctions; ++k) {
    const auto function = static_cast<SampleFunction>(k);
    check_argument_error(function, QTRAJ_E_NULL, [](SampleArguments& a) { a.times = nullptr; });
    check_argument_error(function, QTRAJ_E_NULL, [](SampleArguments& a) { a.q = nullptr; });
    check_argument_error(function, QTRAJ_E_NULL, [](SampleArguments& a) {
      a.omega_out = a.energy = a.jump_out = a.error_out = nullptr;
      a.count = SIZE_MAX;  // before SIZE
    });
  }
  check_argument_error(kJumps, QTRAJ_E_NULL, [](SampleArguments& a) { a.knot_times = nullptr; });
  check_argument_error(kErrors, QTRAJ_E_NULL, [](SampleArguments& a) { a.key_times = nullptr; });
  check_argument_error(kErrors, QTRAJ_E_NULL, [](SampleArguments& a) { a.key_q = nullptr; });
  check_argument_error(kEnergy, QTRAJ_E_NULL, [](SampleArguments& a) {
    a.energy = nullptr;
    a.count = 0;
  });
}

TEST_CASE("C API: diagnostics of too few samples are COUNT, of none with NULL arrays too",
          "[capi][sample_diagnostics][errors]") {
  const size_t least[kFunctions] = {2, 3, 2, 1};
  for (int k = 0; k < kFunctions; ++k)
    for (size_t count = 0; count < least[k]; ++count)
      check_argument_error(static_cast<SampleFunction>(k), QTRAJ_E_TOO_FEW, [&](SampleArguments& a) {
        a.count = count;
        a.frame = 0;  // TOO_FEW before VALUE
        if (count == 0) a.times = a.q = nullptr;
      });
  for (int k = 0; k < kFunctions; ++k) {
    SampleArguments arguments;
    arguments.count = least[k];
    arguments.knot_count = 0;
    CHECK(call(static_cast<SampleFunction>(k), arguments) == QTRAJ_OK);
  }
}

TEST_CASE("C API: no knots and no keys are OK with NULL arrays", "[capi][sample_diagnostics]") {
  SampleArguments a;
  CHECK(qtraj_estimate_jumps(QTRAJ_FRAME_BODY, a.times, a.q, 8, nullptr, 0, nullptr, &a.bad_index) == QTRAJ_OK);
  CHECK(qtraj_keyframe_errors(nullptr, nullptr, 0, a.times, a.q, 8, nullptr, nullptr, &a.bad_index) == QTRAJ_OK);
  CHECK(qtraj_keyframe_errors(nullptr, nullptr, 0, nullptr, nullptr, 0, nullptr, nullptr, &a.bad_index) == QTRAJ_OK);
  CHECK(a.bad_index == SIZE_MAX);
}

TEST_CASE("C API: diagnostics of more than memory holds are SIZE", "[capi][sample_diagnostics][errors]") {
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 4 + 2, SIZE_MAX / 8 + 2, SIZE_MAX / 32 + 2, kMost / 32 + 1}) {
    for (int k = 0; k < kFunctions; ++k)
      check_argument_error(static_cast<SampleFunction>(k), QTRAJ_E_SIZE, [&](SampleArguments& a) {
        a.count = count;
        a.frame = 0;  // SIZE before VALUE
      });
    check_argument_error(kErrors, QTRAJ_E_SIZE, [&](SampleArguments& a) { a.key_count = count; });
  }
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 8 + 2, SIZE_MAX / 24 + 2, kMost / 24 + 1})
    check_argument_error(kJumps, QTRAJ_E_SIZE, [&](SampleArguments& a) { a.knot_count = count; });
}

TEST_CASE("C API: diagnostics in an unknown frame are OPTION", "[capi][sample_diagnostics][errors]") {
  for (const SampleFunction function : {kOmega, kEnergy, kJumps})
    for (const int32_t frame : {0, 3, -1, 1000, INT32_MAX, INT32_MIN})
      check_argument_error(function, QTRAJ_E_VALUE, [&](SampleArguments& a) {
        a.frame = frame;
        a.omega_out = a.jump_out = a.energy = a.samples_q.data();  // OPTION before OVERLAP
      });
}

TEST_CASE("C API: diagnostics written over what they read are OVERLAP, and errors may replace the keys' times",
          "[capi][sample_diagnostics][errors]") {
  for (const SampleFunction function : {kOmega, kEnergy, kJumps, kErrors})
    for (const bool over_times : {false, true}) {
      const SampleArguments good;
      SampleArguments a;
      double* over = over_times ? a.samples_times.data() : a.samples_q.data() + 4;
      a.omega_out = a.energy = a.jump_out = a.error_out = over;
      // keys of their own, so that it is the samples that are overwritten
      a.key_times = good.times;
      a.key_q = good.q;
      CHECK(call(function, a) == QTRAJ_E_OVERLAP);
      CHECK(a.bad_index == SIZE_MAX);
      CHECK(a.samples_q == good.samples_q);
      CHECK(a.samples_times == good.samples_times);
    }
  check_argument_error(kOmega, QTRAJ_E_OVERLAP, [](SampleArguments& a) { a.t_mid_out = a.omega_out + 20; });
  check_argument_error(kOmega, QTRAJ_E_OVERLAP, [](SampleArguments& a) { a.t_mid_out = a.samples_times.data(); });
  check_argument_error(kJumps, QTRAJ_E_OVERLAP, [](SampleArguments& a) { a.jump_out = a.knots.data(); });
  const auto as_indices = [](double* numbers) { return reinterpret_cast<size_t*>(numbers); };
  check_argument_error(kErrors, QTRAJ_E_OVERLAP, [&](SampleArguments& a) { a.index_out = as_indices(a.error_out); });
  check_argument_error(kErrors, QTRAJ_E_OVERLAP,
                       [&](SampleArguments& a) { a.index_out = as_indices(a.samples_times.data()); });
  check_argument_error(kErrors, QTRAJ_E_OVERLAP,
                       [&](SampleArguments& a) { a.index_out = as_indices(a.samples_q.data()); });

  // numbers of another type, though as many and as long
  std::vector<double> own_times = {0, 1, 2, 3, 4, 5, 6, 7};
  check_argument_error(kErrors, QTRAJ_E_OVERLAP, [&](SampleArguments& a) {
    a.key_times = own_times.data();
    a.index_out = as_indices(own_times.data());
  });

  SampleArguments apart, in_place;
  std::vector<double> key_times = {3.6, 0.2, 100, -5, 4.4, 2, 2, 6.6};
  apart.key_times = in_place.key_times = key_times.data();
  CHECK(call(kErrors, apart) == QTRAJ_OK);
  in_place.error_out = key_times.data();
  CHECK(call(kErrors, in_place) == QTRAJ_OK);
  CHECK(key_times == apart.errors);
}

}  // namespace
