// Eigen means of many groups: those of each group alone, a status for each.
#include <qtraj.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "support/capi_batches.hpp"
#include "support/capi_floating.hpp"
#include "support/capi_means.hpp"
#include "support/catch.hpp"
#include "support/guarded.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Groups one after the other; weights only where `weighted`.
template <class Real>
struct Groups {
  std::vector<int64_t> offsets = {0};
  Samples<Real> samples;

  void add(const Samples<Real>& group, bool weighted) {
    samples.q.insert(samples.q.end(), group.q.begin(), group.q.end());
    for (size_t i = 0; weighted && i < group.count(); ++i)
      samples.weights.push_back(group.weights.empty() ? Real(1) : group.weights[i]);
    offsets.push_back(static_cast<int64_t>(samples.count()));
  }
  size_t count() const { return offsets.size() - 1; }
};

template <class Real>
struct Means {
  std::vector<Real> q;
  std::vector<double> eigengaps;
  std::vector<int32_t> statuses;
  qtraj_status status = QTRAJ_E_INTERNAL;
  size_t bad_index = 12345;

  explicit Means(size_t count) : q(4 * count, Real(7)), eigengaps(count, 7), statuses(count, 7) {}
};
template <class Real>
Means<Real> means_of(const Groups<Real>& groups) {
  Means<Real> means(groups.count());
  means.status =
      batch_mean_eigen(groups.count(), groups.offsets.data(), groups.samples.q.data(), groups.samples.weights_or_null(),
                       means.q.data(), means.eigengaps.data(), means.statuses.data(), &means.bad_index);
  return means;
}

// Each group by mean_eigen.
template <class Real>
void check_each(const Groups<Real>& groups, const Means<Real>& means) {
  size_t first = SIZE_MAX;
  for (size_t k = 0; k < groups.count(); ++k) {
    CAPTURE(k);
    const auto row = static_cast<size_t>(groups.offsets[k]), rows = static_cast<size_t>(groups.offsets[k + 1]) - row;
    std::array<Real, 4> mean;
    mean.fill(std::numeric_limits<Real>::quiet_NaN());
    double eigengap = kNaN;
    const Real* const weights = groups.samples.weights_or_null();
    const qtraj_status status = mean_eigen(groups.samples.q.data() + 4 * row, weights ? weights + row : nullptr, rows,
                                           mean.data(), &eigengap, nullptr);
    CHECK(means.statuses[k] == status);
    CHECK(std::memcmp(&means.q[4 * k], mean.data(), sizeof mean) == 0);
    CHECK((means.eigengaps[k] == eigengap || (std::isnan(eigengap) && std::isnan(means.eigengaps[k]))));
    if (status != QTRAJ_OK && first == SIZE_MAX) first = k;
  }
  CHECK(means.bad_index == first);
  CHECK(means.status == (first == SIZE_MAX ? QTRAJ_OK : means.statuses[first]));
}

TEST_CASE("C API: means of groups have the bits of the means of each", "[capi][batches][means]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const bool weighted : {false, true}) {
      test::Random random(8);
      Groups<Real> groups;
      for (int k = 0; k < 200; ++k) groups.add(hard_samples<Real>(random, 2.0), weighted);
      groups.add(cloud<Real>(random, 1000, 0.5), weighted);
      groups.add(cloud<Real>(random, 1, 0.5), weighted);
      check_each(groups, means_of(groups));
    }
  });
}

TEST_CASE("C API: each group has its own status, an empty one is TOO_FEW", "[capi][batches][means]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(9);
    Groups<Real> groups;
    const auto spoilt = [&](size_t element, Real value, Real weight) {
      Samples<Real> samples = cloud<Real>(random, 5, 0.3);
      samples.weights.assign(5, 1);
      samples.q[element] = value;
      samples.weights[3] = weight;
      return samples;
    };
    groups.add(cloud<Real>(random, 9, 0.3), true);
    groups.add({}, true);
    groups.add(spoilt(6, std::numeric_limits<Real>::infinity(), 1), true);
    groups.add(spoilt(0, 0.5, -1), true);
    groups.add({{1, 0, 0, 0, 0, 0, 0, 0}, {1, 0}}, true);
    groups.add({{1, 0, 0, 0, 0, 1, 0, 0}, {0, 0}}, true);
    groups.add({{1, 0, 0, 0, 0, 1, 0, 0}, {2, 2}}, true);
    groups.add(cloud<Real>(random, 4, 0.3), true);
    const Means<Real> means = means_of(groups);
    check_each(groups, means);
    CHECK((means.status == QTRAJ_E_TOO_FEW && means.bad_index == 1));
    const int32_t expected[] = {QTRAJ_OK,          QTRAJ_E_TOO_FEW,   QTRAJ_E_NOT_FINITE, QTRAJ_E_NEGATIVE_WEIGHT,
                                QTRAJ_E_ZERO_NORM, QTRAJ_E_ZERO_NORM, QTRAJ_E_AMBIGUOUS,  QTRAJ_OK};
    CHECK(std::equal(means.statuses.begin(), means.statuses.end(), expected));
  });
}

TEST_CASE("C API: a slice of groups touches nothing else", "[capi][batches][means]") {
  test::Random random(10);
  Groups<double> groups;
  for (int k = 0; k < 12; ++k) groups.add(cloud<double>(random, static_cast<size_t>(3 * k + 1), 0.4), false);
  const Means<double> all = means_of(groups);
  const auto row = static_cast<size_t>(groups.offsets[4]), rows = static_cast<size_t>(groups.offsets[9]) - row;
  for (const bool at_end : {false, true}) {
    test::Guarded<double> q_room(4 * rows), mean_room(20), gap_room(5);
    double *const q = q_room.array(4 * rows, at_end), *const means = mean_room.array(20, at_end),
                  *const gaps = gap_room.array(5, at_end);
    std::copy_n(&groups.samples.q[4 * row], 4 * rows, q);
    CHECK(qtraj_batch_mean_eigen(5, &groups.offsets[4], q - 4 * row, nullptr, means, gaps, nullptr, nullptr) ==
          QTRAJ_OK);
    CHECK(std::equal(means, means + 20, &all.q[16]));
    CHECK(std::equal(gaps, gaps + 5, &all.eigengaps[4]));
  }
}

TEST_CASE("C API: means of groups judge their arguments in the order of the statuses and then leave outputs alone",
          "[capi][batches][means][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    struct Arguments {
      size_t count = 2;
      int64_t offsets[3] = {0, 2, 4};
      Real q[16] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, weights[4] = {1, 1, 1, 1};
      Real means[8] = {7, 7, 7, 7, 7, 7, 7, 7};
      double eigengaps[2] = {7, 7};
      int32_t statuses[2] = {7, 7};
      const int64_t* at = offsets;
      const Real *rows = q, *factors = weights;
      Real* to = means;
      double* gaps = eigengaps;
      int32_t* status_out = statuses;
    };
    const auto check = [](qtraj_status expected, size_t index, auto&& change) {
      Arguments a;
      change(a);
      size_t bad_index = 12345;
      CHECK(batch_mean_eigen(a.count, a.at, a.rows, a.factors, a.to, a.gaps, a.status_out, &bad_index) == expected);
      CHECK(bad_index == index);
      if (expected == QTRAJ_OK) return;
      const auto full = [](auto* values, size_t count) {
        return std::all_of(values, values + count, [](auto value) { return value == 7; });
      };
      CHECK((full(a.means, 8) && full(a.eigengaps, 2) && full(a.statuses, 2)));
    };
    check(QTRAJ_OK, SIZE_MAX, [](auto&) {});
    check(QTRAJ_OK, SIZE_MAX, [](auto& a) { a.factors = nullptr, a.gaps = nullptr, a.status_out = nullptr; });
    check(QTRAJ_OK, SIZE_MAX, [](auto& a) { a.count = 0, a.at = nullptr, a.rows = nullptr, a.to = nullptr; });
    check(QTRAJ_E_NULL, SIZE_MAX, [](auto& a) { a.at = nullptr; });
    check(QTRAJ_E_NULL, SIZE_MAX, [](auto& a) { a.rows = nullptr, a.offsets[1] = -1; });
    check(QTRAJ_E_NULL, SIZE_MAX, [](auto& a) { a.to = nullptr, a.count = SIZE_MAX; });
    check(QTRAJ_E_COUNT, 0, [](auto& a) { a.offsets[0] = -1; });
    check(QTRAJ_E_COUNT, 1, [](auto& a) { a.offsets[2] = 1, a.to = a.q; });
    check(QTRAJ_E_SIZE, SIZE_MAX, [](auto& a) { a.count = SIZE_MAX; });
    check(QTRAJ_E_SIZE, SIZE_MAX, [](auto& a) { a.offsets[2] = INT64_MAX, a.to = a.q; });
    check(QTRAJ_E_OVERLAP, SIZE_MAX, [](auto& a) { a.to = a.q; });
    check(QTRAJ_E_OVERLAP, SIZE_MAX, [](auto& a) { a.to = a.weights + 3; });
    check(QTRAJ_E_OVERLAP, SIZE_MAX, [](auto& a) { a.gaps = reinterpret_cast<double*>(a.means + 2); });
    check(QTRAJ_E_OVERLAP, SIZE_MAX, [](auto& a) { a.status_out = reinterpret_cast<int32_t*>(a.offsets + 2); });
    check(QTRAJ_E_OVERLAP, SIZE_MAX, [](auto& a) { a.status_out = reinterpret_cast<int32_t*>(a.eigengaps + 1); });
    // groups without samples need no arrays of them
    check(QTRAJ_E_TOO_FEW, 0, [](auto& a) {
      std::fill_n(a.offsets, 3, int64_t{5});
      a.rows = a.factors = nullptr, a.to = a.q, a.gaps = nullptr, a.status_out = nullptr;
    });
  });
}

TEST_CASE("C API: means of groups leave the floating-point environment and errno alone", "[capi][batches][means]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(12);
    Groups<Real> groups;
    for (int k = 0; k < 100; ++k) groups.add(hard_samples<Real>(random, 3.0), true);
    set_signalling_nan(groups.samples.q[9]);
    set_signalling_nan(groups.samples.weights[groups.samples.weights.size() - 1]);
    CHECK(disturbance([&] { means_of(groups); }) == std::string("nothing"));
  });
}

}  // namespace
