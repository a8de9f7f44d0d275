// Curve diagnostics where the curve turns thousands of times, and where only some rates overflow.
#include <cmath>
#include <vector>

#include "support/trajectory.hpp"

namespace {

using test::Trajectory;

// One HERMITE segment of about `turning` rad.
Trajectory winding(double turning) {
  const double times[] = {0, 1}, q[] = {1, 0, 0, 0, 0.8, 0.6, 0, 0};
  const double omega[] = {turning, 0.3 * turning, 0, 0, turning, 0.2 * turning};
  qtraj_options* options = test::make_options({QTRAJ_HERMITE});
  CHECK(qtraj_options_set_turns(options, QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
  qtraj_trajectory* handle = nullptr;
  CHECK(qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, times, q, omega, nullptr, 2, &handle, nullptr) == QTRAJ_OK);
  qtraj_options_destroy(options);
  return Trajectory(handle);
}

// Midpoint sums of |alpha|^2 and |omega|.
struct Sums {
  double energy, angle;
};
Sums midpoint_sums(const Trajectory& trajectory, size_t count) {
  std::vector<double> times(count);
  for (size_t i = 0; i < count; ++i) times[i] = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
  const auto motion = trajectory.sample_rates(QTRAJ_FRAME_BODY, times);
  Sums sums = {0, 0};
  for (size_t i = 0; i < 3 * count; i += 3) {
    sums.energy += motion.alpha[i] * motion.alpha[i] + motion.alpha[i + 1] * motion.alpha[i + 1] +
                   motion.alpha[i + 2] * motion.alpha[i + 2];
    sums.angle += std::sqrt(motion.omega[i] * motion.omega[i] + motion.omega[i + 1] * motion.omega[i + 1] +
                            motion.omega[i + 2] * motion.omega[i + 2]);
  }
  return {sums.energy / static_cast<double>(count), sums.angle / static_cast<double>(count)};
}

}  // namespace

TEST_CASE("C API: diagnostics of a segment of many turns are right or NO_CONVERGENCE", "[capi][diagnostics]") {
  for (const double turning : {1e3, 3e4}) {
    const Trajectory trajectory = winding(turning);
    const Sums expected = midpoint_sums(trajectory, 400000);
    double energy = 0, angle = 0;
    CAPTURE(turning);
    CHECK(qtraj_curve_energy(trajectory.get(), &energy) == QTRAJ_OK);
    CHECK(qtraj_curve_total_angle(trajectory.get(), &angle) == QTRAJ_OK);
    CHECK(std::abs(energy / expected.energy - 1) <= 1e-6);
    CHECK(std::abs(angle / expected.angle - 1) <= 1e-6);
  }
  double energy = -7;
  CHECK(qtraj_curve_energy(winding(1e8).get(), &energy) == QTRAJ_E_NO_CONVERGENCE);
  CHECK(energy == -7);
}

TEST_CASE("C API: an acceleration that overflows does not spoil what is said of the rates", "[capi][diagnostics]") {
  test::Keys keys;
  keys.add(0, {1, 0, 0, 0});
  keys.add(1e-154, {0.6, 0.8, 0, 0});
  keys.add(2e-154, {0.6, 0, 0.8, 0});
  const Trajectory trajectory({QTRAJ_NLERP}, keys);
  double omega[9], alpha[9], peak = 0, time = 0;
  CHECK(qtraj_curve_jumps(trajectory.get(), QTRAJ_FRAME_WORLD, omega, nullptr) == QTRAJ_OK);
  CHECK(std::isfinite(omega[4]));
  CHECK(qtraj_curve_jumps(trajectory.get(), QTRAJ_FRAME_WORLD, omega, alpha) == QTRAJ_E_NOT_FINITE);
  CHECK(qtraj_curve_peak_rates(trajectory.get(), &peak, &time, nullptr, nullptr) == QTRAJ_OK);
  CHECK(peak > 1e153);
  CHECK(qtraj_curve_peak_rates(trajectory.get(), nullptr, nullptr, &peak, nullptr) == QTRAJ_E_NOT_FINITE);
}
