#include "functions/algebra.hpp"

#include "math/scaled.hpp"
#include "math/trigonometry.hpp"
#include "targets/kernels.hpp"

namespace qtraj {
namespace {

// The length, to 1e-30, of the difference or the sum of two unit quaternions, given in double-double.
DoubleDouble length_of(const UnitQuaternion& a) {
  const double scale = scale_for(largest_component(a.value));
  const Quaternion scaled = scale * a.value;
  const DoubleDouble length = precise_length(scaled);
  if (length.value == 0) return length;
  const double error = length.error + dot(scaled, Quaternion(scale * a.error)) / length.value;
  return {length.value / scale, error / scale};
}

// a + b in double-double.
UnitQuaternion precise_sum(const UnitQuaternion& a, const UnitQuaternion& b) {
  UnitQuaternion result;
  for (int k = 0; k < 4; ++k) {
    const DoubleDouble sum = two_sum(a.value[k], b.value[k]);
    const DoubleDouble all = two_sum(sum.value, sum.error + (a.error[k] + b.error[k]));
    result.value[k] = all.value;
    result.error[k] = all.error;
  }
  return result;
}

// Lengths of a - b and a + b.
struct Chords {
  DoubleDouble difference, sum;
};
Chords chords(const Quaternion& a, const Quaternion& b) {
  const UnitQuaternion from = normalize(a).unit, to = normalize(b).unit;
  return {length_of(precise_sum(from, negate(to))), length_of(precise_sum(from, to))};
}

constexpr RowKernel<BinaryRows<4, 4, 4>> kMultiplyKernels[] = QTRAJ_OF_EACH_TARGET(multiply);
constexpr RowKernel<AngleRows> kAngleKernels[] = QTRAJ_OF_EACH_TARGET(angles);
constexpr RowKernel<BinaryRows<4, 4, 1>> kDotKernels[] = QTRAJ_OF_EACH_TARGET(dot);
constexpr RowKernel<UnaryRows<4, 4>> kConjugateKernels[] = QTRAJ_OF_EACH_TARGET(conjugate);
constexpr RowKernel<UnaryRows<4, 4>> kInverseKernels[] = QTRAJ_OF_EACH_TARGET(inverse);
constexpr RowKernel<UnaryRows<4, 1>> kNormKernels[] = QTRAJ_OF_EACH_TARGET(norm);
constexpr RowKernel<RotateRows> kRotateKernels[] = QTRAJ_OF_EACH_TARGET(rotate);

// Calls `compute(a, b)`, an angle, for each pair of quaternions other than 0 that the kernel leaves.
template <class Compute>
Outcome for_each_pair(const BinaryRows<4, 4, 1>& rows, bool is_turn, size_t count, const Compute& compute) {
  const AngleRows angle_rows = {rows.a, rows.b, is_turn, rows.out};
  const auto from_row = [&](size_t row) { return kAngleKernels[target()](angle_rows, row, count); };
  return for_each_row(count, rows.out, from_row, [&](size_t row, Row<1>& value) {
    if (!is_finite(rows.a, row) || !is_finite(rows.b, row)) return Status::not_finite;
    if (is_zero(rows.a, row) || is_zero(rows.b, row)) return Status::zero_norm;
    value[0] = compute(row_of(rows.a, row), row_of(rows.b, row));
    return Status::ok;
  });
}

}  // namespace

Outcome multiply(const BinaryRows<4, 4, 4>& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kMultiplyKernels[target()](rows, row, count); };
  return for_each_row(count, rows.out, kernel, [&](size_t row, Quaternion& product) {
    if (!is_finite(rows.a, row) || !is_finite(rows.b, row)) return Status::not_finite;
    const Scaled<Quaternion> left = scale(row_of(rows.a, row)), right = scale(row_of(rows.b, row));
    product = unscale(Scaled<Quaternion>{multiply(left.value, right.value), left.steps + right.steps});
    return Status::ok;
  });
}

Outcome conjugate(const UnaryRows<4, 4>& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kConjugateKernels[target()](rows, row, count); };
  return for_each_row(count, rows.out, kernel, [&](size_t row, Quaternion& result) {
    if (!is_finite(rows.in, row)) return Status::not_finite;
    result = conjugate(row_of(rows.in, row));
    return Status::ok;
  });
}

Outcome inverse(const UnaryRows<4, 4>& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kInverseKernels[target()](rows, row, count); };
  return for_each_row(count, rows.out, kernel, [&](size_t row, Quaternion& result) {
    if (!is_finite(rows.in, row)) return Status::not_finite;
    if (is_zero(rows.in, row)) return Status::zero_norm;
    const Scaled<Quaternion> scaled = scale(row_of(rows.in, row));
    const Quaternion inverted = conjugate(scaled.value) / dot(scaled.value, scaled.value);
    result = unscale(Scaled<Quaternion>{inverted, -scaled.steps});
    return Status::ok;
  });
}

Outcome norm(const UnaryRows<4, 1>& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kNormKernels[target()](rows, row, count); };
  return for_each_row(count, rows.out, kernel, [&](size_t row, Row<1>& value) {
    if (!is_finite(rows.in, row)) return Status::not_finite;
    const Scaled<Quaternion> scaled = scale(row_of(rows.in, row));
    value[0] = unscale(length(scaled.value), scaled.steps);
    return Status::ok;
  });
}

Outcome dot(const BinaryRows<4, 4, 1>& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kDotKernels[target()](rows, row, count); };
  return for_each_row(count, rows.out, kernel, [&](size_t row, Row<1>& value) {
    if (!is_finite(rows.a, row) || !is_finite(rows.b, row)) return Status::not_finite;
    const Scaled<Quaternion> left = scale(row_of(rows.a, row)), right = scale(row_of(rows.b, row));
    value[0] = unscale(dot(left.value, right.value), left.steps + right.steps);
    return Status::ok;
  });
}

Outcome rotate(const RotateRows& rows, size_t count) {
  const auto kernel = [&](size_t row) { return kRotateKernels[target()](rows, row, count); };
  return for_each_row(count, rows.v_world, kernel, [&](size_t row, Vector3& v_world) {
    if (!is_finite(rows.q_wb, row) || !is_finite(rows.v_body, row)) return Status::not_finite;
    if (is_zero(rows.q_wb, row)) return Status::zero_norm;
    const Quaternion unit = normalize(row_of(rows.q_wb, row)).unit.value;
    const Scaled<Vector3> v = scale(row_of(rows.v_body, row));
    v_world = unscale(Scaled<Vector3>{rotate(unit, v.value), v.steps});
    return Status::ok;
  });
}

Outcome distance(const BinaryRows<4, 4, 1>& rows, size_t count) {
  return for_each_pair(rows, false, count, [](const Quaternion& from, const Quaternion& to) {
    const Chords chord = chords(from, to);
    return 2.0 * precise_atan2(chord.difference, chord.sum).value;
  });
}

double rotation_angle(const Quaternion& a, const Quaternion& b) {
  const Chords chord = chords(a, b);
  // near half a turn the values may tie
  const bool near = (chord.difference.value - chord.sum.value) + (chord.difference.error - chord.sum.error) <= 0;
  return 4.0 * (near ? precise_atan2(chord.difference, chord.sum) : precise_atan2(chord.sum, chord.difference)).value;
}

Outcome rotation_angle(const BinaryRows<4, 4, 1>& rows, size_t count) {
  return for_each_pair(rows, true, count,
                       [](const Quaternion& from, const Quaternion& to) { return rotation_angle(from, to); });
}

}  // namespace qtraj
