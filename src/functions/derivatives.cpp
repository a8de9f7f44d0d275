#include "functions/derivatives.hpp"

#include "math/scaled.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

// A rate in the body frame is multiplied by q_wb from the left, one in the world frame from the right.
Quaternion multiply_in(Frame frame, const Quaternion& q_wb, const Quaternion& rate) {
  return frame == Frame::body ? multiply(q_wb, rate) : multiply(rate, q_wb);
}

// A quaternion to divide by, norm * 2^(600 steps) times unit.
struct Divisor {
  Quaternion unit;
  double norm;
  int steps;
};
Divisor divisor(const Quaternion& q) {
  const Scaled<Quaternion> scaled = scale(q);
  const Normalized normalized = normalize(scaled.value);
  return {normalized.unit.value, normalized.norm + normalized.norm_error, scaled.steps};
}

// The rate part of a derivative: q^-1 d (body) or d q^-1 (world).
Scaled<Quaternion> divide(const Quaternion& derivative, Frame frame, const Divisor& q_wb) {
  const Scaled<Quaternion> scaled = scale(derivative);
  const Quaternion turned = multiply_in(frame, conjugate(q_wb.unit), scaled.value);
  return scale(Quaternion(turned / q_wb.norm), scaled.steps - q_wb.steps);
}

Quaternion first_derivative(const Quaternion& unit, Frame frame, const Scaled<Vector3>& omega) {
  const Quaternion rate = quaternion(0, 0.5 * omega.value);
  return unscale(Scaled<Quaternion>{multiply_in(frame, unit, rate), omega.steps});
}

Quaternion second_derivative(const Quaternion& unit, Frame frame, const Scaled<Vector3>& omega,
                             const Scaled<Vector3>& alpha) {
  const Scaled<Quaternion> turning = {quaternion(-0.25 * dot(omega.value, omega.value), Vector3::Zero()),
                                      2 * omega.steps};
  const Scaled<Quaternion> rate = sum(turning, {quaternion(0, 0.5 * alpha.value), alpha.steps});
  return unscale(Scaled<Quaternion>{multiply_in(frame, unit, rate.value), rate.steps});
}

// Twice the vector part.
Vector3 rate_of(const Scaled<Quaternion>& p) { return unscale(Scaled<Vector3>{2.0 * vector_part(p.value), p.steps}); }

constexpr RowKernel<RatesToDerivatives> kDerivativeKernels[] = QTRAJ_OF_EACH_TARGET(derivatives_from_rates);
constexpr RowKernel<DerivativesToRates> kRateKernels[] = QTRAJ_OF_EACH_TARGET(rates_from_derivatives);

}  // namespace

Outcome derivatives_from_rates(const RatesToDerivatives& rows, size_t count) {
  const bool has_alpha = rows.alpha.data != nullptr;
  const auto kernel = [&](size_t row) { return kDerivativeKernels[target()](rows, row, count); };
  return for_each_row(count, rows.derivatives, kernel, [&](size_t row, RowPair<4>& derivatives) {
    if (!is_finite(rows.q_wb, row) || !is_finite(rows.omega, row)) return Status::not_finite;
    if (has_alpha && !is_finite(rows.alpha, row)) return Status::not_finite;
    if (is_zero(rows.q_wb, row)) return Status::zero_norm;
    const Quaternion unit = normalize(row_of(rows.q_wb, row)).unit.value;
    const Scaled<Vector3> omega = scale(row_of(rows.omega, row));
    derivatives.first = first_derivative(unit, rows.frame, omega);
    if (has_alpha) derivatives.second = second_derivative(unit, rows.frame, omega, scale(row_of(rows.alpha, row)));
    return Status::ok;
  });
}

Outcome rates_from_derivatives(const DerivativesToRates& rows, size_t count) {
  const bool has_ddq = rows.ddq.data != nullptr;
  const auto kernel = [&](size_t row) { return kRateKernels[target()](rows, row, count); };
  return for_each_row(count, rows.rates, kernel, [&](size_t row, RowPair<3>& rates) {
    if (!is_finite(rows.q_wb, row) || !is_finite(rows.dq, row)) return Status::not_finite;
    if (has_ddq && !is_finite(rows.ddq, row)) return Status::not_finite;
    if (is_zero(rows.q_wb, row)) return Status::zero_norm;
    const Divisor q = divisor(row_of(rows.q_wb, row));
    const Scaled<Quaternion> p = divide(row_of(rows.dq, row), rows.frame, q);
    rates.first = rate_of(p);
    if (has_ddq) {
      // the vector part of p^2 is 2 Re p Im p
      const Scaled<Quaternion> square = scale(quaternion(0, (2.0 * p.value[0]) * vector_part(p.value)), 2 * p.steps);
      const Scaled<Quaternion> second = divide(row_of(rows.ddq, row), rows.frame, q);
      rates.second = rate_of(sum(second, {-square.value, square.steps}));
    }
    return Status::ok;
  });
}

}  // namespace qtraj
