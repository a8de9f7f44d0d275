// Mistakes of a call that types do not catch: a constant in the place of another, a handle in the place of another.
#include <qtraj.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/vector_handles.hpp"

using namespace capi;

namespace {

// A constant of each family that is passed.
constexpr int32_t kOfEachFamily[] = {
    QTRAJ_SLERP,           QTRAJ_FRAME_WORLD,       QTRAJ_END_NATURAL,   QTRAJ_TANGENT_GIVEN,
    QTRAJ_REFERENCE_MEAN,  QTRAJ_EXTRAPOLATE_HOLD,  QTRAJ_PATH_AS_GIVEN, QTRAJ_CLASS_DONE,
    QTRAJ_SQUAD,           QTRAJ_FRAME_BODY,        QTRAJ_END_PERIODIC,  QTRAJ_TANGENT_CATMULL_ROM,
    QTRAJ_REFERENCE_FIRST, QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_PATH_SHORTEST, QTRAJ_STEP,
    QTRAJ_VECTOR_LINEAR,   QTRAJ_VECTOR_CUBIC};

bool is_method(int32_t value) { return value < 100; }
bool is_vector_method(int32_t value) { return value > 1000; }
bool is_of_family(int32_t value, int32_t member) { return !is_method(value) && value / 100 == member / 100; }

const double kTimes[2] = {0, 1}, kKeys[8] = {1, 0, 0, 0, 0.8, 0.6, 0, 0};

qtraj_trajectory* make_curve() {
  qtraj_trajectory* curve = nullptr;
  REQUIRE(qtraj_create(QTRAJ_SLERP, kTimes, kKeys, 2, &curve, nullptr) == QTRAJ_OK);
  return curve;
}

qtraj_options* make_settings(int32_t method) {
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(method, &options) == QTRAJ_OK);
  return options;
}

qtraj_vector_curve* make_positions() {
  const Options options(make_settings(QTRAJ_VECTOR_LINEAR));
  qtraj_vector_curve* curve = nullptr;
  REQUIRE(qtraj_vector_create(options.get(), kTimes, kKeys, nullptr, nullptr, 2, 3, &curve, nullptr) == QTRAJ_OK);
  return curve;
}

TEST_CASE("C API: a constant in the place of another is VALUE, in every function that takes one", "[capi][misuse]") {
  const Trajectory curve(make_curve());
  const VectorCurve positions(make_positions());
  const Options squad(make_settings(QTRAJ_SQUAD)), log(make_settings(QTRAJ_LOG_SPLINE)),
      cubic(make_settings(QTRAJ_VECTOR_CUBIC));
  double q[8], omega[6], value;
  const double fraction = 0.5, zero[3] = {0, 0, 0};
  for (const int32_t constant : kOfEachFamily) {
    CAPTURE(constant);
    qtraj_trajectory* none;
    if (!is_method(constant)) CHECK(qtraj_create(constant, kTimes, kKeys, 2, &none, nullptr) == QTRAJ_E_VALUE);
    qtraj_options* no_options;
    if (!is_method(constant) && !is_vector_method(constant))
      CHECK(qtraj_options_create(constant, &no_options) == QTRAJ_E_VALUE);
    if (!is_of_family(constant, QTRAJ_FRAME_BODY)) {
      CHECK(qtraj_sample_rates(curve.get(), constant, kTimes, 2, q, omega, nullptr, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_sample_rates_at(curve.get(), constant, 0.5, nullptr, q, omega, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_curve_jumps(curve.get(), constant, omega, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_sample_poses(curve.get(), positions.get(), constant, kTimes, 2, q, nullptr, nullptr, omega, nullptr,
                               nullptr, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_sample_pose_at(curve.get(), positions.get(), constant, 0.5, nullptr, q, nullptr, nullptr, omega,
                                 nullptr, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_estimate_omega(constant, kTimes, kKeys, 2, nullptr, omega, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_derivatives_from_rates(constant, kKeys, omega, nullptr, 1, q, nullptr, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_options_set_end_rates(squad.get(), constant, zero, zero) == QTRAJ_E_VALUE);
    }
    if (!is_of_family(constant, QTRAJ_END_CHORD)) {
      CHECK(qtraj_options_set_ends(squad.get(), constant, constant) == QTRAJ_E_VALUE);
      CHECK(qtraj_options_set_ends(cubic.get(), constant, constant) == QTRAJ_E_VALUE);
      CHECK(qtraj_cubic_spline(kTimes, kTimes, 2, 1, constant, constant, &fraction, 1, &value, nullptr) ==
            QTRAJ_E_VALUE);
    }
    if (!is_of_family(constant, QTRAJ_TANGENT_GIVEN))
      CHECK(qtraj_options_set_tangents(squad.get(), constant) == QTRAJ_E_VALUE);
    if (!is_of_family(constant, QTRAJ_REFERENCE_FIRST))
      CHECK(qtraj_options_set_reference(log.get(), constant, nullptr) == QTRAJ_E_VALUE);
    if (!is_of_family(constant, QTRAJ_EXTRAPOLATE_HOLD)) {
      CHECK(qtraj_options_set_extrapolation(squad.get(), constant, constant) == QTRAJ_E_VALUE);
      CHECK(qtraj_options_set_extrapolation(cubic.get(), constant, constant) == QTRAJ_E_VALUE);
    }
    if (!is_of_family(constant, QTRAJ_PATH_SHORTEST)) {
      CHECK(qtraj_slerp(kKeys, kKeys + 4, &fraction, 1, constant, q, nullptr) == QTRAJ_E_VALUE);
      CHECK(qtraj_slerp_between(kKeys, 0, kKeys + 4, 1, &fraction, 1, constant, q, nullptr) == QTRAJ_E_VALUE);
    }
  }
}

// Calls every function that takes a trajectory and gives a status; each must give `expected`.
void check_trajectory_calls(const qtraj_trajectory* handle, qtraj_status expected) {
  double times[8] = {0.5}, q[32], omega[24], alpha[24];
  float qf[8], omegaf[6];
  size_t bad = 7, cursor = 7;
  CHECK(qtraj_sample(handle, times, 1, q, &bad) == expected);
  CHECK(bad == SIZE_MAX);
  CHECK(qtraj_sample_f32(handle, times, 1, qf, nullptr) == expected);
  CHECK(qtraj_sample_rates(handle, QTRAJ_FRAME_BODY, times, 1, q, omega, alpha, nullptr) == expected);
  CHECK(qtraj_sample_rates_f32(handle, QTRAJ_FRAME_BODY, times, 1, qf, omegaf, nullptr, nullptr) == expected);
  CHECK(qtraj_sample_uniform(handle, 0, 0.5, 2, q, nullptr) == expected);
  CHECK(qtraj_sample_uniform_f32(handle, 0, 0.5, 2, qf, nullptr) == expected);
  CHECK(qtraj_sample_at(handle, 0.5, &cursor, q) == expected);
  CHECK(qtraj_sample_at_f32(handle, 0.5, &cursor, qf) == expected);
  CHECK(qtraj_sample_rates_at(handle, QTRAJ_FRAME_WORLD, 0.5, &cursor, q, omega, alpha) == expected);
  CHECK(qtraj_sample_rates_at_f32(handle, QTRAJ_FRAME_WORLD, 0.5, &cursor, qf, omegaf, nullptr) == expected);
  CHECK(cursor == 7);
  CHECK(qtraj_keys(handle, times, q) == expected);
  CHECK(qtraj_curve_least_norm(handle, q, times) == expected);
  CHECK(qtraj_curve_jumps(handle, QTRAJ_FRAME_BODY, omega, alpha) == expected);
  CHECK(qtraj_curve_peak_rates(handle, q, q + 1, q + 2, q + 3) == expected);
  CHECK(qtraj_curve_energy(handle, q) == expected);
  CHECK(qtraj_curve_total_angle(handle, q) == expected);
  CHECK(qtraj_rate_bounds(handle, q, q + 1) == expected);
  CHECK(qtraj_rate_mismatch(handle, q, nullptr) == expected);
  CHECK(qtraj_segment_times(handle, 2, times) == expected);
  CHECK(qtraj_sample_unnormalized(handle, times, 1, q, nullptr, nullptr, nullptr) == expected);
  CHECK(qtraj_uniform_count(handle, 0, 0.5, &bad) == expected);

  CHECK(qtraj_method(handle) == 0);
  CHECK(qtraj_key_count(handle) == 0);
  CHECK(std::isnan(qtraj_start_time(handle)));
  CHECK(std::isnan(qtraj_end_time(handle)));
  CHECK(qtraj_sign_flips(handle) == 0);
  CHECK(std::isnan(qtraj_worst_norm_error(handle)));
  CHECK(std::isnan(qtraj_least_dot(handle)));
  CHECK(qtraj_iterations(handle) == 0);
  CHECK(std::isnan(qtraj_residual(handle)));
}

void check_options_calls(qtraj_options* handle, qtraj_status expected) {
  const double zero[3] = {0, 0, 0};
  qtraj_trajectory* out = nullptr;
  size_t bytes = 7, bad = 7;
  double memory[200];
  CHECK(qtraj_options_set_ends(handle, QTRAJ_END_CHORD, QTRAJ_END_CHORD) == expected);
  CHECK(qtraj_options_set_end_rates(handle, QTRAJ_FRAME_BODY, zero, zero) == expected);
  CHECK(qtraj_options_set_tangents(handle, QTRAJ_TANGENT_DEFAULT) == expected);
  CHECK(qtraj_options_set_reference(handle, QTRAJ_REFERENCE_FIRST, nullptr) == expected);
  CHECK(qtraj_options_set_extrapolation(handle, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD) == expected);
  CHECK(qtraj_options_set_turns(handle, QTRAJ_TURNS_DEFAULT) == expected);
  CHECK(qtraj_options_set_period(handle, 2) == expected);
  CHECK(qtraj_options_set_closure(handle, 0.1) == expected);
  CHECK(qtraj_options_set_longest_gap(handle, 0.1) == expected);
  CHECK(qtraj_create_with_options(handle, kTimes, kKeys, 2, &out, &bad) == expected);
  CHECK(bad == SIZE_MAX);
  CHECK(qtraj_create_with_rates(handle, QTRAJ_FRAME_BODY, kTimes, kKeys, kKeys, nullptr, 2, &out, nullptr) == expected);
  const int32_t turns[1] = {0};
  CHECK(qtraj_create_with_turns(handle, 0, kTimes, kKeys, nullptr, nullptr, turns, 2, &out, nullptr) == expected);
  CHECK(qtraj_init_size(handle, 2, &bytes) == expected);
  CHECK(bytes == 7);
  CHECK(qtraj_init(memory, sizeof memory, handle, 0, kTimes, kKeys, nullptr, nullptr, nullptr, 2, &out, nullptr) ==
        expected);
  CHECK(out == nullptr);
}

TEST_CASE("C API: NULL handles are NULL, and getters have nothing to tell", "[capi][misuse]") {
  check_trajectory_calls(nullptr, QTRAJ_E_NULL);
  check_options_calls(nullptr, QTRAJ_E_NULL);
}

TEST_CASE("C API: a handle of another kind, misaligned or made of nothing is HANDLE", "[capi][misuse]") {
  const Trajectory curve(make_curve());
  const Options options(make_settings(QTRAJ_SQUAD));
  alignas(8) double memory[100] = {};
  const char* const shifted = reinterpret_cast<const char*>(curve.get()) + 4;
  check_trajectory_calls(reinterpret_cast<const qtraj_trajectory*>(options.get()), QTRAJ_E_HANDLE);
  check_trajectory_calls(reinterpret_cast<const qtraj_trajectory*>(memory), QTRAJ_E_HANDLE);
  check_trajectory_calls(reinterpret_cast<const qtraj_trajectory*>(shifted), QTRAJ_E_HANDLE);
  check_options_calls(reinterpret_cast<qtraj_options*>(curve.get()), QTRAJ_E_HANDLE);
  check_options_calls(reinterpret_cast<qtraj_options*>(memory), QTRAJ_E_HANDLE);
  check_options_calls(reinterpret_cast<qtraj_options*>(reinterpret_cast<char*>(memory) + 1), QTRAJ_E_HANDLE);

  // nor are they freed
  qtraj_destroy(reinterpret_cast<qtraj_trajectory*>(options.get()));
  qtraj_options_destroy(reinterpret_cast<qtraj_options*>(curve.get()));
  CHECK(qtraj_method(curve.get()) == QTRAJ_SLERP);
  CHECK(qtraj_options_set_tangents(options.get(), QTRAJ_TANGENT_MEAN_VELOCITY) == QTRAJ_OK);
}

TEST_CASE("C API: handles in the caller's memory are void once destroyed, and only then", "[capi][misuse]") {
  alignas(8) unsigned char settings[QTRAJ_OPTIONS_BYTES];
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_init(settings, sizeof settings, QTRAJ_SLERP, &options) == QTRAJ_OK);
  size_t bytes;
  REQUIRE(qtraj_init_size(options, 2, &bytes) == QTRAJ_OK);
  std::vector<double> memory(bytes / sizeof(double) + 1);
  qtraj_trajectory* curve = nullptr;
  REQUIRE(qtraj_init(memory.data(), bytes, options, 0, kTimes, kKeys, nullptr, nullptr, nullptr, 2, &curve, nullptr) ==
          QTRAJ_OK);
  CHECK(qtraj_key_count(curve) == 2);

  qtraj_destroy(curve);
  check_trajectory_calls(curve, QTRAJ_E_HANDLE);
  qtraj_destroy(curve);  // twice does no harm
  qtraj_options_destroy(options);
  check_options_calls(options, QTRAJ_E_HANDLE);
  qtraj_options_destroy(options);
}

TEST_CASE("C API: a handle comes after NULL and before all else", "[capi][misuse]") {
  double memory[2] = {};
  const auto* wrong = reinterpret_cast<const qtraj_trajectory*>(memory);
  const auto* wrong_options = reinterpret_cast<const qtraj_options*>(memory);
  double q[8];
  qtraj_trajectory* out;
  CHECK(qtraj_sample(wrong, nullptr, 1, q, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_sample(wrong, kTimes, SIZE_MAX, q, nullptr) == QTRAJ_E_HANDLE);
  CHECK(qtraj_sample(wrong, nullptr, 0, nullptr, nullptr) == QTRAJ_E_HANDLE);
  CHECK(qtraj_sample_rates(wrong, 0, kTimes, 1, q, q, q, nullptr) == QTRAJ_E_HANDLE);
  CHECK(qtraj_sample_rates_at(wrong, 0, 0, nullptr, q, q, q) == QTRAJ_E_HANDLE);
  CHECK(qtraj_create_with_options(wrong_options, nullptr, kKeys, 1, &out, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_create_with_options(wrong_options, kTimes, kKeys, 1, &out, nullptr) == QTRAJ_E_HANDLE);
  CHECK(qtraj_init_size(wrong_options, 0, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_options_set_reference(reinterpret_cast<qtraj_options*>(memory), QTRAJ_REFERENCE_GIVEN, nullptr) ==
        QTRAJ_E_NULL);
}

}  // namespace
