// Rates as evaluators return them, and the vector algebra that evaluators share.
#pragma once

#include "math/arithmetic.hpp"

namespace qtraj {
namespace {

// Rates in the body frame, per unit of the segment's own parameter: their size is that of the rotation, however long or
// short the segment is in time. Multiplied by the evaluator's scale, in 1/s, they become rates in time.
template <class Number>
struct Rates {
  Number omega[3];
  Number alpha[3];
};

template <class Arithmetic, class Number>
QTRAJ_INLINE void cross_product(const Number (&a)[3], const Number (&b)[3], Number (&product)[3]) {
  product[0] = Arithmetic::multiply_add(a[1], b[2], -(a[2] * b[1]));
  product[1] = Arithmetic::multiply_add(a[2], b[0], -(a[0] * b[2]));
  product[2] = Arithmetic::multiply_add(a[0], b[1], -(a[1] * b[0]));
}

// Im(a* b).
template <class Arithmetic, class Number>
QTRAJ_INLINE void relative_vector_part(const Number (&a)[4], const Number (&b)[4], Number (&v)[3]) {
  const Number a_vector[3] = {a[1], a[2], a[3]}, b_vector[3] = {b[1], b[2], b[3]};
  Number turned[3];
  cross_product<Arithmetic>(a_vector, b_vector, turned);
  for (size_t k = 0; k < 3; ++k)
    v[k] = Arithmetic::multiply_add(a[0], b_vector[k], Arithmetic::multiply_add(-b[0], a_vector[k], -turned[k]));
}

// q v q*: a body vector in the world frame.
template <class Arithmetic, class Number>
QTRAJ_INLINE void rotate_to_world(const Number (&q)[4], Number (&v)[3]) {
  const Number u[3] = {q[1], q[2], q[3]};
  Number once[3], twice[3];
  cross_product<Arithmetic>(u, v, once);
  for (Number& component : once) component = component + component;
  cross_product<Arithmetic>(u, once, twice);
  for (size_t k = 0; k < 3; ++k) v[k] = v[k] + Arithmetic::multiply_add(q[0], once[k], twice[k]);
}

// The first and the second derivative of a polynomial with vector coefficients, at x.
template <class Arithmetic, class Number, size_t Terms, size_t Size>
QTRAJ_INLINE void first_derivative(const Number (&c)[Terms][Size], Number x, Number (&first)[Size]) {
  Number slopes[Terms - 1][Size];
  for (size_t term = 1; term < Terms; ++term)
    for (size_t k = 0; k < Size; ++k) slopes[term - 1][k] = Number(static_cast<Element<Number>>(term)) * c[term][k];
  horner<Arithmetic>(slopes, x, first);
}
template <class Arithmetic, class Number, size_t Terms, size_t Size>
QTRAJ_INLINE void second_derivative(const Number (&c)[Terms][Size], Number x, Number (&second)[Size]) {
  using Real = Element<Number>;
  if constexpr (Terms == 2) {
    for (Number& component : second) component = Number(Real(0));
  } else {
    Number slopes[Terms - 2][Size];
    for (size_t term = 2; term < Terms; ++term)
      for (size_t k = 0; k < Size; ++k) slopes[term - 2][k] = Number(static_cast<Real>(term * (term - 1))) * c[term][k];
    horner<Arithmetic>(slopes, x, second);
  }
}

}  // namespace
}  // namespace qtraj
