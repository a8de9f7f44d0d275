// Functions over rows by Eigen, on the same arrays as ours.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>

namespace peers {
namespace rows {

template <class Real>
Eigen::Quaternion<Real> quaternion_at(const Real* q) {
  return {q[0], q[1], q[2], q[3]};
}
template <class Real>
void put(const Eigen::Quaternion<Real>& q, Real* out) {
  out[0] = q.w(), out[1] = q.x(), out[2] = q.y(), out[3] = q.z();
}
template <class Real>
Eigen::Map<const Eigen::Matrix<Real, 3, 1>> vector_at(const Real* v) {
  return Eigen::Map<const Eigen::Matrix<Real, 3, 1>>(v);
}
template <class Real>
Eigen::Map<Eigen::Matrix<Real, 3, 1>> vector_at(Real* v) {
  return Eigen::Map<Eigen::Matrix<Real, 3, 1>>(v);
}
template <class Real>
using RowMajor = Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>;

template <class Real>
void multiply(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i)
    put<Real>(quaternion_at(in[0] + 4 * i) * quaternion_at(in[1] + 4 * i), out[0] + 4 * i);
}
template <class Real>
void conjugate(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) put<Real>(quaternion_at(in[0] + 4 * i).conjugate(), out[0] + 4 * i);
}
template <class Real>
void inverse(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) put<Real>(quaternion_at(in[0] + 4 * i).inverse(), out[0] + 4 * i);
}
template <class Real>
void norm(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) out[0][i] = quaternion_at(in[0] + 4 * i).norm();
}
template <class Real>
void dot(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) out[0][i] = quaternion_at(in[0] + 4 * i).dot(quaternion_at(in[1] + 4 * i));
}
template <class Real>
void normalize(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) put<Real>(quaternion_at(in[0] + 4 * i).normalized(), out[0] + 4 * i);
}
template <class Real>
void rotate(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i)
    vector_at(out[0] + 3 * i) = quaternion_at(in[0] + 4 * i)._transformVector(vector_at(in[1] + 3 * i));
}
template <class Real>
void rotation_angle(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i)
    out[0][i] = quaternion_at(in[0] + 4 * i).angularDistance(quaternion_at(in[1] + 4 * i));
}
template <class Real>
void q_from_rotation_vector(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const Eigen::Matrix<Real, 3, 1> r = vector_at(in[0] + 3 * i);
    put<Real>(Eigen::Quaternion<Real>(Eigen::AngleAxis<Real>(r.norm(), r.normalized())), out[0] + 4 * i);
  }
}
template <class Real>
void rotation_vector_from_q(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i) {
    const Eigen::AngleAxis<Real> turn(quaternion_at(in[0] + 4 * i));
    vector_at(out[0] + 3 * i) = turn.angle() * turn.axis();
  }
}
template <class Real>
void matrix_from_q(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i)
    Eigen::Map<RowMajor<Real>>(out[0] + 9 * i) = quaternion_at(in[0] + 4 * i).toRotationMatrix();
}
template <class Real>
void q_from_matrix(const Real* const* in, size_t count, Real* const* out) {
  for (size_t i = 0; i < count; ++i)
    put<Real>(Eigen::Quaternion<Real>(Eigen::Map<const RowMajor<Real>>(in[0] + 9 * i)), out[0] + 4 * i);
}

}  // namespace rows
}  // namespace peers
