// ROTATION_SPLINE: how its iteration ends.
#include <cstdlib>
#include <memory>

#include "support/capi_variants.hpp"
#include "support/smooth_motion.hpp"

using namespace capi;

namespace {

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};

const int32_t kEnds[] = {QTRAJ_END_ESTIMATED, QTRAJ_END_CHORD, QTRAJ_END_NATURAL, QTRAJ_END_GIVEN};

// Radians in 1e-14 s beside intervals of a second.
Keyframes<double> hopeless() {
  test::Random random(3);
  return {{0, 1e-14, 1, 2, 3}, test::random_walk(random, 5, 3.0, 1, 2).q};
}

// Eight random keys at intervals of 1:1e7, on which continuation takes 1168 steps.
void add_hard_keys(Keyframes<double>& keys) {
  test::Random random(140697);
  double time = keys.times.empty() ? 0.0 : keys.times.back() + 20.0;
  for (int key = 0; key < 8; ++key) {
    keys.times.push_back(time);
    for (const double component : random.orientation()) keys.q.push_back(component);
    time += std::pow(10.0, random.uniform(0.0, 7.0));
  }
}

// A smooth motion from its time `first` on, s.
void add_smooth_keys(Keyframes<double>& keys, int count, double first = 0.0) {
  const double start = keys.times.empty() ? 0.0 : keys.times.back() + 20.0;
  for (int key = 0; key < count; ++key) {
    const double time = 0.1 * key;
    keys.times.push_back(start + time);
    for (const double component : test::smooth_motion(first + time).q) keys.q.push_back(component);
  }
}

Trajectory must_build_spline(const Keyframes<double>& keys, int32_t end = QTRAJ_END_ESTIMATED) {
  return must_build(make_options({"", QTRAJ_ROTATION_SPLINE, end}).get(), keys);
}

TEST_CASE("C API: ROTATION_SPLINE converges on steps to 179 degrees and its jumps of alpha are rounding",
          "[capi][rates][rotation_spline]") {
  test::Random random(17);
  double worst = 0;
  int32_t least = INT32_MAX;
  for (int round = 0; round < 400; ++round) {
    const size_t count = 3 + static_cast<size_t>(random.uniform(0, 15));
    const test::Keys walk = test::random_walk(random, count, 179.0 / 57.29577951308232, 0.2, 2.0);
    const Variant variant = {"", QTRAJ_ROTATION_SPLINE, kEnds[round % 4]};
    const Built built = build(make_options(variant, 2.0).get(), Keyframes<double>{walk.times, walk.q});
    CAPTURE(round, count);
    REQUIRE(built.status == QTRAJ_OK);
    worst = std::max(worst, qtraj_residual(built.trajectory.get()));
    least = std::min(least, qtraj_iterations(built.trajectory.get()));
  }
  CHECK(worst <= 1e-12);
  CHECK(least > 0);
}

TEST_CASE("C API: ROTATION_SPLINE converges on random orientations at intervals that differ a thousand times",
          "[capi][rates][rotation_spline]") {
  test::Random random(23);
  double worst = 0;
  for (int round = 0; round < 2000; ++round) {
    Keyframes<double> keys;
    double time = 0;
    for (size_t key = 0; key < 3 + static_cast<size_t>(round % 10); ++key) {
      keys.times.push_back(time);
      time += std::pow(10.0, random.uniform(-3.0, 0.0));
      for (const double component : random.orientation()) keys.q.push_back(component);
    }
    const Variant variant = {"", QTRAJ_ROTATION_SPLINE, kEnds[round % 4]};
    const Built built = build(make_options(variant, 1.0).get(), keys);
    CAPTURE(round);
    REQUIRE(built.status == QTRAJ_OK);
    worst = std::max(worst, qtraj_residual(built.trajectory.get()));
  }
  CHECK(worst <= 1e-12);
}

TEST_CASE("C API: residual is the largest jump of alpha that curve_jumps finds", "[capi][rates][rotation_spline]") {
  test::Random random(29);
  for (int round = 0; round < 50; ++round) {
    const test::Keys walk = test::random_walk(random, 12, 3.0, 0.2, 2.0);
    const Trajectory curve =
        must_build(make_options({"", QTRAJ_ROTATION_SPLINE}).get(), Keyframes<double>{walk.times, walk.q});
    std::vector<double> jumps(36);
    double peak = 0, fastest = 0;
    REQUIRE(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_BODY, nullptr, jumps.data()) == QTRAJ_OK);
    REQUIRE(qtraj_curve_peak_rates(curve.get(), &fastest, nullptr, &peak, nullptr) == QTRAJ_OK);
    double largest = 0;
    for (const double jump : jumps) largest = std::max(largest, std::abs(jump));
    CHECK(largest <= 1e-12 * std::max(peak, fastest / 0.2));
    CHECK(qtraj_residual(curve.get()) <= 1e-12);
  }
}

TEST_CASE("C API: curves at rest and of two keys converge with no jump", "[capi][rates][rotation_spline]") {
  for (const int32_t end : {QTRAJ_END_ESTIMATED, QTRAJ_END_CHORD, QTRAJ_END_NATURAL, QTRAJ_END_PERIODIC}) {
    CAPTURE(end);
    const Variant variant = {"", QTRAJ_ROTATION_SPLINE, end};
    const Keyframes<double> rest = {{0, 1, 3, 4}, {1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}};
    CHECK(qtraj_residual(must_build(make_options(variant).get(), rest).get()) == 0);
    const Keyframes<double> two = {{0, 2}, {1, 0, 0, 0, -1, 0, 0, 0}};
    CHECK(qtraj_residual(must_build(make_options(variant).get(), two).get()) == 0);
  }
}

TEST_CASE("C API: keys without convergence are NO_CONVERGENCE: no trajectory, no index, nothing leaked",
          "[capi][rates][rotation_spline][errors]") {
  for (const int32_t end : kEnds) {
    CAPTURE(end);
    const Keyframes<double> keys = hopeless();
    const Options options = make_options({"", QTRAJ_ROTATION_SPLINE, end});
    int stale = 0;
    qtraj_trajectory* out = reinterpret_cast<qtraj_trajectory*>(&stale);
    size_t bad_index = 0;
    CHECK(create_with_options(options.get(), keys.times.data(), keys.q.data(), 5, &out, &bad_index) ==
          QTRAJ_E_NO_CONVERGENCE);
    CHECK(out == nullptr);
    CHECK(bad_index == SIZE_MAX);

    size_t bytes = 0;
    REQUIRE(qtraj_init_size(options.get(), 5, &bytes) == QTRAJ_OK);
    const std::unique_ptr<void, Free> memory(std::malloc(bytes));
    out = reinterpret_cast<qtraj_trajectory*>(&stale);
    CHECK(qtraj_init(memory.get(), bytes, options.get(), 0, keys.times.data(), keys.q.data(), nullptr, nullptr, nullptr,
                     5, &out, nullptr) == QTRAJ_E_NO_CONVERGENCE);
    CHECK(out == nullptr);
  }
}

// Of the length of the recording, not of its hardest keys: these take 128 knots of a part at a time.
TEST_CASE("C API: hard keys in a long recording cost what they cost alone and leave the rest as it is",
          "[capi][rates][rotation_spline]") {
  Keyframes<double> hard, smooth, all;
  add_hard_keys(hard);
  const int32_t alone = qtraj_iterations(must_build_spline(hard).get());
  REQUIRE(alone > 500);
  add_smooth_keys(smooth, 4000);
  const Trajectory ordinary = must_build_spline(smooth);
  REQUIRE(qtraj_iterations(ordinary.get()) <= 6);
  add_smooth_keys(all, 4000);
  add_hard_keys(all);
  add_smooth_keys(all, 4000);

  const Trajectory curve = must_build_spline(all);
  CHECK(qtraj_residual(curve.get()) <= 1e-12);
  // the hard keys may lie in two parts; 20 are the whole curve at once, in vain, and its easy parts
  CHECK(qtraj_iterations(curve.get()) <= 2 * alone * 128 / 8008 + 20);
  std::vector<double> times;
  for (int k = 0; k < 3900 * 4; ++k) times.push_back(0.025 * k);
  const Motion<double> with = must_sample_rates<double>(curve.get(), QTRAJ_FRAME_BODY, times),
                       without = must_sample_rates<double>(ordinary.get(), QTRAJ_FRAME_BODY, times);
  double largest = 0;
  for (size_t k = 0; k < with.q.size(); ++k) largest = std::max(largest, std::abs(with.q[k] - without.q[k]));
  for (size_t k = 0; k < with.omega.size(); ++k)
    largest = std::max(largest, std::abs(with.omega[k] - without.omega[k]));
  CHECK(largest <= 1e-14);
}

TEST_CASE("C API: the steps of ROTATION_SPLINE are bounded, at hard keys throughout too",
          "[capi][rates][rotation_spline]") {
  for (const int32_t end : {QTRAJ_END_ESTIMATED, QTRAJ_END_NATURAL, QTRAJ_END_PERIODIC})
    for (const int copies : {1, 30, 60, 500}) {
      CAPTURE(end, copies);
      Keyframes<double> keys;
      for (int copy = 0; copy < copies; ++copy) add_hard_keys(keys);
      if (end == QTRAJ_END_PERIODIC) std::copy_n(keys.q.begin(), 4, keys.q.end() - 4);
      const Built built = build(make_options({"", QTRAJ_ROTATION_SPLINE, end}).get(), keys);
      if (built.status != QTRAJ_OK) {
        CHECK(built.status == QTRAJ_E_NO_CONVERGENCE);
        continue;
      }
      CHECK(qtraj_residual(built.trajectory.get()) <= 1e-9);
      CHECK(qtraj_iterations(built.trajectory.get()) <= 512 + (1 << 20) / (8 * copies) + 40);
    }
}

// Parts of 64 knots, from 257 knots on. The motion up to the hard keys is the same one, and begins where it may.
TEST_CASE("C API: a long curve is the same wherever its parts begin", "[capi][rates][rotation_spline]") {
  std::vector<double> first;
  for (const int32_t end : {QTRAJ_END_CHORD, QTRAJ_END_PERIODIC})
    for (const int before : {120, 121, 150, 180, 240, 250}) {
      CAPTURE(end, before);
      Keyframes<double> keys;
      add_smooth_keys(keys, before, -0.1 * before);
      add_hard_keys(keys);
      add_smooth_keys(keys, 260);
      if (end == QTRAJ_END_PERIODIC) std::copy_n(keys.q.begin(), 4, keys.q.end() - 4);
      const Trajectory curve = must_build_spline(keys, end);
      CHECK(qtraj_residual(curve.get()) <= 1e-12);
      std::vector<double> times;
      const double start = keys.times[static_cast<size_t>(before)];
      for (int k = 0; k < 200; ++k) times.push_back(start + std::pow(10.0, 0.03 * k));
      const std::vector<double> q = must_sample<double>(curve.get(), times);
      if (first.empty()) first = q;
      double largest = 0;
      for (size_t k = 0; k < q.size(); ++k) largest = std::max(largest, std::abs(q[k] - first[k]));
      CHECK(largest <= 1e-6);
    }
}

}  // namespace
