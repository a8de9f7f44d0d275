// Rotation matrices, row-major, from quaternions and back, row by row, from arrays of double or float. Computed with in
// double.
#pragma once

#include "math/vector_algebra.hpp"
#include "rows/algebra.hpp"

namespace qtraj {
namespace {

// ---- Rows of nine ----

QTRAJ_INLINE void store_nine(const double (&m)[9], double* to) { store_rows(m, to, 0); }
template <class Number>
QTRAJ_INLINE void store_nine(const Number (&m)[9], double* to) {
  constexpr size_t kLanes = kLanesOf<Number>;
  const Number first[] = {m[0], m[1], m[2], m[3]}, second[] = {m[4], m[5], m[6], m[7]};
  store_rows_apart(first, to, 9);
  store_rows_apart(second, to + 4, 9);
  double last[kLanes];
  store_lanes(m[8], last);
  for (size_t lane = 0; lane < kLanes; ++lane) to[9 * lane + 8] = last[lane];
}
template <class Number>
QTRAJ_INLINE void store_nine(const Number (&m)[9], float* to) {
  constexpr size_t kLanes = kLanesOf<Number>;
  double rows[9 * kLanes];
  store_nine(m, rows);
  for (size_t k = 0; k < 9; ++k) {
    const Number numbers[] = {load_lanes(rows + k * kLanes, Number())};
    store_rows(numbers, to + k * kLanes, 0);
  }
}

template <class Number>
QTRAJ_INLINE bool load_nine(const double* from, Number (&m)[9]) {
  const double* rows[kLanesOf<Number>];
  for (size_t lane = 0; lane < kLanesOf<Number>; ++lane) rows[lane] = from + 9 * lane;
  load_records(rows, m);
  return true;
}
template <class Number>
QTRAJ_INLINE bool load_nine(const float* from, Number (&m)[9]) {
  if (!can_convert(from, 0, m)) return false;
  double rows[9 * kLanesOf<Number>];
  for (size_t k = 0; k < 9; ++k) {
    Number numbers[1];
    convert_rows(from, k * kLanesOf<Number>, numbers);
    store_lanes(numbers[0], rows + k * kLanesOf<Number>);
  }
  return load_nine(rows, m);
}

// ---- From quaternions ----

// ((w^2 - |u|^2) I + 2 u u^T + 2 w [u]) / |q|^2 of q = (w, u). The diagonal is a difference of two sums of two squares:
// of 1 - 2 (y^2 + z^2)/|q|^2 an error of |q|^2 would count twice where that is near -1.
template <class Arithmetic, class Number>
QTRAJ_INLINE void matrix_of(const Number (&q)[4], Number twice_reciprocal, Number (&m)[9]) {
  const Number w = q[0], x = q[1], y = q[2], z = q[3], xx = x * x, zz = z * z;
  const Number sx = twice_reciprocal * x, sy = twice_reciprocal * y, sz = twice_reciprocal * z;
  const Number wx = w * sx, wy = w * sy, wz = w * sz, half = Number(0.5) * twice_reciprocal;
  const auto add = [](Number a, Number b, Number sum) { return Arithmetic::multiply_add(a, b, sum); };
  m[0] = half * (add(w, w, xx) - add(y, y, zz)), m[1] = add(x, sy, -wz), m[2] = add(x, sz, wy);
  m[3] = add(x, sy, wz), m[4] = half * (add(w, w, y * y) - add(x, x, zz)), m[5] = add(y, sz, -wx);
  m[6] = add(x, sz, -wy), m[7] = add(y, sz, wx), m[8] = half * (add(w, w, zz) - add(y, y, xx));
}

template <class Arithmetic, class Number>
size_t matrix_from_q(const UnaryRows<4, 9>& rows, size_t first, size_t count) {
  return do_rows<Number>(rows.in.is_float, first, count, [&](size_t row, auto real) {
    using Real = decltype(real);
    Real* const out = static_cast<Real*>(rows.out.data);
    Number q[4], m[9];
    prefetch_output<Real, 9, kLanesOf<Number>>(out, row, count);
    if (!load_own_numbers<Real>(rows.in, row, q) || !are_moderate(q)) return false;
    const Number square[] = {square_of<Arithmetic>(q)};
    if (!all(is_large(square))) return false;
    matrix_of<Arithmetic>(q, twice_reciprocal<Arithmetic>(square[0]), m);
    store_nine(m, out + 9 * row);
    return true;
  });
}

// ---- From matrices ----

// One step of the Newton-Schulz iteration, M <- M - M (M^T M - I)/2. Returns the sum of squares of M^T M - I before it.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number orthogonalize(const Number (&m)[9], Number (&nearer)[9]) {
  const Number half(0.5), one(1.0);
  const auto product = [&](size_t i, size_t j, Number sum) {  // of columns
    return Arithmetic::multiply_add(
        m[6 + i], m[6 + j], Arithmetic::multiply_add(m[3 + i], m[3 + j], Arithmetic::multiply_add(m[i], m[j], sum)));
  };
  const Number minus_one = -one, zero(0.0);
  const Number xx = product(0, 0, minus_one), yy = product(1, 1, minus_one), zz = product(2, 2, minus_one);
  const Number xy = product(0, 1, zero), xz = product(0, 2, zero), yz = product(1, 2, zero);
  const Number off[3][3] = {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
  for (size_t row = 0; row < 9; row += 3)
    for (size_t k = 0; k < 3; ++k) {
      const Number excess = Arithmetic::multiply_add(
          m[row + 2], off[2][k], Arithmetic::multiply_add(m[row + 1], off[1][k], m[row] * off[0][k]));
      nearer[row + k] = m[row + k] - half * excess;
    }
  const Number aside = xy * xy + xz * xz + yz * yz;
  return (xx * xx + yy * yy + zz * zz) + (aside + aside);
}

// A multiple, of either sign, of the quaternion of a rotation, by its largest component
// (functions/rotation_matrix.hpp).
template <class Number>
QTRAJ_INLINE void from_largest(const Number (&m)[9], Number (&q)[4]) {
  const Number one(1.0), trace = m[0] + m[4] + m[8];
  const Number wx = m[7] - m[5], wy = m[2] - m[6], wz = m[3] - m[1];
  const Number xy = m[1] + m[3], xz = m[2] + m[6], yz = m[5] + m[7];
  const Number multiples[4][4] = {{one + trace, wx, wy, wz},
                                  {wx, one + m[0] - m[4] - m[8], xy, xz},
                                  {wy, xy, one + m[4] - m[8] - m[0], yz},
                                  {wz, xz, yz, one + m[8] - m[0] - m[4]}};
  // the squares of the components, but for a common factor and a common constant
  const Number squares[] = {trace, m[0], m[4], m[8]};
  Number largest = squares[0];
  for (size_t k = 0; k < 4; ++k) q[k] = multiples[0][k];
  for (size_t i = 1; i < 4; ++i) {
    const auto is_larger = largest < squares[i];
    largest = select(is_larger, squares[i], largest);
    for (size_t k = 0; k < 4; ++k) q[k] = select(is_larger, multiples[i][k], q[k]);
  }
}

// The rotation nearest to m, and in `done` whether it was found in three steps, as from a distance of up to 1e-3 it is.
// The last step starts from a defect below 1e-9, whose square it leaves.
template <class Arithmetic, class Number>
QTRAJ_INLINE bool find_nearest(const Number (&m)[9], Number (&nearest)[9]) {
  constexpr double kDone = 1e-9;
  constexpr int kSteps = 3;
  auto is_done = orthogonalize<Arithmetic>(m, nearest) <= Number(kDone * kDone);
  for (int step = 1; step < kSteps && !all(is_done); ++step) {
    Number next[9];
    const auto is_last = orthogonalize<Arithmetic>(nearest, next) <= Number(kDone * kDone);
    for (size_t k = 0; k < 9; ++k) nearest[k] = select(is_done, nearest[k], next[k]);
    is_done = is_done | is_last;
  }
  return all(is_done);
}

template <class Arithmetic, class Number>
QTRAJ_INLINE Number determinant(const Number (&m)[9]) {
  const Number a[] = {m[0], m[1], m[2]}, b[] = {m[3], m[4], m[5]}, c[] = {m[6], m[7], m[8]};
  Number normal[3];
  cross_product<Arithmetic>(a, b, normal);
  return dot_product<Arithmetic>(normal, c);
}

// Rows that are not near enough to the limit to leave a doubt are ordinary, if three steps find the rotation.
template <class Arithmetic, class Number>
size_t q_from_matrix(const MatrixRows& rows, size_t first, size_t count) {
  const double surely = 0.999 * rows.limit;
  return do_rows<Number>(rows.matrix.is_float, first, count, [&](size_t row, auto real) {
    using Real = decltype(real);
    const Number zero(0.0);
    Number m[9], nearest[9], q[4];
    if (!load_nine(static_cast<const Real*>(rows.matrix.data) + 9 * row, m)) return false;
    if (any(reaches_two(m)) || !find_nearest<Arithmetic>(m, nearest)) return false;
    Number square = zero;
    for (size_t k = 0; k < 9; ++k) {
      const Number difference = m[k] - nearest[k];
      square = Arithmetic::multiply_add(difference, difference, square);
    }
    if (!all(square <= Number(surely * surely)) || !all(zero < determinant<Arithmetic>(nearest))) return false;
    from_largest(nearest, q);
    UnitOf<Number> unit = unit_of(q);
    const auto is_opposite = unit.value[0] < zero;
    for (Number& component : unit.value) component = select(is_opposite, -component, component);
    store_rows(unit.value, static_cast<Real*>(rows.q.data), row);
    if (!rows.distance.data) return true;
    double distances[kLanesOf<Number>];
    store_lanes(square_root(square), distances);
    for (size_t lane = 0; lane < kLanesOf<Number>; ++lane)
      static_cast<Real*>(rows.distance.data)[row + lane] = static_cast<Real>(distances[lane]);
    return true;
  });
}

}  // namespace
}  // namespace qtraj
