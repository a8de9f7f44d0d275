// Products of quaternions, row by row. Rows of float are computed with in float.
#pragma once

#include "math/half_angle.hpp"
#include "rows/row_loop.hpp"
#include "simd/prefetch.hpp"

namespace qtraj {
namespace {

template <class Arithmetic, class Number>
QTRAJ_INLINE bool multiply_rows(const BinaryRows<4, 4, 4>& rows, size_t row, size_t count) {
  using Real = Element<Number>;
  Real* const out = static_cast<Real*>(rows.out.data);
  Number a[4], b[4], product[4];
  prefetch_output<Real, 4, kLanesOf<Number>>(out, row, count);
  if (!load_rows<Real>(rows.a, row, a) || !load_rows<Real>(rows.b, row, b)) return false;
  hamilton_product<Arithmetic>(a, b, product);
  store_rows(product, out, row);
  return true;
}

template <class Arithmetic, class Number, class FloatNumber>
size_t multiply(const BinaryRows<4, 4, 4>& rows, size_t first, size_t count) {
  const auto multiply_in = [&](auto number) {
    using In = decltype(number);
    return do_rows<In>(first, count, [&](size_t row) { return multiply_rows<Arithmetic, In>(rows, row, count); });
  };
  return rows.out.is_float ? multiply_in(FloatNumber()) : multiply_in(Number());
}

}  // namespace
}  // namespace qtraj
