// Rates before the first and after the last knot, and on which side of a knot they are taken.
#include <cfloat>

#include "support/capi_variants.hpp"
#include "support/ends.hpp"

using namespace capi;

namespace {

constexpr size_t kKeys = 7;
const int32_t kFrames[] = {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD};
const double kDistances[] = {1e-12, 1e-3, 0.5, 10.0, 1e6, 1e15, 1e300, DBL_MAX};

template <class Real>
Trajectory tour(const Variant& variant, int32_t rule) {
  const Options options = make_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), rule, rule) == QTRAJ_OK);
  return must_build(options.get(), closed_tour<Real>(kKeys), rates_for<Real>(variant, kKeys));
}

// Times outside, first all before, then all after.
std::vector<double> times_outside(const qtraj_trajectory* curve) {
  std::vector<double> times;
  const double first = qtraj_start_time(curve), last = qtraj_end_time(curve);
  for (const double distance : kDistances)
    times.push_back(std::min(test::before_all(first, last), std::max(-DBL_MAX, first - distance)));
  for (const double distance : kDistances)
    times.push_back(std::max(test::after_all(first, last), std::min(DBL_MAX, last + distance)));
  return times;
}

template <class Real>
bool is_zero(const std::vector<Real>& values) {
  return std::all_of(values.begin(), values.end(), [](Real x) { return x == 0; });
}

// Largest difference of a row of three from another.
template <class Real>
double distance(const Real* a, const Real* b) {
  double worst = 0;
  for (size_t k = 0; k < 3; ++k)
    worst = std::max(worst, std::abs(static_cast<double>(a[k]) - static_cast<double>(b[k])));
  return worst;
}

template <class Real>
double largest(const std::vector<Real>& values) {
  double most = 0;
  for (const Real value : values) most = std::max(most, std::abs(static_cast<double>(value)));
  return most;
}

TEST_CASE("C API: HOLD has zero rates at any distance", "[capi][rates][extrapolation]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const int32_t frame : kFrames) {
        CAPTURE(variant.name, frame);
        const Trajectory curve = tour<double>(variant, QTRAJ_EXTRAPOLATE_HOLD);
        const Motion<Real> motion = must_sample_rates<Real>(curve.get(), frame, times_outside(curve.get()));
        CHECK(is_zero(motion.omega));
        CHECK(is_zero(motion.alpha));
      }
  });
}

TEST_CASE("C API: CONSTANT_RATE has the rate of the end and no acceleration at any distance",
          "[capi][rates][extrapolation]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const int32_t frame : kFrames) {
        CAPTURE(variant.name, frame);
        const Trajectory curve = tour<double>(variant, QTRAJ_EXTRAPOLATE_CONSTANT_RATE);
        const std::vector<double> times = times_outside(curve.get());
        const Motion<Real> motion = must_sample_rates<Real>(curve.get(), frame, times);
        const Motion<double> ends =
            must_sample_rates<double>(curve.get(), frame, {qtraj_start_time(curve.get()), qtraj_end_time(curve.get())});
        const Motion<double> inside =
            must_sample_rates<double>(curve.get(), frame, times_in(closed_tour<double>(kKeys).times, 9));
        const double tolerance = (sizeof(Real) == 8 ? 1e-13 : 1e-6) * largest(inside.omega);
        const std::vector<Real> end_rates(ends.omega.begin(), ends.omega.end());
        double worst = 0;
        for (size_t i = 0; i < times.size(); ++i)
          worst = std::max(worst, distance(&motion.omega[3 * i], &end_rates[i < times.size() / 2 ? 0 : 3]));
        CHECK(worst <= tolerance);
        CHECK(is_zero(motion.alpha));
      }
  });
}

TEST_CASE("C API: PERIODIC repeats the rates of the curve on either side", "[capi][rates][extrapolation]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const int32_t frame : kFrames) {
        const Trajectory curve = tour<Real>(variant, QTRAJ_EXTRAPOLATE_PERIODIC);
        const double first = qtraj_start_time(curve.get()), period = qtraj_end_time(curve.get()) - first;
        const std::vector<double> knots = closed_tour<Real>(kKeys).times;
        // clear of the knots, where methods may jump
        std::vector<double> inside;
        for (size_t i = 0; i + 1 < kKeys; ++i)
          for (const double u : {0.1, 0.5, 0.9}) inside.push_back(knots[i] + u * (knots[i + 1] - knots[i]));
        const Motion<Real> expected = must_sample_rates<Real>(curve.get(), frame, inside);
        for (const double turns : {1.0, 2.0, 1000.0, -1.0, -1000.0}) {
          CAPTURE(variant.name, frame, turns);
          std::vector<double> times = inside;
          for (double& time : times) time += turns * period;
          const Motion<Real> motion = must_sample_rates<Real>(curve.get(), frame, times);
          const double relative = (sizeof(Real) == 8 ? 1e-12 : 1e-5) * (1 + std::abs(turns));
          double omega = 0, alpha = 0;
          for (size_t i = 0; i < inside.size(); ++i) {
            omega = std::max(omega, distance(&motion.omega[3 * i], &expected.omega[3 * i]));
            alpha = std::max(alpha, distance(&motion.alpha[3 * i], &expected.alpha[3 * i]));
          }
          CHECK(omega <= relative * largest(expected.omega));
          CHECK(alpha <= relative * 10 * (largest(expected.alpha) + largest(expected.omega)));
        }
        // exactly one period on: the right-hand value at the first knot
        const Motion<Real> seam = must_sample_rates<Real>(curve.get(), frame, {first, first + 4 * period});
        CHECK(distance(&seam.omega[0], &seam.omega[3]) <= 1e-5 * largest(expected.omega));
      }
  });
}

TEST_CASE("C API: rates at a knot are those on its right, at the last knot those on its left", "[capi][rates]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    // all rates jump at the knots of these
    for (const int32_t method : {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_SQUAD, QTRAJ_HERMITE})
      for (const int32_t frame : kFrames) {
        CAPTURE(method, frame);
        const Keyframes<Real> keys = closed_tour<Real>(kKeys);
        const Trajectory curve =
            must_build(make_options({"", method}).get(), keys, rates_for<Real>({"", method}, kKeys));
        std::vector<double> beside;
        for (size_t i = 0; i < kKeys; ++i)
          beside.push_back(i + 1 < kKeys ? std::nextafter(keys.times[i], DBL_MAX)
                                         : std::nextafter(keys.times[i], -DBL_MAX));
        const Motion<Real> at = must_sample_rates<Real>(curve.get(), frame, keys.times),
                           near = must_sample_rates<Real>(curve.get(), frame, beside);
        const double relative = sizeof(Real) == 8 ? 1e-13 : 1e-5;
        double omega = 0, alpha = 0;
        for (size_t i = 0; i < kKeys; ++i) {
          omega = std::max(omega, distance(&at.omega[3 * i], &near.omega[3 * i]));
          alpha = std::max(alpha, distance(&at.alpha[3 * i], &near.alpha[3 * i]));
        }
        CHECK(omega <= relative * (largest(at.omega) + largest(at.alpha)));
        CHECK(alpha <= relative * 10 * (largest(at.alpha) + largest(at.omega)));
      }
  });
}

TEST_CASE("C API: body and world rates are one vector seen from two frames", "[capi][rates]") {
  for (const Variant& variant : variants())
    for (const int32_t rule : {QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_PERIODIC}) {
      CAPTURE(variant.name, rule);
      const Trajectory curve = tour<double>(variant, rule);
      std::vector<double> times = times_in(closed_tour<double>(kKeys).times, 5);
      times.insert(times.end(), {-3.0, -2.5, 12.0, 14.5});
      const Motion<double> body = must_sample_rates<double>(curve.get(), QTRAJ_FRAME_BODY, times),
                           world = must_sample_rates<double>(curve.get(), QTRAJ_FRAME_WORLD, times);
      double omega = 0, alpha = 0;
      for (size_t i = 0; i < times.size(); ++i) {
        const double* q = &body.q[4 * i];
        const auto turned = [&](const std::vector<double>& rows) {
          return test::rotate({q[0], q[1], q[2], q[3]}, {rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]});
        };
        omega = std::max(omega, distance(turned(body.omega).data(), &world.omega[3 * i]));
        // the constant-rate end turns about a fixed axis, so alpha = 0 is the same in both
        alpha = std::max(alpha, distance(turned(body.alpha).data(), &world.alpha[3 * i]));
      }
      // far from the end the orientation is rounded, its rates are not
      CHECK(omega <= 1e-13 * largest(world.omega));
      CHECK(alpha <= 1e-13 * (largest(world.alpha) + largest(world.omega)));
      CHECK(same_bits(body.q, world.q));
    }
}

}  // namespace
