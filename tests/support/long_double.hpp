// An independent reference for single quaternions: textbook formulas in long double, which has 11 bits more than
// double on x86-64 and 60 more on AArch64, and exponents that no norm of a double leaves.
#ifndef QTRAJ_TESTS_LONG_DOUBLE_HPP
#define QTRAJ_TESTS_LONG_DOUBLE_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wide {

using Real = long double;
using Vector = std::array<Real, 3>;
using Quaternion = std::array<Real, 4>;

static_assert(std::numeric_limits<Real>::digits >= 64, "the reference needs more digits than double");

constexpr Real kPi = 3.14159265358979323846264338327950288L;

template <class Element>
Quaternion quaternion(const Element* q) {
  return {Real(q[0]), Real(q[1]), Real(q[2]), Real(q[3])};
}
template <class Element>
Vector vector(const Element* v) {
  return {Real(v[0]), Real(v[1]), Real(v[2])};
}

template <class Array>
Real dot(const Array& a, const Array& b) {
  Real sum = 0;
  for (size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}
template <class Array>
Real norm(const Array& a) {
  return std::sqrt(dot(a, a));
}
template <class Array>
Array scaled(Real factor, Array a) {
  for (Real& component : a) component *= factor;
  return a;
}
template <class Array>
Array sum(Array a, const Array& b) {
  for (size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}
template <class Array>
Array normalized(const Array& a) {
  return scaled(1 / norm(a), a);
}

inline Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }
inline Vector vector_part(const Quaternion& q) { return {q[1], q[2], q[3]}; }

inline Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

// q v q^-1.
inline Vector rotate(const Quaternion& q, const Vector& v) {
  const Quaternion unit = normalized(q);
  return vector_part(multiply(multiply(unit, {0, v[0], v[1], v[2]}), conjugate(unit)));
}

inline Quaternion exp(const Vector& v) {
  const Real angle = norm(v);
  const Real sinc = angle == 0 ? Real(1) : std::sin(angle) / angle;
  return {std::cos(angle), sinc * v[0], sinc * v[1], sinc * v[2]};
}

// Half-angle vector of q / |q|, length in [0, pi]; 0 where the vector part is.
inline Vector log(const Quaternion& q) {
  const Vector v = vector_part(q);
  const Real sine = norm(v);
  return sine == 0 ? Vector{0, 0, 0} : scaled(std::atan2(sine, q[0]) / sine, v);
}

// Angle between two quaternions in R^4, [0, pi].
inline Real angle(const Quaternion& a, const Quaternion& b) {
  const Quaternion p = normalized(a), q = normalized(b);
  return 2 * std::atan2(norm(sum(p, scaled(-1, q))), norm(sum(p, q)));
}

// Largest absolute difference of a result's components from the reference.
template <class Element, class Array>
double error(const Element* result, const Array& reference) {
  Real largest = 0;
  for (size_t k = 0; k < reference.size(); ++k) {
    const Real difference = std::abs(Real(result[k]) - reference[k]);
    if (!(difference <= largest)) largest = std::isnan(difference) ? std::numeric_limits<Real>::infinity() : difference;
  }
  return static_cast<double>(largest);
}

}  // namespace wide

#endif
