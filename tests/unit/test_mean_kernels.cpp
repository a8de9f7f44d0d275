// Means in the vectors of every kernel: the same bits whatever the vectors' width (Karcher's in the kernels of a kind),
// whether samples are summed in the caller's arrays or one by one, and nothing but the caller's arrays is read.
#include <qtraj.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "rows/logs.hpp"
#include "support/capi_means.hpp"
#include "support/guarded.hpp"
#include "support/kernel_curves.hpp"
#include "support/random.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<LogRows> kLogKernels[] = QTRAJ_OF_EACH_TARGET(add_logs);

}  // namespace
}  // namespace qtraj

namespace {

using capi::Samples;
using test::Guarded;
using test::Random;

constexpr size_t kMost = 300;  // samples: more than two blocks

// A cloud of samples of any norm and sign, of which one in `rare` is of a size or weight that vectors do not do; with
// `faults` some of these are at fault.
template <class Real>
Samples<Real> samples(Random& random, size_t count, bool weighted, int rare, bool faults) {
  constexpr double kTiny = sizeof(Real) == 4 ? 1e-37 : 1e-300, kHuge = 1 / kTiny;
  const double factors[] = {0x1p100, kTiny, -kHuge, 3, HUGE_VAL, 0}, weights[] = {0, 1, 1e-30, -0.0, std::nan(""), -1};
  Samples<Real> all = capi::cloud<Real>(random, count, 0.3);
  for (size_t i = 0; i < count; ++i) {
    double factor = random.uniform(-2, 2), weight = random.uniform(0.1, 3);
    if (random.uniform(0, rare) < 1) {
      const auto kind = static_cast<size_t>(random.uniform(0, faults ? 6 : 4));
      factor *= factors[kind], weight *= weights[(kind + 2 * i) % (faults ? 6 : 4)];
    }
    for (size_t k = 4 * i; k < 4 * i + 4; ++k)
      if (all.q[k] != 0) all.q[k] = static_cast<Real>(factor * static_cast<double>(all.q[k]));
    if (weighted) all.weights.push_back(static_cast<Real>(weight));
  }
  return all;
}

// Status and index of the first sample at fault; OK and SIZE_MAX without.
std::pair<qtraj_status, size_t> first_fault(const Samples<double>& all) {
  bool has_weight = false;
  for (size_t i = 0; i < all.count(); ++i) {
    const double* q = &all.q[4 * i];
    const double weight = all.weight(i);
    if (!std::all_of(q, q + 4, [](double x) { return std::isfinite(x); }) || !std::isfinite(weight))
      return {QTRAJ_E_NOT_FINITE, i};
    if (std::all_of(q, q + 4, [](double x) { return x == 0; })) return {QTRAJ_E_ZERO_NORM, i};
    if (weight < 0) return {QTRAJ_E_NEGATIVE_WEIGHT, i};
    has_weight = has_weight || weight > 0;
  }
  return {has_weight ? QTRAJ_OK : QTRAJ_E_ZERO_NORM, SIZE_MAX};
}

// All that both means return, as bits.
using Bits = std::vector<uint64_t>;
void add_bits(Bits& bits, double value) {
  uint64_t of_value;
  std::memcpy(&of_value, &value, sizeof value);
  bits.push_back(of_value);
}
template <class Real>
Bits bits_of_mean(bool is_karcher, const Real* q, const Real* weights, size_t count) {
  Bits bits;
  std::array<Real, 4> mean{};
  double scalar = 0;
  int32_t iterations = 0;
  size_t bad_index = 0;
  bits.push_back(static_cast<uint64_t>(
      is_karcher ? capi::mean_karcher(q, weights, count, 0, 100, mean.data(), &iterations, &scalar, &bad_index)
                 : capi::mean_eigen(q, weights, count, mean.data(), &scalar, &bad_index)));
  for (const Real component : mean) add_bits(bits, static_cast<double>(component));
  add_bits(bits, scalar);
  bits.push_back(static_cast<uint64_t>(iterations));
  bits.push_back(bad_index);
  return bits;
}
template <class Real>
Bits bits_of_means(const Samples<Real>& of) {
  Bits bits = bits_of_mean(false, of.q.data(), of.weights_or_null(), of.count());
  const Bits of_karcher = bits_of_mean(true, of.q.data(), of.weights_or_null(), of.count());
  bits.insert(bits.end(), of_karcher.begin(), of_karcher.end());
  return bits;
}

std::vector<size_t> counts() {
  std::vector<size_t> all;
  for (size_t count = 0; count <= 72; ++count) all.push_back(count);
  for (const size_t count : {120, 127, 128, 129, 130, 135, 136, 137, 200, 255, 256, 257, 264, 299, 300})
    all.push_back(count);
  return all;
}

// Every set of samples there is, and what the first kernel that may have these bits makes of it.
template <class Real>
struct Case {
  Samples<Real> samples;
  Bits eigen, karcher_fused, karcher_plain;

  // Whether they are those of the kernels before.
  bool is_same(bool is_fused, const Bits& of_eigen, const Bits& of_karcher) {
    Bits& karcher = is_fused ? karcher_fused : karcher_plain;
    if (eigen.empty()) eigen = of_eigen;
    if (karcher.empty()) karcher = of_karcher;
    return of_eigen == eigen && of_karcher == karcher;
  }
};
template <class Real>
std::vector<Case<Real>> cases() {
  std::vector<Case<Real>> all;
  Random random(51);
  for (const size_t count : counts())
    for (const bool weighted : {true, false})
      for (const int rare : {1, 4, 40, 1000000})
        for (const bool faults : {false, true})
          all.push_back({samples<Real>(random, count, weighted, rare, faults), {}, {}, {}});
  return all;
}

template <class Real>
void check_in_every_kernel() {
  std::vector<Case<Real>> all = cases<Real>();
  Guarded<Real> q(4 * kMost), weights(kMost);
  test::for_every_kernel([&](const char* target) {
    size_t wrong = 0;
    for (Case<Real>& c : all)
      for (const bool at_end : {true, false}) {
        const size_t count = c.samples.count();
        Real *placed = q.array(4 * count, at_end), *placed_weights = weights.array(count, at_end);
        // as bytes: a float that is a NaN keeps its bits
        if (count > 0) std::memcpy(placed, c.samples.q.data(), 4 * count * sizeof(Real));
        const bool weighted = !c.samples.weights.empty();
        if (weighted) std::memcpy(placed_weights, c.samples.weights.data(), count * sizeof(Real));
        const Real* given = weighted ? placed_weights : nullptr;
        wrong += !c.is_same(test::is_fused(target), bits_of_mean(false, placed, given, count),
                            bits_of_mean(true, placed, given, count));
      }
    CHECK(wrong == 0);
  });
}

// All that a pass over the samples adds up.
Bits bits_of_sums(const qtraj::LogSums& of) {
  Bits bits;
  add_bits(bits, of.largest_square);
  for (size_t term = 0; term < std::size(of.sums.totals); ++term) add_bits(bits, of.sums.value(term));
  return bits;
}

}  // namespace

TEST_CASE("means are the same bits in every kernel, Karcher's of a kind, and only the samples are read",
          "[mean_kernels]") {
  check_in_every_kernel<double>();
  check_in_every_kernel<float>();
}

TEST_CASE("components of 2 and more are told by their bits", "[mean_kernels]") {
  const auto reaches_two = [](double a, double b) {
    const double q[] = {0.0, a, -0.0, b};
    return qtraj::reaches_two(q);
  };
  const double below = std::nextafter(2.0, 0.0);
  CHECK_FALSE((reaches_two(below, -below) || reaches_two(5e-324, 0.0)));
  for (const double large : {2.0, 3.0, 1e300, HUGE_VAL, std::nan("")})
    CHECK((reaches_two(large, 1.0) && reaches_two(1.0, -large) && reaches_two(-large, large)));
}

TEST_CASE("the sums of logs are those of one sample after the other in the kernel's arithmetic", "[mean_kernels]") {
  test::for_every_kernel([](const char* target) {
    Random random(55);
    const auto one_by_one =
        test::is_fused(target) ? qtraj::add_logs<qtraj::Fused, double> : qtraj::add_logs<qtraj::Plain, double>;
    for (const int rare : {20, 1000000}) {
      // without any that vectors leave to the core
      Samples<double> all = samples<double>(random, 296, true, 1000000, false);
      for (size_t k = 0; k < all.q.size(); k += 4)
        if (random.uniform(0, rare) < 1) std::fill_n(&all.q[k + 1], 3, 0.0);
      for (const double* weights : {static_cast<const double*>(nullptr), all.weights_or_null()}) {
        const size_t count = all.count();
        const qtraj::SampleRows rows = {qtraj::input<4>(all.q.data(), count), qtraj::input<1>(weights, count), 1.0,
                                        false, false};
        const double base[4] = {0, 0.6, 0, 0.8};
        qtraj::LogSums sums, expected;
        CHECK(qtraj::kLogKernels[qtraj::target()]({rows, base, &sums}, 0, count) == count);
        CHECK(one_by_one({rows, base, &expected}, 0, count) == count);
        CHECK(bits_of_sums(sums) == bits_of_sums(expected));
      }
    }
  });
}

TEST_CASE("means name the first sample at fault, in whichever block it is", "[mean_kernels]") {
  test::for_every_kernel([](const char*) {
    Random random(54);
    size_t at_fault = 0, wrong = 0;
    for (int set = 0; set < 1000; ++set) {
      const auto count = static_cast<size_t>(random.uniform(1, kMost));
      const Samples<double> all = samples<double>(random, count, set % 2 == 0, set % 200 + 2, true);
      const auto [status, index] = first_fault(all);
      at_fault += status != QTRAJ_OK;
      for (const capi::Mean<double>& mean : capi::both_means(all)) {
        wrong += mean.bad_index != index;
        wrong += (status != QTRAJ_OK || mean.status != QTRAJ_E_AMBIGUOUS) && mean.status != status;
      }
    }
    CHECK(wrong == 0);
    CHECK(at_fault > 400);
  });
}

TEST_CASE("samples of any magnitude have the mean of those a power of two smaller, bit by bit", "[mean_kernels]") {
  test::for_every_kernel([](const char*) {
    Random random(52);
    for (const size_t count : counts()) {
      const Samples<float> one = samples<float>(random, count, true, 1000000, false);
      Samples<float> all = one, some = one;
      for (size_t k = 0; k < all.q.size(); ++k) {
        all.q[k] *= 0x1p122f;
        if (k / 4 % 100 == 50) some.q[k] *= 0x1p122f;
      }
      CAPTURE(count);
      CHECK(bits_of_means(all) == bits_of_means(one));
      CHECK(bits_of_means(some) == bits_of_means(one));
    }
  });
}

TEST_CASE("samples without weight leave no bit of a mean changed, wherever they stand", "[mean_kernels]") {
  test::for_every_kernel([](const char*) {
    Random random(53);
    for (const size_t count : counts()) {
      if (count == 0) continue;
      const Samples<double> one = samples<double>(random, count, true, 1000000, false);
      Samples<double> with_others;
      for (size_t i = 0; i < count; ++i) {
        while (random.uniform(0, 60) < 1) with_others.add(random.orientation(), random.uniform(-1, 1) < 0 ? -0.0 : 0.0);
        with_others.add({one.q[4 * i], one.q[4 * i + 1], one.q[4 * i + 2], one.q[4 * i + 3]}, one.weights[i]);
      }
      CAPTURE(count, with_others.count());
      CHECK(bits_of_means(with_others) == bits_of_means(one));
    }
  });
}
