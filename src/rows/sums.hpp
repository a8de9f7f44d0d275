// Sums over rows in a fixed order, a vector of rows at once: how blocks are added to a BlockSum (math/block_sum.hpp).
#pragma once

#include "math/block_sum.hpp"
#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

// Adds the open block's sums, lane by lane, to the totals, and the rounding errors of that to the errors.
template <class Vector, size_t Size>
QTRAJ_INLINE void close_block(BlockSum<Size>& sums) {
  for (size_t k = 0; k < Size; ++k)
    for (size_t lane = 0; lane < kSumLanes; lane += kLanesOf<Vector>) {
      double *total = &sums.totals[k][lane], *error = &sums.errors[k][lane], *open = &sums.open[k][lane];
      const DoubleDoubleOf<Vector> sum = two_sum(load_lanes(total, Vector()), load_lanes(open, Vector()));
      store_lanes(sum.value, total);
      store_lanes(load_lanes(error, Vector()) + sum.error, error);
      store_lanes(Vector(0.0), open);
    }
}
// Leaves the sums as they were before the block.
template <size_t Size>
QTRAJ_INLINE bool discard_block(BlockSum<Size>& sums) {
  for (auto& lanes : sums.open)
    for (double& lane : lanes) lane = 0;
  return false;
}

// Adds left[k] right[k] to each sum. Callers list the factors: an array of vectors that nested loops index would be
// spilled to the stack.
template <class Arithmetic, class Vector, size_t Size>
QTRAJ_INLINE void add_products(const Vector (&left)[Size], const Vector (&right)[Size], Vector (&sum)[Size]) {
  each_of<Size>([&](size_t k) { sum[k] = Arithmetic::multiply_add(left[k], right[k], sum[k]); });
}

// Adds `rows` rows, a multiple of kSumLanes, to the open block. add_terms(row, sum) adds the terms of one row per lane
// of a Vector from that row on. False where it is false: the block is then to be discarded.
template <class Vector, size_t Size, class AddTerms>
QTRAJ_INLINE bool add_rows(size_t rows, const AddTerms& add_terms, BlockSum<Size>& sums) {
  static_assert(kSumLanes % kLanesOf<Vector> == 0, "lanes of a sum in whole vectors");
  for (size_t lane = 0; lane < kSumLanes; lane += kLanesOf<Vector>) {
    Vector sum[Size];
    each_of<Size>([&](size_t k) { sum[k] = load_lanes(&sums.open[k][lane], Vector()); });
    for (size_t row = lane; row < rows; row += kSumLanes)
      if (!add_terms(row, sum)) return false;
    each_of<Size>([&](size_t k) { store_lanes(sum[k], &sums.open[k][lane]); });
  }
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
