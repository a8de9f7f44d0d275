#include "functions/exponential.hpp"

#include <cfloat>

#include "math/scaled.hpp"
#include "math/trigonometry.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

Quaternion exp_of(const Vector3& v) {
  const Scaled<Vector3> scaled = scale(v);
  const DoubleDouble length = precise_length(quaternion(0, scaled.value));
  if (length.value == 0) return quaternion(1.0, v);
  constexpr double kFar = 0x1p400;  // an angle so large that sin_cos means no direction
  const DoubleDouble angle =
      scaled.steps > 0 ? DoubleDouble{kFar, 0}
                       : DoubleDouble{unscale(length.value, scaled.steps), unscale(length.error, scaled.steps)};
  const SinCos at = sin_cos(angle);
  // for tiny angles the quotient is 1 and v stays as it is
  return quaternion(at.cos, (at.sin / (length.value + length.error)) * scaled.value);
}

// q as a multiple of (cosine, sine * axis); the axis is unit.
struct Polar {
  double cosine;
  DoubleDouble sine;  // >= 0
  UnitQuaternion axis;
};

// False where there is no axis, the vector part being 0.
bool polar_form(const Quaternion& q, Polar& polar) {
  const Quaternion scaled = scale(q).value;
  const Quaternion vector = quaternion(0, vector_part(scaled));
  if (largest_component(vector) == 0) return false;
  const Normalized normalized = normalize(vector);
  polar = {scaled[0], {normalized.norm, normalized.norm_error}, normalized.unit};
  return true;
}

// angle * axis, rounded once.
Vector3 product(const DoubleDouble& angle, const UnitQuaternion& axis) {
  Vector3 result;
  for (int k = 0; k < 3; ++k) {
    const DoubleDouble leading = two_product(angle.value, axis.value[k + 1]);
    const double low_terms = angle.value * axis.error[k + 1] + angle.error * axis.value[k + 1];
    result[k] = leading.value + (leading.error + low_terms);
  }
  return result;
}

// The half angle of q and its axis, the x axis where q is real; ambiguous where that is a choice.
struct HalfAngle {
  Status status;
  DoubleDouble angle;
  UnitQuaternion axis;
};
HalfAngle half_angle(const Quaternion& q) {
  Polar polar;
  if (polar_form(q, polar)) return {Status::ok, precise_atan2(polar.sine, {polar.cosine, 0}), polar.axis};
  const UnitQuaternion x_axis = {{0, 1, 0, 0}, {0, 0, 0, 0}};
  if (q[0] > 0) return {Status::ok, {0, 0}, x_axis};
  return {Status::ambiguous, precise_atan2({0, 0}, {-1, 0}), x_axis};
}

// factor * angle. Products so large that sin_cos means no direction are not exact.
DoubleDouble multiple(double factor, const DoubleDouble& angle) {
  // two_product takes numbers below 2^500, and a huge factor has a meaningful product with tiny angles only
  const bool huge = std::abs(factor) > 0x1p400;
  if (huge && angle.value > 0x1p-300) return {factor > 0 ? 0x1p400 : -0x1p400, 0};
  const double power = huge ? 0x1p600 : 1.0;
  const double moved = factor / power;
  const DoubleDouble product = two_product(moved, power * angle.value);
  return {product.value, product.error + moved * (power * angle.error)};
}

bool is_whole(double x) {
  constexpr double kWholeFrom = 0x1p53;
  return std::abs(x) >= kWholeFrom || static_cast<double>(static_cast<int64_t>(x)) == x;
}

Status pow_of(const Quaternion& q, double exponent, Quaternion& result) {
  const HalfAngle half = half_angle(q);
  if (half.status == Status::ambiguous && is_whole(exponent)) {
    result = {is_whole(0.5 * exponent) ? 1.0 : -1.0, 0, 0, 0};
    return Status::ok;
  }
  const SinCos at = sin_cos(multiple(exponent, half.angle));
  result = quaternion(at.cos, at.sin * vector_part(half.axis.value));
  return half.status;
}

Vector3 rotation_vector(const Quaternion& q) {
  Polar polar;
  if (!polar_form(q, polar)) return Vector3::Zero();
  const DoubleDouble half = precise_atan2(polar.sine, {std::abs(polar.cosine), 0});
  const double turns = polar.cosine < 0 ? -2.0 : 2.0;
  return product({turns * half.value, turns * half.error}, polar.axis);
}

constexpr RowKernel<ExpRows> kExpKernels[] = QTRAJ_OF_EACH_TARGET(exp);
constexpr RowKernel<UnaryRows<4, 3>> kLogKernels[] = QTRAJ_OF_EACH_TARGET(log),
                                     kRotationVectorKernels[] = QTRAJ_OF_EACH_TARGET(rotation_vectors);
constexpr RowKernel<BinaryRows<4, 1, 4>> kPowKernels[] = QTRAJ_OF_EACH_TARGET(pow);

// Calls `compute(q, values)` for each quaternion other than 0 that the kernel leaves.
template <class Compute>
Outcome for_each_quaternion(const UnaryRows<4, 3>& rows, size_t count, RowKernel<UnaryRows<4, 3>> kernel,
                            const Compute& compute) {
  const auto from_row = [&](size_t row) { return kernel(rows, row, count); };
  return for_each_row(count, rows.out, from_row, [&](size_t row, Vector3& values) {
    const Status status = check_key(rows.in, row);
    return status == Status::ok ? compute(row_of(rows.in, row), values) : status;
  });
}

Outcome exp_of_multiple(double factor, const UnaryRows<3, 4>& rows, size_t count) {
  const ExpRows exp_rows = {rows.in, factor, rows.out};
  const auto from_row = [&](size_t row) { return kExpKernels[target()](exp_rows, row, count); };
  return for_each_row(count, rows.out, from_row, [&](size_t row, Quaternion& q) {
    if (!is_finite(rows.in, row)) return Status::not_finite;
    q = exp_of(factor * row_of(rows.in, row));
    return Status::ok;
  });
}

}  // namespace

Outcome exp(const UnaryRows<3, 4>& rows, size_t count) { return exp_of_multiple(1.0, rows, count); }

Outcome q_from_rotation_vector(const UnaryRows<3, 4>& rows, size_t count) { return exp_of_multiple(0.5, rows, count); }

Outcome log(const UnaryRows<4, 3>& rows, size_t count) {
  return for_each_quaternion(rows, count, kLogKernels[target()], [](const Quaternion& value, Vector3& v) {
    const HalfAngle half = half_angle(value);
    v = product(half.angle, half.axis);
    return half.status;
  });
}

Outcome pow(const BinaryRows<4, 1, 4>& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kPowKernels[target()](rows, row, count); };
  return for_each_row(count, rows.out, kernel, [&](size_t row, Quaternion& result) {
    if (!is_finite(rows.a, row) || !is_finite(rows.b, row)) return Status::not_finite;
    if (is_zero(rows.a, row)) return Status::zero_norm;
    return pow_of(row_of(rows.a, row), number_of(rows.b, row), result);
  });
}

Outcome rotation_vector_from_q(const UnaryRows<4, 3>& rows, size_t count) {
  return for_each_quaternion(rows, count, kRotationVectorKernels[target()], [](const Quaternion& value, Vector3& r) {
    r = rotation_vector(value);
    return Status::ok;
  });
}

}  // namespace qtraj
