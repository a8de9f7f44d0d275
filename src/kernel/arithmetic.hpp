// The two arithmetics that evaluation is instantiated with, and polynomials in them. Fused: AVX2, AVX-512 and AArch64;
// plain: all other targets. Results of one kind are the same bits everywhere, those of the two kinds differ in
// rounding.
//
// Everything in this folder's headers has internal linkage: a copy compiled for a wider instruction set must never be
// the one a linker keeps for other files.
#pragma once

#include <cstddef>

#include "coefficients.hpp"

namespace qtraj {
namespace {

struct Plain {
  static double multiply_add(double a, double b, double c) { return a * b + c; }
  static float multiply_add(float a, float b, float c) { return a * b + c; }
};

struct Fused {
  static double multiply_add(double a, double b, double c) { return __builtin_fma(a, b, c); }
  static float multiply_add(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
};

// Horner's scheme.
template <class Arithmetic, class Real, size_t Terms>
Real horner(const Real (&coefficients)[Terms], Real x) {
  Real sum = coefficients[Terms - 1];
  for (size_t k = Terms - 1; k-- > 0;) sum = Arithmetic::multiply_add(sum, x, coefficients[k]);
  return sum;
}

// A polynomial of coefficients.hpp in the precision of its argument.
template <class Real, class Polynomial>
constexpr const auto& coefficients(Polynomial) {
  if constexpr (sizeof(Real) == sizeof(double))
    return Polynomial::kDouble;
  else
    return Polynomial::kFloat;
}
template <class Arithmetic, class Polynomial, class Real>
Real evaluate(Real x) {
  return horner<Arithmetic>(coefficients<Real>(Polynomial{}), x);
}

// One instruction on every target with a square root; rounded correctly on all.
inline double square_root(double x) { return __builtin_sqrt(x); }
inline float square_root(float x) { return __builtin_sqrtf(x); }

// Dot product in the one order that all kernels use.
template <class Arithmetic, class Real, size_t Size>
Real dot(const Real (&a)[Size], const Real (&b)[Size]) {
  Real sum = a[0] * b[0];
  for (size_t k = 1; k < Size; ++k) sum = Arithmetic::multiply_add(a[k], b[k], sum);
  return sum;
}

// q (1.5 - |q|^2/2): unit length to rounding where |q| is within a few hundred eps of 1.
template <class Arithmetic, class Real>
void newton_normalize(Real (&q)[4]) {
  const Real factor = Arithmetic::multiply_add(Real(-0.5), dot<Arithmetic>(q, q), Real(1.5));
  for (Real& component : q) component *= factor;
}

// Polynomial with vector coefficients, rounded to Real, at x.
template <class Arithmetic, class Real, size_t Terms, size_t Size>
void vector_horner(const double (&coefficients)[Terms][Size], Real x, Real (&value)[Size]) {
  for (size_t k = 0; k < Size; ++k) {
    Real sum = static_cast<Real>(coefficients[Terms - 1][k]);
    for (size_t term = Terms - 1; term-- > 0;)
      sum = Arithmetic::multiply_add(sum, x, static_cast<Real>(coefficients[term][k]));
    value[k] = sum;
  }
}

// s = 2u - 1: position in a segment, -1 at its left knot and 1 at its right one. In double for float samples too: the
// difference of times and 2/h may lie outside the range of float.
template <class Arithmetic>
double position(double elapsed, double scale) {
  return Arithmetic::multiply_add(elapsed, scale, -1.0);
}

}  // namespace
}  // namespace qtraj
