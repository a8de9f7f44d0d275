// The input of a mean: a caller's orientations and weights, checked once, then read in place by every pass.
#pragma once

#include "functions/for_each_row.hpp"
#include "math/block_sum.hpp"
#include "rows/arguments.hpp"

namespace qtraj {

// q / |q| for finite q != 0 of any magnitude, each component within 2 eps of its size.
Quaternion unit(const Quaternion& q);

// Samples copied one by one, a part of a block at a time: for sums over samples that kernels cannot read from the
// caller's arrays.
class SampleBlock {
 public:
  // Whether the block has all its rows.
  bool is_complete() const { return rows_before_ + count_ == kBlockRows; }
  // Whether the part has to be added to the sum before the next sample comes.
  bool is_full() const { return count_ == kRows; }

  // Adds a sample: finite q != 0 of any magnitude, weight above 0.
  void add(const Quaternion& q, double weight);

  // The part as arrays, and the next one begins.
  SampleRows next_part();
  // The last part, whose rows fill the lanes of a sum: the padding rows have weight 0. The next block begins.
  SampleRows last_part();

 private:
  static constexpr size_t kRows = 16;
  static_assert(kBlockRows % kRows == 0 && kRows % kSumLanes == 0);

  double q_[kRows][4], weights_[kRows];  // left uninitialised: only rows that were written are read
  size_t count_ = 0, rows_before_ = 0;   // rows of this part, and of the block's parts before it
};

struct WeightedOrientations {
  Input<4> q;
  Input<1> weights;  // data may be null: all 1
  size_t count;
  // A power of two that scales the largest weight to below 4 and, where it is normal, to at least 1: sums of weights do
  // not overflow, and weights below 1e-308 of the largest become 0.
  double weight_scale = 1;

  // To be called first. False where weights are at fault or all 0.
  bool scale_weights();

  // eps of the caller's type, which decides what is a tie.
  double epsilon() const { return epsilon_of(q); }

  // The first sample at fault. One of weight 0 can be at fault too. Weights that are all 0 are zero_norm, without an
  // index.
  Outcome first_fault() const;

  double weight(size_t sample) const { return weights.data ? weight_scale * number_of(weights, sample) : 1.0; }
  Quaternion unit(size_t sample) const { return qtraj::unit(row_of(q, sample)); }

  // +-mean, the sign such that its dot product with the first sample of weight above 0 is >= 0; where it is 0, with the
  // next.
  Quaternion with_sign_of_first(const Quaternion& mean) const;

  // Sums over all samples of weight above 0, in their order; false where a sample is at fault. add(rows, first, count)
  // is a kernel. Samples that it does not take from the caller's arrays are copied to a SampleBlock. In both ways the
  // k-th sample of weight above 0 goes to the same lane and block, so that sums are the same bits.
  template <class Add>
  bool sum(const Add& add) const {
    const SampleRows rows = {q, weights, weight_scale, false, false};
    size_t sample = 0;
    for (;;) {
      sample += add(rows, sample, count);
      if (sample == count) return true;
      SampleBlock block;
      while (sample < count && !block.is_complete()) {
        if (block.is_full()) add_all(add, block.next_part());
        if (!take(sample++, block)) return false;
      }
      add_all(add, block.last_part());
    }
  }

 private:
  template <class Add>
  static void add_all(const Add& add, const SampleRows& rows) {
    add(rows, size_t{0}, rows.q.rows);
  }
  // Adds a sample, if it counts, to a block; false where it is at fault.
  bool take(size_t sample, SampleBlock& block) const;
};

}  // namespace qtraj
