// SQUAD whose arcs are close together is evaluated by shorter forms: the same curve as by the general ones.
#include <qtraj.h>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/kernel_curves.hpp"

namespace {

using test::KernelCurve;

constexpr size_t kCount = 600;

struct Motion {
  std::vector<double> q = std::vector<double>(4 * kCount), omega = std::vector<double>(3 * kCount), alpha = omega;
};
Motion sample(const KernelCurve& curve) {
  const double first = curve.knots.front(), step = (curve.knots.back() - first) / (kCount - 1);
  std::vector<double> times(kCount);
  for (size_t i = 0; i < kCount; ++i) times[i] = std::min(first + static_cast<double>(i) * step, curve.knots.back());
  Motion motion;
  REQUIRE(qtraj_sample_rates(curve.get(), QTRAJ_FRAME_BODY, times.data(), kCount, motion.q.data(), motion.omega.data(),
                             motion.alpha.data(), nullptr) == QTRAJ_OK);
  return motion;
}

// What construction wrote may be changed: the handle is ours.
qtraj::NestedArcsSegment* segments_of(const KernelCurve& curve) {
  auto* block = reinterpret_cast<char*>(const_cast<qtraj::Trajectory*>(&curve.core()));
  return reinterpret_cast<qtraj::NestedArcsSegment*>(block + curve.core().segments_offset);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}
double largest(const std::vector<double>& a) { return largest_difference(a, std::vector<double>(a.size())); }

TEST_CASE("close arcs by the shorter forms are the curve of the general ones", "[nested_arcs]") {
  test::for_every_kernel([](const char*) {
    size_t near = 0, far = 0;
    double worst_q = 0, worst_omega = 0, worst_alpha = 0;
    for (size_t keys = 3; keys < 60; ++keys)
      for (const double step : {1e-9, 0.01, 0.3, 0.7, 1.0, 1.4, 1.8, 2.4}) {
        const KernelCurve curve = test::kernel_curve({{"SQUAD", QTRAJ_SQUAD}, keys, step, 0}, QTRAJ_EXTRAPOLATE_ERROR,
                                                     QTRAJ_EXTRAPOLATE_ERROR);
        const Motion shorter = sample(curve);
        for (size_t i = 0; i + 1 < keys; ++i) {
          (segments_of(curve)[i].near > 0 ? near : far) += 1;
          segments_of(curve)[i].near = 0;
        }
        const Motion general = sample(curve);
        // spacings are 0.2 s at the least: A in 1/s^2
        const double speed = largest(general.omega), a = std::max(largest(general.alpha), speed / 0.2);
        worst_q = std::max(worst_q, largest_difference(shorter.q, general.q));
        worst_omega = std::max(worst_omega, largest_difference(shorter.omega, general.omega) / speed);
        worst_alpha = std::max(worst_alpha, largest_difference(shorter.alpha, general.alpha) / a);
      }
    CAPTURE(near, far, worst_q, worst_omega, worst_alpha);
    CHECK(near > 5000);
    CHECK(far > 300);
    CHECK(worst_q <= 8e-16);
    CHECK(worst_omega <= 2e-14);
    CHECK(worst_alpha <= 5e-14);
  });
}

}  // namespace
