// Weighted samples for the means, and one name for the double and the float twin of each mean.
#ifndef QTRAJ_TESTS_CAPI_MEANS_HPP
#define QTRAJ_TESTS_CAPI_MEANS_HPP

#include <qtraj.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include "support/hard_inputs.hpp"
#include "support/worst.hpp"

namespace capi {

inline qtraj_status mean_eigen(const double* q, const double* weights, size_t count, double* mean_out, double* eigengap,
                               size_t* bad_index) {
  return qtraj_mean_eigen(q, weights, count, mean_out, eigengap, bad_index);
}
inline qtraj_status mean_eigen(const float* q, const float* weights, size_t count, float* mean_out, double* eigengap,
                               size_t* bad_index) {
  return qtraj_mean_eigen_f32(q, weights, count, mean_out, eigengap, bad_index);
}
inline qtraj_status mean_karcher(const double* q, const double* weights, size_t count, double tolerance,
                                 int32_t max_iterations, double* mean_out, int32_t* iterations, double* residual,
                                 size_t* bad_index) {
  return qtraj_mean_karcher(q, weights, count, tolerance, max_iterations, mean_out, iterations, residual, bad_index);
}
inline qtraj_status mean_karcher(const float* q, const float* weights, size_t count, double tolerance,
                                 int32_t max_iterations, float* mean_out, int32_t* iterations, double* residual,
                                 size_t* bad_index) {
  return qtraj_mean_karcher_f32(q, weights, count, tolerance, max_iterations, mean_out, iterations, residual,
                                bad_index);
}

// Rows of q and weights; without weights all count 1.
template <class Real>
struct Samples {
  std::vector<Real> q, weights;

  size_t count() const { return q.size() / 4; }
  const Real* weights_or_null() const { return weights.empty() ? nullptr : weights.data(); }
  double weight(size_t i) const { return weights.empty() ? 1.0 : static_cast<double>(weights[i]); }
  void add(const test::Quaternion& orientation) {
    for (const double component : orientation) q.push_back(static_cast<Real>(component));
  }
  void add(const test::Quaternion& orientation, double weight) {
    add(orientation);
    weights.push_back(static_cast<Real>(weight));
  }
};

// What a mean returned; fields that the other mean has not stay as they are.
template <class Real>
struct Mean {
  qtraj_status status = QTRAJ_E_INTERNAL;
  std::array<Real, 4> q{};
  double eigengap = -7, residual = -7;
  int32_t iterations = -7;
  size_t bad_index = 12345;
};

template <class Real>
Mean<Real> eigen(const Samples<Real>& samples) {
  Mean<Real> mean;
  mean.status = mean_eigen(samples.q.data(), samples.weights_or_null(), samples.count(), mean.q.data(), &mean.eigengap,
                           &mean.bad_index);
  return mean;
}
template <class Real>
Mean<Real> karcher(const Samples<Real>& samples, double tolerance = 0, int32_t max_iterations = 100) {
  Mean<Real> mean;
  mean.status = mean_karcher(samples.q.data(), samples.weights_or_null(), samples.count(), tolerance, max_iterations,
                             mean.q.data(), &mean.iterations, &mean.residual, &mean.bad_index);
  return mean;
}

// The eigen and the Karcher mean.
template <class Real>
std::array<Mean<Real>, 2> both_means(const Samples<Real>& samples) {
  return {eigen(samples), karcher(samples)};
}

// Largest difference of components of two orientations, the sign of one of them free.
template <class A, class B>
double difference(const A& a, const B& b) {
  double minus = 0, plus = 0;
  for (size_t k = 0; k < 4; ++k) {
    test::raise_to(minus, std::abs(static_cast<double>(a[k]) - static_cast<double>(b[k])));
    test::raise_to(plus, std::abs(static_cast<double>(a[k]) + static_cast<double>(b[k])));
  }
  return std::min(minus, plus);
}

// Square of the chord between two orientations, the sign of one of them free.
template <class A, class B>
double squared_distance(const A& a, const B& b) {
  double minus = 0, plus = 0;
  for (size_t k = 0; k < 4; ++k) {
    const double x = static_cast<double>(a[k]), y = static_cast<double>(b[k]);
    minus += (x - y) * (x - y);
    plus += (x + y) * (x + y);
  }
  return std::min(minus, plus);
}

// What rounding a component to float adds to an error.
template <class Real>
constexpr double kHalfUlp = sizeof(Real) == sizeof(double) ? 0.0 : 0x1p-25;

template <class Real>
bool same_bits(const std::array<Real, 4>& a, const std::array<Real, 4>& b) {
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

template <class Real>
Samples<Real> chosen_rows(const Samples<Real>& samples, const std::vector<size_t>& rows) {
  Samples<Real> chosen;
  for (const size_t i : rows) {
    chosen.q.insert(chosen.q.end(), &samples.q[4 * i], &samples.q[4 * i] + 4);
    if (!samples.weights.empty()) chosen.weights.push_back(samples.weights[i]);
  }
  return chosen;
}

// A turn with a rotation vector of normal components, `spread` rad each.
inline test::Quaternion random_turn(test::Random& random, double spread) {
  const test::Vector v = {spread * random.normal(), spread * random.normal(), spread * random.normal()};
  const double angle = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return test::about({v[0] / angle, v[1] / angle, v[2] / angle}, angle);
}

// Samples around an orientation, unit and of weight 1.
template <class Real>
Samples<Real> cloud(test::Random& random, size_t count, double spread) {
  Samples<Real> samples;
  const test::Quaternion center = random.orientation();
  for (size_t i = 0; i < count; ++i) samples.add(test::multiply(center, random_turn(random, spread)));
  return samples;
}

// 1 to 30 samples with every difficulty: spreads from 1e-12 rad to `widest`, repeated samples, all norms and signs,
// weights of all sizes, also 0.
template <class Real>
Samples<Real> hard_samples(test::Random& random, double widest) {
  const double decades = sizeof(Real) == sizeof(double) ? 160.0 : 30.0;
  const auto count = static_cast<size_t>(random.uniform(1, 31));
  const double spread = random.uniform(0, 1) < 0.6 ? random.uniform(0, widest) : std::pow(10, random.uniform(-12, 0));
  const double weighting = random.uniform(0, 1);
  const test::Quaternion center = random.orientation();
  test::Quaternion q = center;
  Samples<Real> samples;
  for (size_t i = 0; i < count; ++i) {
    if (random.uniform(0, 1) < 0.9) q = test::multiply(center, random_turn(random, std::min(spread, widest)));
    const double sign = random.uniform(-1, 1) < 0 ? -1.0 : 1.0;
    samples.add(test::scaled(sign * test::hard_norm(random, decades), q));
    if (weighting < 0.3) continue;
    const double size = weighting < 0.6 ? random.uniform(0, 5) : std::pow(10.0, random.uniform(-30.0, 30.0));
    samples.weights.push_back(i > 0 && random.uniform(0, 1) < 0.1 ? Real(0) : static_cast<Real>(size));
  }
  return samples;
}

}  // namespace capi

#endif
