// Angles between quaternions, row by row, for kernels with fused multiply-adds: without them the exact products of
// rows/angles.hpp take as long as the core. functions/algebra.hpp states what they promise.
#pragma once

#include "rows/angles.hpp"

namespace qtraj {
namespace {

// The angle that rows ask for, of the point of a* b.
template <class Arithmetic, class Number>
QTRAJ_INLINE Number angle_asked_for(const AngleRows& rows, const PointOf<Number>& point) {
  if (!rows.is_turn) return angle_of<Arithmetic>(point);
  const auto is_back = point.w.value < Number(0.0);
  const DoubleDoubleOf<Number> w = {select(is_back, -point.w.value, point.w.value),
                                    select(is_back, -point.w.error, point.w.error)};
  return Number(2.0) * angle_of<Arithmetic>(PointOf<Number>{w, point.sine});
}

// What one loop over a tile leaves for the next, one vector after the other: short loops overlap the long dependency
// chains of their rows.
template <class Number>
struct PointTile {
  static constexpr size_t kVectors = 4;
  Number w[kVectors], w_error[kVectors], sine[kVectors], residual[kVectors];
};

// Does one tile of up to `vectors` vectors of rows from `row` on, and tells how many.
template <class Arithmetic, class Number>
QTRAJ_INLINE size_t angle_tile(const AngleRows& rows, size_t row, size_t vectors) {
  using Real = Element<Number>;
  constexpr size_t kLanes = kLanesOf<Number>;
  PointTile<Number> tile;
  size_t done = 0;
  for (; done < vectors; ++done) {
    Number a[4], b[4];
    PointOf<Number> point;
    const size_t at = row + done * kLanes;
    if (!load_rows<Real>(rows.a, at, a) || !load_rows<Real>(rows.b, at, b) || !find_point<Arithmetic>(a, b, point))
      break;
    tile.w[done] = point.w.value, tile.w_error[done] = point.w.error;
    tile.sine[done] = point.sine.value, tile.residual[done] = point.sine.residual;
  }
  for (size_t k = 0; k < done; ++k) {
    const PointOf<Number> point = {{tile.w[k], tile.w_error[k]}, {tile.sine[k], tile.residual[k]}};
    const Number angle[1] = {angle_asked_for<Arithmetic>(rows, point)};
    store_rows(angle, static_cast<Real*>(rows.angle.data), row + k * kLanes);
  }
  return done;
}

// Between quaternions of float, in double, where their products are exact, and rounded: to 0.51 eps of float, besides
// 1e-15 that the sums make of tiny angles. Terms are in the order in which they cancel for a = b and a = -b.
template <class Arithmetic, class Number>
QTRAJ_INLINE bool float_distance_rows(const AngleRows& rows, size_t row) {
  Number a[4], b[4];
  if (!load_rows<float>(rows.a, row, a) || !load_rows<float>(rows.b, row, b)) return false;
  const Number v[3] = {dot_product<Arithmetic>({a[0], -a[1], -a[2], a[3]}, {b[1], b[0], b[3], b[2]}),
                       dot_product<Arithmetic>({a[0], -a[2], a[1], -a[3]}, {b[2], b[0], b[3], b[1]}),
                       dot_product<Arithmetic>({a[0], -a[3], -a[1], a[2]}, {b[3], b[0], b[2], b[1]})};
  const Number sine = square_root(dot_product<Arithmetic>(v, v));
  const Number angle[1] = {angle_of_point<Arithmetic>(sine, dot_product<Arithmetic>(a, b))};
  store_rows(angle, static_cast<float*>(rows.angle.data), row);
  return true;
}

template <class Arithmetic, class Number>
size_t angles(const AngleRows& rows, size_t first, size_t count) {
  if (rows.angle.is_float)
    return do_rows<Number>(first, count,
                           [&](size_t row) { return float_distance_rows<Arithmetic, Number>(rows, row); });
  if constexpr (!kIsFused<Arithmetic>) return 0;
  constexpr size_t kLanes = kLanesOf<Number>, kMost = PointTile<Number>::kVectors;
  size_t row = first;
  while (count - row >= kLanes) {
    const size_t left = (count - row) / kLanes, vectors = left < kMost ? left : kMost;
    const size_t done = angle_tile<Arithmetic, Number>(rows, row, vectors);
    row += done * kLanes;
    if (done < vectors) break;
  }
  return row - first;
}

}  // namespace
}  // namespace qtraj
