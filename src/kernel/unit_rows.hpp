// Normalisation and rotation row by row. Plain arithmetic: the same bits in the core and in kernels of either
// arithmetic.
#pragma once

#include "array_rows.hpp"
#include "motion.hpp"
#include "unit_quaternion.hpp"

namespace qtraj {
namespace {

template <class Real, class Number>
QTRAJ_INLINE bool normalize_rows(const KeyArrays& arrays, size_t row) {
  Number a[4];
  if (!load_rows<Real>({arrays.q, false}, row, a)) return false;
  store_rows(unit_of(a).value, static_cast<Real*>(arrays.q_out), row);
  return true;
}
template <class Vector>
size_t normalize(const KeyArrays& arrays, size_t first, size_t count) {
  return do_rows<Vector>(arrays.single, first, count, [&](size_t row, auto number, auto real) {
    return normalize_rows<decltype(real), decltype(number)>(arrays, row);
  });
}

template <class Real, class Number>
QTRAJ_INLINE bool rotate_rows(const RotateArrays& arrays, size_t row) {
  Number a[4], v[3];
  if (!load_rows<Real>(arrays.q, row, a) || !load_rows<Real>(arrays.v, row, v)) return false;
  rotate_to_world<Plain>(unit_of(a).value, v);
  store_rows(v, static_cast<Real*>(arrays.v_world), row);
  return true;
}
template <class Vector>
size_t rotate(const RotateArrays& arrays, size_t first, size_t count) {
  return do_rows<Vector>(arrays.single, first, count, [&](size_t row, auto number, auto real) {
    return rotate_rows<decltype(real), decltype(number)>(arrays, row);
  });
}

}  // namespace
}  // namespace qtraj
