// The log from one orientation to the nearer of q and -q. Plain arithmetic: the same bits in the core and in kernels of
// either arithmetic. What it promises is in qtraj/log_moments.hpp.
#pragma once

#include "near_one.hpp"

namespace qtraj {
namespace {

// d: the angle between them on S^3, rad.
template <class Number>
struct NearestLogOf {
  Number log[3], angle, cosine, sine;  // as in NearestLog
  Number vector[3];                    // along the log or against it, of any length
  Number inverse;                      // of the vector's square; 1 where that may be 0
  Number across;                       // d cot d
};

// Whether the first component that is not 0 is negative.
template <class Number>
QTRAJ_INLINE auto is_first_negative(const Number (&q)[4]) {
  const Number zero(0.0);
  Number first = q[0];
  // most often there is nothing to select
  for (size_t k = 1; k < 4 && !all((first < zero) | (zero < first)); ++k)
    first = select((first < zero) | (zero < first), first, q[k]);
  return first < zero;
}

// Base unit; q of ordinary size. d/sin d is a polynomial in 1 - cos d and needs no case of its own where d is 0: the
// log is (d/sin d) v, v the vector part of conj(base) q / |q|.
template <class Number>
QTRAJ_INLINE NearestLogOf<Number> nearest_log_of(const Number (&base)[4], const Number (&q)[4]) {
  const Number zero(0.0), one(1.0), w = base[0], x = base[1], y = base[2], z = base[3];
  const Number relative[4] = {w * q[0] + x * q[1] + y * q[2] + z * q[3], w * q[1] - x * q[0] - y * q[3] + z * q[2],
                              w * q[2] + x * q[3] - y * q[0] - z * q[1], w * q[3] - x * q[2] + y * q[1] - z * q[0]};
  NearestLogOf<Number> at;
  for (size_t k = 0; k < 3; ++k) at.vector[k] = relative[k + 1];
  const Number square = dot<Plain>(at.vector, at.vector), square_of_q = relative[0] * relative[0] + square;

  at.inverse = one / select(Number(0x1p-700) < square, square, one);
  const Number excess = square_of_q - one;
  const auto is_near = is_near_one(excess);
  Number inverse_of_q = inverse_near_one<Plain>(excess), scale = inverse_root_near_one<Plain>(excess);
  if (!all(is_near)) {
    inverse_of_q = select(is_near, inverse_of_q, one / square_of_q);
    scale = select(is_near, scale, square_root(inverse_of_q));
  }
  at.cosine = select(relative[0] < zero, -relative[0], relative[0]) * scale;
  at.sine = square_root(square * inverse_of_q);

  const Number ratio = evaluate<Plain, AcosRatio>(one - at.cosine), factor = ratio * scale;
  const Number toward = select(is_first_negative(relative), -factor, factor);
  for (size_t k = 0; k < 3; ++k) at.log[k] = toward * at.vector[k];
  at.angle = ratio * at.sine;
  at.across = ratio * at.cosine;
  return at;
}

}  // namespace
}  // namespace qtraj
