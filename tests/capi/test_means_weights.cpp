// Weights of both means: none, zero, one-sided, and of every size.
#include "support/capi_handles.hpp"
#include "support/capi_means.hpp"
#include "support/catch.hpp"

using namespace capi;

TEST_CASE("C API: samples of weight 0 do not count at all", "[capi][means][weights]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(15);
    int left_out = 0;
    for (int set = 0; set < 300; ++set) {
      Samples<Real> samples = hard_samples<Real>(random, 3.0);
      samples.weights.resize(samples.count(), Real(1));
      for (Real& weight : samples.weights)
        if (random.uniform(0, 1) < 0.3) weight = random.uniform(0, 1) < 0.5 ? Real(-0.0) : Real(0);
      samples.weights.back() = 1;
      std::vector<size_t> counting;
      for (size_t i = 0; i < samples.count(); ++i)
        if (samples.weight(i) > 0) counting.push_back(i);
      left_out += static_cast<int>(samples.count() - counting.size());
      const Samples<Real> rest = chosen_rows(samples, counting);
      for (size_t k = 0; k < 2; ++k) {
        const Mean<Real> a = both_means(samples)[k], b = both_means(rest)[k];
        CHECK((a.status == b.status && a.eigengap == b.eigengap && a.residual == b.residual));
        CHECK(same_bits(a.q, b.q));
      }
    }
    CHECK(left_out > 300);
  });
}

TEST_CASE("C API: means depend on the ratios of the weights, up to the largest and the least numbers",
          "[capi][means][weights]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(16);
    const Real largest = std::numeric_limits<Real>::max(), least = std::numeric_limits<Real>::denorm_min();
    for (int set = 0; set < 100; ++set) {
      Samples<Real> samples = cloud<Real>(random, 20, 0.4);
      const Mean<Real> equal = eigen(samples), equal_karcher = karcher(samples);
      for (const Real weight : {Real(1), largest, least, std::numeric_limits<Real>::min()}) {
        samples.weights.assign(20, weight);
        CHECK(difference(eigen(samples).q, equal.q) <= 1e-15 + 2 * kHalfUlp<Real>);
        CHECK(difference(karcher(samples).q, equal_karcher.q) <= 1e-15 + 2 * kHalfUlp<Real>);
      }
      // weights against which the others vanish
      samples.weights.assign(20, least);
      samples.weights[7] = random.uniform(0, 1) < 0.5 ? largest : Real(1);
      const std::vector<Real> only(&samples.q[28], &samples.q[28] + 4);
      CHECK((eigen(samples).status == QTRAJ_OK && difference(eigen(samples).q, only) <= 4e-16 + 2 * kHalfUlp<Real>));
      CHECK(
          (karcher(samples).status == QTRAJ_OK && difference(karcher(samples).q, only) <= 4e-16 + 2 * kHalfUlp<Real>));
    }
  });
}

TEST_CASE("C API: a weight of 3 is three samples", "[capi][means][weights]") {
  test::Random random(17);
  for (int set = 0; set < 100; ++set) {
    Samples<double> once = cloud<double>(random, 10, 0.4), thrice = once;
    once.weights.assign(10, 1.0);
    once.weights[4] = 3.0;
    for (int copy = 0; copy < 2; ++copy)
      for (size_t k = 16; k < 20; ++k) thrice.q.push_back(copy == 0 ? thrice.q[k] : -thrice.q[k]);
    CHECK(difference(eigen(once).q, eigen(thrice).q) <= 1e-15);
    CHECK(difference(karcher(once).q, karcher(thrice).q) <= 1e-15);
  }
}
