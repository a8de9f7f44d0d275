// A processor told to treat subnormal numbers as 0 (FTZ and DAZ, as programs for sound and some -ffast-math start-up
// files do): ordinary curves keep their bits, and whatever is OK is finite, unit and goes through its keys.
#include <cfloat>

#include "support/capi_means.hpp"
#include "support/capi_variants.hpp"

#if defined(__x86_64__)
#include <xmmintrin.h>

using namespace capi;

namespace {

constexpr unsigned kFlushing = 0x8040, kControls = ~0x3fu;  // all but the exception flags

// Calls with subnormal results and inputs taken as 0; the register's controls must come back as they went.
template <class Call>
void while_flushing(const Call& call) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | kFlushing);
  call();
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  CHECK((after & kControls) == ((before | kFlushing) & kControls));
}

template <class Real>
bool is_finite(const std::vector<Real>& values) {
  for (const Real value : values)
    if (!std::isfinite(value)) return false;
  return true;
}

// Samples of one curve: by double and float, with rates in both frames.
struct Samples {
  std::vector<qtraj_status> statuses;
  Motion<double> motion, world;
  Motion<float> motion_f32;

  explicit Samples(size_t count) : motion(count), world(count), motion_f32(count) {}
  void take(const qtraj_trajectory* curve, const std::vector<double>& times) {
    const size_t count = times.size();
    const auto rates = [&](int32_t frame, auto& m) {
      statuses.push_back(
          sample_rates(curve, frame, times.data(), count, m.q.data(), m.omega.data(), m.alpha.data(), nullptr));
    };
    rates(QTRAJ_FRAME_BODY, motion), rates(QTRAJ_FRAME_WORLD, world), rates(QTRAJ_FRAME_BODY, motion_f32);
    statuses.push_back(sample(curve, times.data(), count, motion.q.data(), nullptr));
  }
  bool is_same(const Samples& other) const {
    return statuses == other.statuses && same_bits(motion, other.motion) && same_bits(world, other.world) &&
           same_bits(motion_f32, other.motion_f32);
  }
};

TEST_CASE("C API: ordinary curves have the same bits with subnormal numbers taken as 0", "[capi][flush]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      const Options options = make_options(variant);
      REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
              QTRAJ_OK);
      const Keyframes<Real> keys = closed_tour<Real>(9);
      const Rates<Real> rates = rates_for<Real>(variant, 9);
      std::vector<double> times = times_in(keys.times, 20);
      times.insert(times.end(), {-9, 90});
      Samples expected(times.size()), samples(times.size());
      expected.take(must_build(options.get(), keys, rates).get(), times);
      while_flushing([&] { samples.take(build(options.get(), keys, rates).trajectory.get(), times); });
      CHECK(samples.is_same(expected));
    }
  });
}

// The first and the last key of a curve, and what it is there: by how much a component is off, q and -q being one.
double off_at_ends(const qtraj_trajectory* curve) {
  const size_t count = qtraj_key_count(curve);
  std::vector<double> times(count), keys(4 * count), q(4);
  REQUIRE(qtraj_keys(curve, times.data(), keys.data()) == QTRAJ_OK);
  double worst = 0;
  for (const size_t key : {size_t{0}, count - 1}) {
    while_flushing([&] { qtraj_sample_at(curve, times[key], nullptr, q.data()); });
    double off[2] = {0, 0};
    for (size_t k = 0; k < 4; ++k) {
      off[0] = std::max(off[0], std::abs(q[k] - keys[4 * key + k]));
      off[1] = std::max(off[1], std::abs(q[k] + keys[4 * key + k]));
    }
    worst = std::max(worst, std::min(off[0], off[1]));
  }
  return worst;
}

const std::vector<std::vector<double>>& hard_times() {
  static const std::vector<std::vector<double>> rows = {{0, 1, 3, 4},
                                                        {0, 1e-150, 2e-150, 3e-150},
                                                        {-5e-324, 1e-154, 1, 2},
                                                        {1e-310, 1, 2, 1e300},
                                                        {-8e307, 0, 1, 8e307},
                                                        {0, 1, 2, 1.7e308},
                                                        {-8.9e307, 8.9e307 - 1e300, 8.9e307, 8.91e307}};
  return rows;
}

const std::vector<std::vector<double>>& hard_keys() {
  constexpr double kLeast = 5e-324, kMost = DBL_MAX;
  static const std::vector<std::vector<double>> rows = {
      {1, 0, 0, 0, 1, 0.5, 0, 0, 1, 0.5, 0.3, 0, 1, 0, 0.3, 0.2},
      {1, 0, 0, 0, 1, 1e-9, 0, 0, 1, 1e-9, 1e-12, 0, 1, 0, 1e-12, 0},
      {1, kLeast, 0, 0, 1, 1e-310, kLeast, 0, 1, 1e-308, kLeast, kLeast, 1, 1e-160, 0, 0},
      {1e-308, 1e-309, 0, 0, 3e-308, 0, 1e-308, 0, 1e-307, 1e-308, 0, 0, 1e-300, 1e-301, 0, 0},
      {kMost, 1, 1e-300, kLeast, kMost, kMost, 0, 0, 1, 0, 0.5, 0, 1e-160, 1e-160, 0, 0},
      {kLeast, 0, 0, 0, kLeast, kLeast, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}};
  return rows;
}

TEST_CASE("C API: with subnormal numbers taken as 0 a curve that is OK is finite, unit and goes through its keys",
          "[capi][flush]") {
  for (const Variant& variant : variants())
    for (const std::vector<double>& knots : hard_times())
      for (const std::vector<double>& q_wb : hard_keys()) {
        CAPTURE(variant.name, &knots - hard_times().data(), &q_wb - hard_keys().data());
        const Options options = make_options(variant, 0.0);
        REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_HOLD,
                                                QTRAJ_EXTRAPOLATE_CONSTANT_RATE) == QTRAJ_OK);
        Built built{};
        const Keyframes<double> keys{knots, q_wb};
        const Rates<double> rates = rates_for<double>(variant, 4, 0);
        while_flushing([&] { built = build(options.get(), keys, rates); });
        if (built.status != QTRAJ_OK) continue;
        std::vector<double> times = times_in(knots, 9);
        times.insert(times.end(), {-DBL_MAX, DBL_MAX, 5e-324, -1e-310});
        Samples samples(times.size());
        while_flushing([&] { samples.take(built.trajectory.get(), times); });
        CHECK(samples.statuses.back() == QTRAJ_OK);
        CHECK(worst_norm_error(samples.motion.q) <= 4);
        if (samples.statuses[0] == QTRAJ_OK)
          CHECK((is_finite(samples.motion.omega) && is_finite(samples.motion.alpha)));
        if (samples.statuses[2] == QTRAJ_OK) CHECK(worst_norm_error(samples.motion_f32.q) <= 4);
        // winding exponents lose digits in ordinary arithmetic too
        double ordinary = 0;
        if (variant.method == QTRAJ_LOG_SPLINE) {
          const Trajectory curve = build(options.get(), keys, rates).trajectory;
          if (curve) ordinary = off_at_ends(curve.get());
        }
        CHECK(off_at_ends(built.trajectory.get()) <= 1e-14 + ordinary);
      }
}

TEST_CASE("C API: an interval whose reciprocal is subnormal is too long where these are 0", "[capi][flush]") {
  const double q_wb[8] = {1, 0, 0, 0, 1, 1, 0, 0};
  for (const int32_t method : {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_SQUAD, QTRAJ_LOG_SPLINE, QTRAJ_ROTATION_SPLINE}) {
    CAPTURE(method);
    const auto status_of = [&](double start, double end) {
      const double times[2] = {start, end};
      qtraj_trajectory* out = nullptr;
      const qtraj_status status = qtraj_create(method, times, q_wb, 2, &out, nullptr);
      qtraj_destroy(out);
      return status;
    };
    qtraj_status longest{}, too_long{}, shortest{};
    while_flushing([&] {
      longest = status_of(0, 0x1p1020);
      too_long = status_of(0, 1.7e308);
      shortest = status_of(0, 7.4e-155);
    });
    CHECK(longest == QTRAJ_OK);
    CHECK(too_long == QTRAJ_E_TIME_SPAN);
    CHECK(shortest == QTRAJ_E_TIME_ORDER);
    CHECK(status_of(0, 1.7e308) == QTRAJ_OK);
    CHECK(status_of(0, 7.4e-155) == QTRAJ_E_TIME_ORDER);
  }
}

TEST_CASE("C API: means with subnormal numbers taken as 0", "[capi][flush]") {
  test::Random random(3);
  std::vector<double> near, weights;
  for (int i = 0; i < 300; ++i) {
    near.push_back(1);
    for (int k = 0; k < 3; ++k) near.push_back(random.uniform(-0.4, 0.4));
    weights.push_back(random.uniform(0, 1));
  }
  const auto both = [&](const std::vector<double>& q, const double* w, double(&mean)[8]) {
    const size_t count = q.size() / 4;
    double gap, residual;
    int32_t iterations;
    return std::pair(qtraj_mean_eigen(q.data(), w, count, mean, &gap, nullptr),
                     qtraj_mean_karcher(q.data(), w, count, 0, 100, mean + 4, &iterations, &residual, nullptr));
  };
  double expected[8], mean[8];
  for (const double* w : {static_cast<const double*>(nullptr), static_cast<const double*>(weights.data())}) {
    both(near, w, expected);
    while_flushing([&] { both(near, w, mean); });
    CHECK(std::memcmp(mean, expected, sizeof mean) == 0);
  }
  const std::vector<double> hard_weights[] = {{1, 1, 1, 1},
                                              {5e-324, 1e-310, 1e-308, 1},
                                              {5e-324, 5e-324, 5e-324, 5e-324},
                                              {1e-308, 3e-308, 1e-307, 0},
                                              {DBL_MAX, 1e-300, 1e-310, DBL_MAX}};
  for (const std::vector<double>& q : hard_keys())
    for (const std::vector<double>& w : hard_weights) {
      CAPTURE(&q - hard_keys().data(), &w - hard_weights);
      std::pair<qtraj_status, qtraj_status> statuses;
      while_flushing([&] { statuses = both(q, w.data(), mean); });
      if (statuses.first == QTRAJ_OK) CHECK(worst_norm_error(std::vector<double>(mean, mean + 4)) <= 4);
      if (statuses.second == QTRAJ_OK) CHECK(worst_norm_error(std::vector<double>(mean + 4, mean + 8)) <= 4);
    }
}

}  // namespace

#else
TEST_CASE("C API: subnormal numbers taken as 0", "[capi][flush]") { WARN("not run: written for x86-64"); }
#endif
