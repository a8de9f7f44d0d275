// qtraj_sample_many: arguments at fault, rows at fault, and what it gives on curves of the C API alone.
#include <cfloat>
#include <limits>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

qtraj_status sample_many(const qtraj_trajectory* const* curves, size_t series, int32_t frame, const double* times,
                         size_t count, int32_t layout, double* q, double* omega, double* alpha, size_t* bad_index) {
  return qtraj_sample_many(curves, series, frame, times, count, layout, q, omega, alpha, bad_index);
}
qtraj_status sample_many(const qtraj_trajectory* const* curves, size_t series, int32_t frame, const double* times,
                         size_t count, int32_t layout, float* q, float* omega, float* alpha, size_t* bad_index) {
  return qtraj_sample_many_f32(curves, series, frame, times, count, layout, q, omega, alpha, bad_index);
}

// Memory that is no handle.
const qtraj_trajectory* no_trajectory() {
  static const uint64_t words[200] = {};
  return reinterpret_cast<const qtraj_trajectory*>(words);
}

// A call of 3 curves at 5 times, good as it is.
template <class Real>
struct Arguments {
  static constexpr size_t kSeries = 3, kCount = 5;
  std::vector<Trajectory> owned;
  const qtraj_trajectory* handles[kSeries];
  double time_values[kCount] = {-1.5, 0, 1, 2, -1.0};
  std::vector<Real> q_rows = std::vector<Real>(4 * kSeries * kCount, Real(7)),
                    omega_rows = std::vector<Real>(3 * kSeries * kCount, Real(7)),
                    alpha_rows = std::vector<Real>(3 * kSeries * kCount, Real(7));

  const qtraj_trajectory* const* curves = handles;
  size_t series = kSeries, count = kCount, bad_index = 12345;
  const double* times = time_values;
  int32_t frame = QTRAJ_FRAME_BODY, layout = QTRAJ_LAYOUT_SERIES_FIRST;
  Real *q = q_rows.data(), *omega = omega_rows.data(), *alpha = alpha_rows.data();

  Arguments() {
    for (size_t k = 0; k < kSeries; ++k) {
      const Variant variant = {"", k == 1 ? QTRAJ_SQUAD : QTRAJ_SLERP};
      owned.push_back(must_build(make_options(variant).get(), closed_tour<Real>(8 + k)));
      handles[k] = owned.back().get();
    }
  }
  Arguments(const Arguments&) = delete;

  qtraj_status call() { return sample_many(curves, series, frame, times, count, layout, q, omega, alpha, &bad_index); }
  bool untouched() const {
    const auto holds_7 = [](const std::vector<Real>& rows) {
      return std::all_of(rows.begin(), rows.end(), [](Real value) { return value == Real(7); });
    };
    return holds_7(q_rows) && holds_7(omega_rows) && holds_7(alpha_rows);
  }
};

// The call with one thing changed is refused with nothing written.
template <class Change>
void check_refused(qtraj_status expected, const Change& change) {
  for_double_and_float([&](auto zero) {
    Arguments<decltype(zero)> arguments;
    change(arguments);
    CHECK(arguments.call() == expected);
    CHECK(arguments.bad_index == SIZE_MAX);
    CHECK(arguments.untouched());
  });
}

TEST_CASE("C API: sample_many refuses what is missing, in the order NULL, HANDLE, SIZE, VALUE, OVERLAP",
          "[capi][sample_many][errors]") {
  check_refused(QTRAJ_E_NULL, [](auto& a) { a.curves = nullptr; });
  check_refused(QTRAJ_E_NULL, [](auto& a) { a.times = nullptr; });
  check_refused(QTRAJ_E_NULL, [](auto& a) { a.q = a.omega = a.alpha = nullptr; });
  check_refused(QTRAJ_E_NULL, [](auto& a) { a.handles[2] = nullptr; });
  check_refused(QTRAJ_E_NULL, [](auto& a) { a.handles[1] = nullptr, a.count = 0; });
  check_refused(QTRAJ_E_NULL, [](auto& a) { a.times = nullptr, a.series = SIZE_MAX; });
  // a missing trajectory before one that is none
  check_refused(QTRAJ_E_NULL, [](auto& a) {
    a.handles[0] = no_trajectory();
    a.handles[2] = nullptr;
  });
  for (const size_t k : {size_t{0}, size_t{2}}) {
    check_refused(QTRAJ_E_HANDLE, [&](auto& a) {
      a.handles[k] = no_trajectory();
      a.frame = 0, a.count = SIZE_MAX;
    });
    check_refused(QTRAJ_E_HANDLE, [&](auto& a) {
      a.handles[k] = reinterpret_cast<const qtraj_trajectory*>(reinterpret_cast<const char*>(a.handles[k]) + 4);
      a.count = 0;
    });
  }
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 3 + 1, SIZE_MAX / 24 + 1, size_t{PTRDIFF_MAX} / 48 + 1})
    check_refused(QTRAJ_E_SIZE, [&](auto& a) { a.count = count, a.layout = 0; });
  check_refused(QTRAJ_E_SIZE, [](auto& a) { a.series = SIZE_MAX; });
  check_refused(QTRAJ_E_SIZE, [](auto& a) { a.series = SIZE_MAX / 8 + 2, a.count = 8; });
  for (const int32_t layout : {0, 1, 800, 803, -1, 101})
    check_refused(QTRAJ_E_VALUE, [&](auto& a) { a.layout = layout, a.q = a.omega; });
  for (const int32_t frame : {0, 100, 103, 801})
    check_refused(QTRAJ_E_VALUE, [&](auto& a) { a.frame = frame, a.q = a.omega; });
}

TEST_CASE("C API: an output of sample_many may overlap no other array", "[capi][sample_many][errors]") {
  check_refused(QTRAJ_E_OVERLAP, [](auto& a) { a.q = a.omega; });
  check_refused(QTRAJ_E_OVERLAP, [](auto& a) { a.alpha = a.omega + 3 * 15 - 1; });
  check_refused(QTRAJ_E_OVERLAP, [](auto& a) { a.alpha = a.q + 4 * 15 - 1; });
  check_refused(QTRAJ_E_OVERLAP, [](auto& a) { a.times = reinterpret_cast<const double*>(a.q); });
  check_refused(QTRAJ_E_OVERLAP, [](auto& a) { a.times = reinterpret_cast<const double*>(a.alpha + 2); });
  // trajectories that stand where the rows go
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Arguments<Real> a;
    std::vector<uint64_t> memory(100);
    std::memcpy(memory.data() + 9, a.handles, sizeof a.handles);
    const std::vector<uint64_t> before = memory;
    a.curves = reinterpret_cast<const qtraj_trajectory* const*>(memory.data() + 9);
    a.omega = reinterpret_cast<Real*>(memory.data()), a.q = nullptr;
    CHECK(a.call() == QTRAJ_E_OVERLAP);
    CHECK(memory == before);
  });
}

TEST_CASE("C API: sample_many of nothing is OK", "[capi][sample_many]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Arguments<Real> a;
    Real* const none = nullptr;
    size_t bad_index = 0;
    CHECK(sample_many(nullptr, 0, QTRAJ_FRAME_BODY, nullptr, 5, QTRAJ_LAYOUT_TIME_FIRST, none, none, none,
                      &bad_index) == QTRAJ_OK);
    CHECK(bad_index == SIZE_MAX);
    CHECK(sample_many(a.curves, 3, QTRAJ_FRAME_BODY, nullptr, 0, QTRAJ_LAYOUT_SERIES_FIRST, none, none, none,
                      nullptr) == QTRAJ_OK);
    a.count = 0;
    CHECK(a.call() == QTRAJ_OK);
    CHECK(a.untouched());
  });
}

// Good rows, and where a time is at fault the fault in each series: the first of them in the order of the rows counts.
TEST_CASE("C API: rows of sample_many at fault are NaN, all others right, the status that of the first row",
          "[capi][sample_many][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const int32_t layout : {QTRAJ_LAYOUT_SERIES_FIRST, QTRAJ_LAYOUT_TIME_FIRST})
      for (const size_t count : {size_t{5}, size_t{60}}) {
        CAPTURE(layout, count);
        Arguments<Real> a;
        std::vector<double> times(count, 0.25);
        times[3] = kNaN;
        times[count - 1] = -100;
        a.times = times.data(), a.count = count, a.layout = layout;
        std::vector<Real> q(12 * count);
        a.q = q.data(), a.omega = a.alpha = nullptr;
        CHECK(a.call() == QTRAJ_E_NOT_FINITE);
        const bool is_time_first = layout == QTRAJ_LAYOUT_TIME_FIRST;
        CHECK(a.bad_index == (is_time_first ? 9 : 3));
        for (size_t k = 0; k < 3; ++k) {
          const std::vector<Real> good = must_sample<Real>(a.handles[k], {0.25});
          size_t wrong = 0;
          for (size_t i = 0; i < count; ++i) {
            const Real* const row = &q[4 * (is_time_first ? 3 * i + k : count * k + i)];
            const bool is_fault = i == 3 || i == count - 1;
            wrong += is_fault ? !std::isnan(row[0]) || !std::isnan(row[3])
                              : std::memcmp(row, good.data(), sizeof(Real[4])) != 0;
          }
          CHECK(wrong == 0);
        }
      }
  });
}

TEST_CASE("C API: a rate of sample_many that overflows makes its row NaN and no other", "[capi][sample_many][errors]") {
  // a turn in 1e-154 s: its acceleration is past DBL_MAX
  const std::vector<double> fast_times = {0, 1e-154}, slow_times = {0, 1};
  const std::vector<double> q = {1, 0, 0, 0, 0.6, 0.8, 0, 0};
  const Options options = make_options({"", QTRAJ_ROTATION_SPLINE});
  REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD) == QTRAJ_OK);
  const double rate[3] = {0.1, 0.2, 0};
  REQUIRE(qtraj_options_set_ends(options.get(), QTRAJ_END_GIVEN, QTRAJ_END_GIVEN) == QTRAJ_OK);
  REQUIRE(qtraj_options_set_end_rates(options.get(), QTRAJ_FRAME_BODY, rate, rate) == QTRAJ_OK);
  const Trajectory fast = must_build(options.get(), Keyframes<double>{fast_times, q}),
                   slow = must_build(options.get(), Keyframes<double>{slow_times, q});
  std::vector<const qtraj_trajectory*> rig(40, slow.get());
  rig[13] = fast.get();
  const double time = 0;
  std::vector<double> omega(120), alpha(120), expected(3);
  size_t bad_index = 0;
  const qtraj_status one =
      qtraj_sample_rates(fast.get(), QTRAJ_FRAME_WORLD, &time, 1, nullptr, nullptr, expected.data(), nullptr);
  CHECK(one == QTRAJ_E_NOT_FINITE);
  CHECK(qtraj_sample_many(rig.data(), 40, QTRAJ_FRAME_WORLD, &time, 1, QTRAJ_LAYOUT_SERIES_FIRST, nullptr, omega.data(),
                          alpha.data(), &bad_index) == QTRAJ_E_NOT_FINITE);
  CHECK(bad_index == 13);
  const Motion<double> right = must_sample_rates<double>(slow.get(), QTRAJ_FRAME_WORLD, {time});
  for (size_t k = 0; k < 40; ++k) {
    CAPTURE(k);
    if (k == 13)
      CHECK((std::isnan(omega[3 * k]) && std::isnan(alpha[3 * k + 2])));
    else
      CHECK((std::memcmp(&omega[3 * k], right.omega.data(), sizeof(double[3])) == 0 &&
             std::memcmp(&alpha[3 * k], right.alpha.data(), sizeof(double[3])) == 0));
  }
}

TEST_CASE("C API: sample_many raises no floating-point flag and leaves errno alone", "[capi][sample_many]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Arguments<Real> a;
    double times[] = {-1.5, 1e300, 0, -1.0, 0};
    set_signalling_nan(times[2]);
    a.times = times;
    for (const size_t series : {size_t{1}, size_t{3}}) {
      a.series = series;
      CHECK(std::string(disturbance([&] { (void)a.call(); })) == "nothing");
    }
  });
}

TEST_CASE("C API: sample_many gives the bits of sample_rates for every variant", "[capi][sample_many][same_bits]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    std::vector<Trajectory> owned;
    std::vector<const qtraj_trajectory*> rig;
    for (const Variant& variant : variants()) {
      owned.push_back(must_build(make_options(variant).get(), closed_tour<Real>(40), rates_for<Real>(variant, 40)));
      for (int copy = 0; copy < 11; ++copy) rig.push_back(owned.back().get());
    }
    const std::vector<double> times = {-1.5, 3.25, -2.0, 8.0, 8.5, 0};
    const size_t series = rig.size(), count = times.size();
    for (const int32_t layout : {QTRAJ_LAYOUT_SERIES_FIRST, QTRAJ_LAYOUT_TIME_FIRST}) {
      Motion<Real> all(series * count);
      CHECK(sample_many(rig.data(), series, QTRAJ_FRAME_WORLD, times.data(), count, layout, all.q.data(),
                        all.omega.data(), all.alpha.data(), nullptr) == QTRAJ_OK);
      size_t different = 0;
      for (size_t k = 0; k < series; ++k) {
        const Motion<Real> one = must_sample_rates<Real>(rig[k], QTRAJ_FRAME_WORLD, times);
        for (size_t i = 0; i < count; ++i) {
          const size_t row = layout == QTRAJ_LAYOUT_TIME_FIRST ? i * series + k : k * count + i;
          different += std::memcmp(&all.q[4 * row], &one.q[4 * i], sizeof(Real[4])) != 0 ||
                       std::memcmp(&all.omega[3 * row], &one.omega[3 * i], sizeof(Real[3])) != 0 ||
                       std::memcmp(&all.alpha[3 * row], &one.alpha[3 * i], sizeof(Real[3])) != 0;
        }
      }
      CHECK(different == 0);
    }
  });
}

TEST_CASE("C API: sample_many has the bits of sample where keys are held up to a last one beside 0",
          "[capi][sample_many][same_bits]") {
  const Trajectory curve =
      must_build(make_options({"", QTRAJ_STEP}).get(), Keyframes<double>{{-1.0, 0.0}, {1, 0, 0, 0, 0.6, 0.8, 0, 0}});
  const std::vector<const qtraj_trajectory*> rig(11, curve.get());
  for (const double time : {-1e-307, -DBL_MIN, -1e-310, -5e-324, 0.0}) {
    CAPTURE(time);
    std::vector<double> all(44), one(4);
    REQUIRE(qtraj_sample_many(rig.data(), 11, QTRAJ_FRAME_BODY, &time, 1, QTRAJ_LAYOUT_TIME_FIRST, all.data(), nullptr,
                              nullptr, nullptr) == QTRAJ_OK);
    REQUIRE(qtraj_sample(curve.get(), &time, 1, one.data(), nullptr) == QTRAJ_OK);
    for (size_t k = 0; k < 11; ++k) CHECK(std::memcmp(&all[4 * k], one.data(), sizeof(double[4])) == 0);
  }
}

}  // namespace
