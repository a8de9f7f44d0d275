// The input of a mean: a caller's orientations and weights, checked once, then read in place by every pass.
#pragma once

#include "functions/for_each_row.hpp"
#include "math/block_sum.hpp"
#include "rows/arguments.hpp"

namespace qtraj {

// q / |q| for finite q != 0 of any magnitude, each component within 2 eps of its size.
Quaternion unit(const Quaternion& q);

// A block of samples copied one by one: for sums over samples that kernels cannot read from the caller's arrays.
class SampleBlock {
 public:
  bool is_full() const { return count_ == kBlockRows; }

  // Adds a sample: finite q != 0 of any magnitude, weight above 0.
  void add(const Quaternion& q, double weight);

  // The samples as arrays whose rows fill the lanes of a sum; the padding rows have weight 0.
  SampleRows padded();

  void clear() { count_ = 0; }

 private:
  double q_[kBlockRows][4], weights_[kBlockRows];  // left uninitialised: only rows that were written are read
  size_t count_ = 0;
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
    const SampleRows rows = {q, weights, weight_scale, false};
    size_t sample = 0;
    for (;;) {
      sample += add(rows, sample, count);
      if (sample == count) return true;
      SampleBlock block;
      while (sample < count && !block.is_full())
        if (!take(sample++, block)) return false;
      const SampleRows padded = block.padded();
      add(padded, size_t{0}, padded.q.rows);
    }
  }

 private:
  // Adds a sample, if it counts, to a block; false where it is at fault.
  bool take(size_t sample, SampleBlock& block) const;
};

}  // namespace qtraj
