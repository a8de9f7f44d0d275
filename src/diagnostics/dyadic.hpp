// Halving [-1, 1] into pieces, from left to right, without a stack: a piece is a number and a depth.
#pragma once

#include <cstdint>

#include "diagnostics/rate_bounds.hpp"

namespace qtraj {

class DyadicPieces {
 public:
  explicit DyadicPieces(int deepest) : deepest_(deepest) {}

  bool done() const { return number_ >= uint64_t{1} << depth_; }
  // exact up to a depth of 50
  Piece piece() const {
    const double width = 2.0 / static_cast<double>(uint64_t{1} << depth_);
    return {(static_cast<double>(number_) + 0.5) * width - 1.0, 0.5 * width};
  }
  // Goes to the left half of the piece; false at the greatest depth.
  bool halve() {
    if (depth_ == deepest_) return false;
    ++depth_;
    number_ *= 2;
    return true;
  }
  // Goes past the piece, to the largest one that starts where it ends.
  void next() {
    ++number_;
    while (depth_ > 0 && number_ % 2 == 0) number_ /= 2, --depth_;
  }

 private:
  uint64_t number_ = 0;
  int depth_ = 0, deepest_;
};

}  // namespace qtraj
