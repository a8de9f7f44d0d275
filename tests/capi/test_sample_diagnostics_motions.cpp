// Diagnostics of samples: motions whose values are known by hand, invariances, half turns.
#include <algorithm>

#include "support/capi_samples.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

// q(t) = q_start exp(angle(t)/2 axis): the body rate is angle' along the axis, the world rate the same axis in world.
test::Keys turning(test::Random& random, const test::Quaternion& q_start, const test::Vector& axis, size_t count,
                   double (*angle)(double)) {
  test::Keys samples;
  double time = -3;
  for (size_t k = 0; k < count; ++k) {
    const double norm = (random.uniform(0, 1) < 0.5 ? -1 : 1) * random.uniform(0.5, 2);
    samples.add(time, test::scaled(norm, test::multiply(q_start, test::about(axis, angle(time)))));
    time += random.uniform(0.05, 0.4);
  }
  return samples;
}

double error_of(const double* omega, const test::Vector& expected) {
  return std::max(
      {std::abs(omega[0] - expected[0]), std::abs(omega[1] - expected[1]), std::abs(omega[2] - expected[2])});
}
test::Vector along(const test::Vector& axis, double rate) { return {rate * axis[0], rate * axis[1], rate * axis[2]}; }

TEST_CASE("C API: a curve of constant rate has that rate, no energy and no jump", "[capi][sample_diagnostics]") {
  test::Random random(32);
  const test::Quaternion q_start = random.orientation();
  const test::Vector axis = random.direction();
  const test::Keys samples = turning(random, q_start, axis, 30, [](double time) { return 2.5 * time; });
  for (const int32_t frame : kFrames) {
    const test::Vector expected = along(frame == QTRAJ_FRAME_WORLD ? test::rotate(q_start, axis) : axis, 2.5);
    const EstimatedRates rates = estimate(samples, frame);
    CHECK(rates.status == QTRAJ_OK);
    double worst = 0;
    for (size_t k = 0; k < 29; ++k) test::raise_to(worst, error_of(&rates.omega[3 * k], expected));
    CHECK(worst <= 1e-13);
    CHECK(energy_of(samples, frame) <= 1e-22);
    const std::vector<double> inner(samples.times.begin() + 2, samples.times.end() - 2);
    for (const double component : jumps_of(samples, inner, frame)) CHECK(std::abs(component) <= 2e-13);
  }
}

TEST_CASE("C API: constant acceleration gives its rate at mid-times and its energy", "[capi][sample_diagnostics]") {
  test::Random random(33);
  const test::Quaternion q_start = random.orientation();
  const test::Vector axis = random.direction();
  constexpr double kAlpha = 0.7;
  const test::Keys samples = turning(random, q_start, axis, 30, [](double time) { return 0.5 * kAlpha * time * time; });
  for (const int32_t frame : kFrames) {
    const test::Vector turned = frame == QTRAJ_FRAME_WORLD ? test::rotate(q_start, axis) : axis;
    const EstimatedRates rates = estimate(samples, frame);
    double worst = 0;
    for (size_t k = 0; k < 29; ++k)
      test::raise_to(worst, error_of(&rates.omega[3 * k], along(turned, kAlpha * rates.t_mid[k])));
    CHECK(worst <= 1e-13);
    const double expected = kAlpha * kAlpha * (rates.t_mid.back() - rates.t_mid.front());
    CHECK(std::abs(energy_of(samples, frame) - expected) <= 1e-12 * expected);
    // between neighbouring intervals the rate grows by alpha times the distance of their middles
    const std::vector<double> jumps = jumps_of(samples, {samples.times[20]}, frame);
    CHECK(error_of(jumps.data(), along(turned, kAlpha * (rates.t_mid[20] - rates.t_mid[19]))) <= 1e-13);
  }
}

TEST_CASE("C API: a single jump of the rate is found at its knot and nowhere else", "[capi][sample_diagnostics]") {
  const test::Quaternion q_start = test::about({0.6, 0, 0.8}, 1.1);
  const test::Vector before = {0, 0, 1}, after = {-0.5, 2, 0};  // rad/s, body
  const double after_size = std::sqrt(4.25);
  const test::Vector after_axis = {-0.5 / after_size, 2 / after_size, 0};
  const auto at = [&](double time) {
    const test::Quaternion first = test::multiply(q_start, test::about(before, std::min(time, 0.0)));
    return test::multiply(first, test::about(after_axis, after_size * std::max(time, 0.0)));
  };
  for (const bool sampled_at_knot : {true, false}) {
    test::Keys samples;
    for (int k = -8; k <= 8; ++k)
      if (k != 0 || sampled_at_knot) samples.add(0.25 * k, at(0.25 * k));
    for (const int32_t frame : kFrames) {
      CAPTURE(sampled_at_knot, frame);
      const test::Vector jump = {after[0] - before[0], after[1] - before[1], after[2] - before[2]};
      const test::Vector expected = frame == QTRAJ_FRAME_WORLD ? test::rotate(q_start, jump) : jump;
      // any order; off the samples the intervals on both sides of the one around the knot count
      const std::vector<double> jumps = jumps_of(samples, {1.0, 0.0, -1.0, 0.1, -0.75}, frame);
      CHECK(error_of(&jumps[0], {0, 0, 0}) <= 1e-14);
      CHECK(error_of(&jumps[3], expected) <= 1e-14);
      CHECK(error_of(&jumps[6], {0, 0, 0}) <= 1e-14);
      // 0.1 lies after the sample at 0, where there is one: both its neighbours turn at the later rate
      if (!sampled_at_knot) CHECK(error_of(&jumps[9], expected) <= 1e-14);
      CHECK(error_of(&jumps[12], {0, 0, 0}) <= 1e-14);
      if (sampled_at_knot) CHECK(std::abs(energy_of(samples, frame) - (0.25 + 4 + 1) / 0.25) <= 1e-12);
    }
  }
}

TEST_CASE("C API: keyframe errors of known motions are the angles turned since the nearest sample",
          "[capi][sample_diagnostics]") {
  test::Random random(38);
  const test::Quaternion q_start = random.orientation();
  const test::Vector axis = random.direction();
  double (*const angles[])(double) = {[](double time) { return 2.5 * time; },
                                      [](double time) { return 0.35 * time * time; },
                                      [](double time) { return time < 0 ? time : 3 * time; }};
  for (double (*angle)(double) : angles) {
    const test::Keys samples = turning(random, q_start, axis, 30, angle);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const double time = random.uniform(samples.times.front() - 0.1, samples.times.back() + 0.1);
      const test::Quaternion key = test::multiply(q_start, test::about(axis, angle(time)));
      size_t nearest = 0, index = SIZE_MAX;
      for (size_t k = 1; k < samples.count(); ++k)
        if (std::abs(samples.times[k] - time) < std::abs(samples.times[nearest] - time)) nearest = k;
      double error = -1;
      REQUIRE(qtraj_keyframe_errors(&time, key.data(), 1, samples.times.data(), samples.q.data(), samples.count(),
                                    &error, &index, nullptr) == QTRAJ_OK);
      REQUIRE(index == nearest);
      test::raise_to(worst, std::abs(error - std::abs(angle(time) - angle(samples.times[nearest]))));
    }
    CHECK(worst <= 1e-14);
  }
}

TEST_CASE("C API: signs and norms of samples change no bit of a diagnostic", "[capi][sample_diagnostics]") {
  test::Random random(37);
  const test::Keys samples = test::random_walk(random, 60, 3.0, 0.01, 1);
  test::Keys other = samples;
  for (size_t k = 0; k < samples.count(); ++k) {
    const double factor = std::ldexp(random.uniform(0, 1) < 0.5 ? -1 : 1, static_cast<int>(random.uniform(-900, 900)));
    for (size_t i = 4 * k; i < 4 * k + 4; ++i) other.q[i] *= factor;
  }
  const std::vector<double> knots(samples.times.begin() + 1, samples.times.end() - 1);
  for (const int32_t frame : kFrames) {
    CHECK(estimate(samples, frame).omega == estimate(other, frame).omega);
    CHECK(energy_of(samples, frame) == energy_of(other, frame));
    CHECK(jumps_of(samples, knots, frame) == jumps_of(other, knots, frame));
  }
  std::vector<double> errors(60, 7.0);
  CHECK(qtraj_keyframe_errors(samples.times.data(), samples.q.data(), 60, other.times.data(), other.q.data(), 60,
                              errors.data(), nullptr, nullptr) == QTRAJ_OK);
  CHECK(errors == std::vector<double>(60, 0.0));
}

TEST_CASE("C API: half a turn between samples is AMBIGUOUS, and the row one of the two answers",
          "[capi][sample_diagnostics][singular]") {
  struct Step {
    double w;
    bool ambiguous;
  };
  for (const Step& step : {Step{0, true}, Step{5e-324, true}, Step{8e-16, true}, Step{-8e-16, true}, Step{1e-15, false},
                           Step{-1e-15, false}, Step{1e-9, false}}) {
    CAPTURE(step.w);
    // half a turn about x in 0.5 s in the second interval, nothing before, a quarter turn about y after
    const double times[4] = {0, 1, 1.5, 2};
    const double root = std::sqrt(0.5);
    const double q[16] = {2, 0, 0, 0, -2, 0, 0, 0, step.w, 1, 0, 0, step.w, root, 0, root};
    const qtraj_status expected = step.ambiguous ? QTRAJ_E_AMBIGUOUS : QTRAJ_OK;
    double t_mid[3], omega[9], energy = 0, jumps[6];
    size_t bad_index = 0;
    CHECK(qtraj_estimate_omega(QTRAJ_FRAME_BODY, times, q, 4, t_mid, omega, &bad_index) == expected);
    CHECK(bad_index == (step.ambiguous ? 2 : SIZE_MAX));
    const double size = 6.283185307179586;
    CHECK(std::abs(std::abs(omega[3]) - size) <= 1e-8);
    CHECK(error_of(omega, {0, 0, 0}) == 0);
    CHECK(qtraj_estimate_energy(QTRAJ_FRAME_BODY, times, q, 4, &energy, &bad_index) == expected);
    CHECK(bad_index == (step.ambiguous ? 2 : SIZE_MAX));
    CHECK(std::abs(energy - (size * size / 0.75 + (size * size + size * size / 4) / 0.5)) <= 1e-6);
    const double knots[2] = {1.0, 1.5};
    CHECK(qtraj_estimate_jumps(QTRAJ_FRAME_BODY, times, q, 4, knots, 2, jumps, &bad_index) == expected);
    CHECK(bad_index == (step.ambiguous ? 4 : SIZE_MAX));
    CHECK(std::abs(jumps[0] - omega[3]) == 0);
    // the given sign in an exact tie: +x from -1 taken as it is
    if (step.w == 0) CHECK(omega[3] < 0);
  }
}

}  // namespace
