// Linear systems of 3 x 3 blocks, tridiagonal or cyclic, in O(count):
//   lower_i x_{i-1} + diagonal_i x_i + upper_i x_{i+1} = right_i, upper_i a number.
//
// A System gives the parts of row i: Matrix3 lower(i), Matrix3 diagonal(i), double upper(i), and
// Vector3 right(i, x) = right_i - lower_i x. Cyclic: count >= 2, x_{-1} is x_{count-1} and x_{count} is x_0.
#pragma once

#include "math/matrix3.hpp"

namespace qtraj {

// Working space of the elimination.
struct BlockSpace {
  double (*x)[3];        // [count], the result of the forward substitution
  double (*inverse)[9];  // [count], inverses of the pivot blocks
  double (*column)[9];   // [count], d x_i / d x_0; cyclic systems only
};

// Factorizes the left sides, without pivoting between rows. False where a pivot block is singular. Tridiagonal: rows
// first ... last - 1 in their own x; terms in other x are not there, or in right.
template <class System>
bool factorize_tridiagonal(size_t first, size_t last, const System& system, const BlockSpace& space);
template <class System>
bool factorize_cyclic(size_t count, const System& system, const BlockSpace& space);

// Solves for the right sides; `space` holds the factorization of the same lower and upper. Calls take(i, x_i) for each
// i in no particular order, after the last call of right. It is called as the x appear, not at the end: back
// substitution is one dependency chain, and the caller's work on each x overlaps with it.
template <class System, class Take>
void solve_tridiagonal(size_t first, size_t last, const System& system, const BlockSpace& space, const Take& take);
template <class System, class Take>
void solve_cyclic(size_t count, const System& system, const BlockSpace& space, const Take& take);

// ---- Implementation ----

namespace block {

template <class System>
bool invert_pivots(size_t first, size_t last, const System& system, const BlockSpace& space) {
  Matrix3 inverse = Matrix3::Zero();
  for (size_t i = first; i < last; ++i) {
    Matrix3 pivot = system.diagonal(i);
    if (i > first) pivot -= system.upper(i - 1) * product(system.lower(i), inverse);
    if (!invert(pivot, inverse)) return false;
    store_matrix(inverse, space.inverse[i]);
  }
  return true;
}

template <class System, class Take>
void substitute(size_t first, size_t last, const System& system, const BlockSpace& space, const Take& take) {
  Vector3 x = Vector3::Zero();
  for (size_t i = first; i < last; ++i) {
    x = product(load_matrix(space.inverse[i]), system.right(i, x));
    store(x, space.x[i]);
  }
  take(last - 1, x);
  for (size_t i = last - 1; i-- > first;) {
    x = load(space.x[i]) - system.upper(i) * product(load_matrix(space.inverse[i]), x);
    take(i, x);
  }
}

}  // namespace block

template <class System>
bool factorize_tridiagonal(size_t first, size_t last, const System& system, const BlockSpace& space) {
  return block::invert_pivots(first, last, system, space);
}

template <class System, class Take>
void solve_tridiagonal(size_t first, size_t last, const System& system, const BlockSpace& space, const Take& take) {
  block::substitute(first, last, system, space, take);
}

template <class System>
bool factorize_cyclic(size_t count, const System& system, const BlockSpace& space) {
  if (!block::invert_pivots(1, count, system, space)) return false;
  // rows 1, 2, ... give x_i = x_i' + column_i x_0, x' being their solution for x_0 = 0; row 0 then gives x_0
  Matrix3 column = Matrix3::Identity();
  for (size_t i = 1; i < count; ++i) {
    column = -product(load_matrix(space.inverse[i]), product(system.lower(i), column));
    store_matrix(column, space.column[i]);
  }
  const size_t last = count - 1;
  Matrix3 next = Matrix3::Identity();
  for (size_t i = last; i > 0; --i) {
    next = load_matrix(space.column[i]) - system.upper(i) * product(load_matrix(space.inverse[i]), next);
    store_matrix(next, space.column[i]);
  }
  const Matrix3 pivot =
      system.diagonal(0) + product(system.lower(0), load_matrix(space.column[last])) + system.upper(0) * next;
  Matrix3 inverse;
  if (!invert(pivot, inverse)) return false;
  store_matrix(inverse, space.inverse[0]);
  return true;
}

template <class System, class Take>
void solve_cyclic(size_t count, const System& system, const BlockSpace& space, const Take& take) {
  block::substitute(1, count, system, space, [&](size_t i, const Vector3& x) { store(x, space.x[i]); });
  const Vector3 right = system.right(0, load(space.x[count - 1])) - system.upper(0) * load(space.x[1]);
  const Vector3 x0 = product(load_matrix(space.inverse[0]), right);
  take(0, x0);
  for (size_t i = 1; i < count; ++i) take(i, Vector3(load(space.x[i]) + product(load_matrix(space.column[i]), x0)));
}

}  // namespace qtraj
