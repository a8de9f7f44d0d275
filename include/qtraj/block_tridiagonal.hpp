// Linear systems of 3 x 3 blocks, tridiagonal or cyclic, in O(count).
#pragma once

#include "qtraj/matrix3.hpp"

namespace qtraj {

// lower x_{i-1} + diagonal x_i + upper x_{i+1} = right.
struct BlockRow {
  Matrix3 lower, diagonal, upper;
  Vector3 right;
};

// Working space of the elimination and its result.
struct BlockSpace {
  double (*x)[3];       // [count], the solution
  double (*upper)[9];   // [count]
  double (*column)[9];  // [count]; cyclic systems only
};

// Solves for x_0 ... x_{count-1} by elimination without pivoting between rows; `row(i)` gives the rows in order.
// Cyclic: count >= 2, x_{-1} is x_{count-1} and x_{count} is x_0. False where a pivot block is singular.
template <class RowOf>
bool solve_tridiagonal(size_t count, const RowOf& row, const BlockSpace& space);
template <class RowOf>
bool solve_cyclic(size_t count, const RowOf& row, const BlockSpace& space);

// ---- Implementation ----

namespace block {

inline Matrix3 load(const double (&from)[9]) { return Matrix3(from); }
inline void store(const Matrix3& from, double (&to)[9]) {
  for (int k = 0; k < 9; ++k) to[k] = from.data()[k];
}

// Eliminates row i with the row before; gives the inverse of its pivot block.
inline bool eliminate(const BlockRow& row, size_t i, bool first, const BlockSpace& space, Matrix3& inverse) {
  const Matrix3 pivot = first ? row.diagonal : Matrix3(row.diagonal - product(row.lower, load(space.upper[i - 1])));
  if (!invert(pivot, inverse)) return false;
  store(product(inverse, row.upper), space.upper[i]);
  const Vector3 carried = first ? Vector3::Zero() : product(row.lower, qtraj::load(space.x[i - 1]));
  qtraj::store(product(inverse, Vector3(row.right - carried)), space.x[i]);
  return true;
}

inline void substitute_back(size_t i, const BlockSpace& space) {
  const Vector3 next = product(load(space.upper[i]), qtraj::load(space.x[i + 1]));
  qtraj::store(Vector3(qtraj::load(space.x[i]) - next), space.x[i]);
}

}  // namespace block

template <class RowOf>
bool solve_tridiagonal(size_t count, const RowOf& row, const BlockSpace& space) {
  Matrix3 inverse;
  for (size_t i = 0; i < count; ++i)
    if (!block::eliminate(row(i), i, i == 0, space, inverse)) return false;
  for (size_t i = count - 1; i-- > 0;) block::substitute_back(i, space);
  return true;
}

template <class RowOf>
bool solve_cyclic(size_t count, const RowOf& row, const BlockSpace& space) {
  // x_i = space.x_i + column_i x_0 for i >= 1; the row of x_0 then gives x_0
  Matrix3 inverse;
  for (size_t i = 1; i < count; ++i) {
    const BlockRow at = row(i);
    if (!block::eliminate(at, i, i == 1, space, inverse)) return false;
    const Matrix3 before = i == 1 ? Matrix3::Identity() : block::load(space.column[i - 1]);
    block::store(product(inverse, product(at.lower, Matrix3(-before))), space.column[i]);
  }
  const size_t last = count - 1;
  block::store(block::load(space.column[last]) - block::load(space.upper[last]), space.column[last]);
  for (size_t i = last; i-- > 1;) {
    block::substitute_back(i, space);
    const Matrix3 next = product(block::load(space.upper[i]), block::load(space.column[i + 1]));
    block::store(block::load(space.column[i]) - next, space.column[i]);
  }
  const BlockRow seam = row(0);
  const Matrix3 pivot = seam.diagonal + product(seam.lower, block::load(space.column[last])) +
                        product(seam.upper, block::load(space.column[1]));
  if (!invert(pivot, inverse)) return false;
  const Vector3 right = seam.right - product(seam.lower, load(space.x[last])) - product(seam.upper, load(space.x[1]));
  const Vector3 x0 = product(inverse, right);
  store(x0, space.x[0]);
  for (size_t i = 1; i < count; ++i)
    store(Vector3(load(space.x[i]) + product(block::load(space.column[i]), x0)), space.x[i]);
  return true;
}

}  // namespace qtraj
