// Rates at one time have one value: whatever the order, the split, the place in memory or the thread.
#include <numeric>
#include <thread>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

template <class Real>
Trajectory tour(const Variant& variant, bool wraps) {
  const Options options = make_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), wraps ? QTRAJ_EXTRAPOLATE_PERIODIC : QTRAJ_EXTRAPOLATE_HOLD,
                                          wraps ? QTRAJ_EXTRAPOLATE_PERIODIC : QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
          QTRAJ_OK);
  return must_build(options.get(), closed_tour<Real>(20), rates_for<Real>(variant, 20));
}

std::vector<double> many_times() {
  const std::vector<double> knots = closed_tour<double>(20).times;
  std::vector<double> times = times_in(knots, 8);
  test::Random random(61);
  while (times.size() < 300) times.push_back(random.uniform(knots.front() - 5, knots.back() + 5));
  return times;
}

// Calls body(curve, frame, times, expected) for every variant, frame and type of samples.
template <class Body>
void for_every_curve(Body&& body) {
  const std::vector<double> times = many_times();
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const bool wraps : {false, true})
        for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
          CAPTURE(variant.name, wraps, frame);
          const Trajectory curve = tour<Real>(variant, wraps);
          body(curve.get(), frame, times, must_sample_rates<Real>(curve.get(), frame, times));
        }
  });
}

TEST_CASE("C API: rates do not depend on the order of the times", "[capi][rates][same_bits]") {
  for_every_curve([](const qtraj_trajectory* curve, int32_t frame, const std::vector<double>& times, auto expected) {
    using Real = typename std::decay_t<decltype(expected.q)>::value_type;
    std::vector<size_t> order(times.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return times[a] > times[b]; });
    std::vector<double> permuted;
    for (const size_t from : order) permuted.push_back(times[from]);
    const Motion<Real> motion = must_sample_rates<Real>(curve, frame, permuted);
    Motion<Real> back(times.size());
    for (size_t i = 0; i < order.size(); ++i) {
      std::copy_n(&motion.q[4 * i], 4, &back.q[4 * order[i]]);
      std::copy_n(&motion.omega[3 * i], 3, &back.omega[3 * order[i]]);
      std::copy_n(&motion.alpha[3 * i], 3, &back.alpha[3 * order[i]]);
    }
    CHECK(same_bits(back, expected));
  });
}

TEST_CASE("C API: rates do not depend on how the batch is split, nor on the place in memory",
          "[capi][rates][same_bits]") {
  for_every_curve([](const qtraj_trajectory* curve, int32_t frame, const std::vector<double>& times, auto expected) {
    using Real = typename std::decay_t<decltype(expected.q)>::value_type;
    for (const size_t length : {1u, 2u, 3u, 5u, 8u, 33u, 257u}) {
      Motion<Real> motion(times.size());
      bool all_ok = true;
      for (size_t first = 0; first < times.size(); first += length) {
        const size_t count = std::min<size_t>(length, times.size() - first);
        all_ok = sample_rates(curve, frame, &times[first], count, &motion.q[4 * first], &motion.omega[3 * first],
                              &motion.alpha[3 * first], nullptr) == QTRAJ_OK &&
                 all_ok;
      }
      CAPTURE(length);
      CHECK(all_ok);
      CHECK(same_bits(motion, expected));
    }
  });
}

TEST_CASE("C API: rates are repeatable to the bit and exact for float keys and rates given as double",
          "[capi][rates][same_bits]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Keyframes<float> keys = closed_tour<float>(20);
    const Rates<float> rates = rates_for<float>(variant, 20);
    const Options options = make_options(variant);
    const Keyframes<double> wide_keys = {keys.times, {keys.q.begin(), keys.q.end()}};
    const Trajectory narrow = must_build(options.get(), keys, rates), again = must_build(options.get(), keys, rates),
                     wide = must_build(options.get(), wide_keys, widened(rates));
    const std::vector<double> times = times_in(keys.times, 9);
    const Motion<double> expected = must_sample_rates<double>(narrow.get(), QTRAJ_FRAME_WORLD, times);
    CHECK(same_bits(must_sample_rates<double>(again.get(), QTRAJ_FRAME_WORLD, times), expected));
    CHECK(same_bits(must_sample_rates<double>(wide.get(), QTRAJ_FRAME_WORLD, times), expected));
  }
}

TEST_CASE("C API: threads sampling rates of one handle get the bits of one thread",
          "[capi][rates][same_bits][threads]") {
  for_every_curve([](const qtraj_trajectory* curve, int32_t frame, const std::vector<double>& times, auto expected) {
    using Real = typename std::decay_t<decltype(expected.q)>::value_type;
    bool right[3] = {};
    std::vector<std::thread> threads;
    for (bool& fine : right)
      threads.emplace_back([&] {
        Motion<Real> motion(times.size());
        double number = 0;
        fine = sample_rates(curve, frame, times.data(), times.size(), motion.q.data(), motion.omega.data(),
                            motion.alpha.data(), nullptr) == QTRAJ_OK &&
               same_bits(motion, expected) && qtraj_curve_total_angle(curve, &number) == QTRAJ_OK;
      });
    for (std::thread& thread : threads) thread.join();
    CHECK((right[0] && right[1] && right[2]));
  });
}

}  // namespace
