#include "qtraj/derivatives.hpp"

#include "qtraj/scaled.hpp"

namespace qtraj {
namespace {

// With q_wb on its left, rates are in the body frame, on its right in the world frame.
Quaternion multiply_in(Frame frame, const Quaternion& q_wb, const Quaternion& rate) {
  return frame == Frame::body ? multiply(q_wb, rate) : multiply(rate, q_wb);
}

// A quaternion to divide by: norm * 2^(600 steps) times unit.
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

}  // namespace

Outcome derivatives_from_rates(Frame frame, const Rows<4>& q_wb, const Rows<3>& omega, const Rows<3>& alpha,
                               size_t count, const OutputRowPairs<4>& dq_and_ddq_out) {
  return for_each_row(count, dq_and_ddq_out, [&](size_t row, OutputRowPairs<4>::Row& derivatives) {
    if (!q_wb.is_finite(row) || !omega.is_finite(row)) return Status::not_finite;
    if (alpha.data && !alpha.is_finite(row)) return Status::not_finite;
    if (q_wb.is_zero(row)) return Status::zero_norm;
    const Quaternion unit = normalize(q_wb[row]).unit.value;
    const Scaled<Vector3> scaled = scale(omega[row]);
    derivatives.first = first_derivative(unit, frame, scaled);
    if (alpha.data) derivatives.second = second_derivative(unit, frame, scaled, scale(alpha[row]));
    return Status::ok;
  });
}

Outcome rates_from_derivatives(Frame frame, const Rows<4>& q_wb, const Rows<4>& dq, const Rows<4>& ddq, size_t count,
                               const OutputRowPairs<3>& omega_and_alpha_out) {
  return for_each_row(count, omega_and_alpha_out, [&](size_t row, OutputRowPairs<3>::Row& rates) {
    if (!q_wb.is_finite(row) || !dq.is_finite(row)) return Status::not_finite;
    if (ddq.data && !ddq.is_finite(row)) return Status::not_finite;
    if (q_wb.is_zero(row)) return Status::zero_norm;
    const Divisor q = divisor(q_wb[row]);
    const Scaled<Quaternion> p = divide(dq[row], frame, q);
    rates.first = rate_of(p);
    if (ddq.data) {
      // the vector part of p^2 is 2 Re p Im p
      const Scaled<Quaternion> square = scale(quaternion(0, (2.0 * p.value[0]) * vector_part(p.value)), 2 * p.steps);
      const Scaled<Quaternion> second = divide(ddq[row], frame, q);
      rates.second = rate_of(sum(second, {-square.value, square.steps}));
    }
    return Status::ok;
  });
}

}  // namespace qtraj
