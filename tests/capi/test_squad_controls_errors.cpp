// squad_controls and faulty arguments, keys and times.
#include <cfloat>
#include <cstring>
#include <string>

#include "support/capi_floating.hpp"
#include "support/catch.hpp"
#include "support/pair_functions.hpp"

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kCount = 9;

test::Keys good_keys() {
  test::Random random(41);
  return test::random_walk(random, kCount, 1.5, 0.5, 1.5);
}

struct Controls {
  qtraj_status status = QTRAJ_OK;
  size_t bad_index = 7;
  std::vector<double> a = std::vector<double>(4 * kCount, 7.0), b = a;

  bool row_is_nan(size_t row) const {
    bool all = true;
    for (size_t k = 4 * row; k < 4 * row + 4; ++k) all = all && std::isnan(a[k]) && std::isnan(b[k]);
    return all;
  }
  bool row_equals(const Controls& other, size_t row) const {
    return std::memcmp(&a[4 * row], &other.a[4 * row], 32) == 0 && std::memcmp(&b[4 * row], &other.b[4 * row], 32) == 0;
  }
};
Controls call(const test::Keys& keys) {
  Controls controls;
  const char* found = capi::disturbance([&] {
    controls.status = qtraj_squad_controls(keys.times.data(), keys.q.data(), kCount, controls.a.data(),
                                           controls.b.data(), &controls.bad_index);
  });
  CHECK(found == std::string("nothing"));
  return controls;
}

TEST_CASE("C API: squad_controls of nothing is OK with NULL arrays", "[capi][squad_controls]") {
  size_t bad_index = 7;
  CHECK(qtraj_squad_controls(nullptr, nullptr, 0, nullptr, nullptr, &bad_index) == QTRAJ_OK);
  CHECK(bad_index == SIZE_MAX);
  CHECK(qtraj_squad_controls(nullptr, nullptr, 0, nullptr, nullptr, nullptr) == QTRAJ_OK);
}

TEST_CASE("C API: squad_controls judges arguments in order and then leaves outputs alone",
          "[capi][squad_controls][errors]") {
  const test::Keys keys = good_keys();
  const double *times = keys.times.data(), *q = keys.q.data();
  Controls out;
  const std::vector<double> untouched = out.a;
  const auto check = [&](qtraj_status expected, const double* t, const double* q_wb, size_t count, double* a,
                         double* b) {
    size_t bad_index = 7;
    CHECK(qtraj_squad_controls(t, q_wb, count, a, b, &bad_index) == expected);
    CHECK(bad_index == SIZE_MAX);
    CHECK(qtraj_squad_controls(t, q_wb, count, a, b, nullptr) == expected);
    CHECK(out.a == untouched);
    CHECK(out.b == untouched);
  };
  check(QTRAJ_E_NULL, times, nullptr, kCount, out.a.data(), out.b.data());
  check(QTRAJ_E_NULL, times, q, kCount, nullptr, out.b.data());
  check(QTRAJ_E_NULL, times, q, kCount, out.a.data(), nullptr);
  check(QTRAJ_E_NULL, times, q, SIZE_MAX, out.a.data(), nullptr);
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 4 + 2, size_t{PTRDIFF_MAX} / 32 + 1})
    check(QTRAJ_E_SIZE, times, q, count, out.a.data(), out.a.data());
  check(QTRAJ_E_OVERLAP, times, q, kCount, out.a.data(), out.a.data());
  check(QTRAJ_E_OVERLAP, times, q, 4, out.a.data(), out.a.data() + 15);
  check(QTRAJ_E_OVERLAP, times, out.a.data() + 4, 4, out.a.data(), out.b.data());
  check(QTRAJ_E_OVERLAP, times, out.b.data() + 1, 4, out.a.data(), out.b.data());
  check(QTRAJ_E_OVERLAP, out.a.data() + 15, q, 4, out.a.data(), out.b.data());
}

TEST_CASE("C API: squad_controls may write over its keys", "[capi][squad_controls]") {
  const test::Keys keys = good_keys();
  const Controls expected = call(keys);
  Controls out;
  std::vector<double> in_place = keys.q;
  CHECK(qtraj_squad_controls(keys.times.data(), in_place.data(), kCount, in_place.data(), out.b.data(), nullptr) ==
        QTRAJ_OK);
  CHECK(in_place == expected.a);
  CHECK(out.b == expected.b);
  in_place = keys.q;
  CHECK(qtraj_squad_controls(keys.times.data(), in_place.data(), kCount, out.a.data(), in_place.data(), nullptr) ==
        QTRAJ_OK);
  CHECK(out.a == expected.a);
  CHECK(in_place == expected.b);
}

// Key at fault, and rows that depend on it.
struct Fault {
  test::Keys keys;
  qtraj_status status;
  size_t bad_index;
  std::vector<size_t> nan_rows;
};

void check(const Fault& fault) {
  const Controls good = call(good_keys()), found = call(fault.keys);
  CAPTURE(fault.bad_index);
  CHECK(found.status == fault.status);
  CHECK(found.bad_index == fault.bad_index);
  for (size_t row = 0; row < kCount; ++row) {
    CAPTURE(row);
    const bool is_nan = std::find(fault.nan_rows.begin(), fault.nan_rows.end(), row) != fault.nan_rows.end();
    CHECK((is_nan ? found.row_is_nan(row) : found.row_equals(good, row)));
  }
}

test::Keys with_q(size_t key, double value) {
  test::Keys keys = good_keys();
  for (size_t k = 4 * key; k < 4 * key + 4; ++k) keys.q[k] = value;
  return keys;
}
test::Keys with_time(size_t key, double value) {
  test::Keys keys = good_keys();
  keys.times[key] = value;
  return keys;
}

TEST_CASE("C API: a key at fault makes the controls of its inner neighbours NaN, no others",
          "[capi][squad_controls][errors]") {
  double signalling;
  capi::set_signalling_nan(signalling);
  test::Keys with_signalling = good_keys();
  std::memcpy(&with_signalling.q[4 * 4 + 1], &signalling, sizeof signalling);
  check({with_signalling, QTRAJ_E_NOT_FINITE, 4, {3, 4, 5}});
  for (const double value : {kNaN, kInfinity, -kInfinity}) {
    check({with_q(4, value), QTRAJ_E_NOT_FINITE, 4, {3, 4, 5}});
    check({with_time(4, value), QTRAJ_E_NOT_FINITE, 4, {3, 4, 5}});
    check({with_q(0, value), QTRAJ_E_NOT_FINITE, 0, {0, 1}});
    check({with_time(0, value), QTRAJ_E_NOT_FINITE, 0, {0, 1}});
    check({with_q(1, value), QTRAJ_E_NOT_FINITE, 1, {1, 2}});
    check({with_q(8, value), QTRAJ_E_NOT_FINITE, 8, {7, 8}});
    check({with_time(8, value), QTRAJ_E_NOT_FINITE, 8, {7, 8}});
  }
  check({with_q(5, 0.0), QTRAJ_E_ZERO_NORM, 5, {4, 5, 6}});

  // the first fault gives the status
  test::Keys two = with_q(6, 0.0);
  two.q[4 * 2] = kNaN;
  check({two, QTRAJ_E_NOT_FINITE, 2, {1, 2, 3, 5, 6, 7}});
  // at one key NOT_FINITE, ZERO_NORM, TIME_ORDER
  two = with_q(5, 0.0);
  two.times[5] = kNaN;
  check({two, QTRAJ_E_NOT_FINITE, 5, {4, 5, 6}});
  two.times[5] = two.times[4];
  check({two, QTRAJ_E_ZERO_NORM, 5, {4, 5, 6}});
}

TEST_CASE("C API: times of squad_controls are judged like knots, the later one at fault",
          "[capi][squad_controls][errors]") {
  const std::vector<double> times = good_keys().times;
  check({with_time(4, times[3]), QTRAJ_E_TIME_ORDER, 4, {3, 4, 5}});
  check({with_time(4, times[2]), QTRAJ_E_TIME_ORDER, 4, {3, 4, 5}});
  check({with_time(1, times[0]), QTRAJ_E_TIME_ORDER, 1, {1, 2}});
  check({with_time(8, times[0] - 1), QTRAJ_E_TIME_ORDER, 8, {7, 8}});
}

TEST_CASE("C API: squad_controls takes any keys and times without raising anything",
          "[capi][squad_controls][floating]") {
  const double all_times[] = {0, 1e-154, 1e-300, 1.0, 1.7e9, 1e154, 1e308, DBL_MAX, -1.0, -DBL_MAX, kNaN, kInfinity};
  const double all_q[] = {0.0, 5e-324, 1e-160, 1.0, -1.0, 1e160, DBL_MAX, kNaN};
  test::Random random(42);
  const auto any = [&](const auto& values) {
    return values[static_cast<size_t>(random.uniform(0, 0.999) * static_cast<double>(std::size(values)))];
  };
  test::Keys keys = good_keys();
  for (int i = 0; i < 20000; ++i) {
    for (double& time : keys.times) time = any(all_times);
    if (i % 2 == 0)
      std::sort(keys.times.begin(), keys.times.end(),
                [](double x, double y) { return std::isnan(y) ? !std::isnan(x) : !std::isnan(x) && x < y; });
    for (double& component : keys.q) component = random.uniform(0, 1) < 0.1 ? any(all_q) : random.normal();
    const Controls controls = call(keys);
    for (size_t row = 0; row < kCount; ++row)
      for (const double* q : {&controls.a[4 * row], &controls.b[4 * row]})
        if (!controls.row_is_nan(row) && !(std::abs(pairs::norm_of(q) - 1) <= 4 * DBL_EPSILON))
          FAIL("norm " << pairs::norm_of(q) << " in run " << i);
  }
}

}  // namespace
