// No kernel reads or writes outside the caller's arrays, or writes to its inputs, however many rows there are.
#include "support/guarded.hpp"
#include "support/kernel_curves.hpp"

namespace {

using test::Arrays;
using test::Guarded;
using test::KernelCurve;
using test::OwnRows;
using test::Request;

constexpr size_t kMost = 1033;

// Every tail of a vector, and counts around half a chunk, one and two.
std::vector<size_t> counts() {
  std::vector<size_t> all;
  for (size_t count = 0; count <= 64; ++count) all.push_back(count);
  for (const size_t rows : {256u, 512u, 1024u})
    for (const size_t count : {rows - 9, rows - 1, rows, rows + 1, rows + 7, rows + 9}) all.push_back(count);
  return all;
}

// In runs, or in no order.
std::vector<double> times_within(const std::vector<double>& knots, bool in_order) {
  test::Random random(kMost);
  const double first = knots.front(), span = knots.back() - first;
  std::vector<double> times;
  for (size_t i = 0; i < kMost; ++i)
    times.push_back(first + (in_order ? static_cast<double>(i) / kMost : random.uniform(0, 1)) * span);
  return times;
}

// The caller's arrays, each between guard pages.
template <class Real>
struct GuardedCall {
  Guarded<double> times{kMost};
  Guarded<Real> q{4 * kMost}, omega{3 * kMost}, alpha{3 * kMost};

  static constexpr int kFilling = 0x5a;

  Arrays<Real> arrays(const Request& request, size_t count, bool at_end) {
    q.fill(kFilling), omega.fill(kFilling), alpha.fill(kFilling);
    return {request.q ? q.array(4 * count, at_end) : nullptr, request.omega ? omega.array(3 * count, at_end) : nullptr,
            request.alpha ? alpha.array(3 * count, at_end) : nullptr};
  }
  bool nothing_else_written(const Arrays<Real>& a, size_t count) {
    return q.holds_around(a.q ? a.q : q.array(0, false), a.q ? 4 * count : 0, kFilling) &&
           omega.holds_around(a.omega ? a.omega : omega.array(0, false), a.omega ? 3 * count : 0, kFilling) &&
           alpha.holds_around(a.alpha ? a.alpha : alpha.array(0, false), a.alpha ? 3 * count : 0, kFilling);
  }
};

template <class Real>
void check_curve(const KernelCurve& curve, const Request& request, bool in_order) {
  const std::vector<double> times = times_within(curve.knots, in_order);
  OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, times);
  GuardedCall<Real> call;
  size_t wrong = 0, not_ok = 0, wrote_outside = 0;
  for (const size_t count : counts())
    for (const bool at_end : {true, false}) {
      const Arrays<Real> to = call.arrays(request, count, at_end);
      double* from = call.times.array(count, at_end);
      std::copy_n(times.begin(), count, from);
      call.times.protect(PROT_READ);
      not_ok += sample(curve.get(), request, from, count, to) != QTRAJ_OK;
      call.times.protect(PROT_READ | PROT_WRITE);
      for (size_t row = 0; row < count; ++row) wrong += !same_row(to, expected.arrays(), row);
      wrote_outside += !call.nothing_else_written(to, count);
    }
  CHECK(not_ok == 0);
  CHECK(wrong == 0);
  CHECK(wrote_outside == 0);
}

template <class Real>
void check_uniform(const KernelCurve& curve) {
  const Request& request = test::kRequests[0];
  GuardedCall<Real> call;
  const double start = curve.knots.front(), step = (curve.knots.back() - start) / (kMost + 1);
  std::vector<double> times;
  for (size_t i = 0; i < kMost; ++i) times.push_back(start + static_cast<double>(i) * step);
  OwnRows<Real> expected = test::one_by_one<Real>(curve.get(), request, times);
  size_t wrong = 0, wrote_outside = 0;
  for (const size_t count : counts())
    for (const bool at_end : {true, false}) {
      const Arrays<Real> to = call.arrays(request, count, at_end);
      capi::sample_uniform(curve.get(), start, step, count, to.q, nullptr);
      for (size_t row = 0; row < count; ++row) wrong += !same_row(to, expected.arrays(), row);
      wrote_outside += !call.nothing_else_written(to, count);
    }
  CHECK(wrong == 0);
  CHECK(wrote_outside == 0);
}

}  // namespace

TEST_CASE("kernels stay within the caller's arrays at every count, aligned to their elements or better",
          "[batch][memory]") {
  const std::vector<KernelCurve> curves = test::kernel_curves(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR);
  test::for_every_kernel([&](const char*) {
    for (const KernelCurve& curve : curves)
      for (const Request& request : test::kRequests)
        for (const bool in_order : {true, false}) {
          CAPTURE(curve.name, request.q, request.omega, request.alpha, request.frame, in_order);
          check_curve<double>(curve, request, in_order);
          check_curve<float>(curve, request, in_order);
        }
  });
}

TEST_CASE("kernels stay within the output of uniform times at every count", "[batch][memory]") {
  const std::vector<KernelCurve> curves = test::kernel_curves(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_ERROR);
  test::for_every_kernel([&](const char*) {
    for (const KernelCurve& curve : curves) {
      CAPTURE(curve.name);
      check_uniform<double>(curve);
      check_uniform<float>(curve);
    }
  });
}
