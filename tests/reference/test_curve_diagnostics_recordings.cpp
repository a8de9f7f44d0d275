// Curve diagnostics of real attitude recordings.
#include "support/recording.hpp"
#include "support/trajectory.hpp"

using namespace test;

namespace {

TEST_CASE("C API: diagnostics of recordings are finite, and their length is at least that of the steps",
          "[reference][diagnostics][recordings]") {
  for (const Recording& recording : all_recordings())
    for (const int32_t method : {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_SQUAD, QTRAJ_ROTATION_SPLINE}) {
      CAPTURE(recording.name, method);
      const Trajectory curve({method}, recording.keys);
      const Keys used = curve.keys();
      double steps = 0;
      for (size_t i = 1; i < used.count(); ++i) {
        const Quaternion a = used.orientation(i - 1);
        const Quaternion step = multiply({a[0], -a[1], -a[2], -a[3]}, used.orientation(i));
        steps += 2 * std::atan2(std::sqrt(step[1] * step[1] + step[2] * step[2] + step[3] * step[3]), step[0]);
      }
      double angle = 0, energy = -1, omega = 0, omega_time = 0, alpha = -1, alpha_time = 0;
      REQUIRE(qtraj_curve_total_angle(curve.get(), &angle) == QTRAJ_OK);
      REQUIRE(qtraj_curve_energy(curve.get(), &energy) == QTRAJ_OK);
      REQUIRE(qtraj_curve_peak_rates(curve.get(), &omega, &omega_time, &alpha, &alpha_time) == QTRAJ_OK);
      CHECK(angle >= steps * (1 - 1e-9));
      if (method == QTRAJ_SLERP || method == QTRAJ_NLERP) CHECK(std::abs(angle - steps) <= 1e-9 * steps);
      CHECK((energy >= 0 && std::isfinite(energy)));
      CHECK((std::isfinite(omega) && std::isfinite(alpha) && alpha >= 0));
      CHECK(omega * (used.times.back() - used.times.front()) >= angle * (1 - 1e-9));
      for (const double time : {omega_time, alpha_time})
        CHECK((time >= used.times.front() && time <= used.times.back()));

      // no sample is faster than the peak, to what rates are promised to: alpha to 1e-13 of A, which on a nearly
      // constant spin is the largest |omega|/h and far more than |alpha|
      const std::vector<double> knots = used.times;
      std::vector<double> times;
      for (size_t i = 0; i + 1 < knots.size(); ++i)
        for (const double u : {0.0, 0.21, 0.5, 0.79}) times.push_back(knots[i] + u * (knots[i + 1] - knots[i]));
      const auto motion = curve.sample_rates(QTRAJ_FRAME_BODY, times);
      double fastest = 0, hardest = 0;
      for (size_t i = 0; i < motion.omega.size(); i += 3) {
        const auto size = [i](const std::vector<double>& v) {
          return std::sqrt(v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2]);
        };
        fastest = std::max(fastest, size(motion.omega));
        hardest = std::max(hardest, size(motion.alpha));
      }
      CHECK(fastest <= omega * (1 + 1e-12));
      double shortest = knots[1] - knots[0];
      for (size_t i = 1; i < knots.size(); ++i) shortest = std::min(shortest, knots[i] - knots[i - 1]);
      CHECK(hardest <= alpha * (1 + 1e-12) + 1e-13 * omega / shortest);
      if (method != QTRAJ_ROTATION_SPLINE) continue;
      CHECK(qtraj_iterations(curve.get()) > 0);
      CHECK(qtraj_residual(curve.get()) <= 1e-12);
    }
}

TEST_CASE("C API: ROTATION_SPLINE through a recording has no jumps", "[reference][diagnostics][recordings]") {
  for (const Recording& recording : all_recordings()) {
    CAPTURE(recording.name);
    const Trajectory curve({QTRAJ_ROTATION_SPLINE}, recording.keys);
    const size_t count = recording.keys.count();
    std::vector<double> omega(3 * count), alpha(3 * count);
    REQUIRE(qtraj_curve_jumps(curve.get(), QTRAJ_FRAME_BODY, omega.data(), alpha.data()) == QTRAJ_OK);
    double fastest = 0, hardest = 0, shortest = 1e300;
    REQUIRE(qtraj_curve_peak_rates(curve.get(), &fastest, nullptr, &hardest, nullptr) == QTRAJ_OK);
    for (size_t i = 1; i < count; ++i)
      shortest = std::min(shortest, recording.keys.times[i] - recording.keys.times[i - 1]);
    double omega_jump = 0, alpha_jump = 0;
    for (size_t k = 0; k < 3 * count; ++k) {
      omega_jump = std::max(omega_jump, std::abs(omega[k]));
      alpha_jump = std::max(alpha_jump, std::abs(alpha[k]));
    }
    CHECK(omega_jump <= 1e-12 * fastest);
    CHECK(alpha_jump <= 1e-12 * std::max(hardest, fastest / shortest));
  }
}

}  // namespace
