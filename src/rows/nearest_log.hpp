// The log from one orientation to the nearer of q and -q. It is in steps, because sums over samples do each step for a
// tile of rows (logs.hpp). means/log_moments.hpp states what it promises.
#pragma once

#include "math/unit_quaternion.hpp"
#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

// conj(base) q, base unit. d: the angle between the base and +-q on S^3, rad.
template <class Number>
struct RelativeOf {
  Number q[4];
  Number sine_squared;  // |q|^2 sin^2 d, the square of the vector part
  Number inverse;       // +-1/|q|, with the sign that takes q to the nearer of both: inverse q0 = cos d
};

// conj(a) b
template <class Arithmetic, class Number>
QTRAJ_INLINE void conjugate_product(const Number (&a)[4], const Number (&b)[4], Number (&product)[4]) {
  const auto sum = [&](Number b0, Number b1, Number b2, Number b3) {
    const Number component[4] = {b0, b1, b2, b3};
    return dot_product<Arithmetic>(component, a);
  };
  product[0] = sum(b[0], b[1], b[2], b[3]);
  product[1] = sum(b[1], -b[0], -b[3], b[2]);
  product[2] = sum(b[2], b[3], -b[0], -b[1]);
  product[3] = sum(b[3], -b[2], b[1], -b[0]);
}

// The first component that is not 0.
template <class Number>
QTRAJ_INLINE Number first_nonzero(const Number (&q)[4]) {
  Number first = q[0];
  for (size_t k = 1; k < 4; ++k) first = select(first != Number(0.0), first, q[k]);
  return first;
}

// False, with `to` unusable, where a q is not ordinary. The caller has already excluded those with a component of
// magnitude 2 or more (reaches_two), whose squares might overflow.
template <class Arithmetic, class Number>
QTRAJ_INLINE bool relate(const Number (&base)[4], const Number (&q)[4], RelativeOf<Number>& to) {
  const Number one(1.0);
  conjugate_product<Arithmetic>(base, q, to.q);
  const Number vector[3] = {to.q[1], to.q[2], to.q[3]};
  to.sine_squared = dot_product<Arithmetic>(vector, vector);
  const Number square = Arithmetic::multiply_add(to.q[0], to.q[0], to.sine_squared), excess = square - one;
  const auto is_near = is_near_one(excess);
  Number length_inverse = inverse_root_near_one<Arithmetic>(excess), sign = to.q[0];
  if (!all(is_near & (sign != Number(0.0)))) {
    if (!all(is_ordinary(q))) return false;
    length_inverse = select(is_near, length_inverse, square_root(one / square));
    sign = first_nonzero(to.q);
  }
  to.inverse = with_sign_of(sign, length_inverse);
  return true;
}

// 1 - cos d. AcosRatio of it is d / sin d, without a special case at d = 0; times `inverse` and the vector part that is
// the log.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number versine_of(const RelativeOf<Number>& to) {
  return Arithmetic::multiply_add(-to.q[0], to.inverse, Number(1.0));
}

}  // namespace
}  // namespace qtraj
