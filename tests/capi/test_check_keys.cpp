// All faults of a recording at once: which keys are at fault, what the report says, and that the others make a curve.
#include <cstdio>
#include <ctime>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"
#include "support/long_double.hpp"

using namespace capi;

namespace {

qtraj_status check_keys(const double* times, const double* q, size_t count, int32_t* statuses, qtraj_key_report* report,
                        size_t* bad_index) {
  return qtraj_check_keys(times, q, count, statuses, report, bad_index);
}
qtraj_status check_keys(const double* times, const float* q, size_t count, int32_t* statuses, qtraj_key_report* report,
                        size_t* bad_index) {
  return qtraj_check_keys_f32(times, q, count, statuses, report, bad_index);
}

struct Checked {
  qtraj_status status;
  size_t bad_index = 0;
  std::vector<int32_t> statuses;
  qtraj_key_report report;
};

template <class Real>
Checked check(const Keyframes<Real>& keys) {
  Checked checked;
  checked.statuses.assign(keys.count(), -1);
  checked.status = check_keys(keys.times.data(), keys.q.data(), keys.count(), checked.statuses.data(), &checked.report,
                              &checked.bad_index);
  return checked;
}

// A turn about z by `step` rad a key, at these times.
Keyframes<double> turning(const std::vector<double>& times, double step = 0.1) {
  Keyframes<double> keys;
  keys.times = times;
  for (size_t k = 0; k < times.size(); ++k)
    for (const double component : test::about({0, 0, 1}, step * static_cast<double>(k))) keys.q.push_back(component);
  return keys;
}

// Indices of the keys at fault.
std::vector<size_t> faults(const std::vector<double>& times) {
  const Checked checked = check(turning(times));
  std::vector<size_t> indices;
  for (size_t k = 0; k < times.size(); ++k)
    if (checked.statuses[k] != QTRAJ_OK) indices.push_back(k);
  CHECK(checked.report.faults == indices.size());
  CHECK(checked.bad_index == (indices.empty() ? SIZE_MAX : indices[0]));
  CHECK(checked.status == (indices.empty() ? QTRAJ_OK : checked.statuses[indices[0]]));
  return indices;
}

using Indices = std::vector<size_t>;

TEST_CASE("C API: a wild time is one fault, whichever way it is off", "[capi][check_keys]") {
  CHECK(faults({0, 1, 2, 3, 4, 5}).empty());
  CHECK(faults({0, 1, 1e9, 3, 4, 5}) == Indices{2});
  CHECK(faults({10, 11, 12, 0, 14, 15}) == Indices{3});
  CHECK(faults({1e9, 1, 2, 3}) == Indices{0});
  CHECK(faults({1, 2, 3, 0}) == Indices{3});
  CHECK(faults({0, 1, 100, 101, 4, 5, 6, 7}) == Indices{2, 3});
  CHECK(faults({1, 2, 3, 3, 4}) == Indices{3});
  CHECK(faults({1, 2, 4, 3, 5}) == Indices{3});
  CHECK(faults({0, 0, 0, 0}) == Indices{1, 2, 3});
  CHECK(faults({3, 2, 1}) == Indices{1, 2});
  // a clock that was set back: the longer part stays, of equal ones the first
  CHECK(faults({10, 11, 12, 13, 0, 1}) == Indices{4, 5});
  CHECK(faults({10, 11, 0, 1, 2}) == Indices{0, 1});
  CHECK(faults({10, 11, 0, 1}) == Indices{2, 3});
}

TEST_CASE("C API: times that are too close or too far apart are faults like those of constructors",
          "[capi][check_keys]") {
  CHECK(faults({0, 1e-160, 1}) == Indices{1});
  CHECK(faults({0, 1e-150, 1}).empty());
  const Checked checked = check(turning({-1.7e308, 0, 1, 1.7e308, 1.75e308}));
  CHECK(checked.statuses == std::vector<int32_t>{0, 0, 0, QTRAJ_E_TIME_SPAN, QTRAJ_E_TIME_SPAN});
  CHECK(checked.status == QTRAJ_E_TIME_SPAN);
  CHECK(checked.bad_index == 3);
}

TEST_CASE("C API: at one key NOT_FINITE comes before ZERO_NORM, and both before its time", "[capi][check_keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    Keyframes<Real> keys;
    keys.times = {0, 1, std::numeric_limits<double>::infinity(), 3, 4, 3, 5};
    keys.q.assign(4 * 7, Real(0.5));
    keys.q[4 * 1 + 2] = nan;
    for (size_t k = 0; k < 4; ++k) keys.q[4 * 2 + k] = keys.q[4 * 3 + k] = keys.q[4 * 5 + k] = 0;
    const Checked checked = check(keys);
    CHECK(checked.statuses ==
          std::vector<int32_t>{0, QTRAJ_E_NOT_FINITE, QTRAJ_E_NOT_FINITE, QTRAJ_E_ZERO_NORM, 0, QTRAJ_E_ZERO_NORM, 0});
    CHECK(checked.status == QTRAJ_E_NOT_FINITE);
    CHECK(checked.bad_index == 1);
    CHECK(checked.report.faults == 4);
    // neighbours are keys 0, 4 and 6
    CHECK(checked.report.longest_interval == 4);
    CHECK(checked.report.longest_interval_index == 4);
    CHECK(checked.report.shortest_interval == 1);
    CHECK(checked.report.shortest_interval_index == 6);
  });
}

// ---- Property: what is left are keys that constructors take ----

// A recording with every kind of fault, in places and in runs.
template <class Real>
Keyframes<Real> dirty_recording(test::Random& random) {
  Keyframes<Real> keys;
  const auto count = static_cast<size_t>(random.uniform(2, 60));
  const double rate = random.uniform(0, 0.6);
  double time = random.uniform(-100, 100);
  int run = 0;
  double offset = 0;
  for (size_t k = 0; k < count; ++k) {
    time += random.uniform(0.01, 1);
    double stamp = time;
    test::Quaternion q = random.orientation();
    if (--run > 0) stamp += offset;
    if (random.uniform(0, 1) < rate) {
      const double kind = random.uniform(0, 12);
      if (kind < 1)
        stamp = 0;
      else if (kind < 2)
        stamp = random.uniform(-1e9, 1e9);
      else if (kind < 3)
        stamp = keys.times.empty() ? time : keys.times.back();
      else if (kind < 4)
        stamp = time = time - random.uniform(0, 5);
      else if (kind < 5)
        stamp = std::numeric_limits<double>::quiet_NaN();
      else if (kind < 6)
        stamp = random.uniform(-1, 1) * std::numeric_limits<double>::max();
      else if (kind < 7)
        stamp = (keys.times.empty() ? time : keys.times.back()) * (1 + 2.3e-16);
      else if (kind < 8)
        q = {0, 0, 0, 0};
      else if (kind < 9)
        q[1] = std::numeric_limits<double>::infinity();
      else if (kind < 10)
        stamp = random.uniform(0, 1) * 1e-150;
      else {
        run = static_cast<int>(random.uniform(2, 10));
        offset = random.uniform(-50, 50);
      }
    }
    const double norm = random.uniform(0.5, 2);
    keys.times.push_back(stamp);
    for (const double component : q) keys.q.push_back(static_cast<Real>(norm * component));
  }
  return keys;
}

// Most keys without fault of one series, by trying all beginnings: O(n^2).
template <class Real>
size_t longest_series(const Keyframes<Real>& keys) {
  std::vector<size_t> length(keys.count(), 0);
  size_t longest = 0;
  for (size_t k = 0; k < keys.count(); ++k) {
    const Real* q = &keys.q[4 * k];
    bool finite = std::isfinite(keys.times[k]), zero = true;
    for (size_t c = 0; c < 4; ++c) {
      finite = finite && std::isfinite(q[c]);
      zero = zero && q[c] == 0;
    }
    if (!finite || zero) continue;
    length[k] = 1;
    for (size_t j = 0; j < k; ++j) {
      const long double step = static_cast<long double>(keys.times[k]) - static_cast<long double>(keys.times[j]);
      if (length[j] > 0 && step > 7.5e-155L) length[k] = std::max(length[k], length[j] + 1);
    }
    longest = std::max(longest, length[k]);
  }
  return longest;
}

TEST_CASE("C API: without the keys at fault constructors take a recording, and no fewer could be left out",
          "[capi][check_keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(71);
    size_t refused = 0, short_of_longest = 0, wrong = 0, compared = 0;
    for (int repetition = 0; repetition < 20000; ++repetition) {
      const Keyframes<Real> keys = dirty_recording<Real>(random);
      const Checked checked = check(keys);
      Keyframes<Real> good;
      size_t spans = 0;
      for (size_t k = 0; k < keys.count(); ++k) {
        if (checked.statuses[k] == QTRAJ_E_TIME_SPAN) ++spans;
        if (checked.statuses[k] != QTRAJ_OK) continue;
        good.times.push_back(keys.times[k]);
        good.q.insert(good.q.end(), &keys.q[4 * k], &keys.q[4 * k] + 4);
      }
      if (good.count() + spans != longest_series(keys)) ++short_of_longest;
      if (checked.report.faults != keys.count() - good.count()) ++wrong;
      if (good.count() < 2) continue;
      ++compared;
      qtraj_trajectory* handle = nullptr;
      if (create(QTRAJ_SLERP, good.times.data(), good.q.data(), good.count(), &handle, nullptr) != QTRAJ_OK) ++refused;
      const Trajectory curve(handle);
      // and it is good itself
      const Checked again = check(good);
      if (again.status != QTRAJ_OK || again.report.faults != 0) ++wrong;
      if (curve && std::abs(qtraj_worst_norm_error(handle) - again.report.worst_norm_error) > 4.5e-16) ++wrong;
    }
    CHECK(refused == 0);
    CHECK(short_of_longest == 0);
    CHECK(wrong == 0);
    CHECK(compared > 15000);
  });
}

// ---- The report ----

TEST_CASE("C API: the report has the worst norm, step and intervals with the index of each", "[capi][check_keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(72);
    Keyframes<Real> keys;
    for (size_t k = 0; k < 500; ++k) {
      keys.times.push_back(static_cast<double>(k) + random.uniform(0, 0.5));
      const double norm = random.uniform(0.99, 1.02);
      for (const double component : random.orientation()) keys.q.push_back(static_cast<Real>(norm * component));
    }
    const Checked checked = check(keys);
    REQUIRE(checked.status == QTRAJ_OK);
    const qtraj_key_report& report = checked.report;
    // the reference: everything in long double
    long double norm_error = -1, angle = -1, longest = -1, shortest = 1e9L;
    size_t norm_index = 0, angle_index = 0, longest_index = 0, shortest_index = 0, changes = 0, first_change = SIZE_MAX;
    for (size_t k = 0; k < keys.count(); ++k) {
      const wide::Quaternion q = wide::quaternion(&keys.q[4 * k]);
      const long double error = std::abs(wide::norm(q) - 1);
      if (error > norm_error) norm_error = error, norm_index = k;
      if (k == 0) continue;
      const wide::Quaternion before = wide::quaternion(&keys.q[4 * k - 4]);
      if (wide::dot(before, q) < 0 && ++changes == 1) first_change = k;
      const long double to_q = wide::angle(before, q), to_minus_q = wide::angle(before, wide::scaled(-1, q));
      const long double step = 2 * std::min(to_q, to_minus_q), interval = keys.times[k] - keys.times[k - 1];
      if (step > angle) angle = step, angle_index = k;
      if (interval > longest) longest = interval, longest_index = k;
      if (interval < shortest) shortest = interval, shortest_index = k;
    }
    CHECK(report.worst_norm_index == norm_index);
    CHECK(std::abs(report.worst_norm_error - norm_error) <= 2.3e-16L);
    CHECK(report.largest_angle_index == angle_index);
    CHECK(std::abs(report.largest_angle - angle) <= 1.7e-16L * angle);
    CHECK(report.longest_interval_index == longest_index);
    CHECK(report.longest_interval == static_cast<double>(longest));
    CHECK(report.shortest_interval_index == shortest_index);
    CHECK(report.shortest_interval == static_cast<double>(shortest));
    CHECK(report.sign_changes == changes);
    CHECK(report.first_sign_change == first_change);
    for (const uint64_t word : report.reserved) CHECK(word == 0);
  });
}

TEST_CASE("C API: where there is nothing to report, indices are UINT64_MAX and values NaN", "[capi][check_keys]") {
  qtraj_key_report report;
  size_t bad_index = 0;
  REQUIRE(qtraj_check_keys(nullptr, nullptr, 0, nullptr, &report, &bad_index) == QTRAJ_OK);
  CHECK(bad_index == SIZE_MAX);
  CHECK((std::isnan(report.worst_norm_error) && report.worst_norm_index == UINT64_MAX));
  const double time = 1, q[4] = {2, 0, 0, 0};
  REQUIRE(qtraj_check_keys(&time, q, 1, nullptr, &report, nullptr) == QTRAJ_OK);
  CHECK((report.worst_norm_error == 1 && report.worst_norm_index == 0));
  CHECK((std::isnan(report.largest_angle) && report.largest_angle_index == UINT64_MAX));
  CHECK((std::isnan(report.longest_interval) && report.longest_interval_index == UINT64_MAX));
  CHECK((std::isnan(report.shortest_interval) && report.shortest_interval_index == UINT64_MAX));
  CHECK((report.faults == 0 && report.sign_changes == 0 && report.first_sign_change == UINT64_MAX));
}

TEST_CASE("C API: an array that is not what the caller thinks shows in the norms", "[capi][check_keys]") {
  test::Random random(73);
  const size_t count = 200;
  std::vector<double> times, q;
  test::Quaternion pose = random.orientation();
  for (size_t k = 0; k < count; ++k) {
    times.push_back(0.1 * static_cast<double>(k));
    pose = test::multiply(pose, test::turn_within(random, 0.2));
    q.insert(q.end(), pose.begin(), pose.end());
  }
  const auto worst = [&](const std::vector<double>& keys) {
    qtraj_key_report report;
    (void)qtraj_check_keys(times.data(), keys.data(), count, nullptr, &report, nullptr);
    return report.worst_norm_error;
  };
  CHECK(worst(q) < 1e-15);
  std::vector<double> transposed(q.size()), shifted(q.size()), as_float(q.size());
  for (size_t k = 0; k < count; ++k)
    for (size_t c = 0; c < 4; ++c) {
      transposed[c * count + k] = q[4 * k + c];
      shifted[4 * k + c] = c == 0 ? times[k] : q[4 * k + c - 1];  // the time's column taken for w
    }
  CHECK(worst(transposed) > 0.01);
  CHECK(worst(shifted) > 0.01);
  std::vector<float> floats(2 * q.size());
  for (size_t k = 0; k < q.size(); ++k) floats[k] = static_cast<float>(q[k]);
  std::memcpy(as_float.data(), floats.data(), q.size() * sizeof(double));
  CHECK(worst(as_float) > 0.01);
}

// ---- The call ----

TEST_CASE("C API: arguments of check_keys that are wrong write nothing", "[capi][check_keys][errors]") {
  Keyframes<double> keys = turning({0, 1, 2, 3});
  int32_t statuses[4] = {7, 7, 7, 7};
  qtraj_key_report report;
  std::memset(&report, 7, sizeof report);
  const qtraj_key_report before = report;
  const auto refused = [&](qtraj_status expected, const double* times, const double* q, size_t count, int32_t* out,
                           qtraj_key_report* into) {
    size_t bad_index = 0;
    CHECK(qtraj_check_keys(times, q, count, out, into, &bad_index) == expected);
    CHECK(bad_index == SIZE_MAX);
    for (const int32_t status : statuses) CHECK(status == 7);
    CHECK(std::memcmp(&report, &before, sizeof report) == 0);
  };
  const double *times = keys.times.data(), *q = keys.q.data();
  refused(QTRAJ_E_NULL, nullptr, q, 4, statuses, &report);
  refused(QTRAJ_E_NULL, times, nullptr, 4, statuses, &report);
  refused(QTRAJ_E_SIZE, times, q, SIZE_MAX, statuses, &report);
  refused(QTRAJ_E_SIZE, times, q, SIZE_MAX / 64 + 1, statuses, &report);
  // the report in the statuses, the statuses in the keys, the report in the times
  std::vector<double> room(64, 1.0);
  auto* in_room = reinterpret_cast<int32_t*>(room.data());
  refused(QTRAJ_E_OVERLAP, times, q, 4, in_room, reinterpret_cast<qtraj_key_report*>(room.data() + 1));
  refused(QTRAJ_E_OVERLAP, room.data(), q, 4, in_room, &report);
  refused(QTRAJ_E_OVERLAP, times, room.data(), 4, in_room + 8, &report);
  refused(QTRAJ_E_OVERLAP, room.data() + 15, q, 4, statuses, reinterpret_cast<qtraj_key_report*>(room.data()));
  CHECK(qtraj_check_keys(times, q, 4, nullptr, nullptr, nullptr) == QTRAJ_OK);
}

TEST_CASE("C API: check_keys leaves the floating-point environment alone, whatever the keys hold",
          "[capi][check_keys][floating]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Keyframes<Real> keys;
    keys.times = {-1.7e308, 5e-324, 1, 0.5, 1.7e308, 3};
    keys.q.assign(24, std::numeric_limits<Real>::max());
    set_signalling_nan(keys.q[5]);
    keys.q[8] = std::numeric_limits<Real>::denorm_min();
    keys.q[9] = keys.q[10] = keys.q[11] = 0;
    int32_t statuses[6];
    qtraj_key_report report;
    CHECK(std::string(disturbance([&] {
            (void)check_keys(keys.times.data(), keys.q.data(), 6, statuses, &report, nullptr);
          })) == "nothing");
    set_signalling_nan(keys.times[2]);
    CHECK(std::string(disturbance([&] {
            (void)check_keys(keys.times.data(), keys.q.data(), 6, statuses, &report, nullptr);
          })) == "nothing");
  });
}

}  // namespace
