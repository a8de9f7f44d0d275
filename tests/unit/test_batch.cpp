// Batches of every kernel: neither split nor order nor place in memory changes a bit of a sample.
#include <numeric>
#include <set>

#include "support/kernel_curves.hpp"

namespace {

using test::Arrays;
using test::KernelCurve;
using test::OwnRows;
using test::Request;

// Runs, then jumps; the later ones outside the knots now and then.
std::vector<double> mixed_times(const std::vector<double>& knots, size_t count) {
  test::Random random(count);
  const double first = knots.front(), span = knots.back() - first;
  std::vector<double> times;
  while (times.size() < count / 2)
    times.push_back(first + 0.1 * span * static_cast<double>(times.size()) / static_cast<double>(count));
  while (times.size() < count) times.push_back(first + random.uniform(-0.1, 1.1) * span);
  return times;
}

template <class Real>
size_t different_rows(const Arrays<Real>& a, const Arrays<Real>& b, size_t count) {
  size_t different = 0;
  for (size_t row = 0; row < count; ++row) different += !same_row(a, b, row);
  return different;
}

// Calls body(curve, request, zero of the type) for every kernel, evaluator, type and request.
template <class Body>
void for_every_call(Body&& body) {
  const std::vector<KernelCurve> curves = test::kernel_curves(QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE);
  test::for_every_kernel([&](const char*) {
    for (const KernelCurve& curve : curves)
      for (const Request& request : test::kRequests) {
        CAPTURE(curve.name, request.q, request.omega, request.alpha, request.frame);
        body(curve, request, double());
        body(curve, request, float());
      }
  });
}

}  // namespace

TEST_CASE("the curves of these tests reach every evaluator", "[batch]") {
  std::set<std::pair<qtraj::SegmentKind, qtraj::ExponentRange>> reached;
  for (const KernelCurve& curve : test::kernel_curves(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR))
    reached.insert({curve.core().kind, curve.core().range});
  using Kind = qtraj::SegmentKind;
  using Range = qtraj::ExponentRange;
  for (const Kind kind : {Kind::arc, Kind::nested_arcs, Kind::normalized})
    CHECK(reached.count({kind, Range::quarter_turn}) == 1);
  for (const Range range : {Range::quarter_turn, Range::half_turn, Range::full_turn, Range::any}) {
    CAPTURE(static_cast<int>(range));
    CHECK(reached.count({Kind::rotation_vector, range}) == 1);
    CHECK(reached.count({Kind::rotation_vector_quintic, range}) == 1);
  }
  CHECK(reached.count({Kind::normalized_quintic, Range::quarter_turn}) == 1);
  CHECK(reached.count({Kind::normalized_quintic, Range::any}) == 1);
}

TEST_CASE("every split of a batch in two gives the same bits", "[batch][bits]") {
  constexpr size_t kCount = 41;
  for_every_call([](const KernelCurve& curve, const Request& request, auto zero) {
    using Real = decltype(zero);
    const std::vector<double> times = mixed_times(curve.knots, kCount);
    OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, times), split(kCount, request);
    size_t different = 0;
    for (size_t first = 0; first <= kCount; ++first) {
      const Arrays<Real> to = split.arrays();
      sample(curve.get(), request, times.data(), first, to);
      sample(curve.get(), request, times.data() + first, kCount - first, to.from_row(first));
      different += different_rows(to, expected.arrays(), kCount);
    }
    CHECK(different == 0);
  });
}

TEST_CASE("runs of any length in a segment give the bits of each sample alone", "[batch][bits]") {
  // vectors that are partial together, the most of float on AVX-512, and a few more
  constexpr size_t kMost = 4 * 16 + 20;
  for_every_call([](const KernelCurve& curve, const Request& request, auto zero) {
    using Real = decltype(zero);
    const double begin = curve.knots[1], length = curve.knots[2] - begin;
    std::vector<double> times;
    for (size_t i = 0; i < kMost; ++i) times.push_back(begin + length * static_cast<double>(i) / kMost);
    OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, times);
    size_t different = 0;
    for (size_t count = 1; count <= kMost; ++count) {
      OwnRows<Real> rows(count, request);
      sample(curve.get(), request, times.data(), count, rows.arrays());
      different += different_rows(rows.arrays(), expected.arrays(), count);
    }
    CHECK(different == 0);
  });
}

TEST_CASE("sorted times of any density give the bits of each sample alone", "[batch][bits]") {
  for_every_call([](const KernelCurve& curve, const Request& request, auto zero) {
    using Real = decltype(zero);
    const size_t segments = curve.knots.size() - 1;
    const double first = curve.knots.front(), span = curve.knots.back() - first;
    test::Random random(segments);
    size_t different = 0;
    // samples a segment: about as many as vectors or half of them have lanes, where runs begin
    for (const double density : {0.5, 1.0, 1.9, 2.1, 3.9, 4.1, 7.9, 8.1, 15.9, 16.1, 40.0}) {
      std::vector<double> times = curve.knots;  // some on the knots
      while (static_cast<double>(times.size()) < density * static_cast<double>(segments) && times.size() < 1200)
        times.push_back(first + span * random.uniform(0, 1));
      std::sort(times.begin(), times.end());
      OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, times), rows(times.size(), request);
      sample(curve.get(), request, times.data(), times.size(), rows.arrays());
      different += different_rows(rows.arrays(), expected.arrays(), times.size());
    }
    CHECK(different == 0);
  });
}

TEST_CASE("a time that falls anywhere among increasing ones gives the bits of each sample alone", "[batch][bits]") {
  // before, across and after 0; an early one, and a zero of the other sign after many
  constexpr size_t kCount = 75;
  for (const double start : {-100.0, -2.0, 0.0, 3.0}) {
    const KernelCurve curve =
        test::kernel_curve(test::kernel_cases()[0], QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD, start);
    const double length = curve.knots[3] - curve.knots[1];
    std::vector<double> increasing;
    for (size_t i = 0; i < kCount; ++i)
      increasing.push_back(curve.knots[1] + length * static_cast<double>(i) / static_cast<double>(kCount));
    test::for_every_kernel([&](const char*) {
      CAPTURE(start);
      size_t different = 0;
      for (size_t at = 0; at < kCount; ++at) {
        std::vector<std::vector<double>> batches(3, increasing);
        batches[0][at] = curve.knots[0];
        for (const size_t batch : {size_t{1}, size_t{2}}) {
          const double zero = batch == 1 ? 0.0 : -0.0;
          std::fill(batches[batch].begin(), batches[batch].begin() + static_cast<ptrdiff_t>(at), zero);
          batches[batch][at] = -zero;
        }
        for (const std::vector<double>& times : batches) {
          OwnRows<double> expected = test::one_by_one<double>(curve.get(), test::kRequests[0], times),
                          rows(kCount, test::kRequests[0]);
          sample(curve.get(), test::kRequests[0], times.data(), kCount, rows.arrays());
          different += different_rows(rows.arrays(), expected.arrays(), kCount);
        }
      }
      CHECK(different == 0);
    });
  }
}

TEST_CASE("any order of the times of a batch gives the same bits", "[batch][bits]") {
  constexpr size_t kCount = 600;  // two chunks
  for_every_call([](const KernelCurve& curve, const Request& request, auto zero) {
    using Real = decltype(zero);
    const std::vector<double> times = mixed_times(curve.knots, kCount);
    OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, times);
    std::vector<size_t> order(kCount);
    std::iota(order.begin(), order.end(), size_t{0});
    const auto check = [&](const char* name) {
      std::vector<double> permuted;
      for (const size_t from : order) permuted.push_back(times[from]);
      OwnRows<Real> rows(kCount, request), back(kCount, request);
      const Arrays<Real> from = rows.arrays(), to = back.arrays();
      sample(curve.get(), request, permuted.data(), kCount, from);
      for (size_t i = 0; i < kCount; ++i) {
        if (to.q) std::copy_n(from.q + 4 * i, 4, to.q + 4 * order[i]);
        if (to.omega) std::copy_n(from.omega + 3 * i, 3, to.omega + 3 * order[i]);
        if (to.alpha) std::copy_n(from.alpha + 3 * i, 3, to.alpha + 3 * order[i]);
      }
      CAPTURE(name);
      CHECK(different_rows(to, expected.arrays(), kCount) == 0);
    };
    check("as they are");
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return times[a] < times[b]; });
    check("sorted");
    std::reverse(order.begin(), order.end());
    check("descending");
    test::Random random(7);
    for (size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[static_cast<size_t>(random.uniform(0, static_cast<double>(i + 1)))]);
    check("shuffled");
  });
}

TEST_CASE("uniform times give the bits of the same times in an array, with every kernel", "[batch][bits]") {
  for_every_call([](const KernelCurve& curve, const Request& request, auto zero) {
    using Real = decltype(zero);
    if (request.with_rates()) return;
    const double first = curve.knots.front(), span = curve.knots.back() - first;
    for (const size_t count : {1u, 2u, 5u, 9u, 255u, 257u, 700u})
      for (const double turns : {0.4, 1.2, -1.2}) {
        const double start = first + (turns < 0 ? 1.1 : -0.1) * span, step = turns * span / static_cast<double>(count);
        std::vector<double> times;
        for (size_t i = 0; i < count; ++i) times.push_back(start + static_cast<double>(i) * step);
        OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, times), uniform(count, request);
        capi::sample_uniform(curve.get(), start, step, count, uniform.arrays().q, nullptr);
        CAPTURE(count, turns);
        CHECK(different_rows(uniform.arrays(), expected.arrays(), count) == 0);
      }
  });
}
