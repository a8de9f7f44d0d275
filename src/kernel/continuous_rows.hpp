// Keys made continuous in sign, many at once: a key is flipped where the number of opposed neighbours up to it is odd.
#pragma once

#include "array_rows.hpp"

namespace qtraj {
namespace {

// Rows `row` - 1, done and written, and `row`, `row` + 1, ..., as they are given; false where one is not ordinary.
template <class Real, class Number>
QTRAJ_INLINE bool load_neighbours(const KeyArrays& arrays, size_t row, Number (&previous)[4], Number (&q)[4]) {
  if (!load_rows<Real>({arrays.q, false}, row, q)) return false;
  double window[kLanesOf<Number>][4], before[4];
  if (!load_rows<Real>({arrays.q_out, false}, row - 1, before)) return false;
  std::memcpy(window[0], before, sizeof before);
  double given[4];
  for (size_t lane = 1; lane < kLanesOf<Number>; ++lane) {
    convert_rows(static_cast<const Real*>(arrays.q), row + lane - 1, given);
    std::memcpy(window[lane], given, sizeof given);
  }
  convert_rows(window[0], 0, previous);
  return true;
}

// Bit i: whether an odd number of the bits 0 .. i is set.
inline unsigned parities(unsigned bits) {
  for (unsigned shift = 1; shift < 8 * sizeof bits; shift *= 2) bits ^= bits << shift;
  return bits;
}

template <class Real, class Number>
QTRAJ_INLINE bool continue_rows(const KeyArrays& arrays, size_t row, size_t& flips) {
  Number previous[4], q[4];
  if (!load_neighbours<Real>(arrays, row, previous, q)) return false;
  // the rounding of a dot product is below 4 eps of the lengths: its sign is that of the exact one
  const Number cosine = dot<Plain>(previous, q), zero(0.0);
  const Number least = Number(0x1p-80) * dot<Plain>(previous, previous) * dot<Plain>(q, q);
  if (!all(least < cosine * cosine)) return false;

  const unsigned flipped = parities(lane_bits(cosine < zero)) & ((1u << kLanesOf<Number>)-1);
  const auto is_flipped = lanes_of(flipped, Number());
  for (Number& component : q) component = select(is_flipped, -component, component);
  flips += static_cast<size_t>(__builtin_popcount(flipped));
  store_rows(q, static_cast<Real*>(arrays.q_out), row);
  return true;
}

template <class Vector>
size_t make_continuous(const KeyArrays& arrays, size_t first, size_t count, size_t& flips) {
  return do_rows<Vector>(arrays.single, first, count, [&](size_t row, auto number, auto real) {
    return continue_rows<decltype(real), decltype(number)>(arrays, row, flips);
  });
}

}  // namespace
}  // namespace qtraj
