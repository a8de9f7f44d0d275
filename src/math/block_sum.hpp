// Long sums good to a few eps, whatever the number of terms: kernels add to them (rows/sums.hpp), means read them.
// Kernels include this header: it uses no type of Eigen.
#pragma once

#include <cstddef>

#include "math/error_free.hpp"

namespace qtraj {

// The order of summation: row i is added to lane i % kSumLanes, in blocks of kBlockRows rows. It does not depend on the
// width of the target's vectors, so that sums are the same bits everywhere.
constexpr size_t kSumLanes = 8, kBlockRows = 128;

// The 16 terms of a lane in a block are summed plainly, blocks and lanes with compensation (A. Neumaier, ZAMM 54
// (1974), 39). Error below 8 eps of the sum of the terms' absolute values for fewer than 2^50 terms; of a million
// random terms below 0.6 eps.
template <size_t Size>
struct BlockSum {
  double totals[Size][kSumLanes] = {}, errors[Size][kSumLanes] = {};
  double open[Size][kSumLanes] = {};  // of the block whose rows are being added, all 0 between blocks

  double value(size_t term) const {
    double total = totals[term][0], error = errors[term][0];
    for (size_t lane = 1; lane < kSumLanes; ++lane) {
      const DoubleDouble sum = two_sum(total, totals[term][lane]);
      total = sum.value;
      error += sum.error + errors[term][lane];
    }
    return total + error;
  }
};

}  // namespace qtraj
