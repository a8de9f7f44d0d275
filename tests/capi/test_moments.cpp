// Moments of samples in parts, and the mean that they have: its error against long double, merging, faults.
#include <qtraj.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <string>

#include "support/capi_batches.hpp"
#include "support/capi_floating.hpp"
#include "support/catch.hpp"
#include "support/long_double_means.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

using Moments = std::array<double, 11>;

template <class Real>
Samples<Real> rows_of(const Samples<Real>& samples, size_t first, size_t count) {
  std::vector<size_t> rows;
  for (size_t i = first; i < first + count; ++i) rows.push_back(i);
  return chosen_rows(samples, rows);
}
template <class Real>
qtraj_status add(const Samples<Real>& samples, Moments& moments, size_t* bad_index = nullptr) {
  return moments_add(samples.q.data(), samples.weights_or_null(), samples.count(), moments.data(), bad_index);
}
void merge(const Moments& from, Moments& to) {
  for (size_t k = 0; k < 11; ++k) to[k] += from[k];
}
Mean<double> mean_of(const Moments& moments) {
  Mean<double> mean;
  mean.status = qtraj_mean_from_moments(moments.data(), mean.q.data(), &mean.eigengap);
  return mean;
}

// Sum of the weights, and the upper triangle of sum w q q^T, in long double.
template <class Real>
std::array<wide::Real, 11> wide_moments(const Samples<Real>& samples) {
  std::array<wide::Real, 11> moments{};
  for (size_t i = 0; i < samples.count(); ++i) moments[0] += static_cast<wide::Real>(samples.weight(i));
  const wide::Matrix4 scatter = wide::scatter(samples);
  size_t at = 1;
  for (size_t row = 0; row < 4; ++row)
    for (size_t column = row; column < 4; ++column) moments[at++] = scatter[row][column];
  return moments;
}

TEST_CASE("C API: moments are exact to rounding, and the mean of them keeps its bound", "[capi][moments]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(21);
    double sum_error = 0, element_error = 0, mean_error = 0, gap_error = 0;
    int means = 0;
    for (int set = 0; set < 6000; ++set) {
      const Samples<Real> samples = hard_samples<Real>(random, set % 2 ? 3.0 : 0.5);
      Moments moments{};
      const qtraj_status status = add(samples, moments);
      REQUIRE(status == QTRAJ_OK);
      const std::array<wide::Real, 11> expected = wide_moments(samples);
      const double weight = static_cast<double>(expected[0]);
      const auto error = [&](size_t k) {
        return static_cast<double>(std::abs(static_cast<wide::Real>(moments[k]) - expected[k])) / weight;
      };
      test::raise_to(sum_error, error(0));
      for (size_t k = 1; k < 11; ++k) test::raise_to(element_error, error(k));
      const Mean<double> mean = mean_of(moments);
      if (mean.status == QTRAJ_E_AMBIGUOUS) continue;
      REQUIRE(mean.status == QTRAJ_OK);
      ++means;
      const wide::EigenMean wide_mean = wide::eigen_mean(wide::scatter(samples));
      const double gap = static_cast<double>(wide_mean.eigengap);
      test::raise_to(mean_error, difference(mean.q, wide_mean.q) / (4e-16 + 4e-16 / gap));
      test::raise_to(gap_error, std::abs(mean.eigengap - gap));
      CHECK(mean.q[0] >= 0);
    }
    CHECK(means > 5000);
    CHECK(sum_error <= DBL_EPSILON);
    CHECK(element_error <= 4e-16);
    CHECK(mean_error <= 1);
    CHECK(gap_error <= 2e-15);
  });
}

TEST_CASE("C API: moments of parts, merged in any way, have the mean of all", "[capi][moments]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(22);
    for (const double spread : {0.01, 0.5, 1.2}) {
      Samples<Real> samples = cloud<Real>(random, 3000, spread);
      for (size_t i = 0; i < samples.count(); ++i) samples.weights.push_back(static_cast<Real>(random.uniform(0, 5)));
      const wide::EigenMean expected = wide::eigen_mean(wide::scatter(samples));
      const double gap = static_cast<double>(expected.eigengap);
      const auto check = [&](const Moments& moments, double sums) {
        const Mean<double> mean = mean_of(moments);
        CHECK(mean.status == QTRAJ_OK);
        CHECK(difference(mean.q, expected.q) <= 4e-16 + (4e-16 + 1.2e-16 * sums) / gap);
        CHECK(std::abs(mean.eigengap - gap) <= 1e-15 + 4e-16 * sums);
      };
      Moments one_by_one{}, chain{};
      for (size_t i = 0; i < samples.count(); ++i) REQUIRE(add(rows_of(samples, i, 1), one_by_one) == QTRAJ_OK);
      check(one_by_one, 3000);
      std::vector<Moments> parts;
      for (size_t i = 0; i < samples.count(); i += 125) {
        parts.push_back({});
        REQUIRE(add(rows_of(samples, i, 125), parts.back()) == QTRAJ_OK);
        merge(parts.back(), chain);
      }
      check(chain, 24);
      for (size_t step = 1; step < parts.size(); step *= 2)
        for (size_t i = 0; i + step < parts.size(); i += 2 * step) merge(parts[i + step], parts[i]);
      check(parts[0], 5);
    }
  });
}

TEST_CASE("C API: moments without weights count their samples exactly", "[capi][moments]") {
  test::Random random(23);
  Moments moments{};
  for (int part = 0; part < 50; ++part) REQUIRE(add(cloud<double>(random, 37, 1.0), moments) == QTRAJ_OK);
  REQUIRE(add(cloud<float>(random, 1, 1.0), moments) == QTRAJ_OK);
  CHECK(moments[0] == 50 * 37 + 1);
}

TEST_CASE("C API: weights of every size keep their place in moments, to the end of the range", "[capi][moments]") {
  const double sizes[] = {DBL_MIN, 1e-300, 1e-3, 1, 1e300, DBL_MAX / 4};
  for (const double size : sizes) {
    Moments moments{};
    const double q[] = {3, 0, 0, 4, 4, 0, 0, 3}, weights[] = {size, 0};
    CHECK(qtraj_moments_add(q, weights, 2, moments.data(), nullptr) == QTRAJ_OK);
    CHECK(moments[0] == size);
    CHECK(std::abs(moments[1] / size - 0.36) <= 4e-16);
    CHECK(std::abs(moments[4] / size - 0.48) <= 4e-16);
    const Mean<double> mean = mean_of(moments);
    CHECK(mean.status == QTRAJ_OK);
    CHECK((std::abs(mean.q[0] - 0.6) <= 8e-16 && std::abs(mean.q[3] - 0.8) <= 8e-16));
  }
}

TEST_CASE("C API: a mean of moments has the sign that its rule says", "[capi][moments]") {
  const double quaternions[][4] = {{-1, 2, 0, 0}, {0, -1, 2, 0}, {0, 0, -3, 1}, {0, 0, 0, -1}};
  for (const auto& q : quaternions) {
    Moments moments{};
    REQUIRE(qtraj_moments_add(q, nullptr, 1, moments.data(), nullptr) == QTRAJ_OK);
    const Mean<double> mean = mean_of(moments);
    REQUIRE(mean.status == QTRAJ_OK);
    size_t first = 0;
    while (mean.q[first] == 0) ++first;
    CHECK(mean.q[first] > 0);
    CHECK(q[first] < 0);
  }
}

TEST_CASE("C API: a fault adds nothing to moments", "[capi][moments][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    struct Fault {
      qtraj_status status;
      Real component, weight;
    };
    Real signalling;
    set_signalling_nan(signalling);
    const Fault faults[] = {{QTRAJ_E_NOT_FINITE, static_cast<Real>(kNaN), 1},
                            {QTRAJ_E_NOT_FINITE, 1, static_cast<Real>(kInfinity)},
                            {QTRAJ_E_NOT_FINITE, 1, signalling},
                            {QTRAJ_E_ZERO_NORM, 0, 1},
                            {QTRAJ_E_ZERO_NORM, 0, 0},
                            {QTRAJ_E_NEGATIVE_WEIGHT, 1, -1}};
    for (const Fault& fault : faults)
      for (const size_t at : {size_t{0}, size_t{130}, size_t{299}}) {
        test::Random random(24);
        Samples<Real> samples = cloud<Real>(random, 300, 0.5);
        samples.weights.assign(300, 1);
        Moments moments{};
        REQUIRE(add(samples, moments) == QTRAJ_OK);
        const Moments before = moments;
        const Real q[] = {fault.component, 0, 0, 0};
        std::memcpy(&samples.q[4 * at], q, sizeof q);
        std::memcpy(&samples.weights[at], &fault.weight, sizeof(Real));
        size_t bad_index = 12345;
        CHECK(add(samples, moments, &bad_index) == fault.status);
        CHECK(bad_index == at);
        CHECK(moments == before);
      }
  });
}

TEST_CASE("C API: moments that overflow, or are not finite as they are, stay", "[capi][moments][errors]") {
  const double q[] = {1, 0, 0, 0, 0, 1, 0, 0}, large[] = {1e308, 1e308};
  Moments moments{};
  size_t bad_index = 12345;
  // one call, and the sum with what is there
  CHECK(qtraj_moments_add(q, large, 2, moments.data(), &bad_index) == QTRAJ_E_NOT_FINITE);
  CHECK(bad_index == SIZE_MAX);
  CHECK(moments == Moments{});
  CHECK(qtraj_moments_add(q, large, 1, moments.data(), nullptr) == QTRAJ_OK);
  const Moments before = moments;
  CHECK(qtraj_moments_add(q, large, 1, moments.data(), nullptr) == QTRAJ_E_NOT_FINITE);
  CHECK(moments == before);
  for (const double bad : {kNaN, kInfinity, -kInfinity})
    for (const size_t k : {size_t{0}, size_t{7}}) {
      Moments broken = before;
      broken[k] = bad;
      CHECK(qtraj_moments_add(q, nullptr, 2, broken.data(), &bad_index) == QTRAJ_E_NOT_FINITE);
      CHECK(bad_index == SIZE_MAX);
      CHECK(broken[1] == before[1]);
    }
}

TEST_CASE("C API: samples without weight add nothing, and no samples have no mean", "[capi][moments][errors]") {
  const double q[] = {1, 0, 0, 0, 0, 1, 0, 0}, nothing[] = {0, 0};
  Moments moments{};
  size_t bad_index = 12345;
  CHECK(qtraj_moments_add(q, nothing, 2, moments.data(), &bad_index) == QTRAJ_OK);
  CHECK((bad_index == SIZE_MAX && moments == Moments{}));
  CHECK(qtraj_moments_add(nullptr, nullptr, 0, nullptr, &bad_index) == QTRAJ_OK);
  CHECK(qtraj_moments_add(q, q, 0, moments.data(), &bad_index) == QTRAJ_OK);
  CHECK(moments == Moments{});
  const Mean<double> mean = mean_of(moments);
  CHECK(mean.status == QTRAJ_E_ZERO_NORM);
  CHECK((std::isnan(mean.q[0]) && std::isnan(mean.q[3]) && std::isnan(mean.eigengap)));
}

TEST_CASE("C API: moments judge their arguments in the order of the statuses", "[capi][moments][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Real q[16] = {1, 0, 0, 0}, weights[4] = {1};
    Moments moments{};
    size_t bad_index = 12345;
    constexpr size_t kMost = PTRDIFF_MAX;
    CHECK(moments_add(static_cast<Real*>(nullptr), weights, 1, moments.data(), &bad_index) == QTRAJ_E_NULL);
    CHECK(bad_index == SIZE_MAX);
    CHECK(moments_add(q, weights, SIZE_MAX, nullptr, &bad_index) == QTRAJ_E_NULL);
    CHECK(moments_add(q, weights, kMost / (4 * sizeof(Real)) + 1, moments.data(), &bad_index) == QTRAJ_E_SIZE);
    CHECK(moments_add(q, weights, 1, reinterpret_cast<double*>(q), &bad_index) == QTRAJ_E_OVERLAP);
    CHECK(moments_add(q, reinterpret_cast<Real*>(&moments[10]), 1, moments.data(), &bad_index) == QTRAJ_E_OVERLAP);
    CHECK((bad_index == SIZE_MAX && moments == Moments{} && q[0] == 1));
  });
}

TEST_CASE("C API: what are no moments has a status", "[capi][moments][errors]") {
  test::Random random(25);
  Moments good{};
  REQUIRE(add(cloud<double>(random, 50, 0.4), good) == QTRAJ_OK);
  const auto check = [&](qtraj_status expected, auto&& change) {
    Moments moments = good;
    change(moments);
    double mean[4] = {7, 7, 7, 7}, eigengap = 7;
    CHECK(qtraj_mean_from_moments(moments.data(), mean, &eigengap) == expected);
    const bool refused = expected == QTRAJ_E_VALUE;
    for (const double component : mean) CHECK((refused ? component == 7 : std::isnan(component)));
    CHECK((refused ? eigengap == 7 : std::isnan(eigengap)));
  };
  for (size_t k = 0; k < 11; ++k)
    for (const double bad : {kNaN, kInfinity, -kInfinity})
      check(QTRAJ_E_NOT_FINITE, [&](Moments& moments) { moments[k] = bad; });
  check(QTRAJ_E_NEGATIVE_WEIGHT, [](Moments& moments) { moments[0] = -moments[0]; });
  check(QTRAJ_E_NEGATIVE_WEIGHT, [](Moments& moments) {
    for (double& moment : moments) moment = -moment;
  });
  check(QTRAJ_E_ZERO_NORM, [](Moments& moments) { moments = {}; });
  // the trace is not the weight; a full matrix instead of its triangle; an eigenvalue below 0
  check(QTRAJ_E_VALUE, [](Moments& moments) { moments[0] *= 1 + 2e-8; });
  check(QTRAJ_E_VALUE, [](Moments& moments) { moments[0] = 0; });
  check(QTRAJ_E_VALUE, [](Moments& moments) { moments[10] = 0; });
  check(QTRAJ_E_VALUE, [](Moments& moments) { std::rotate(moments.begin(), moments.begin() + 1, moments.end()); });
  check(QTRAJ_E_VALUE, [](Moments& moments) { moments = {2, 1, 1.001, 0, 0, 1, 0, 0, 0, 0, 0}; });
  check(QTRAJ_E_VALUE, [](Moments& moments) { moments = {1, 1.5, 0, 0, 0, -0.5, 0, 0, 0, 0, 0}; });
  check(QTRAJ_E_VALUE, [](Moments& moments) { moments = {1e-300, 1e-300, 1e300, 0, 0, 0, 0, 0, 0, 0, 0}; });
  // rounding is no fault
  Moments rounded = good;
  for (double& moment : rounded) moment *= 1 + 1e-9;
  CHECK(mean_of(rounded).status == QTRAJ_OK);
  rounded[0] *= 1 + 5e-9;
  CHECK(mean_of(rounded).status == QTRAJ_OK);
  // a tie
  const double turns[] = {1, 0, 0, 0, 0, 0, 1, 0};
  Moments tie{};
  REQUIRE(qtraj_moments_add(turns, nullptr, 2, tie.data(), nullptr) == QTRAJ_OK);
  const Mean<double> mean = mean_of(tie);
  CHECK((mean.status == QTRAJ_E_AMBIGUOUS && mean.eigengap == 0));
  CHECK(std::abs(std::hypot(mean.q[0], mean.q[2]) - 1) < 1e-15);
  // arguments
  double out[11] = {};
  CHECK(qtraj_mean_from_moments(nullptr, out, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_mean_from_moments(good.data(), nullptr, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_mean_from_moments(good.data(), &good[8], nullptr) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_mean_from_moments(good.data(), out, &out[3]) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_mean_from_moments(good.data(), out, &good[0]) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_mean_from_moments(good.data(), out, nullptr) == QTRAJ_OK);
}

TEST_CASE("C API: moments leave the floating-point environment and errno alone, for every input", "[capi][moments]") {
  const std::string nothing = "nothing";
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    test::Random random(26);
    Moments moments{};
    for (int set = 0; set < 300; ++set) {
      Samples<Real> samples = hard_samples<Real>(random, 3.0);
      if (set % 3 == 0) set_signalling_nan(samples.q[1]);
      CHECK(disturbance([&] { (void)add(samples, moments); }) == nothing);
      CHECK(disturbance([&] { (void)mean_of(moments); }) == nothing);
    }
  });
  const double extremes[] = {0, 5e-324, DBL_MIN, 1, 1e300, DBL_MAX, -DBL_MAX, kNaN, -kInfinity};
  test::Random random(27);
  for (int set = 0; set < 2000; ++set) {
    Moments moments;
    for (double& moment : moments) moment = extremes[static_cast<size_t>(random.uniform(0, 8.999))];
    const double q[] = {1, 2, 3, 4}, weight[] = {extremes[set % 6]};
    CHECK(disturbance([&] { (void)mean_of(moments); }) == nothing);
    CHECK(disturbance([&] { (void)qtraj_moments_add(q, weight, 1, moments.data(), nullptr); }) == nothing);
  }
}

}  // namespace
