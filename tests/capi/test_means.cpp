// Both means: the eigen mean's accuracy, and what holds for signs, order, weights and numbers of samples.
#include <algorithm>
#include <cfloat>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/long_double_means.hpp"

using namespace capi;

namespace {

template <class Real>
double dot_with(const Samples<Real>& samples, size_t i, const std::array<Real, 4>& mean) {
  const wide::Quaternion q = wide::normalized(wide::quaternion(&samples.q[4 * i]));
  return static_cast<double>(wide::dot(q, wide::quaternion(mean.data())));
}

// The first sample that counts.
template <class Real>
size_t first_weighted(const Samples<Real>& samples) {
  size_t i = 0;
  while (samples.weight(i) == 0) ++i;
  return i;
}

template <class Real>
bool same_bits_but_sign(const std::array<Real, 4>& a, const std::array<Real, 4>& b) {
  std::array<Real, 4> negated;
  for (size_t k = 0; k < 4; ++k) negated[k] = -b[k];
  return same_bits(a, b) || same_bits(a, negated);
}

// Samples of components 0, 1 and -1: many of them exactly a half turn from others and from the mean.
template <class Real>
Samples<Real> half_turns(test::Random& random) {
  Samples<Real> samples;
  const double count = random.uniform(1, 6);
  while (static_cast<double>(samples.count()) < count) {
    test::Quaternion q;
    for (double& component : q) component = std::floor(random.uniform(-1, 2));
    if (q != test::Quaternion{0, 0, 0, 0}) samples.add(q);
  }
  return samples;
}

struct Worst {
  int sets = 0, ambiguous = 0;
  double error = 0, gap_error = 0, norm_error = 0, wrong_sign = 0;
};

// Of the eigen mean; its error in units of the promise.
template <class Real>
Worst worst_of_eigen(int sets, double widest) {
  test::Random random(11);
  Worst worst;
  for (; worst.sets < sets; ++worst.sets) {
    const Samples<Real> samples = hard_samples<Real>(random, widest);
    const Mean<Real> mean = eigen(samples);
    if (mean.status == QTRAJ_E_AMBIGUOUS) ++worst.ambiguous;
    if (mean.status != QTRAJ_OK) continue;
    const wide::EigenMean expected = wide::eigen_mean(wide::scatter(samples));
    const double gap = static_cast<double>(expected.eigengap), promise = 4e-16 + 4e-16 / gap + kHalfUlp<Real>;
    test::raise_to(worst.error, difference(mean.q, expected.q) / promise);
    test::raise_to(worst.gap_error, std::abs(mean.eigengap - gap));
    const double norm = static_cast<double>(wide::norm(wide::quaternion(mean.q.data())));
    test::raise_to(worst.norm_error, std::abs(norm - 1) / double(std::numeric_limits<Real>::epsilon()));
    test::raise_to(worst.wrong_sign, -dot_with(samples, first_weighted(samples), mean.q));
  }
  return worst;
}

}  // namespace

TEST_CASE("C API: the eigen mean keeps its error bound on random and singular samples", "[capi][means]") {
  for (const double widest : {0.5, 3.0}) {
    const Worst worst = worst_of_eigen<double>(10000, widest), worst_f32 = worst_of_eigen<float>(5000, widest);
    for (const Worst& of : {worst, worst_f32}) {
      CAPTURE(widest, of.sets, of.ambiguous);
      CHECK(of.ambiguous == 0);
      CHECK(of.error <= 1.0);
      CHECK(of.gap_error <= 2e-15);
      CHECK(of.norm_error <= 4.0);
    }
    CHECK(worst.wrong_sign <= 1e-15);
    CHECK(worst_f32.wrong_sign <= 1e-7);
  }
}

TEST_CASE("C API: means of a million samples are as good as those of a few", "[capi][means]") {
  // a thousand samples a thousand times: the exact means are those of the thousand
  test::Random random(12);
  Samples<float> thousand = cloud<float>(random, 1000, 0.4), million;
  for (int i = 0; i < 1000; ++i) thousand.weights.push_back(static_cast<float>(random.uniform(0, 2)));
  for (int copy = 0; copy < 1000; ++copy) {
    million.q.insert(million.q.end(), thousand.q.begin(), thousand.q.end());
    million.weights.insert(million.weights.end(), thousand.weights.begin(), thousand.weights.end());
  }
  const Samples<double> same = {{million.q.begin(), million.q.end()}, {million.weights.begin(), million.weights.end()}};
  const auto [eigen_mean, karcher_mean] = both_means(same);
  REQUIRE((eigen_mean.status == QTRAJ_OK && karcher_mean.status == QTRAJ_OK));
  const wide::Quaternion found = wide::quaternion(karcher_mean.q.data());
  CHECK(difference(eigen_mean.q, wide::eigen_mean(wide::scatter(thousand)).q) <= 1e-15);
  CHECK(difference(karcher_mean.q, wide::karcher_mean(thousand, found, 2).q) <= 1e-15);

  const auto [eigen_f32, karcher_f32] = both_means(million);
  CHECK((eigen_f32.status == QTRAJ_OK && karcher_f32.status == QTRAJ_OK));
  CHECK(difference(eigen_f32.q, eigen_mean.q) <= 0x1p-25);
  CHECK(difference(karcher_f32.q, karcher_mean.q) <= 0x1p-25 + 1e-12);
  CHECK(eigen_f32.eigengap == eigen_mean.eigengap);
}

TEST_CASE("C API: signs of the samples change no bit of a mean but its sign", "[capi][means]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(13);
    for (int set = 0; set < 500; ++set) {
      const Samples<Real> samples = set % 2 == 0 ? hard_samples<Real>(random, 3.0) : half_turns<Real>(random);
      Samples<Real> flipped = samples;
      for (size_t i = 0; i < samples.count(); ++i)
        if (random.uniform(-1, 1) < 0)
          for (size_t k = 4 * i; k < 4 * i + 4; ++k) flipped.q[k] = -flipped.q[k];
      for (size_t k = 0; k < 2; ++k) {
        const Mean<Real> a = both_means(samples)[k], b = both_means(flipped)[k];
        CHECK((a.status == b.status && a.eigengap == b.eigengap && a.iterations == b.iterations));
        CHECK(same_bits_but_sign(a.q, b.q));
      }
    }
  });
}

TEST_CASE("C API: the order of the samples changes a mean by rounding only", "[capi][means]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(14);
    for (int set = 0; set < 500; ++set) {
      const Samples<Real> samples = hard_samples<Real>(random, set % 2 == 0 ? 0.5 : 3.0);
      std::vector<size_t> order(samples.count());
      for (size_t i = 0; i < order.size(); ++i) order[i] = i;
      for (size_t i = order.size(); i-- > 1;)
        std::swap(order[i], order[static_cast<size_t>(random.uniform(0, static_cast<double>(i + 1)))]);
      const Samples<Real> shuffled = chosen_rows(samples, order);
      const Mean<Real> a = eigen(samples), b = eigen(shuffled);
      CHECK((a.status == QTRAJ_OK && b.status == QTRAJ_OK));
      CHECK(difference(a.q, b.q) <= 8e-16 + 8e-16 / a.eigengap + 2 * kHalfUlp<Real>);
      const Mean<Real> c = karcher(samples), d = karcher(shuffled);
      CHECK(c.status == d.status);
      if (c.status == QTRAJ_OK) CHECK(difference(c.q, d.q) <= 2e-15 + 2 * kHalfUlp<Real>);
    }
  });
}

TEST_CASE("C API: a weight of 1e-334 of the largest still gives the mean its sign", "[capi][means]") {
  const double q[] = {-1, 0, 0, 0, 1, 0.1, 0, 0}, weights[] = {5e-324, 1e10};
  double eigen[4], karcher[4];
  REQUIRE(qtraj_mean_eigen(q, weights, 2, eigen, nullptr, nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_mean_karcher(q, weights, 2, 0, 100, karcher, nullptr, nullptr, nullptr) == QTRAJ_OK);
  CHECK(eigen[0] < 0);
  CHECK(karcher[0] < 0);
}

TEST_CASE("C API: a mean has the sign of the first sample that counts", "[capi][means]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const double first : {1.0, -1.0})
      for (const double second : {1.0, -1.0})
        for (size_t k = 0; k < 2; ++k) {
          Samples<Real> samples;
          samples.add({first, 0.1, 0, 0}, 1);
          samples.add({second, 0, 0.1, 0}, 3);
          CHECK(static_cast<double>(both_means(samples)[k].q[0]) * first > 0.9);
          samples.weights[0] = 0;
          CHECK(static_cast<double>(both_means(samples)[k].q[0]) * second > 0.9);
          // a first sample at a right angle to the mean, in R^4, says nothing
          samples.q[0] = samples.q[2] = 0;
          samples.q[1] = 1;
          samples.q[6] = 0;
          samples.weights = {Real(0.125), 3};
          const Mean<Real> right_angle = eigen(samples);
          CHECK((right_angle.status == QTRAJ_OK && static_cast<double>(right_angle.q[0]) == second));
        }
  });
}

TEST_CASE("C API: one sample of any norm is its own mean", "[capi][means][singular]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(18);
    const double decades = sizeof(Real) == sizeof(double) ? 160 : 30;
    for (int set = 0; set < 1000; ++set) {
      Samples<Real> samples;
      samples.add(test::scaled(test::hard_norm(random, decades), test::hard_orientation(random)));
      for (const Real weight : {Real(1), Real(1e-30)}) {
        if (weight < 1) samples.weights = {weight};
        const Mean<Real> a = eigen(samples), b = karcher(samples);
        const wide::Quaternion expected = wide::normalized(wide::quaternion(samples.q.data()));
        CHECK((a.status == QTRAJ_OK && b.status == QTRAJ_OK && b.iterations == 1));
        CHECK((wide::error(a.q.data(), expected) <= 6e-16 + kHalfUlp<Real>));
        CHECK((wide::error(b.q.data(), expected) <= 6e-16 + kHalfUlp<Real>));
        CHECK((a.eigengap > 1 - 2e-15 && a.eigengap <= 1 && b.residual <= 1e-15));
      }
    }
    for (const Real extreme : {std::numeric_limits<Real>::max(), std::numeric_limits<Real>::denorm_min()}) {
      const Samples<Real> samples = {{extreme, 0, -extreme, 0}, {}};
      for (const Mean<Real>& mean : {eigen(samples), karcher(samples)}) {
        CHECK((mean.status == QTRAJ_OK && mean.q[0] > 0));
        CHECK(difference(mean.q, std::array<double, 4>{std::sqrt(0.5), 0, -std::sqrt(0.5), 0}) <=
              4e-16 + kHalfUlp<Real>);
      }
    }
  });
}

TEST_CASE("C API: evenly spread samples and two a half turn apart have no one mean", "[capi][means][singular]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Samples<Real> four, two;
    for (size_t k = 0; k < 4; ++k) {
      test::Quaternion q = {0, 0, 0, 0};
      q[k] = 1;
      four.add(q);
      if (k < 2) two.add(q);
    }
    for (const Mean<Real>& mean : {eigen(four), karcher(four), eigen(two), karcher(two)}) {
      CHECK((mean.status == QTRAJ_E_AMBIGUOUS && mean.bad_index == SIZE_MAX));
      double square = 0;
      for (const Real component : mean.q) square += static_cast<double>(component) * static_cast<double>(component);
      CHECK(std::abs(square - 1) <= 4 * static_cast<double>(std::numeric_limits<Real>::epsilon()));
      CHECK(mean.q[0] >= 0);
    }
    CHECK(eigen(four).eigengap == 0);
    // the best Karcher mean of two is half way
    CHECK(std::abs(std::abs(karcher(two).q[0]) - std::sqrt(Real(0.5))) <= std::numeric_limits<Real>::epsilon());

    // for the eigen mean any difference of weights decides, beyond 64 eps
    const Real eps = std::numeric_limits<Real>::epsilon();
    two.weights = {Real(1), Real(1) + 120 * eps};
    CHECK(eigen(two).status == QTRAJ_E_AMBIGUOUS);
    two.weights[1] = Real(1) + 136 * eps;
    CHECK((eigen(two).status == QTRAJ_OK && std::abs(eigen(two).q[1]) == 1));
    for (const Real weight :
         {Real(0.5), Real(1e-3), Real(1e-9), Real(1e-30), std::numeric_limits<Real>::denorm_min()}) {
      two.weights[1] = weight;
      CHECK((eigen(two).status == QTRAJ_OK && karcher(two).status == QTRAJ_E_AMBIGUOUS));
    }
  });
}
