// Sums over rows in a fixed order, a vector of rows at once: how blocks are added to a BlockSum (math/block_sum.hpp).
#pragma once

#include "math/block_sum.hpp"
#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

// Adds a block's sums, lane by lane, to the totals, and the rounding errors of that to the errors.
template <class Vector, size_t Size>
QTRAJ_INLINE void close_block(const double (&block)[Size][kSumLanes], BlockSum<Size>& sums) {
  for (size_t k = 0; k < Size; ++k)
    for (size_t lane = 0; lane < kSumLanes; lane += kLanesOf<Vector>) {
      double *total = &sums.totals[k][lane], *error = &sums.errors[k][lane];
      const DoubleDoubleOf<Vector> sum = two_sum(load_lanes(total, Vector()), load_lanes(&block[k][lane], Vector()));
      store_lanes(sum.value, total);
      store_lanes(load_lanes(error, Vector()) + sum.error, error);
    }
}

// Adds left[k] right[k] to each sum. Callers list the factors: an array of vectors that nested loops index would be
// spilled to the stack.
template <class Arithmetic, class Vector, size_t Size>
QTRAJ_INLINE void add_products(const Vector (&left)[Size], const Vector (&right)[Size], Vector (&sum)[Size]) {
  for (size_t k = 0; k < Size; ++k) sum[k] = Arithmetic::multiply_add(left[k], right[k], sum[k]);
}

// Adds one block of `rows` rows, a multiple of kSumLanes up to kBlockRows. add_terms(row, sum) adds the terms of one
// row per lane of a Vector from that row on. Where it is false, so is the result, and `sums` stay as they were.
template <class Vector, size_t Size, class AddTerms>
QTRAJ_INLINE bool add_block(size_t rows, const AddTerms& add_terms, BlockSum<Size>& sums) {
  static_assert(kSumLanes % kLanesOf<Vector> == 0, "lanes of a sum in whole vectors");
  double block[Size][kSumLanes];
  for (size_t lane = 0; lane < kSumLanes; lane += kLanesOf<Vector>) {
    Vector sum[Size];
    for (Vector& term : sum) term = Vector(0.0);
    for (size_t row = lane; row < rows; row += kSumLanes)
      if (!add_terms(row, sum)) return false;
    for (size_t k = 0; k < Size; ++k) store_lanes(sum[k], &block[k][lane]);
  }
  close_block<Vector>(block, sums);
  return true;
}

// Calls block(row, rows) for blocks of rows from `first` on, until it is false or a block's rows are no multiple of
// kSumLanes. Returns how many rows were done.
template <class Block>
size_t do_blocks(size_t first, size_t count, const Block& block) {
  size_t row = first;
  while (row < count) {
    const size_t rows = count - row < kBlockRows ? count - row : kBlockRows;
    if (rows % kSumLanes != 0 || !block(row, rows)) break;
    row += rows;
  }
  return row - first;
}

}  // namespace
}  // namespace qtraj
