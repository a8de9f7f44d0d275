// One time, one result: whatever the function, the order, the split, the cursor, the place in memory or the thread.
#include <array>
#include <numeric>
#include <thread>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

// A curve that takes any time: wrapped where `wraps`, else held before and turning on after.
template <class Real>
Trajectory tour(const Variant& variant, bool wraps) {
  const Options options = make_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), wraps ? QTRAJ_EXTRAPOLATE_PERIODIC : QTRAJ_EXTRAPOLATE_HOLD,
                                          wraps ? QTRAJ_EXTRAPOLATE_PERIODIC : QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
          QTRAJ_OK);
  return must_build(options.get(), closed_tour<Real>(40), rates_for<Real>(variant, 40));
}

// Sorted runs, knots, repeated times, times outside and times in no order: 1000 in all.
std::vector<double> many_times(const qtraj_trajectory* trajectory) {
  std::vector<double> knots(qtraj_key_count(trajectory));
  REQUIRE(qtraj_keys(trajectory, knots.data(), nullptr) == QTRAJ_OK);
  std::vector<double> times = times_in(knots, 10);
  test::Random random(3);
  while (times.size() < 900) times.push_back(random.uniform(knots.front() - 5, knots.back() + 5));
  while (times.size() < 1000) times.push_back(times[times.size() - 400]);
  return times;
}

// Calls body(variant, trajectory, times, expected rows) for every variant, for double and float samples.
template <class Body>
void for_every_curve(Body&& body) {
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const bool wraps : {false, true}) {
        CAPTURE(variant.name, wraps);
        const Trajectory curve = tour<Real>(variant, wraps);
        const std::vector<double> times = many_times(curve.get());
        body(curve.get(), times, must_sample<Real>(curve.get(), times));
      }
  });
}

TEST_CASE("C API: a sample does not depend on the order of the times", "[capi][same_bits]") {
  for_every_curve([](const qtraj_trajectory* curve, const std::vector<double>& times, const auto& expected) {
    using Real = typename std::decay_t<decltype(expected)>::value_type;
    std::vector<size_t> order(times.size());
    std::iota(order.begin(), order.end(), size_t{0});
    const auto check = [&] {
      std::vector<double> permuted;
      for (const size_t from : order) permuted.push_back(times[from]);
      const std::vector<Real> q = must_sample<Real>(curve, permuted);
      std::vector<Real> back(q.size());
      for (size_t i = 0; i < order.size(); ++i) std::copy_n(&q[4 * i], 4, &back[4 * order[i]]);
      CHECK(same_bits(back, expected));
    };
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return times[a] < times[b]; });
    check();
    std::reverse(order.begin(), order.end());
    check();
    test::Random random(7);
    for (size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[static_cast<size_t>(random.uniform(0, static_cast<double>(i + 1)))]);
    check();
  });
}

TEST_CASE("C API: a sample does not depend on how the batch is split", "[capi][same_bits]") {
  for_every_curve([](const qtraj_trajectory* curve, const std::vector<double>& times, const auto& expected) {
    using Real = typename std::decay_t<decltype(expected)>::value_type;
    for (const size_t length : {1u, 2u, 3u, 5u, 7u, 8u, 9u, 16u, 33u, 64u, 257u, 999u}) {
      CAPTURE(length);
      std::vector<Real> q(expected.size());
      bool all_ok = true;
      for (size_t first = 0; first < times.size(); first += length) {
        const size_t count = std::min<size_t>(length, times.size() - first);
        all_ok = sample(curve, &times[first], count, &q[4 * first], nullptr) == QTRAJ_OK && all_ok;
      }
      CHECK(all_ok);
      CHECK(same_bits(q, expected));
    }
  });
}

TEST_CASE("C API: sample_at gives the bits of the batch with every cursor", "[capi][same_bits]") {
  for_every_curve([](const qtraj_trajectory* curve, const std::vector<double>& times, const auto& expected) {
    using Real = typename std::decay_t<decltype(expected)>::value_type;
    size_t running = 0;
    for (int kind = 0; kind < 4; ++kind) {
      CAPTURE(kind);
      std::vector<Real> q(expected.size());
      bool all_ok = true;
      for (size_t i = 0; i < times.size(); ++i) {
        size_t any = kind == 2 ? SIZE_MAX - i : 7919 * i;
        size_t* cursor = kind == 0 ? nullptr : kind == 1 ? &running : &any;
        all_ok = sample_at(curve, times[i], cursor, &q[4 * i]) == QTRAJ_OK && all_ok;
      }
      CHECK(all_ok);
      CHECK(same_bits(q, expected));
    }
  });
}

TEST_CASE("C API: sample_uniform gives the bits of sample at start + (double)i * step", "[capi][same_bits]") {
  struct Grid {
    double start, step;
    size_t count;
  };
  const Grid grids[] = {{-2.0, 0.1, 400},   {-2.0, 1.0 / 3.0, 100}, {35.0, -0.07, 700}, {1.0, 0.0, 50},
                        {-7.0, 1e-3, 1001}, {-2.0, 5e-324, 20},     {1e6, -7.7, 300},   {-1e9, 1e9 / 3, 30},
                        {0.3, 1e-17, 100},  {-2.0, 40.0, 2},        {-1.0, 0.5, 1},     {3e300, -1e299, 60}};
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const bool wraps : {false, true}) {
        const Trajectory curve = tour<Real>(variant, wraps);
        for (const Grid& grid : grids) {
          CAPTURE(variant.name, wraps, grid.start, grid.step);
          std::vector<double> times(grid.count);
          for (size_t i = 0; i < grid.count; ++i) {
            const double offset = static_cast<double>(i) * grid.step;  // rounded on its own: never one fma
            times[i] = grid.start + offset;
          }
          std::vector<Real> q(4 * grid.count);
          CHECK(sample_uniform(curve.get(), grid.start, grid.step, grid.count, q.data(), nullptr) == QTRAJ_OK);
          CHECK(same_bits(q, must_sample<Real>(curve.get(), times)));
        }
      }
  });
}

TEST_CASE("C API: arrays need the alignment of their element only and bits do not depend on it",
          "[capi][same_bits][memory]") {
  for_every_curve([](const qtraj_trajectory* curve, const std::vector<double>& times, const auto& expected) {
    using Real = typename std::decay_t<decltype(expected)>::value_type;
    for (size_t shift = 0; shift < 8; ++shift) {
      // ends where its block ends, so that a sanitizer sees any access past it
      std::vector<double> moved(shift + times.size());
      std::vector<Real> q(shift + expected.size());
      std::copy(times.begin(), times.end(), moved.begin() + static_cast<ptrdiff_t>(shift));
      CHECK(sample(curve, moved.data() + shift, times.size(), q.data() + shift, nullptr) == QTRAJ_OK);
      CHECK(std::memcmp(q.data() + shift, expected.data(), expected.size() * sizeof(Real)) == 0);
    }
  });
}

TEST_CASE("C API: construction is repeatable to the bit and exact for float keys given as double",
          "[capi][same_bits]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Keyframes<float> keys = closed_tour<float>(40);
    const Rates<float> rates = rates_for<float>(variant, 40);
    const Options options = make_options(variant);
    const Trajectory first = must_build(options.get(), keys, rates), second = must_build(options.get(), keys, rates);
    const std::vector<double> times = times_in(keys.times, 9);
    const std::vector<double> expected = must_sample<double>(first.get(), times);
    CHECK(same_bits(must_sample<double>(second.get(), times), expected));
    // construction is in double: keys that float holds exactly are the same keys
    const Keyframes<double> wide_keys = {keys.times, std::vector<double>(keys.q.begin(), keys.q.end())};
    const Trajectory wide = must_build(options.get(), wide_keys, widened(rates));
    CHECK(same_bits(must_sample<double>(wide.get(), times), expected));
    CHECK(same_bits(must_sample<float>(wide.get(), times), must_sample<float>(first.get(), times)));
  }
}

TEST_CASE("C API: threads sampling one handle get the bits of one thread", "[capi][same_bits][threads]") {
  for_every_curve([](const qtraj_trajectory* curve, const std::vector<double>& times, const auto& expected) {
    using Real = typename std::decay_t<decltype(expected)>::value_type;
    constexpr size_t kThreads = 4;
    std::array<bool, kThreads> right = {};
    std::vector<std::thread> threads;
    for (size_t thread = 0; thread < kThreads; ++thread)
      threads.emplace_back([&, thread] {
        bool fine = true;
        for (int round = 0; round < 4; ++round) {
          std::vector<Real> q(expected.size());
          size_t cursor = thread;
          fine = fine && sample(curve, times.data(), times.size(), q.data(), nullptr) == QTRAJ_OK;
          fine = fine && same_bits(q, expected);
          for (size_t i = thread; i < times.size(); i += kThreads)
            fine = sample_at(curve, times[i], &cursor, &q[4 * i]) == QTRAJ_OK && fine;
          fine = fine && same_bits(q, expected);
        }
        right[thread] = fine;
      });
    for (std::thread& thread : threads) thread.join();
    CHECK(std::all_of(right.begin(), right.end(), [](bool fine) { return fine; }));
  });
}

}  // namespace
