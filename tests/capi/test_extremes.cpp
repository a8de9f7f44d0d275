// The ends of what is valid: norms, times and gaps near the limits of their type. Finite input never gives NaN.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr double kNormTolerance = 4;  // eps

const int32_t kOutside[] = {QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_PERIODIC};

// Times between the knots, at and next to them, and far outside.
std::vector<double> probing_times(const std::vector<double>& knots) {
  std::vector<double> times = times_in(knots, 7);
  for (const double knot : knots) {
    times.push_back(std::nextafter(knot, -DBL_MAX));
    times.push_back(std::nextafter(knot, DBL_MAX));
    times.push_back(knot > 0 ? 0.5 * knot : std::max(2 * knot, -DBL_MAX));
  }
  for (const double far : {0.0, 5e-324, 1e-160, 1.0, 1e3, 1e15, 1e154, 1e300, DBL_MAX / 2, DBL_MAX})
    times.insert(times.end(), {far, -far});
  return times;
}

double longest_gap(const std::vector<double>& times) {
  double gap = 0;
  for (size_t i = 1; i < times.size(); ++i) gap = std::max(gap, times[i] - times[i - 1]);
  return gap;
}
double shortest_gap(const std::vector<double>& times) {
  double gap = DBL_MAX;
  for (size_t i = 1; i < times.size(); ++i) gap = std::min(gap, times[i] - times[i - 1]);
  return gap;
}

// Largest over smallest of the keys' largest components.
template <class Real>
double norm_ratio(const std::vector<Real>& q) {
  double least = DBL_MAX, most = 0;
  for (size_t i = 0; i < q.size(); i += 4) {
    double largest = 0;
    for (size_t k = i; k < i + 4; ++k) largest = std::max(largest, std::abs(static_cast<double>(q[k])));
    least = std::min(least, largest), most = std::max(most, largest);
  }
  return least >= 1 || most <= DBL_MAX * least ? most / least : DBL_MAX;
}

// Builds with every extrapolation and samples in double and float, watching flags. Rates are 0: others may be too fast.
template <class Real>
void check_curve(const Variant& variant, const Keyframes<Real>& keys) {
  const std::vector<double> times = probing_times(keys.times);
  const Rates<Real> rates = rates_for<Real>(variant, keys.count(), 0.0);
  for (const int32_t outside : kOutside) {
    CAPTURE(variant.name, outside);
    const Options options = make_options(variant, 0.0);
    REQUIRE(qtraj_options_set_extrapolation(options.get(), outside, outside) == QTRAJ_OK);
    Built built{};
    CHECK(std::string(disturbance([&] { built = build(options.get(), keys, rates); })) == "nothing");
    if (built.status == QTRAJ_E_NO_CONVERGENCE) {
      // steps of radians in a tiny part of the next interval
      CHECK(variant.method == QTRAJ_ROTATION_SPLINE);
      CHECK(built.bad_index == SIZE_MAX);
      CHECK(longest_gap(keys.times) > 1e9 * shortest_gap(keys.times));
      continue;
    }
    if (variant.needs_tangents() && built.status == QTRAJ_E_ZERO_NORM) {
      CHECK(norm_ratio(keys.q) > 0x1p99);  // keys without a direction beside the largest
      continue;
    }
    if (built.status != QTRAJ_OK) {
      // the one other method that valid keyframes can throw out of range, and that must not wind
      CHECK(variant.method == QTRAJ_LOG_SPLINE);
      const bool winds = variant.end == QTRAJ_END_PERIODIC && built.status == QTRAJ_E_NOT_CLOSED;
      CHECK((winds || built.status == QTRAJ_E_NOT_FINITE));
      CHECK(built.bad_index < keys.count());
      continue;
    }
    std::vector<double> q(4 * times.size());
    std::vector<float> q_f32(4 * times.size());
    qtraj_status status = QTRAJ_E_INTERNAL, status_f32 = QTRAJ_E_INTERNAL;
    CHECK(std::string(disturbance([&] {
            status = sample(built.trajectory.get(), times.data(), times.size(), q.data(), nullptr);
            status_f32 = sample(built.trajectory.get(), times.data(), times.size(), q_f32.data(), nullptr);
          })) == "nothing");
    CHECK(status == QTRAJ_OK);
    CHECK(status_f32 == QTRAJ_OK);
    CHECK(worst_norm_error(q) <= kNormTolerance);
    CHECK(worst_norm_error(q_f32) <= kNormTolerance);
  }
}

TEST_CASE("C API: keys of any finite norm give the curve of their directions", "[capi][extremes]") {
  for (const Variant& variant : variants())
    for (const double scale : {1e-160, 1e-150, 1e150, 1e160, 1e-300, 1e300}) {
      CAPTURE(variant.name, scale);
      if (variant.needs_tangents()) continue;  // goes through keys as they are
      Keyframes<double> keys = closed_tour<double>(6);
      const Rates<double> rates = rates_for<double>(variant, 6);
      const std::vector<double> times = times_in(keys.times, 6);
      const Options options = make_options(variant);
      const std::vector<double> expected = must_sample<double>(must_build(options.get(), keys, rates).get(), times);
      for (size_t key = 0; key < 6; key += 2)
        for (size_t k = 0; k < 4; ++k) keys.q[4 * key + k] *= scale;
      const std::vector<double> q = must_sample<double>(must_build(options.get(), keys, rates).get(), times);
      double worst = 0;
      for (size_t i = 0; i < q.size(); ++i) worst = std::max(worst, std::abs(q[i] - expected[i]));
      CHECK(worst <= 1e-14);
      check_curve(variant, keys);
    }
}

TEST_CASE("C API: float keys of any norm from 1e-30 to 1e30 give the curve of their directions", "[capi][extremes]") {
  for (const Variant& variant : variants())
    for (const float scale : {1e-30f, 1e-37f, 1e30f, 1e37f}) {
      CAPTURE(variant.name, scale);
      if (variant.needs_tangents()) continue;  // goes through keys as they are
      Keyframes<float> keys = closed_tour<float>(6);
      const Rates<float> rates = rates_for<float>(variant, 6);
      const std::vector<double> times = times_in(keys.times, 6);
      const Options options = make_options(variant);
      const std::vector<float> expected = must_sample<float>(must_build(options.get(), keys, rates).get(), times);
      for (size_t key = 0; key < 6; key += 2)
        for (size_t k = 0; k < 4; ++k) keys.q[4 * key + k] *= scale;
      const std::vector<float> q = must_sample<float>(must_build(options.get(), keys, rates).get(), times);
      double worst = 0;
      for (size_t i = 0; i < q.size(); ++i) worst = std::max(worst, std::abs(static_cast<double>(q[i] - expected[i])));
      CHECK(worst <= 2e-6);
      check_curve(variant, keys);
    }
}

TEST_CASE("C API: keys made of the largest and the least numbers are orientations like others", "[capi][extremes]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    constexpr Real kMost = std::numeric_limits<Real>::max(), kLeast = std::numeric_limits<Real>::denorm_min();
    const std::vector<Real> rows[] = {
        {kMost, kMost, kMost, kMost, kMost, kMost, kMost, -kMost, kMost, kMost, -kMost, kMost, kMost, kMost, kMost,
         kMost},
        {kLeast, 0, 0, 0, kLeast, kLeast, 0, 0, 0, kLeast, kLeast, 0, kLeast, 0, 0, 0},
        {kMost, kLeast, kLeast, kLeast, 1, 1, kLeast, kLeast, kMost, kMost, 1, kLeast, kMost, kLeast, kLeast, 0},
        {1, kLeast, 0, 0, 1, 0, kLeast, 0, 1, kLeast, kLeast, kLeast, 1, kLeast, 0, 0},
    };
    for (const std::vector<Real>& q : rows)
      for (const Variant& variant : variants()) {
        CAPTURE(&q - rows);
        if (variant.reference != QTRAJ_REFERENCE_MEAN || q[0] != kLeast)  // that mean is ambiguous
          check_curve(variant, Keyframes<Real>{{0, 1, 3, 4}, q});
      }
  });
}

TEST_CASE("C API: keys a half turn apart, repeated or a hair apart are orientations like others", "[capi][extremes]") {
  const std::vector<double> rows[] = {
      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0},             // half turns
      {1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0},           // one orientation, all signs
      {1, 0, 0, 0, 1, 1e-200, 0, 0, 1, 0, 1e-154, 0, 1, 0, 0, 0},   // steps whose squares vanish
      {1, 0, 0, 0, 1, 1e-16, 0, 0, 1, 0, 1e-17, 0, 1, 0, 0, 0},     // steps near rounding
      {1, 0, 0, 0, 5e-324, 1, 0, 0, -5e-324, 1, 0, 0, 1, 0, 0, 0},  // either side of a half turn
      {0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5},
  };
  for (const std::vector<double>& q : rows)
    for (const Variant& variant : variants()) {
      CAPTURE(&q - rows);
      const bool half_turns = &q == &rows[0] || &q == &rows[4];
      if (variant.reference == QTRAJ_REFERENCE_MEAN && half_turns) continue;  // may be ambiguous
      check_curve(variant, Keyframes<double>{{0, 1, 3, 4}, q});
    }
}

TEST_CASE("C API: SQUAD turns by half a turn from rest to rest", "[capi][extremes][squad]") {
  // the arc between its controls then spans half of S^3, and so has no middle
  for (const double along : {1.0, 0.6}) {
    const Keyframes<double> keys = {{0, 1}, {1, 0, 0, 0, 0, along, std::sqrt(1 - along * along), 0}};
    const Options options = make_options({"", QTRAJ_SQUAD, QTRAJ_END_GIVEN}, 0.0);
    const Trajectory curve = must_build(options.get(), keys);
    const std::vector<double> times = times_in(keys.times, 100);
    const std::vector<double> q = must_sample<double>(curve.get(), times);
    CHECK(worst_norm_error(q) <= kNormTolerance);
    CHECK(worst_norm_error(must_sample<float>(curve.get(), times)) <= kNormTolerance);
    CHECK(std::abs(q[0] - 1) <= 4 * DBL_EPSILON);
    CHECK(std::abs(q[q.size() - 3] - along) <= 4 * DBL_EPSILON);
  }
}

TEST_CASE("C API: knots and gaps of any size that is valid give finite unit samples", "[capi][extremes]") {
  constexpr double kLeastGap = 7.5e-155;
  double near_most[5];
  near_most[4] = DBL_MAX;
  for (int i = 4; i > 0; --i) near_most[i - 1] = std::nextafter(near_most[i], 0.0);
  const std::vector<std::vector<double>> rows = {
      {-DBL_MAX / 2, -DBL_MAX / 4, 0, DBL_MAX / 4, DBL_MAX / 2},
      {-DBL_MAX / 2, -1, 0, 1, DBL_MAX / 2},
      {-DBL_MAX, -DBL_MAX / 2, -DBL_MAX / 4, -1, 0},
      {0, 1e-154, 1, 1e300, DBL_MAX},
      {0, kLeastGap, 2 * kLeastGap, 3 * kLeastGap, 4 * kLeastGap},
      {-kLeastGap, 0, kLeastGap, 2 * kLeastGap, 1e300},
      {0, 1e-154, 1e300, 1.5e300, 1.7e308},
      {-1e300, 0, 1e-154, 1, 1e300},
      {-1e300, -1e-154, 0, 1e-154, 1e300},
      {-1.7e308, -1e-100, 1e-154, 1e-50, 1},
      {0, 1e-154, 1e-100, 1e-50, 1},
      {0, 1, 1 + 1e-15, 2, 3},
      {0, 1e-15, 1e-8, 1, 1e8},
      {1e300, 1.1e300, 1.2e300, 1e301, 1e302},
      {-DBL_MAX, std::nextafter(-DBL_MAX, 0.0), -1e300, -1, -1e-154},
      {near_most, near_most + 5},
      {0, 1e308, 1.1e308, 1.7e308, DBL_MAX},
      {1.6e9, 1.6e9 + 1e-4, 1.6e9 + 12, 1.6e9 + 12.0001, 1.6e9 + 100},
  };
  const std::vector<double> wide = {1, 0, 0, 0, 0.1, 1, 0.2, 0, 0.1, 0.2, 1, 0.3, 0.8, -0.7, 0.3, 1, 1, 0, 0, 0};
  const std::vector<double> half_turns = {1, 0, 0, 0, 1e-9, 1, 0, 0, 0, 0, 1, 1e-9, 0.6, 0.8, 0, 0, -1, 0, 0, 0};
  for (const std::vector<double>& times : rows) {
    CAPTURE(&times - rows.data());
    const Keyframes<double> tour = {times, closed_tour<double>(5).q};
    const Keyframes<float> tour_f32 = {times, closed_tour<float>(5).q};
    for (const Variant& variant : variants()) {
      check_curve(variant, tour);
      check_curve(variant, tour_f32);
      check_curve(variant, Keyframes<double>{times, wide});
      if (variant.reference != QTRAJ_REFERENCE_MEAN) check_curve(variant, Keyframes<double>{times, half_turns});
    }
  }
}

TEST_CASE("C API: two keys, the least count, serve every method at every distance in time", "[capi][extremes]") {
  const double pairs[][2] = {{0, 7.5e-155},
                             {0, DBL_MAX},
                             {-DBL_MAX, 0},
                             {-DBL_MAX / 2, DBL_MAX / 2},
                             {std::nextafter(DBL_MAX, 0.0), DBL_MAX},
                             {-1e-154, 1e-154},
                             {0, 1}};
  for (const Variant& variant : variants())
    for (const double(&times)[2] : pairs) {
      CAPTURE(&times - pairs);
      check_curve(variant, Keyframes<double>{{times[0], times[1]}, {0.5, 0.5, -0.5, 0.5, -2, -2, 2, -2}});
    }
}

}  // namespace
