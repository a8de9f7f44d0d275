// The Karcher mean: accuracy, steps, and which sets are ambiguous.
#include <algorithm>
#include <cfloat>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/karcher_search.hpp"
#include "support/long_double_means.hpp"

using namespace capi;

namespace {

struct Worst {
  int sets = 0, ok = 0, ambiguous = 0;
  double error = 0, norm_error = 0, wrong_sign = 0, residual = 0;
};

// Errors in units of the promise, residuals in units of the floor.
template <class Real>
Worst worst_of_karcher(int sets, double widest) {
  const auto eps = static_cast<double>(std::numeric_limits<Real>::epsilon());
  test::Random random(21);
  Worst worst;
  for (; worst.sets < sets; ++worst.sets) {
    const Samples<Real> samples = hard_samples<Real>(random, widest);
    const Mean<Real> mean = karcher(samples);
    if (mean.status == QTRAJ_E_AMBIGUOUS) ++worst.ambiguous;
    if (mean.status != QTRAJ_OK) continue;
    ++worst.ok;
    const wide::Quaternion q = wide::quaternion(mean.q.data());
    const wide::KarcherMean expected = wide::karcher_mean(samples, q, 2);
    const double promise = 6e-16 / static_cast<double>(expected.curvature) + kHalfUlp<Real>;
    test::raise_to(worst.error, difference(mean.q, expected.q) / promise);
    test::raise_to(worst.norm_error, std::abs(static_cast<double>(wide::norm(q)) - 1) / eps);
    test::raise_to(worst.residual, mean.residual / (4 * eps));
    size_t first = 0;
    while (samples.weight(first) == 0) ++first;
    const wide::Quaternion first_q = wide::normalized(wide::quaternion(&samples.q[4 * first]));
    test::raise_to(worst.wrong_sign, -static_cast<double>(wide::dot(first_q, q)) / eps);
  }
  return worst;
}

}  // namespace

TEST_CASE("C API: the Karcher mean keeps its error bound on random and singular samples", "[capi][means][karcher]") {
  for (const double widest : {0.5, 3.0})
    for (const Worst& worst : {worst_of_karcher<double>(2500, widest), worst_of_karcher<float>(1000, widest)}) {
      CAPTURE(widest, worst.sets, worst.ok, worst.ambiguous);
      CHECK(worst.ok + worst.ambiguous == worst.sets);
      CHECK((widest < 1 ? worst.ambiguous == 0 : worst.ok > worst.sets / 2));
      CHECK(worst.error <= 1.0);
      CHECK(worst.norm_error <= 4.0);
      CHECK(worst.wrong_sign <= 4.0);
      CHECK(worst.residual <= 2.0);
    }
}

TEST_CASE("C API: sets with a spread of up to half a radian an axis all have a proven mean", "[capi][means][karcher]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(22);
    int proven = 0, most_iterations = 0;
    for (int set = 0; set < 3000; ++set) {
      const auto count = static_cast<size_t>(random.uniform(3, 31));
      const Mean<Real> mean = karcher(cloud<Real>(random, count, set % 2 == 0 ? 0.5 : random.uniform(0, 0.5)));
      proven += mean.status == QTRAJ_OK;
      most_iterations = std::max(most_iterations, mean.iterations);
    }
    CHECK(proven == 3000);
    CHECK(most_iterations <= 5);
  });
}

TEST_CASE("C API: the Karcher mean of two divides their arc by their weights", "[capi][means][karcher]") {
  test::Random random(23);
  for (int set = 0; set < 1000; ++set) {
    const test::Quaternion a = random.orientation();
    const test::Vector axis = random.direction();
    const double angle = random.uniform(0, 3.14), weight = random.uniform(0, 5);
    Samples<double> samples;
    samples.add(a, 1.0);
    samples.add(test::multiply(a, test::about(axis, angle)), weight);
    const Mean<double> mean = karcher(samples);
    // closer to a half turn the proof may fail, not the mean
    CHECK((mean.status == QTRAJ_OK || (mean.status == QTRAJ_E_AMBIGUOUS && angle > 2.6)));
    CHECK(difference(mean.q, test::multiply(a, test::about(axis, angle * weight / (1 + weight)))) <= 1e-15);
  }
}

TEST_CASE("C API: two samples are ambiguous at any weights where their half angle is a right angle to 64 eps",
          "[capi][means][karcher][singular]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const auto eps = static_cast<double>(std::numeric_limits<Real>::epsilon());
    for (const double weight : {1.0, 0.5, 0.01, 1e-6, 1e-12, 1e-30})
      for (const double off : {-1e3, -100.0, -70.0, -50.0, -1.0, 0.0, 1.0, 50.0, 70.0, 100.0, 1e3}) {
        CAPTURE(weight, off);
        Samples<Real> samples;
        samples.add({1, 0, 0, 0}, 1.0);
        samples.add({off * eps, 0, 1, 0}, weight);
        const qtraj_status status = karcher(samples).status;
        if (std::abs(off) < 64) CHECK(status == QTRAJ_E_AMBIGUOUS);
        if (std::abs(off) > 64 && (weight == 1 || weight < 1e-20)) CHECK(status == QTRAJ_OK);
      }
  });
}

TEST_CASE("C API: the tolerance ends the steps, 0 is 4 eps, and iterations and residual tell of them",
          "[capi][means][karcher]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const double floor = 4 * static_cast<double>(std::numeric_limits<Real>::epsilon());
    test::Random random(24);
    for (int set = 0; set < 200; ++set) {
      const Samples<Real> samples = cloud<Real>(random, 20, 0.45);
      const Mean<Real> exact = karcher(samples);
      REQUIRE((exact.status == QTRAJ_OK && exact.iterations > 1));
      for (const double tolerance : {-0.0, 5e-324, 0.9 * floor, floor}) {
        const Mean<Real> mean = karcher(samples, tolerance);
        CHECK((same_bits(mean.q, exact.q) && mean.iterations == exact.iterations && mean.residual == exact.residual));
      }
      int32_t iterations = exact.iterations;
      for (const double tolerance : {1e-6, 1e-3, 0.1, DBL_MAX}) {
        const Mean<Real> mean = karcher(samples, tolerance);
        CHECK((mean.status == QTRAJ_OK && mean.residual <= tolerance && mean.iterations <= iterations));
        CHECK(difference(mean.q, exact.q) <= std::min(tolerance, 0.01) + floor);
        iterations = mean.iterations;
      }
      CHECK(iterations == 1);
    }
  });
}

// Three samples at 60 degrees of one great circle but for 1e-8: one of the starts is so near a saddle without curvature
// that its descent takes millions of steps.
TEST_CASE("C API: descents that only serve the proof do not go on to max_iterations", "[capi][means][karcher]") {
  for (const uint64_t seed : {204u, 453u, 472u, 710u, 1213u}) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<double> q;
    for (int i = 0; i < 3; ++i) {
      const double angle = i * 3.141592653589793 / 3;
      q.insert(q.end(), {std::cos(angle), std::sin(angle), 1e-8 * random.uniform(-1, 1), 0});
    }
    const auto mean_within = [&](int32_t most) {
      std::vector<double> result(5);
      int32_t iterations = 0;
      CHECK(qtraj_mean_karcher(q.data(), nullptr, 3, 0, most, result.data(), &iterations, &result[4], nullptr) ==
            QTRAJ_E_AMBIGUOUS);
      CHECK(iterations <= 10);
      return result;
    };
    // 20 minutes if they did
    CHECK(mean_within(INT32_MAX) == mean_within(100));
  }
}

TEST_CASE("C API: a Karcher mean that runs out of iterations is NO_CONVERGENCE and leaves the last iterate",
          "[capi][means][karcher]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const auto eps = static_cast<double>(std::numeric_limits<Real>::epsilon());
    test::Random random(25);
    for (int set = 0; set < 200; ++set) {
      const Samples<Real> samples = cloud<Real>(random, 10, 0.5);
      const UnitSamples units = unit_samples(samples);
      const Mean<Real> exact = karcher(samples);
      REQUIRE(exact.status == QTRAJ_OK);
      Mean<Real> before = eigen(samples);
      for (int32_t limit = 1; limit < exact.iterations; ++limit) {
        const Mean<Real> mean = karcher(samples, 0, limit);
        CHECK((mean.status == QTRAJ_E_NO_CONVERGENCE && mean.iterations == limit && mean.bad_index == SIZE_MAX));
        // one step further and no higher
        const double step = 2 * std::asin(0.5 * std::sqrt(squared_distance(mean.q, before.q)));
        CHECK(std::abs(mean.residual - step) <= 4 * eps);
        const double f[] = {squares_at(units, before.q.data()), squares_at(units, mean.q.data())};
        CHECK(f[1] <= f[0] + 16 * eps);
        before = mean;
      }
      const Mean<Real> enough = karcher(samples, 0, exact.iterations);
      CHECK((enough.status == QTRAJ_OK && same_bits(enough.q, exact.q)));
      CHECK(same_bits(karcher(samples, 0, INT32_MAX).q, exact.q));
    }
  });
}
