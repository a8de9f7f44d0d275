// Zeros have one sign, in a batch and alone: compilers may fold a negation into a multiply-add, which changes that of
// a sum of 0 (math/arithmetic.hpp).
#include "math/arithmetic.hpp"
#include "support/kernel_curves.hpp"

using namespace capi;

namespace {

// Through three of the quaternions +-1, +-i, +-j, +-k, whose turns have zeros everywhere.
Trajectory between_axes(int32_t method, int code) {
  const double times[] = {0, 1, 2};
  double q[3][4] = {};
  for (int key = 0; key < 3; ++key) {
    const int axis = code >> 3 * key & 7;
    q[key][axis & 3] = (axis & 4) != 0 ? -1 : 1;
  }
  qtraj_trajectory* out = nullptr;
  qtraj_create(method, times, q[0], 3, &out, nullptr);
  return Trajectory(out);
}

template <class Real>
bool batch_is_one_by_one(const qtraj_trajectory* curve, const std::vector<double>& times) {
  for (const test::Request& request : test::kRequests) {
    test::OwnRows<Real> alone = test::one_by_one<Real>(curve, request, times), batch(times.size(), request);
    test::sample(curve, request, times.data(), times.size(), batch.arrays());
    for (size_t row = 0; row < times.size(); ++row)
      if (!test::same_row(alone.arrays(), batch.arrays(), row)) return false;
  }
  return true;
}

TEST_CASE("the negative of a multiply-add that is 0 is -0", "[signed_zeros]") {
  const volatile double one = 1.0;
  const volatile float one_f32 = 1.0f;
  CHECK(std::signbit(-qtraj::Fused::multiply_add<double>(one, one, -one)));
  CHECK(std::signbit(-qtraj::Fused::multiply_add<float>(one_f32, one_f32, -one_f32)));
}

TEST_CASE("rates that are 0 have the same sign in a batch and alone, in every kernel", "[signed_zeros]") {
  std::vector<double> times;
  for (int i = 0; i < 34; ++i) times.push_back(i * (2.0 / 33));
  times.push_back(0.5);
  test::for_every_kernel([&](const char*) {
    for (const int32_t method : {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_SQUAD, QTRAJ_LOG_SPLINE, QTRAJ_ROTATION_SPLINE})
      for (int code = 0; code < 512; ++code) {
        const Trajectory curve = between_axes(method, code);
        if (!curve) continue;
        if (!batch_is_one_by_one<double>(curve.get(), times) || !batch_is_one_by_one<float>(curve.get(), times))
          FAIL_CHECK("method " << method << ", keys " << code);
      }
  });
}

}  // namespace
