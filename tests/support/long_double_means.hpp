// Means of weighted samples in long double.
#ifndef QTRAJ_TESTS_LONG_DOUBLE_MEANS_HPP
#define QTRAJ_TESTS_LONG_DOUBLE_MEANS_HPP

#include <utility>

#include "support/capi_means.hpp"
#include "support/long_double.hpp"

namespace wide {

using Matrix3 = std::array<Vector, 3>;
using Matrix4 = std::array<Quaternion, 4>;

template <class Element>
Matrix4 scatter(const capi::Samples<Element>& samples) {
  Matrix4 sum{};
  for (size_t i = 0; i < samples.count(); ++i) {
    const Quaternion q = normalized(quaternion(&samples.q[4 * i]));
    const Real weight = samples.weight(i);
    for (size_t row = 0; row < 4; ++row)
      for (size_t column = 0; column < 4; ++column) sum[row][column] += weight * q[row] * q[column];
  }
  return sum;
}

inline Quaternion product(const Matrix4& a, const Quaternion& x) {
  return {dot(a[0], x), dot(a[1], x), dot(a[2], x), dot(a[3], x)};
}

struct Eigenvector {
  Quaternion q;
  Real value;
};

// Of the largest eigenvalue of a positive semidefinite matrix: squared again and again it becomes a multiple of q q^T.
inline Eigenvector top_eigenvector(const Matrix4& a) {
  Matrix4 power = a;
  Real change = 1;
  for (int squaring = 0; squaring < 60 && change > 0; ++squaring) {
    Matrix4 square{};
    Real largest = 0;
    for (size_t row = 0; row < 4; ++row)
      for (size_t column = 0; column < 4; ++column) {
        square[row][column] = dot(power[row], power[column]);
        largest = std::max(largest, square[row][row]);
      }
    if (largest == 0) return {{1, 0, 0, 0}, 0};
    change = 0;
    for (size_t row = 0; row < 4; ++row)
      for (size_t column = 0; column < 4; ++column) {
        square[row][column] /= largest;
        change = std::max(change, std::abs(square[row][column] - power[row][column]) - Real(1e-18));
      }
    power = square;
  }
  size_t column = 0;
  for (size_t k = 1; k < 4; ++k)
    if (power[k][k] > power[column][column]) column = k;
  const Quaternion q = normalized(power[column]);
  return {q, dot(q, product(a, q))};
}

struct EigenMean {
  Quaternion q;
  Real eigengap;
};

inline EigenMean eigen_mean(Matrix4 a) {
  const Real trace = a[0][0] + a[1][1] + a[2][2] + a[3][3];
  for (Quaternion& row : a) row = scaled(1 / trace, row);
  const Eigenvector first = top_eigenvector(a);
  for (size_t row = 0; row < 4; ++row)
    for (size_t column = 0; column < 4; ++column) a[row][column] -= first.value * first.q[row] * first.q[column];
  return {first.q, first.value - top_eigenvector(a).value};
}

// What samples tell of a base: r the half-angle vectors from it to the nearer of q and -q, d their lengths.
struct Moments {
  Real weight = 0, squares = 0, distances = 0, farthest = 0;  // sum w, sum w d^2, sum w d, largest d
  Vector logs{};                                              // sum w r
  Matrix3 hessian{};                                          // of sum w d^2 / 2
  Real undecided = 0;                                         // weight of samples of which r and -r are both right
};

template <class Element>
Moments moments(const capi::Samples<Element>& samples, const Quaternion& base) {
  Moments sums;
  for (size_t i = 0; i < samples.count(); ++i) {
    Quaternion relative = multiply(conjugate(base), normalized(quaternion(&samples.q[4 * i])));
    if (relative[0] < 0) relative = scaled(-1, relative);
    const Vector r = log(relative);
    const Real weight = samples.weight(i), angle = norm(r);
    const Real sideways = angle == 0 ? Real(1) : angle / std::tan(angle);
    sums.weight += weight;
    sums.squares += weight * angle * angle;
    sums.distances += weight * angle;
    sums.farthest = std::max(sums.farthest, angle);
    if (relative[0] < Real(1e-15)) sums.undecided += weight;
    for (size_t row = 0; row < 3; ++row) {
      sums.logs[row] += weight * r[row];
      sums.hessian[row][row] += weight * sideways;
      if (angle == 0) continue;
      for (size_t column = 0; column < 3; ++column)
        sums.hessian[row][column] += weight * (1 - sideways) * (r[row] / angle) * (r[column] / angle);
    }
  }
  return sums;
}

// A stationary point of sum w d^2 close to `q`, by steps of Newton's method, and the least eigenvalue of the Hessian
// there over the sum of weights.
struct KarcherMean {
  Quaternion q;
  Real curvature;
};

inline Vector product(const Matrix3& a, const Vector& x) { return {dot(a[0], x), dot(a[1], x), dot(a[2], x)}; }

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Matrix3 inverse_of_symmetric(const Matrix3& a) {
  const Vector first = cross(a[1], a[2]);
  const Real factor = 1 / dot(a[0], first);
  return {scaled(factor, first), scaled(factor, cross(a[2], a[0])), scaled(factor, cross(a[0], a[1]))};
}

template <class Element>
KarcherMean karcher_mean(const capi::Samples<Element>& samples, Quaternion q, int steps) {
  Matrix3 inverse{};
  for (int step = 0; step < steps; ++step) {
    q = normalized(q);
    Moments at = moments(samples, q);
    for (Vector& row : at.hessian) row = scaled(1 / at.weight, row);
    inverse = inverse_of_symmetric(at.hessian);
    q = multiply(q, exp(product(inverse, scaled(1 / at.weight, at.logs))));
  }
  Vector slowest = {Real(0.6), Real(0.64), Real(0.48)};
  for (int step = 0; step < 30; ++step) slowest = normalized(product(inverse, slowest));
  return {normalized(q), 1 / norm(product(inverse, slowest))};
}

}  // namespace wide

#endif
