#include "qtraj/algebra.hpp"

#include "kernel/kernel.hpp"
#include "qtraj/precise.hpp"
#include "qtraj/scaled.hpp"

namespace qtraj {
namespace {

using Number = OutputRows<1>::Row;

// Length of (a + error), for unit a and b the chord between them, to 1e-30.
Exact length_of(const UnitQuaternion& a) {
  const double scale = scale_for(largest_component(a.value));
  const Quaternion scaled = scale * a.value;
  const Exact length = precise_length(scaled);
  if (length.value == 0) return length;
  const double error = length.error + dot(scaled, Quaternion(scale * a.error)) / length.value;
  return {length.value / scale, error / scale};
}

// a + b, keeping what the rounding left.
UnitQuaternion precise_sum(const UnitQuaternion& a, const UnitQuaternion& b) {
  UnitQuaternion result;
  for (int k = 0; k < 4; ++k) {
    const Exact sum = two_sum(a.value[k], b.value[k]);
    const Exact all = two_sum(sum.value, sum.error + (a.error[k] + b.error[k]));
    result.value[k] = all.value;
    result.error[k] = all.error;
  }
  return result;
}

// Lengths of a - b and a + b.
struct Chords {
  Exact difference, sum;
};
Chords chords(const Quaternion& a, const Quaternion& b) {
  const UnitQuaternion from = normalize(a).unit, to = normalize(b).unit;
  return {length_of(precise_sum(from, negate(to))), length_of(precise_sum(from, to))};
}

// Calls `compute(a, b)`, a number, for each pair of quaternions other than 0.
template <class Compute>
Outcome for_each_pair(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<1>& out,
                      const Compute& compute) {
  return for_each_row(count, out, [&](size_t row, Number& value) {
    if (!a.is_finite(row) || !b.is_finite(row)) return Status::not_finite;
    if (a.is_zero(row) || b.is_zero(row)) return Status::zero_norm;
    value[0] = compute(a[row], b[row]);
    return Status::ok;
  });
}

}  // namespace

Outcome multiply(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<4>& q_out) {
  return for_each_row(count, q_out, [&](size_t row, Quaternion& product) {
    if (!a.is_finite(row) || !b.is_finite(row)) return Status::not_finite;
    const Scaled<Quaternion> left = scale(a[row]), right = scale(b[row]);
    product = unscale(Scaled<Quaternion>{multiply(left.value, right.value), left.steps + right.steps});
    return Status::ok;
  });
}

Outcome conjugate(const Rows<4>& q, size_t count, const OutputRows<4>& q_out) {
  return for_each_row(count, q_out, [&](size_t row, Quaternion& result) {
    if (!q.is_finite(row)) return Status::not_finite;
    result = conjugate(q[row]);
    return Status::ok;
  });
}

Outcome inverse(const Rows<4>& q, size_t count, const OutputRows<4>& q_out) {
  return for_each_row(count, q_out, [&](size_t row, Quaternion& result) {
    if (!q.is_finite(row)) return Status::not_finite;
    if (q.is_zero(row)) return Status::zero_norm;
    const Scaled<Quaternion> scaled = scale(q[row]);
    const Quaternion inverted = conjugate(scaled.value) / dot(scaled.value, scaled.value);
    result = unscale(Scaled<Quaternion>{inverted, -scaled.steps});
    return Status::ok;
  });
}

Outcome norm(const Rows<4>& q, size_t count, const OutputRows<1>& norm_out) {
  return for_each_row(count, norm_out, [&](size_t row, Number& value) {
    if (!q.is_finite(row)) return Status::not_finite;
    const Scaled<Quaternion> scaled = scale(q[row]);
    value[0] = unscale(length(scaled.value), scaled.steps);
    return Status::ok;
  });
}

Outcome dot(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<1>& dot_out) {
  return for_each_row(count, dot_out, [&](size_t row, Number& value) {
    if (!a.is_finite(row) || !b.is_finite(row)) return Status::not_finite;
    const Scaled<Quaternion> left = scale(a[row]), right = scale(b[row]);
    value[0] = unscale(dot(left.value, right.value), left.steps + right.steps);
    return Status::ok;
  });
}

Outcome rotate(const Rows<4>& q_wb, const Rows<3>& v_body, size_t count, const OutputRows<3>& v_world_out) {
  const RotateArrays arrays = {q_wb.array(), v_body.array(), v_world_out.data, v_world_out.single};
  const auto vectors = [&](size_t row) { return kernel().rows.rotate(arrays, row, count); };
  return for_each_row(count, v_world_out, vectors, [&](size_t row, Vector3& v_world) {
    if (!q_wb.is_finite(row) || !v_body.is_finite(row)) return Status::not_finite;
    if (q_wb.is_zero(row)) return Status::zero_norm;
    const Quaternion unit = normalize(q_wb[row]).unit.value;
    const Scaled<Vector3> v = scale(v_body[row]);
    v_world = unscale(Scaled<Vector3>{rotate(unit, v.value), v.steps});
    return Status::ok;
  });
}

Outcome distance(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<1>& angle_out) {
  return for_each_pair(a, b, count, angle_out, [](const Quaternion& from, const Quaternion& to) {
    const Chords chord = chords(from, to);
    return 2.0 * precise_atan2(chord.difference, chord.sum).value;
  });
}

double rotation_angle(const Quaternion& a, const Quaternion& b) {
  const Chords chord = chords(a, b);
  // near a half turn the first doubles may tie
  const bool near = (chord.difference.value - chord.sum.value) + (chord.difference.error - chord.sum.error) <= 0;
  return 4.0 * (near ? precise_atan2(chord.difference, chord.sum) : precise_atan2(chord.sum, chord.difference)).value;
}

Outcome rotation_angle(const Rows<4>& a, const Rows<4>& b, size_t count, const OutputRows<1>& angle_out) {
  return for_each_pair(a, b, count, angle_out,
                       [](const Quaternion& from, const Quaternion& to) { return rotation_angle(from, to); });
}

}  // namespace qtraj
