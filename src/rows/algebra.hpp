// Products, conjugates, inverses and norms of quaternions, row by row. Rows of float are computed with in float.
//
// Which rows are ordinary is found more cheaply than by is_ordinary where a result tells that they were large enough.
// Rows without a component of magnitude 2 or more, or NaN (reaches_two), can be computed with, and a number made of
// them that is_large, 2^-511 or more (in float 2^-63), has lost nothing to products that underflow.
#pragma once

#include "math/half_angle.hpp"
#include "math/unit_quaternion.hpp"
#include "math/vector_algebra.hpp"
#include "rows/row_loop.hpp"
#include "simd/prefetch.hpp"

namespace qtraj {
namespace {

// Whether rows can be computed with.
template <class Number>
QTRAJ_INLINE bool are_moderate(const Number (&a)[4]) {
  return !any(reaches_two(a)) || all(is_ordinary(a));
}
template <class Number>
QTRAJ_INLINE bool are_moderate(const Number (&a)[4], const Number (&b)[4]) {
  const Number both[] = {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]};
  return !any(reaches_two(both)) || (all(is_ordinary(a)) && all(is_ordinary(b)));
}

// ---- Of two quaternions ----

template <class Arithmetic, class Number>
QTRAJ_INLINE bool multiply_rows(const BinaryRows<4, 4, 4>& rows, size_t row, size_t count) {
  using Real = Element<Number>;
  Real* const out = static_cast<Real*>(rows.out.data);
  Number a[4], b[4], product[4];
  prefetch_output<Real, 4, kLanesOf<Number>>(out, row, count);
  read_numbers<Real>(rows.a, row, a);
  read_numbers<Real>(rows.b, row, b);
  if (!are_moderate(a, b)) return false;
  hamilton_product<Arithmetic>(a, b, product);
  // its length is |a| |b|, and one component at least half of that
  if (!all(is_large(product))) return false;
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

// Numbers in their order in memory, as many vectors as a row has numbers: one row, or one per lane.
template <class Number>
QTRAJ_INLINE void load_in_place(const double* from, size_t row, Number (&to)[4]) {
  for (size_t k = 0; k < 4; ++k) to[k] = load_lanes(from + 4 * row + k * kLanesOf<Number>, Number());
}
template <class Number>
QTRAJ_INLINE void store_in_place(const Number (&from)[4], double* to, size_t row) {
  for (size_t k = 0; k < 4; ++k) store_lanes(from[k], to + 4 * row + k * kLanesOf<Number>);
}

// Rows of a quaternion array where they lie, or as many copies of its only row as there are lanes.
template <class Number>
class RowsInPlace {
 public:
  explicit RowsInPlace(const Input<4>& array)
      : rows_(static_cast<const double*>(array.data)), is_repeated_(is_repeated(array)) {
    if (!is_repeated_) return;
    for (size_t lane = 0; lane < kLanesOf<Number>; ++lane) std::memcpy(copies_[lane], rows_, sizeof copies_[lane]);
    rows_ = copies_[0];
  }
  RowsInPlace(const RowsInPlace&) = delete;
  RowsInPlace& operator=(const RowsInPlace&) = delete;

  QTRAJ_INLINE void load(size_t row, Number (&to)[4]) const { load_in_place(rows_, is_repeated_ ? 0 : row, to); }
  QTRAJ_INLINE bool are_ordinary(size_t row) const {
    Number q[4];
    convert_rows(rows_, is_repeated_ ? 0 : row, q);
    return all(is_ordinary(q));
  }

 private:
  const double* rows_;
  bool is_repeated_;
  double copies_[kLanesOf<Number>][4];
};

// The products are made where the numbers lie, and only they are brought into one vector per component. A product is
// rounded three times on its way into the sum: within 1.5 eps of sum |a_i b_i|, which is at most |a| |b|. The same bits
// in either arithmetic.
template <class Number>
size_t dot(const BinaryRows<4, 4, 1>& rows, size_t first, size_t count) {
  double* const out = static_cast<double*>(rows.out.data);
  const RowsInPlace<Number> a_rows(rows.a), b_rows(rows.b);
  const auto are_ordinary = [&](size_t row) { return a_rows.are_ordinary(row) && b_rows.are_ordinary(row); };
  return do_rows<Number>(first, count, [&](size_t row) {
    Number a[4], b[4], products[4];
    prefetch_output<double, 1, kLanesOf<Number>>(out, row, count);
    a_rows.load(row, a);
    b_rows.load(row, b);
    const Number both[] = {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]};
    if (any(reaches_two(both)) && !are_ordinary(row)) return false;
    double in_place[kLanesOf<Number>][4];
    for (size_t k = 0; k < 4; ++k) products[k] = a[k] * b[k];
    store_in_place(products, in_place[0], 0);
    convert_rows(in_place[0], 0, products);
    const Number sum[] = {(products[0] + products[1]) + (products[2] + products[3])};
    // a small one may be of long quaternions at a right angle
    if (!all(is_large(sum)) && !are_ordinary(row)) return false;
    store_rows(sum, out, row);
    return true;
  });
}

// ---- Of one quaternion ----

template <class Number>
size_t conjugate(const UnaryRows<4, 4>& rows, size_t first, size_t count) {
  // of each row from its first number, or, with vectors of two, half of it
  alignas(64) static constexpr double kSigns[] = {0.0, -0.0, -0.0, -0.0, 0.0, -0.0, -0.0, -0.0};
  const double* const in = static_cast<const double*>(rows.in.data);
  double* const out = static_cast<double*>(rows.out.data);
  return do_rows<Number>(first, count, [&](size_t row) {
    Number q[4];
    prefetch_output<double, 4, kLanesOf<Number>>(out, row, count);
    load_in_place(in, row, q);
    if (any(reaches_two(q)))
      for (size_t k = 0; k < 4; ++k)
        if (!all(is_finite(q[k]))) return false;
    for (size_t k = 0; k < 4; ++k) q[k] = flip_signs(q[k], load_lanes(kSigns + k * kLanesOf<Number> % 4, Number()));
    store_in_place(q, out, row);
    return true;
  });
}

// |q|^2, of which the rounding errors are 1.5 eps, relative: three follow each other.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number square_of(const Number (&q)[4]) {
  return Arithmetic::multiply_add(q[1], q[1], q[0] * q[0]) + Arithmetic::multiply_add(q[3], q[3], q[2] * q[2]);
}

// 2/|q|^2 of a large square.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number twice_reciprocal(Number square) {
  const Number two(2.0), excess = square - Number(1.0), near = inverse_near_one<Arithmetic>(excess);
  const auto is_near = is_near_one(excess);
  return all(is_near) ? near + near : select(is_near, near + near, two / square);
}

// v + s (w (u x v) + u x (u x v)), s = 2/|q|^2, of q = (w, u): a quaternion of any length needs no root. In double,
// also of arrays of float.
template <class Arithmetic, class Number>
size_t rotate(const RotateRows& rows, size_t first, size_t count) {
  return do_rows<Number>(rows.v_body.is_float, first, count, [&](size_t row, auto real) {
    using Real = decltype(real);
    Real* const out = static_cast<Real*>(rows.v_world.data);
    Number q[4], v[3], once[3], twice[3];
    prefetch_output<Real, 3, kLanesOf<Number>>(out, row, count);
    if (!load_numbers<Real>(rows.q_wb, row, q) || !are_moderate(q)) return false;
    const Number square[] = {square_of<Arithmetic>(q)};
    if (!all(is_large(square)) || !load_rows<Real>(rows.v_body, row, v)) return false;
    const Number s = twice_reciprocal<Arithmetic>(square[0]), u[] = {q[1], q[2], q[3]};
    cross_product<Arithmetic>(u, v, once);
    cross_product<Arithmetic>(u, once, twice);
    for (size_t k = 0; k < 3; ++k)
      v[k] = Arithmetic::multiply_add(s, Arithmetic::multiply_add(q[0], once[k], twice[k]), v[k]);
    store_rows(v, out, row);
    return true;
  });
}

// 1/|q|^2 has the 1.5 eps of the square and 0.5 of its own, each component 0.5 more: 2.5 eps. Near 1 the series is off
// by eps/32, but there a square below 1 has half the rounding error, and a reciprocal below 1 has.
template <class Arithmetic, class Number>
size_t inverse(const UnaryRows<4, 4>& rows, size_t first, size_t count) {
  double* const out = static_cast<double*>(rows.out.data);
  return do_rows<Number>(first, count, [&](size_t row) {
    const Number one(1.0);
    Number q[4];
    prefetch_output<double, 4, kLanesOf<Number>>(out, row, count);
    convert_rows(static_cast<const double*>(rows.in.data), row, q);
    if (!are_moderate(q)) return false;
    const Number square[] = {square_of<Arithmetic>(q)}, excess = square[0] - one;
    if (!all(is_large(square))) return false;
    Number reciprocal = inverse_near_one<Arithmetic>(excess);
    const auto is_near = is_near_one(excess);
    if (!all(is_near)) reciprocal = select(is_near, reciprocal, one / square[0]);
    const Number opposite = -reciprocal;
    const Number inverted[] = {q[0] * reciprocal, q[1] * opposite, q[2] * opposite, q[3] * opposite};
    store_rows(inverted, out, row);
    return true;
  });
}

// Half of the 1.5 eps of the square, and 0.5 of the root: 1.25 eps, relative. Near 1 the series leaves out
// excess^3/16, below 2^-61.
template <class Arithmetic, class Number>
size_t norm(const UnaryRows<4, 1>& rows, size_t first, size_t count) {
  double* const out = static_cast<double*>(rows.out.data);
  return do_rows<Number>(first, count, [&](size_t row) {
    const Number one(1.0);
    Number q[4];
    prefetch_output<double, 1, kLanesOf<Number>>(out, row, count);
    convert_rows(static_cast<const double*>(rows.in.data), row, q);
    if (!are_moderate(q)) return false;
    const Number square[] = {square_of<Arithmetic>(q)}, excess = square[0] - one;
    if (!all(is_large(square))) return false;
    const Number slope = Arithmetic::multiply_add(Number(-0.125), excess, Number(0.5));
    Number length[] = {Arithmetic::multiply_add(slope, excess, one)};
    const auto is_near = is_near_one(excess);
    if (!all(is_near)) length[0] = select(is_near, length[0], square_root(square[0]));
    store_rows(length, out, row);
    return true;
  });
}

}  // namespace
}  // namespace qtraj
