// Rates as evaluators leave them, and the vector algebra they share.
#pragma once

#include "arithmetic.hpp"

namespace qtraj {
namespace {

// Rates in the body frame, per unit of the segment's own parameter: numbers of the size of the rotation, whatever the
// length of the segment. The evaluator's scale, in 1/s, takes them to time.
template <class Real>
struct Rates {
  Real omega[3];
  Real alpha[3];
};

template <class Arithmetic, class Real>
void cross(const Real (&a)[3], const Real (&b)[3], Real (&product)[3]) {
  product[0] = Arithmetic::multiply_add(a[1], b[2], -(a[2] * b[1]));
  product[1] = Arithmetic::multiply_add(a[2], b[0], -(a[0] * b[2]));
  product[2] = Arithmetic::multiply_add(a[0], b[1], -(a[1] * b[0]));
}

// Im(a* b).
template <class Arithmetic, class Real>
void relative_vector_part(const Real (&a)[4], const Real (&b)[4], Real (&v)[3]) {
  const Real a_vector[3] = {a[1], a[2], a[3]}, b_vector[3] = {b[1], b[2], b[3]};
  Real turned[3];
  cross<Arithmetic>(a_vector, b_vector, turned);
  for (size_t k = 0; k < 3; ++k)
    v[k] = Arithmetic::multiply_add(a[0], b_vector[k], Arithmetic::multiply_add(-b[0], a_vector[k], -turned[k]));
}

// q v q*: a body vector in the world frame.
template <class Arithmetic, class Real>
void rotate_to_world(const Real (&q)[4], Real (&v)[3]) {
  const Real u[3] = {q[1], q[2], q[3]};
  Real once[3], twice[3];
  cross<Arithmetic>(u, v, once);
  for (Real& component : once) component *= Real(2);
  cross<Arithmetic>(u, once, twice);
  for (size_t k = 0; k < 3; ++k) v[k] += Arithmetic::multiply_add(q[0], once[k], twice[k]);
}

// A polynomial with vector coefficients and its first two derivatives, by Horner's scheme; the value as vector_horner
// has it.
template <class Arithmetic, class Real, size_t Terms, size_t Size>
void polynomial_jet(const double (&c)[Terms][Size], Real x, Real (&value)[Size], Real (&first)[Size],
                    Real (&second)[Size]) {
  vector_horner<Arithmetic>(c, x, value);
  for (size_t k = 0; k < Size; ++k) {
    first[k] = second[k] = 0;
    for (size_t term = Terms; term-- > 1;) {
      const Real slope = static_cast<Real>(term) * static_cast<Real>(c[term][k]);
      first[k] = Arithmetic::multiply_add(first[k], x, slope);
      if (term >= 2) second[k] = Arithmetic::multiply_add(second[k], x, static_cast<Real>(term - 1) * slope);
    }
  }
}

template <class Real, size_t Size>
void load(const double (&from)[Size], Real (&to)[Size]) {
  for (size_t k = 0; k < Size; ++k) to[k] = static_cast<Real>(from[k]);
}

}  // namespace
}  // namespace qtraj
