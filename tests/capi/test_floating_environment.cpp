// Only FE_INEXACT and FE_UNDERFLOW may be raised, whatever the input; traps, rounding mode and errno are the caller's.
#include <cfloat>
#include <string>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
const std::string kNothing = "nothing";

// Times inside, outside, far off and not finite.
std::vector<double> all_times(const std::vector<double>& knots) {
  std::vector<double> times = times_in(knots, 4);
  times.insert(times.end(), {kNaN, -kNaN, kInfinity, -kInfinity, DBL_MAX, -DBL_MAX, 1e300, -1e300, 1e15, -1e15, 1e3,
                             -1e3, 5e-324, -5e-324, 0.0, -0.0});
  times.emplace_back();
  set_signalling_nan(times.back());
  return times;
}

template <class Real>
std::string sampling_disturbs(const qtraj_trajectory* trajectory, const std::vector<double>& times) {
  const size_t count = times.size();
  std::vector<Real> q(4 * count);
  size_t bad_index = 0, cursor = SIZE_MAX;
  std::vector<Real> omega(3 * count), alpha(3 * count);
  std::string found = disturbance([&] { sample(trajectory, times.data(), count, q.data(), &bad_index); });
  if (found != kNothing) return "sample " + found;
  for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
    found = disturbance([&] {
      sample_rates(trajectory, frame, times.data(), count, q.data(), omega.data(), alpha.data(), &bad_index);
      for (const double& time : times)
        sample_rates_at(trajectory, frame, time, &cursor, q.data(), omega.data(), alpha.data());
    });
    if (found != kNothing) return "sample_rates " + found;
  }
  found = disturbance([&] {
    for (const double& time : times) sample_at(trajectory, time, &cursor, q.data());
  });
  return found == kNothing ? found : "sample_at " + found;
}

struct Extrapolation {
  int32_t before, after;
};
const Extrapolation kExtrapolations[] = {{QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR},
                                         {QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE},
                                         {QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_HOLD},
                                         {QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC}};

TEST_CASE("C API: sampling raises nothing but FE_INEXACT and FE_UNDERFLOW at any time", "[capi][floating]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const Extrapolation& outside : kExtrapolations) {
        CAPTURE(variant.name, outside.before, outside.after);
        const Options options = make_options(variant);
        REQUIRE(qtraj_options_set_extrapolation(options.get(), outside.before, outside.after) == QTRAJ_OK);
        const Keyframes<Real> keys = closed_tour<Real>(6);
        const Trajectory curve = must_build(options.get(), keys, rates_for<Real>(variant, 6));
        CHECK(sampling_disturbs<double>(curve.get(), all_times(keys.times)) == kNothing);
        CHECK(sampling_disturbs<float>(curve.get(), all_times(keys.times)) == kNothing);
      }
  });
}

TEST_CASE("C API: sample_uniform raises nothing where its times overflow or are not finite", "[capi][floating]") {
  const double third = std::nextafter(DBL_MAX / 3, kInfinity);  // DBL_MAX / third rounds to 3, 3 * third to infinity
  double signalling;
  set_signalling_nan(signalling);
  const double values[] = {kNaN,   kInfinity,   -kInfinity, signalling, DBL_MAX, -DBL_MAX, 1e308, -1e308, third,
                           -third, DBL_MAX / 7, 1e300,      1,          0.25,    0.0,      -0.0,  5e-324};
  const Trajectory curve = must_build(make_options({"", QTRAJ_SLERP}).get(), closed_tour<double>(6));
  std::vector<double> q(4 * 12);
  std::vector<float> q_f32(4 * 12);
  for (const double& start : values)
    for (const double& step : values)
      for (const size_t count : {size_t{1}, size_t{2}, size_t{4}, size_t{12}}) {
        CAPTURE(start, step, count);
        CHECK(disturbance([&] { qtraj_sample_uniform(curve.get(), start, step, count, q.data(), nullptr); }) ==
              kNothing);
        CHECK(disturbance([&] { qtraj_sample_uniform_f32(curve.get(), start, step, count, q_f32.data(), nullptr); }) ==
              kNothing);
      }
}

TEST_CASE("C API: constructors raise nothing on good, singular and faulty keyframes", "[capi][floating]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Real signalling;
    set_signalling_nan(signalling);
    // what is written over the components of the third key
    const Real values[] = {Real(kNaN),
                           Real(kInfinity),
                           Real(-kInfinity),
                           Real(0),
                           Real(-0.0),
                           std::numeric_limits<Real>::max(),
                           std::numeric_limits<Real>::denorm_min(),
                           std::numeric_limits<Real>::min(),
                           Real(1e-30),
                           Real(1e30),
                           signalling};
    for (const Variant& variant : variants())
      for (const Real& value : values)
        for (const size_t components : {size_t{1}, size_t{4}}) {
          CAPTURE(variant.name, value, components);
          const Options options = make_options(variant);
          Keyframes<Real> keys = closed_tour<Real>(6);
          for (size_t k = 0; k < components; ++k) std::memcpy(&keys.q[8 + k], &value, sizeof value);
          const Rates<Real> rates = rates_for<Real>(variant, 6);
          CHECK(disturbance([&] { build(options.get(), keys, rates); }) == kNothing);
        }
  });
}

// Pairs of keys with a long gap between them, the second near 0: the third and the fourth key are equally far from the
// first to rounding, a division by 0 for whoever interpolates its rate.
TEST_CASE("C API: estimated ends raise nothing where the distances of two keys round to one", "[capi][floating]") {
  const double early = std::nextafter(-1.0, 0.0), late = std::nextafter(-0.01, 0.0);
  const std::vector<double> times = {-1, early, -0.01, late, 1}, mirrored = {-1, -late, 0.01, -early, 1};
  REQUIRE(times[2] - times[0] == times[3] - times[0]);
  for (const int32_t method : {QTRAJ_SQUAD, QTRAJ_ROTATION_SPLINE})
    for (const std::vector<double>& knots : {times, mirrored}) {
      CAPTURE(method, knots[1]);
      Keyframes<double> keys{knots, {}};
      for (int key = 0; key < 5; ++key) keys.q.insert(keys.q.end(), {std::cos(0.1 * key), std::sin(0.1 * key), 0, 0});
      const Options options = make_options({"", method, QTRAJ_END_ESTIMATED});
      must_build(options.get(), keys);
      CHECK(disturbance([&] { build(options.get(), keys); }) == kNothing);
    }
}

TEST_CASE("C API: constructors raise nothing on faulty times and rates", "[capi][floating]") {
  const std::vector<std::vector<double>> rows = {
      {0, 1, 2, 3, 4, kNaN},
      {kNaN, 1, 2, 3, 4, 5},
      {-kInfinity, 0, 1, 2, 3, 4},
      {0, 1, 2, 3, 4, kInfinity},
      {0, 0, 0, 0, 0, 0},
      {5, 4, 3, 2, 1, 0},
      {0, 5e-324, 1, 2, 3, 4},
      {0, 7.4e-155, 1, 2, 3, 4},
      {-DBL_MAX, 0, DBL_MAX, 0, 0, 0},
      {DBL_MAX, -DBL_MAX, 0, 0, 0, 0},
      {-DBL_MAX, -1e300, 0, 1, 2, 1e300},
  };
  double signalling;
  set_signalling_nan(signalling);
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Options options = make_options(variant);
    Keyframes<double> keys = closed_tour<double>(6);
    Rates<double> rates = rates_for<double>(variant, 6);
    for (const std::vector<double>& times : rows) {
      CAPTURE(&times - rows.data());
      CHECK(disturbance([&] { build(options.get(), Keyframes<double>{times, keys.q}, rates); }) == kNothing);
    }
    if (rates.omega.empty()) continue;
    for (const double value : {kNaN, kInfinity, DBL_MAX, -1e300, 1e156, 5e-324}) {
      Rates<double> faulty = rates;
      faulty.omega[4] = value;
      CHECK(disturbance([&] { build(options.get(), keys, faulty); }) == kNothing);
      if (!variant.needs_alpha()) continue;
      faulty.omega[4] = 0;
      faulty.alpha[4] = value;
      CHECK(disturbance([&] { build(options.get(), keys, rates); }) == kNothing);
    }
    Rates<float> rates_f32 = rates_for<float>(variant, 6);
    set_signalling_nan(rates_f32.omega[4]);
    std::memcpy(&rates.omega[4], &signalling, sizeof signalling);
    CHECK(disturbance([&] { build(options.get(), keys, rates); }) == kNothing);
    CHECK(disturbance([&] { build(options.get(), closed_tour<float>(6), rates_f32); }) == kNothing);
  }
}

TEST_CASE("C API: setters, sizes and getters raise nothing", "[capi][floating]") {
  double signalling;
  set_signalling_nan(signalling);
  for (const double value : {kNaN, kInfinity, DBL_MAX, 5e-324, 0.0, -1.0}) {
    const double omega[2][3] = {{value, 0, 1}, {signalling, 0, 1}};
    const double q_wb[2][4] = {{value, 0, 0, 0}, {0, 0, 0, signalling}};
    const Options squad = make_options({"", QTRAJ_SQUAD, QTRAJ_END_GIVEN}),
                  spline = make_options({"", QTRAJ_LOG_SPLINE});
    for (int row = 0; row < 2; ++row) {
      CHECK(disturbance([&] { qtraj_options_set_end_rates(squad.get(), QTRAJ_FRAME_BODY, omega[row], omega[row]); }) ==
            kNothing);
      CHECK(disturbance([&] { qtraj_options_set_reference(spline.get(), QTRAJ_REFERENCE_GIVEN, q_wb[row]); }) ==
            kNothing);
    }
  }
  for (const int32_t method : all_methods()) {
    const Options options = make_options({"", method});
    const Trajectory curve = must_build(options.get(), closed_tour<double>(6), rates_for<double>({"", method}, 6));
    for (const qtraj_trajectory* trajectory :
         {static_cast<const qtraj_trajectory*>(nullptr), static_cast<const qtraj_trajectory*>(curve.get())})
      CHECK(disturbance([&] {
              size_t bytes;
              double times[6], q[24], norm, time;
              qtraj_init_size(options.get(), 100, &bytes);
              qtraj_init_size(options.get(), SIZE_MAX, &bytes);
              qtraj_method(trajectory), qtraj_key_count(trajectory), qtraj_start_time(trajectory);
              qtraj_end_time(trajectory), qtraj_sign_flips(trajectory), qtraj_worst_norm_error(trajectory);
              qtraj_least_dot(trajectory), qtraj_iterations(trajectory), qtraj_residual(trajectory);
              qtraj_keys(trajectory, times, q), qtraj_curve_least_norm(trajectory, &norm, &time);
              qtraj_curve_jumps(trajectory, QTRAJ_FRAME_WORLD, q, nullptr), qtraj_curve_energy(trajectory, &norm);
              qtraj_curve_peak_rates(trajectory, &norm, &time, nullptr, nullptr),
                  qtraj_curve_total_angle(trajectory, &norm);
              qtraj_version(), qtraj_version_number(), qtraj_target(), qtraj_status_text(1000);
            }) == kNothing);
  }
}

TEST_CASE("C API: curves that end at 0 or beside it leave flags and errno alone", "[capi][floating]") {
  const double lasts[] = {0, 5e-324, -5e-324, 1e-310, -1e-310, DBL_MIN, -DBL_MIN, 2 * DBL_MIN, -2 * DBL_MIN};
  const double q[] = {1, 0, 0, 0, 1, 0, 0, 1};
  for (const double last : lasts) {
    CAPTURE(last);
    const double times[] = {-1, last};
    qtraj_trajectory* made = nullptr;
    double end[4] = {0, 0, 0, 0};
    qtraj_status status = QTRAJ_E_INTERNAL;
    CHECK(disturbance([&] {
            qtraj_destroy(made);  // of the call before
            status = qtraj_create(QTRAJ_SLERP, times, q, 2, &made, nullptr);
          }) == kNothing);
    const Trajectory curve(made);
    REQUIRE(status == QTRAJ_OK);
    CHECK(qtraj_sample_at(made, last, nullptr, end) == QTRAJ_OK);
    CHECK(std::abs(end[3] - std::sqrt(0.5)) < 1e-15);
  }
}

TEST_CASE("C API: in other rounding modes samples stay finite and the mode stays set", "[capi][floating]") {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for (const Variant& variant : variants()) {
      CAPTURE(mode, variant.name);
      const Options options = make_options(variant);
      REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
              QTRAJ_OK);
      const Keyframes<double> keys = closed_tour<double>(6);
      const Rates<double> rates = rates_for<double>(variant, 6);
      const std::vector<double> times = times_in(keys.times, 5);
      std::vector<double> q(4 * times.size());
      REQUIRE(std::fesetround(mode) == 0);
      const Built built = build(options.get(), keys, rates);
      const qtraj_status status =
          built.trajectory ? sample(built.trajectory.get(), times.data(), times.size(), q.data(), nullptr) : QTRAJ_OK;
      const int mode_after = std::fegetround();
      std::fesetround(FE_TONEAREST);
      CHECK(mode_after == mode);
      CHECK(status == QTRAJ_OK);
      if (built.trajectory) CHECK(worst_norm_error(q) <= 1e8);
    }
}

}  // namespace
