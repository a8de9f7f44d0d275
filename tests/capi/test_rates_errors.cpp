// Sampling with rates and faulty arguments or times: statuses, subsets of outputs, overlaps, rows at fault.
#include <cfloat>
#include <limits>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kKeys = 6;

template <class Real>
Trajectory tour(const Variant& variant) {
  return must_build(make_options(variant).get(), closed_tour<Real>(kKeys), rates_for<Real>(variant, kKeys));
}

// Whether a row is NaN throughout.
template <class Real>
bool is_nan(const std::vector<Real>& rows, size_t length, size_t row) {
  return std::all_of(rows.begin() + static_cast<ptrdiff_t>(length * row),
                     rows.begin() + static_cast<ptrdiff_t>(length * (row + 1)), [](Real x) { return std::isnan(x); });
}
template <class Real>
bool is_nan(const Motion<Real>& motion, size_t row) {
  return is_nan(motion.q, 4, row) && is_nan(motion.omega, 3, row) && is_nan(motion.alpha, 3, row);
}

template <class Real>
void copy_row(const Motion<Real>& from, size_t row, Motion<Real>& to) {
  const auto at = static_cast<ptrdiff_t>(row);
  std::copy_n(from.q.begin() + 4 * at, 4, to.q.begin() + 4 * at);
  std::copy_n(from.omega.begin() + 3 * at, 3, to.omega.begin() + 3 * at);
  std::copy_n(from.alpha.begin() + 3 * at, 3, to.alpha.begin() + 3 * at);
}

TEST_CASE("C API: sampling rates of nothing is OK with NULL arrays", "[capi][rates]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Real* none = nullptr;
    for (const Variant& variant : variants()) {
      CAPTURE(variant.name);
      const Trajectory curve = tour<Real>(variant);
      for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
        size_t bad_index = 0;
        CHECK(sample_rates(curve.get(), frame, nullptr, 0, none, none, none, &bad_index) == QTRAJ_OK);
        CHECK(bad_index == SIZE_MAX);
        CHECK(sample_rates(curve.get(), frame, nullptr, 0, none, none, none, nullptr) == QTRAJ_OK);
      }
    }
  });
}

TEST_CASE(
    "C API: sampling rates judges arguments in the order NULL, SIZE, OPTION, OVERLAP and then leaves outputs alone",
    "[capi][rates][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Trajectory curve = tour<Real>({"", QTRAJ_HERMITE});
    const qtraj_trajectory* missing = nullptr;
    const double times[3] = {-1.9, -1.8, -1.7};
    std::vector<Real> block(64, Real(7));
    const std::vector<Real> untouched = block;
    Real *q = block.data(), *omega = q + 16, *alpha = q + 32, *none = nullptr;
    constexpr int32_t kBody = QTRAJ_FRAME_BODY;
    const auto check = [&](qtraj_status expected, const qtraj_trajectory* handle, int32_t frame, const double* at,
                           size_t count, Real* q_out, Real* omega_out, Real* alpha_out) {
      CAPTURE(frame, count);
      size_t bad_index = 12345;
      CHECK(sample_rates(handle, frame, at, count, q_out, omega_out, alpha_out, &bad_index) == expected);
      CHECK(bad_index == SIZE_MAX);
      CHECK(sample_rates(handle, frame, at, count, q_out, omega_out, alpha_out, nullptr) == expected);
      CHECK(block == untouched);
    };
    check(QTRAJ_E_NULL, missing, kBody, times, 3, q, omega, alpha);
    check(QTRAJ_E_NULL, missing, 0, nullptr, 0, none, none, none);
    check(QTRAJ_E_NULL, curve.get(), kBody, nullptr, 3, q, omega, alpha);
    check(QTRAJ_E_NULL, curve.get(), kBody, times, 3, none, none, none);
    check(QTRAJ_E_NULL, curve.get(), 0, times, 3, none, none, none);
    check(QTRAJ_E_NULL, curve.get(), 0, nullptr, SIZE_MAX, q, q, q);
    constexpr size_t kMost = PTRDIFF_MAX;
    for (const size_t count : {SIZE_MAX, SIZE_MAX / 4 + 2, SIZE_MAX / 32 + 2, kMost / (4 * sizeof(Real)) + 1}) {
      check(QTRAJ_E_SIZE, curve.get(), kBody, times, count, q, omega, alpha);
      check(QTRAJ_E_SIZE, curve.get(), 0, times, count, q, q, q);
    }
    for (const int32_t frame : {0, 3, -1, 1000, INT32_MAX, INT32_MIN}) {
      check(QTRAJ_E_VALUE, curve.get(), frame, times, 3, q, omega, alpha);
      check(QTRAJ_E_VALUE, curve.get(), frame, times, 3, q, q, q);
    }
    check(QTRAJ_E_OVERLAP, curve.get(), kBody, times, 3, q, q, none);
    check(QTRAJ_E_OVERLAP, curve.get(), kBody, times, 3, none, omega, omega);
    check(QTRAJ_E_OVERLAP, curve.get(), kBody, times, 3, alpha, omega, alpha);
    check(QTRAJ_E_OVERLAP, curve.get(), kBody, times, 3, q, q + 11, alpha);
    check(QTRAJ_E_OVERLAP, curve.get(), kBody, times, 3, q + 8, q, alpha);
    check(QTRAJ_E_OVERLAP, curve.get(), kBody, times, 3, q, omega, omega + 8);
  });
}

TEST_CASE("C API: sample_rates_at judges arguments like sample_rates", "[capi][rates][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Trajectory curve = tour<Real>({"", QTRAJ_SQUAD});
    const qtraj_trajectory* missing = nullptr;
    std::vector<Real> block(32, Real(7));
    const std::vector<Real> untouched = block;
    Real *q = block.data(), *omega = q + 8, *alpha = q + 16, *none = nullptr;
    size_t cursor = 3;
    CHECK(sample_rates_at(missing, QTRAJ_FRAME_BODY, -1.9, &cursor, q, omega, alpha) == QTRAJ_E_NULL);
    CHECK(sample_rates_at(missing, 0, kNaN, &cursor, none, none, none) == QTRAJ_E_NULL);
    CHECK(sample_rates_at(curve.get(), 0, -1.9, &cursor, none, none, none) == QTRAJ_E_NULL);
    for (const int32_t frame : {0, 3, -1, INT32_MAX, INT32_MIN})
      CHECK(sample_rates_at(curve.get(), frame, kNaN, &cursor, q, q, alpha) == QTRAJ_E_VALUE);
    CHECK(sample_rates_at(curve.get(), QTRAJ_FRAME_BODY, -1.9, &cursor, q, q, alpha) == QTRAJ_E_OVERLAP);
    CHECK(sample_rates_at(curve.get(), QTRAJ_FRAME_BODY, -1.9, &cursor, q, q + 3, alpha) == QTRAJ_E_OVERLAP);
    CHECK(sample_rates_at(curve.get(), QTRAJ_FRAME_BODY, kNaN, &cursor, none, omega, omega + 2) == QTRAJ_E_OVERLAP);
    CHECK(block == untouched);
    CHECK(cursor == 3);
    CHECK(sample_rates_at(curve.get(), QTRAJ_FRAME_BODY, -1.9, &cursor, q, q + 4, q + 7) == QTRAJ_OK);
    CHECK(block[10] == Real(7));
  });
}

TEST_CASE("C API: every pair of arrays of sample_rates may touch but not overlap", "[capi][rates][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Trajectory curve = tour<Real>({"", QTRAJ_SLERP});
    constexpr size_t kCount = 3, kBlock = 512, kFixedAt = 208;
    const size_t bytes[4] = {kCount * sizeof(double), 4 * kCount * sizeof(Real), 3 * kCount * sizeof(Real),
                             3 * kCount * sizeof(Real)};
    // array `fixed` stays, array `moving` moves across it; the others are apart or NULL
    for (size_t fixed = 0; fixed < 4; ++fixed)
      for (size_t moving = 1; moving < 4; ++moving) {
        if (moving == fixed) continue;
        bool all_right = true;
        for (size_t offset = 96; offset <= 336; offset += sizeof(Real)) {
          alignas(double) unsigned char block[kBlock] = {};
          unsigned char* at[4] = {block, nullptr, nullptr, nullptr};
          at[fixed] = block + kFixedAt;
          at[moving] = block + offset;
          for (size_t i = 0; i < kCount; ++i) reinterpret_cast<double*>(at[0])[i] = -1.9 + 0.1 * static_cast<double>(i);
          const std::vector<unsigned char> before(block, block + kBlock);
          const bool apart = offset + bytes[moving] <= kFixedAt || offset >= kFixedAt + bytes[fixed];
          size_t bad_index = 0;
          const qtraj_status status =
              sample_rates(curve.get(), QTRAJ_FRAME_WORLD, reinterpret_cast<const double*>(at[0]), kCount,
                           reinterpret_cast<Real*>(at[1]), reinterpret_cast<Real*>(at[2]),
                           reinterpret_cast<Real*>(at[3]), &bad_index);
          all_right = all_right && status == (apart ? QTRAJ_OK : QTRAJ_E_OVERLAP) && bad_index == SIZE_MAX;
          if (!apart) all_right = all_right && std::equal(before.begin(), before.end(), block);
        }
        CAPTURE(fixed, moving);
        CHECK(all_right);
      }
  });
}

TEST_CASE("C API: any subset of outputs has the bits of all, and q those of sample", "[capi][rates][same_bits]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
        CAPTURE(variant.name, frame);
        const Trajectory curve = tour<Real>(variant);
        const std::vector<double> times = times_in(closed_tour<Real>(kKeys).times, 5);
        const Motion<Real> all = must_sample_rates<Real>(curve.get(), frame, times);
        CHECK(same_bits(all.q, must_sample<Real>(curve.get(), times)));
        for (unsigned subset = 1; subset < 8; ++subset) {
          Motion<Real> some = all, single = all;
          const auto part = [subset](std::vector<Real>& rows, unsigned bit) {
            if (subset & bit) std::fill(rows.begin(), rows.end(), Real(7));
            return (subset & bit) != 0 ? rows.data() : nullptr;
          };
          CHECK(sample_rates(curve.get(), frame, times.data(), times.size(), part(some.q, 1), part(some.omega, 2),
                             part(some.alpha, 4), nullptr) == QTRAJ_OK);
          CHECK(same_bits(some, all));
          size_t cursor = SIZE_MAX;
          bool all_ok = true;
          for (size_t i = 0; i < times.size(); ++i)
            all_ok =
                sample_rates_at(curve.get(), frame, times[i], i % 2 == 0 ? &cursor : nullptr,
                                subset & 1 ? &single.q[4 * i] : nullptr, subset & 2 ? &single.omega[3 * i] : nullptr,
                                subset & 4 ? &single.alpha[3 * i] : nullptr) == QTRAJ_OK &&
                all_ok;
          CHECK(all_ok);
          CHECK(same_bits(single, all));
        }
      }
  });
}

TEST_CASE("C API: a row at fault is NaN in every output of sample_rates, all others are right",
          "[capi][rates][errors]") {
  const std::pair<double, qtraj_status> faults[] = {{kNaN, QTRAJ_E_NOT_FINITE},
                                                    {-kInfinity, QTRAJ_E_NOT_FINITE},
                                                    {DBL_MAX, QTRAJ_E_TIME_RANGE},
                                                    {-2.0 - 1e-13, QTRAJ_E_TIME_RANGE}};
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      const Trajectory curve = tour<Real>(variant);
      const std::vector<double> good = times_in(closed_tour<Real>(kKeys).times, 3);
      const Motion<Real> expected = must_sample_rates<Real>(curve.get(), QTRAJ_FRAME_WORLD, good);
      const size_t last = good.size() - 1;
      for (const auto& first : faults)
        for (const auto& second : faults)
          for (const size_t row : {size_t{0}, size_t{5}, last - 1}) {
            CAPTURE(variant.name, first.first, second.first, row);
            std::vector<double> times = good;
            times[row] = first.first;
            times[last] = second.first;
            Motion<Real> motion(times.size());
            size_t bad_index = 0;
            const qtraj_status status =
                sample_rates(curve.get(), QTRAJ_FRAME_WORLD, times.data(), times.size(), motion.q.data(),
                             motion.omega.data(), motion.alpha.data(), &bad_index);
            const bool rows_nan = is_nan(motion, row) && is_nan(motion, last);
            copy_row(expected, row, motion);
            copy_row(expected, last, motion);
            CHECK((status == first.second && bad_index == row && rows_nan && same_bits(motion, expected)));
            // and without some of the outputs
            std::vector<Real> omega(3 * times.size());
            CHECK(sample_rates(curve.get(), QTRAJ_FRAME_WORLD, times.data(), times.size(), static_cast<Real*>(nullptr),
                               omega.data(), static_cast<Real*>(nullptr), nullptr) == first.second);
            CHECK((is_nan(omega, 3, row) && is_nan(omega, 3, last)));
          }
    }
  });
}

}  // namespace
