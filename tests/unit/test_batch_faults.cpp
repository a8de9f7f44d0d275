// Rows at fault in vectors: the row is NaN, the others are right, the first is reported, nothing is raised; and times
// far from zero.
#include <cfloat>
#include <limits>

#include "support/capi_floating.hpp"
#include "support/ends.hpp"
#include "support/kernel_curves.hpp"

namespace {

using test::Arrays;
using test::KernelCurve;
using test::OwnRows;
using test::Request;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct FaultyTime {
  const char* name;
  double time;
  qtraj_status status;
};

std::vector<FaultyTime> faulty_times(const std::vector<double>& knots) {
  const double quiet = std::numeric_limits<double>::quiet_NaN();
  std::vector<FaultyTime> all = {{"NaN", quiet, QTRAJ_E_NOT_FINITE},
                                 {"signalling NaN", 0, QTRAJ_E_NOT_FINITE},
                                 {"-NaN", std::copysign(quiet, -1.0), QTRAJ_E_NOT_FINITE},
                                 {"infinity", kInfinity, QTRAJ_E_NOT_FINITE},
                                 {"-infinity", -kInfinity, QTRAJ_E_NOT_FINITE},
                                 {"largest", DBL_MAX, QTRAJ_E_TIME_RANGE},
                                 {"smallest", -DBL_MAX, QTRAJ_E_TIME_RANGE},
                                 {"just before", test::before_all(knots.front(), knots.back()), QTRAJ_E_TIME_RANGE},
                                 {"just after", test::after_all(knots.front(), knots.back()), QTRAJ_E_TIME_RANGE}};
  capi::set_signalling_nan(all[1].time);
  return all;
}

// Sorted: runs in vectors; else each lane has its own segment.
std::vector<double> times_within(const std::vector<double>& knots, size_t count, bool in_order) {
  test::Random random(count);
  const double first = knots.front(), span = knots.back() - first;
  std::vector<double> times;
  for (size_t i = 0; i < count; ++i)
    times.push_back(first +
                    (in_order ? static_cast<double>(i) / static_cast<double>(count) : random.uniform(0, 1)) * span);
  return times;
}

template <class Real>
bool all_nan(const Real* row, size_t size) {
  for (size_t k = 0; row && k < size; ++k)
    if (row[k] == row[k]) return false;
  return true;
}
template <class Real>
bool is_nan_row(const Arrays<Real>& rows, size_t row) {
  const Arrays<Real> at = rows.from_row(row);
  return all_nan(at.q, 4) && all_nan(at.omega, 3) && all_nan(at.alpha, 3);
}

// One fault at every place of the batch from that one on in turn, all faults in turn at each.
template <class Real>
void check_single_faults(const KernelCurve& curve, const Request& request, bool in_order, size_t count = 41,
                         size_t from = 0) {
  const std::vector<double> good = times_within(curve.knots, count, in_order);
  OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, good);
  for (const FaultyTime& fault : faulty_times(curve.knots)) {
    size_t wrong = 0;
    for (size_t at = from; at < good.size(); ++at) {
      std::vector<double> times = good;
      std::memcpy(&times[at], &fault.time, sizeof(double));
      OwnRows<Real> rows(good.size(), request);
      size_t bad_index = 0;
      wrong += sample(curve.get(), request, times.data(), times.size(), rows.arrays(), &bad_index) != fault.status;
      wrong += bad_index != at;
      for (size_t row = 0; row < good.size(); ++row)
        wrong += row == at ? !is_nan_row(rows.arrays(), row) : !same_row(rows.arrays(), expected.arrays(), row);
    }
    CAPTURE(fault.name);
    CHECK(wrong == 0);
  }
}

template <class Real>
void check_many_faults(const KernelCurve& curve, const Request& request) {
  constexpr size_t kCount = 700;
  const std::vector<FaultyTime> faults = faulty_times(curve.knots);
  const std::vector<double> good = times_within(curve.knots, kCount, true);
  OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, good), rows(kCount, request);
  test::Random random(5);
  std::vector<double> times = good;
  std::vector<bool> is_bad(kCount);
  for (size_t row = 3; row < kCount; ++row) {
    is_bad[row] = row == 3 || random.uniform(0, 1) < 0.3;
    if (is_bad[row]) std::memcpy(&times[row], &faults[row % faults.size()].time, sizeof(double));
  }
  size_t bad_index = 0, wrong = 0;
  CHECK(sample(curve.get(), request, times.data(), kCount, rows.arrays(), &bad_index) ==
        faults[3 % faults.size()].status);
  CHECK(bad_index == 3);
  for (size_t row = 0; row < kCount; ++row)
    wrong += is_bad[row] ? !is_nan_row(rows.arrays(), row) : !same_row(rows.arrays(), expected.arrays(), row);
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("a time at fault spoils its own row only, at every place in a vector", "[batch][errors]") {
  const std::vector<KernelCurve> curves = test::kernel_curves(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR);
  test::for_every_kernel([&](const char*) {
    for (const KernelCurve& curve : curves)
      for (const Request& request : test::kRequests) {
        CAPTURE(curve.name, request.q, request.omega, request.alpha, request.frame);
        for (const bool in_order : {true, false}) {
          check_single_faults<double>(curve, request, in_order);
          check_single_faults<float>(curve, request, in_order);
        }
        check_many_faults<double>(curve, request);
        check_many_faults<float>(curve, request);
      }
  });
}

TEST_CASE("faults are found among times before, across and after zero", "[batch][errors]") {
  // a chunk that begins with 0 or later is looked at by its bits
  for (const double start : {-100.0, -2.0, 0.0, 3.0}) {
    const KernelCurve curve =
        test::kernel_curve(test::kernel_cases()[0], QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR, start);
    test::for_every_kernel([&](const char*) {
      CAPTURE(start);
      for (const bool in_order : {true, false}) {
        check_single_faults<double>(curve, test::kRequests[0], in_order, 43);
        check_single_faults<float>(curve, test::kRequests[0], in_order, 43);
      }
      // a last chunk of a few rows
      for (size_t count = 513; count <= 530; ++count)
        check_single_faults<double>(curve, test::kRequests[0], true, count, 511);
      check_many_faults<double>(curve, test::kRequests[0]);
      check_many_faults<float>(curve, test::kRequests[0]);
    });
  }
}

namespace {

// Six keys every `step` seconds and six every second: rates of the first are past the range of Real where it is said
// so, and past what vectors do.
template <class Real>
void check_fast_rates(int32_t method, double step, bool overflows) {
  std::vector<double> knots, q;
  for (int key = 0; key < 12; ++key) {
    knots.push_back(key < 6 ? step * key : static_cast<double>(key));
    const test::Quaternion turn = test::about({0.6, 0, 0.8}, 0.3 * key * key);
    q.insert(q.end(), turn.begin(), turn.end());
  }
  const KernelCurve curve = {"", knots, capi::must_build<double>(capi::make_options({"", method}).get(), {knots, q})};
  std::vector<double> times;
  for (size_t row = 0; row < 60; ++row)
    times.push_back(row % 3 == 0 ? 5 * step * static_cast<double>(row) / 60.0 : 6.0 + static_cast<double>(row) / 12.0);
  test::for_every_kernel([&](const char*) {
    for (const Request& request : test::kRequests) {
      CAPTURE(method, step, request.q, request.omega, request.alpha, request.frame);
      OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, times), rows(times.size(), request);
      sample(curve.get(), request, times.data(), times.size(), rows.arrays());
      size_t wrong = 0, faulty = 0;
      for (size_t row = 0; row < times.size(); ++row) {
        wrong += !same_row(rows.arrays(), expected.arrays(), row);
        faulty += is_nan_row(rows.arrays(), row);
      }
      CHECK(wrong == 0);
      if (request.alpha) CHECK((faulty > 0) == overflows);
      CHECK(faulty < times.size());
      if (!request.with_rates()) CHECK(faulty == 0);
    }
  });
}

}  // namespace

TEST_CASE("rates that overflow spoil their own rows only, in every frame and type", "[batch][errors]") {
  for (const int32_t method : {QTRAJ_SQUAD, QTRAJ_NLERP, QTRAJ_LOG_SPLINE})
    check_fast_rates<float>(method, 1e-30, true);
  // scales on both sides of the largest that vectors do, 2^300 = 2.0e90
  for (const double step : {1e-89, 1e-90, 1e-91, 1e-150}) check_fast_rates<double>(QTRAJ_NLERP, step, false);
  check_fast_rates<double>(QTRAJ_NLERP, 1e-154, true);
}

TEST_CASE("no kernel disturbs the floating-point environment, whatever the times", "[batch][floating]") {
  const std::string nothing = "nothing";
  const std::pair<int32_t, int32_t> outside[] = {{QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR},
                                                 {QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE},
                                                 {QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_HOLD}};
  for (const auto& rule : outside) {
    std::vector<KernelCurve> curves = test::kernel_curves(rule.first, rule.second);
    curves.push_back(test::kernel_curve(test::kernel_cases()[0], rule.first, rule.second, 3.0));
    test::for_every_kernel([&](const char*) {
      for (const KernelCurve& curve : curves) {
        const std::vector<FaultyTime> faults = faulty_times(curve.knots);
        for (const bool in_order : {true, false}) {
          std::vector<double> times = times_within(curve.knots, 300, in_order);
          for (size_t i = 0; i < 7 * faults.size(); ++i)
            std::memcpy(&times[1 + 4 * i + i % 4], &faults[i % faults.size()].time, sizeof(double));
          for (const Request& request : test::kRequests) {
            CAPTURE(curve.name, request.q, request.omega, request.alpha, request.frame, in_order);
            OwnRows<double> rows(times.size(), request);
            OwnRows<float> rows_f32(times.size(), request);
            // the tail too: the last vector is not full
            for (const size_t count : {times.size(), times.size() - 5, size_t{19}}) {
              CHECK(capi::disturbance([&] { sample(curve.get(), request, times.data(), count, rows.arrays()); }) ==
                    nothing);
              CHECK(capi::disturbance([&] { sample(curve.get(), request, times.data(), count, rows_f32.arrays()); }) ==
                    nothing);
            }
          }
        }
      }
    });
  }
}

TEST_CASE("seconds since 1970 are sampled no worse by vectors than one by one", "[batch]") {
  // knots on multiples of 2^-20 s: the same curve near 0 and at 1.7e9 s, to the last bit
  for (const test::KernelCase& c : test::kernel_cases()) {
    CAPTURE(c.variant.name);
    test::Random random(c.count);
    test::Keys walk = random_walk(random, c.count, c.largest_step, 0.2, 2.0);
    std::vector<double> near, far, times_near, times_far;
    for (size_t key = 0; key < c.count; ++key) {
      near.push_back(std::floor((walk.times[key] - walk.times[0]) * 0x1p20) * 0x1p-20);
      far.push_back(near.back() + 1.7e9);
    }
    for (const double time : times_within(near, 500, true)) times_near.push_back(std::floor(time * 0x1p20) * 0x1p-20);
    for (const double time : times_within(near, 100, false)) times_near.push_back(std::floor(time * 0x1p20) * 0x1p-20);
    for (const double time : times_near) times_far.push_back(time + 1.7e9);
    const capi::Options options = capi::make_options(c.variant);
    const capi::Rates<double> rates = capi::rates_for<double>(c.variant, c.count, c.rate);
    const capi::Trajectory at_zero = capi::must_build<double>(options.get(), {near, walk.q}, rates),
                           at_epoch = capi::must_build<double>(options.get(), {far, walk.q}, rates);
    test::for_every_kernel([&](const char*) {
      for (const Request& request : test::kRequests) {
        OwnRows<double> expected = test::one_by_one<double>(at_zero.get(), request, times_near),
                        rows(times_far.size(), request);
        OwnRows<float> expected_f32 = test::one_by_one<float>(at_zero.get(), request, times_near),
                       rows_f32(times_far.size(), request);
        CHECK(sample(at_epoch.get(), request, times_far.data(), times_far.size(), rows.arrays()) == QTRAJ_OK);
        CHECK(sample(at_epoch.get(), request, times_far.data(), times_far.size(), rows_f32.arrays()) == QTRAJ_OK);
        CHECK(same_bits(rows.rows, expected.rows));
        CHECK(same_bits(rows_f32.rows, expected_f32.rows));
      }
    });
  }
}
