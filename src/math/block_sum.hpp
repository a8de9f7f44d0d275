// Long sums of vectors to a few eps, whatever their length. Kernels include this header: it names no type of Eigen.
#pragma once

#include <cstddef>

#include "math/error_free.hpp"

namespace qtraj {

// Rows that are summed: row i goes to lane i % kSumLanes, in blocks of kBlockRows rows. In this order whatever vectors
// they are done in, so that sums are the same bits everywhere.
constexpr size_t kSumLanes = 8, kBlockRows = 128;

// Plain sums over the 16 terms of a lane in a block, compensated across the blocks and lanes (A. Neumaier, ZAMM 54
// (1974), 39). Error below 8 eps of the sum of the terms' absolute values for fewer than 2^50 terms; of a million
// random terms below 0.6 eps. rows/sums.hpp adds to it.
template <size_t Size>
struct BlockSum {
  double totals[Size][kSumLanes] = {}, errors[Size][kSumLanes] = {};

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
