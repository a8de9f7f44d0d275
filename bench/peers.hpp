// What a user would write with the peers: plain loops, their own types, keys prepared before. Each writes [count] rows
// in the peer's own component order, which `kEigenOrder` and its like name.
#pragma once

#define GLM_ENABLE_EXPERIMENTAL
#include <Eigen/Dense>
#include <algorithm>
#include <boost/qvm/quat.hpp>
#include <boost/qvm/quat_operations.hpp>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/quaternion.hpp>
#include <vector>

namespace peers {

// Where w, x, y, z are in a row.
const int kEigenOrder[4] = {3, 0, 1, 2};
const int kGlmOrder[4] = {3, 0, 1, 2};
const int kQvmOrder[4] = {0, 1, 2, 3};

template <class Real>
Eigen::Quaternion<Real> eigen_from(const double* q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).cast<Real>();
}
template <class Real>
glm::qua<Real> glm_from(const double* q) {
  return glm::qua<Real>(glm::qua<double>(q[0], q[1], q[2], q[3]));
}
template <class Real>
boost::qvm::quat<Real> qvm_from(const double* q) {
  return {{static_cast<Real>(q[0]), static_cast<Real>(q[1]), static_cast<Real>(q[2]), static_cast<Real>(q[3])}};
}

// [count][4] rows w x y z, as the peer holds them.
template <class Converted>
std::vector<Converted> rows_from(const std::vector<double>& q, Converted (*convert)(const double*)) {
  std::vector<Converted> rows;
  rows.reserve(q.size() / 4);
  for (size_t i = 0; i + 4 <= q.size(); i += 4) rows.push_back(convert(&q[i]));
  return rows;
}

// The segment of a time, for times that mostly increase.
inline size_t advance(const std::vector<double>& knots, double time, size_t segment) {
  while (segment + 2 < knots.size() && time >= knots[segment + 1]) ++segment;
  return segment;
}
// The segment of any time.
inline size_t search(const std::vector<double>& knots, double time) {
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, time);
  return static_cast<size_t>(after - knots.begin()) - 1;
}
template <class Real>
Real fraction_of(const std::vector<double>& knots, size_t segment, double time) {
  return static_cast<Real>((time - knots[segment]) / (knots[segment + 1] - knots[segment]));
}

// ---- Eigen ----

template <class Real>
using EigenRows = std::vector<Eigen::Quaternion<Real>>;

template <class Real>
Eigen::Map<Eigen::Quaternion<Real>> eigen_row(Real* rows, size_t i) {
  return Eigen::Map<Eigen::Quaternion<Real>>(rows + 4 * i);
}

// What a slerp between the same keys can be prepared of: unit keys of continuous sign, and for each segment the angle
// and the inverses of its sine and of its length.
struct EigenSegment {
  Eigen::Quaterniond key;
  double angle, inverse_sine, inverse_length;
};
inline void eigen_prepare_slerp(const double* times, const double* q_wb, size_t count, EigenSegment* segments) {
  for (size_t i = 0; i < count; ++i) {
    Eigen::Quaterniond key = eigen_from<double>(q_wb + 4 * i).normalized();
    if (i > 0) {
      EigenSegment& before = segments[i - 1];
      double cosine = before.key.dot(key);
      if (cosine < 0) key.coeffs() = -key.coeffs(), cosine = -cosine;
      before.angle = std::acos(std::min(cosine, 1.0));
      before.inverse_sine = 1 / std::sin(before.angle);
      before.inverse_length = 1 / (times[i] - times[i - 1]);
    }
    segments[i].key = key;
  }
}

template <class Real>
void eigen_slerp_sorted(const std::vector<double>& knots, const EigenRows<Real>& keys, const double* times,
                        size_t count, Real* out) {
  size_t segment = 0;
  for (size_t i = 0; i < count; ++i) {
    segment = advance(knots, times[i], segment);
    eigen_row(out, i) = keys[segment].slerp(fraction_of<Real>(knots, segment, times[i]), keys[segment + 1]);
  }
}

template <class Real>
void eigen_slerp_any_order(const std::vector<double>& knots, const EigenRows<Real>& keys, const double* times,
                           size_t count, Real* out) {
  for (size_t i = 0; i < count; ++i) {
    const size_t segment = search(knots, times[i]);
    eigen_row(out, i) = keys[segment].slerp(fraction_of<Real>(knots, segment, times[i]), keys[segment + 1]);
  }
}

template <class Real>
void eigen_slerp_pairs(const EigenRows<Real>& a, const EigenRows<Real>& b, const Real* fraction, size_t count,
                       Real* out) {
  for (size_t i = 0; i < count; ++i) eigen_row(out, i) = a[i].slerp(fraction[i], b[i]);
}

// Top eigenvector of the sum of q q^T.
template <class Real>
Eigen::Vector4d eigen_mean(const EigenRows<Real>& q) {
  Eigen::Matrix4d scatter = Eigen::Matrix4d::Zero();
  for (const Eigen::Quaternion<Real>& each : q) {
    const Eigen::Vector4d row = each.coeffs().template cast<double>();
    scatter += row * row.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(scatter).eigenvectors().col(3);
}

// ---- GLM ----

template <class Real>
using GlmRows = std::vector<glm::qua<Real>>;

template <class Real>
void glm_slerp_sorted(const std::vector<double>& knots, const GlmRows<Real>& keys, const double* times, size_t count,
                      glm::qua<Real>* out) {
  size_t segment = 0;
  for (size_t i = 0; i < count; ++i) {
    segment = advance(knots, times[i], segment);
    out[i] = glm::slerp(keys[segment], keys[segment + 1], fraction_of<Real>(knots, segment, times[i]));
  }
}

// a, b: controls of the keys, at the start and at the end of a segment.
template <class Real>
void glm_squad_sorted(const std::vector<double>& knots, const GlmRows<Real>& keys, const GlmRows<Real>& a,
                      const GlmRows<Real>& b, const double* times, size_t count, glm::qua<Real>* out) {
  size_t segment = 0;
  for (size_t i = 0; i < count; ++i) {
    segment = advance(knots, times[i], segment);
    out[i] = glm::squad(keys[segment], keys[segment + 1], a[segment], b[segment + 1],
                        fraction_of<Real>(knots, segment, times[i]));
  }
}

template <class Real>
void glm_squad_any_order(const std::vector<double>& knots, const GlmRows<Real>& keys, const GlmRows<Real>& a,
                         const GlmRows<Real>& b, const double* times, size_t count, glm::qua<Real>* out) {
  for (size_t i = 0; i < count; ++i) {
    const size_t segment = search(knots, times[i]);
    out[i] = glm::squad(keys[segment], keys[segment + 1], a[segment], b[segment + 1],
                        fraction_of<Real>(knots, segment, times[i]));
  }
}

// ---- Boost.QVM ----

template <class Real>
using QvmRows = std::vector<boost::qvm::quat<Real>>;

template <class Real>
void qvm_slerp_sorted(const std::vector<double>& knots, const QvmRows<Real>& keys, const double* times, size_t count,
                      boost::qvm::quat<Real>* out) {
  size_t segment = 0;
  for (size_t i = 0; i < count; ++i) {
    segment = advance(knots, times[i], segment);
    out[i] = boost::qvm::slerp(keys[segment], keys[segment + 1], fraction_of<Real>(knots, segment, times[i]));
  }
}

// ---- No library ----

// Reads the times and writes as many bytes as sampling does: what memory alone costs.
template <class Real>
void read_and_write(const double* times, size_t count, Real* out) {
  for (size_t i = 0; i < count; ++i) {
    const Real value = static_cast<Real>(times[i]);
    for (int k = 0; k < 4; ++k) out[4 * i + k] = value;
  }
}

// Sum of the half-angle vectors from a mean [4] to each of q [count][4], nearer sign: one step of a Karcher mean.
inline void atan2_karcher_step(const double* mean, const double* q, size_t count, double sum[3]) {
  for (int k = 0; k < 3; ++k) sum[k] = 0;
  const double w = mean[0], x = mean[1], y = mean[2], z = mean[3];
  for (size_t i = 0; i < count; ++i) {
    const double* p = q + 4 * i;
    // conjugate(mean) p
    double cosine = w * p[0] + x * p[1] + y * p[2] + z * p[3];
    const double v[3] = {w * p[1] - x * p[0] - y * p[3] + z * p[2], w * p[2] + x * p[3] - y * p[0] - z * p[1],
                         w * p[3] - x * p[2] + y * p[1] - z * p[0]};
    const double sine = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (sine == 0) continue;
    const double angle = std::atan2(sine, std::abs(cosine));
    const double scale = (cosine < 0 ? -angle : angle) / sine;
    for (int k = 0; k < 3; ++k) sum[k] += scale * v[k];
  }
}

}  // namespace peers
