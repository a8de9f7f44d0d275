// Diagnostics of samples where samples, knots or keys are faulty: statuses and rows.
#include <cfloat>
#include <cmath>
#include <limits>

#include "support/capi_floating.hpp"
#include "support/capi_samples.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

bool is_nan_row(const std::vector<double>& rows, size_t row, size_t width) {
  for (size_t k = row * width; k < (row + 1) * width; ++k)
    if (!std::isnan(rows[k])) return false;
  return true;
}

// A fault of sample 4.
struct Fault {
  const char* name;
  double time;
  std::vector<double> q;  // empty: as it is
  qtraj_status status;
};
const Fault kFaults[] = {
    {"NaN time", kNaN, {}, QTRAJ_E_NOT_FINITE},           {"infinite time", -kInfinity, {}, QTRAJ_E_NOT_FINITE},
    {"NaN", 4, {1, 0, kNaN, 0}, QTRAJ_E_NOT_FINITE},      {"infinity", 4, {-kInfinity, 0, 0, 0}, QTRAJ_E_NOT_FINITE},
    {"NaN late", 3, {1, 0, kNaN, 0}, QTRAJ_E_NOT_FINITE}, {"zero", 4, {0, -0.0, 0, 0}, QTRAJ_E_ZERO_NORM},
    {"zero, late", 3.5, {0, 0, 0, 0}, QTRAJ_E_ZERO_NORM}, {"zero, never", kNaN, {0, 0, 0, 0}, QTRAJ_E_NOT_FINITE},
    {"equal time", 3.5, {}, QTRAJ_E_TIME_ORDER},          {"early time", -1, {}, QTRAJ_E_TIME_ORDER},
    {"far early time", -DBL_MAX, {}, QTRAJ_E_TIME_ORDER}};

TEST_CASE("C API: rows that use a faulty sample are NaN, all others right, the status its own",
          "[capi][sample_diagnostics][errors]") {
  SampleArguments good;
  for (int function = 0; function < kFunctions; ++function)
    REQUIRE(call(static_cast<SampleFunction>(function), good) == QTRAJ_OK);
  for (const Fault& fault : kFaults) {
    CAPTURE(fault.name);
    SampleArguments a;
    a.samples_times[4] = fault.time;
    if (!fault.q.empty()) std::copy(fault.q.begin(), fault.q.end(), a.samples_q.begin() + 16);
    const bool bad_time = fault.time != 4;

    CHECK(call(kOmega, a) == fault.status);
    CHECK(a.bad_index == 4);
    for (size_t row = 0; row < 7; ++row) {
      const bool is_bad = row == 3 || row == 4;
      CHECK(is_nan_row(a.omega, row, 3) == is_bad);
      CHECK(is_nan_row(a.t_mid, row, 1) == is_bad);
      if (is_bad) continue;
      CHECK(a.t_mid[row] == good.t_mid[row]);
      for (size_t k = 3 * row; k < 3 * row + 3; ++k) CHECK(a.omega[k] == good.omega[k]);
    }
    CHECK(call(kEnergy, a) == fault.status);
    CHECK(a.bad_index == 4);
    CHECK(std::isnan(a.energy_value));

    CHECK(call(kJumps, a) == fault.status);
    CHECK(a.bad_index == 4);
    const bool uses_sample_4[6] = {false, false, true, true, false, true};  // knots 2, 1, 3.7, 5, 6, 2.5
    for (size_t row = 0; row < 6; ++row) {
      CAPTURE(row);
      CHECK(is_nan_row(a.jumps, row, 3) == (bad_time || uses_sample_4[row]));
      for (size_t k = 3 * row; k < 3 * row + 3; ++k) CHECK((std::isnan(a.jumps[k]) || a.jumps[k] == good.jumps[k]));
    }

    const SampleArguments keys;
    a.key_times = keys.times;
    a.key_q = keys.q;
    CHECK(call(kErrors, a) == fault.status);
    CHECK(a.bad_index == 8 + 4);
    for (size_t row = 0; row < 8; ++row) {
      const bool is_bad = bad_time || row == 4;
      CHECK(std::isnan(a.errors[row]) == is_bad);
      CHECK(a.indices[row] == (is_bad ? SIZE_MAX : row));
    }
  }
}

TEST_CASE("C API: sample times are judged by the finite times before them", "[capi][sample_diagnostics][errors]") {
  struct Case {
    std::vector<double> times;
    std::vector<size_t> bad_rows;
    qtraj_status status;
    size_t bad_index;
  };
  const Case cases[] = {
      {{0, 1, 2, 100, 4, 5}, {3, 4}, QTRAJ_E_TIME_ORDER, 4},
      {{0, 5, kNaN, 3, 6, 7}, {1, 2, 3}, QTRAJ_E_NOT_FINITE, 2},
      {{kNaN, 5, 5, 6, 7, 8}, {0, 1, 2}, QTRAJ_E_NOT_FINITE, 0},
      {{-DBL_MAX, 0, DBL_MAX / 2, 1e308, 1.2e308, 1.3e308}, {1, 2, 3, 4}, QTRAJ_E_TIME_SPAN, 2},
      {{DBL_MAX, -DBL_MAX, -DBL_MAX / 2, 1e308, 1.2e308, 1.3e308}, {0, 1, 2, 3}, QTRAJ_E_TIME_ORDER, 1},
      {{0, 5e-324, 1, 2, 3, 4}, {0, 1}, QTRAJ_E_TIME_ORDER, 1},
      {{0, 7.4e-155, 1, 2, 3, 4}, {0, 1}, QTRAJ_E_TIME_ORDER, 1},
      {{0, 7.5e-155, 1, 2, 3, 4}, {}, QTRAJ_OK, SIZE_MAX},
      {{-DBL_MAX / 2, 0, 1, 2, 3, DBL_MAX / 2}, {}, QTRAJ_OK, SIZE_MAX},
  };
  for (const Case& faulty : cases) {
    CAPTURE(&faulty - cases);
    SampleArguments a;
    a.times = faulty.times.data();
    a.count = 6;
    const char* disturbed = disturbance([&] { call(kOmega, a); });
    CHECK(disturbed == std::string("nothing"));
    CHECK(call(kOmega, a) == faulty.status);
    CHECK(a.bad_index == faulty.bad_index);
    for (size_t row = 0; row < 5; ++row) {
      const bool expected = std::count(faulty.bad_rows.begin(), faulty.bad_rows.end(), row) > 0;
      CHECK(is_nan_row(a.omega, row, 3) == expected);
      CHECK(is_nan_row(a.t_mid, row, 1) == expected);
    }
  }
}

TEST_CASE("C API: knots without an interval on both sides are NaN and TIME_RANGE, others are right",
          "[capi][sample_diagnostics][errors]") {
  SampleArguments good;
  REQUIRE(call(kJumps, good) == QTRAJ_OK);
  for (const double knot : {0.0, 0.9, 6.1, 7.0, -1.0, 8.0, DBL_MAX, -DBL_MAX, kNaN, kInfinity}) {
    CAPTURE(knot);
    SampleArguments a;
    a.knots[2] = knot;
    CHECK(call(kJumps, a) == (std::isfinite(knot) ? QTRAJ_E_TIME_RANGE : QTRAJ_E_NOT_FINITE));
    CHECK(a.bad_index == 8 + 2);
    CHECK(is_nan_row(a.jumps, 2, 3));
    std::copy_n(&good.jumps[6], 3, &a.jumps[6]);
    CHECK(a.jumps == good.jumps);
  }
  SampleArguments two;
  two.count = 2;
  CHECK(call(kJumps, two) == QTRAJ_E_TIME_RANGE);
  CHECK(two.bad_index == 2);
}

TEST_CASE("C API: faulty keys are NaN rows and come before faulty samples", "[capi][sample_diagnostics][errors]") {
  for (const bool bad_sample : {false, true})
    for (const int kind : {0, 1, 2}) {
      CAPTURE(bad_sample, kind);
      SampleArguments a;
      std::vector<double> key_times = a.samples_times, key_q = a.samples_q;
      if (bad_sample) a.samples_q[4 * 1] = kNaN;
      if (kind == 0) key_times[5] = kInfinity;
      if (kind == 1) key_q[4 * 5 + 2] = kNaN;
      if (kind == 2) std::fill_n(&key_q[4 * 5], 4, 0.0);
      a.key_times = key_times.data();
      a.key_q = key_q.data();
      CHECK(call(kErrors, a) == (kind == 2 ? QTRAJ_E_ZERO_NORM : QTRAJ_E_NOT_FINITE));
      CHECK(a.bad_index == 5);
      for (size_t row = 0; row < 8; ++row) {
        const bool is_bad = row == 5 || (bad_sample && row == 1);
        CHECK(std::isnan(a.errors[row]) == is_bad);
        CHECK(a.indices[row] == (is_bad ? SIZE_MAX : row));
      }
    }
}

TEST_CASE("C API: an energy beyond 1e300 is NOT_FINITE and a fault outranks half a turn",
          "[capi][sample_diagnostics][errors]") {
  SampleArguments a;
  a.samples_times = {0, 1, 2, 3, 3 + 1e-15, 3 + 2e-15, 4, 5};
  a.times = a.samples_times.data();
  CHECK(call(kEnergy, a) == QTRAJ_OK);
  for (const double h : {1e-150, 1e-110, 1e-101}) {
    SampleArguments fast;
    fast.samples_times = {-3, -2, -1, 0, h, 2 * h, 4, 5};
    fast.times = fast.samples_times.data();
    CHECK(call(kEnergy, fast) == QTRAJ_E_NOT_FINITE);
    CHECK((fast.bad_index == 4 || fast.bad_index == 5));
    CHECK(std::isnan(fast.energy_value));
    CHECK(disturbance([&] { call(kEnergy, fast); }) == std::string("nothing"));
  }
  // to and fro by 1 rad in h: 4 / h^3 with every turn, 0.9e300
  const double h = std::cbrt(4 / 0.9e300),
               q[16] = {1, 0, 0, 0, std::cos(0.5), std::sin(0.5), 0, 0, 1, 0, 0, 0, std::cos(0.5), std::sin(0.5), 0, 0};
  const double times[4] = {-h, 0, h, 2 * h};
  double energy = 0;
  size_t bad_index = 0;
  CHECK(qtraj_estimate_energy(QTRAJ_FRAME_BODY, times, q, 3, &energy, nullptr) == QTRAJ_OK);
  CHECK(std::abs(energy / 0.9e300 - 1) <= 1e-13);
  CHECK(qtraj_estimate_energy(QTRAJ_FRAME_BODY, times, q, 4, &energy, &bad_index) == QTRAJ_E_NOT_FINITE);
  CHECK(bad_index == 3);

  const double half_turn[8] = {1, 0, 0, 0, 0, 1, 0, 0};
  std::copy_n(half_turn, 8, a.samples_q.begin());
  CHECK(call(kEnergy, a) == QTRAJ_E_AMBIGUOUS);
  CHECK(a.bad_index == 1);
  CHECK(std::isfinite(a.energy_value));
  a.samples_q[4 * 6] = kNaN;
  CHECK(call(kEnergy, a) == QTRAJ_E_NOT_FINITE);
  CHECK(a.bad_index == 6);
  CHECK(call(kOmega, a) == QTRAJ_E_AMBIGUOUS);
  CHECK(a.bad_index == 1);
}

TEST_CASE("C API: diagnostics of samples disturb nothing", "[capi][sample_diagnostics][floating]") {
  double signalling;
  set_signalling_nan(signalling);
  const double values[] = {DBL_MAX, -DBL_MAX, 5e-324, DBL_MIN, 1e-160, -1e160, 0, kInfinity, kNaN, signalling};
  for (const double& a_value : values)
    for (const double& b_value : values)
      for (int function = 0; function < kFunctions; ++function)
        for (const bool in_q : {false, true}) {
          CAPTURE(a_value, b_value, function, in_q);
          SampleArguments a;
          std::vector<double> key_times = a.samples_times;
          std::memcpy(&key_times[3], &a_value, sizeof a_value);
          std::memcpy(&a.knots[3], &a_value, sizeof a_value);
          std::memcpy(in_q ? &a.samples_q[13] : &a.samples_times[3], &a_value, sizeof a_value);
          for (const size_t k : {20, 21, 22, 23})
            std::memcpy(in_q ? &a.samples_q[k] : &a.samples_times[k == 20 ? 0 : 6], &b_value, sizeof b_value);
          a.key_times = key_times.data();
          CHECK(disturbance([&] { call(static_cast<SampleFunction>(function), a); }) == std::string("nothing"));
        }
}

}  // namespace
