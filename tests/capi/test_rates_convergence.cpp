// ROTATION_SPLINE: how its iteration ends.
#include <cstdlib>
#include <memory>

#include "support/capi_variants.hpp"

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

}  // namespace
