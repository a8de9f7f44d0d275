// How much work a curve diagnostic may take: a fixed number of pieces, and so many for each segment.
#pragma once

#include <cstddef>

namespace qtraj {

class Budget {
 public:
  explicit Budget(size_t segments) : left_(kPerCall + kPerSegment * segments) {}

  // Takes one piece; false where none is left.
  bool take() {
    if (left_ == 0) return false;
    --left_;
    return true;
  }

 private:
  static constexpr size_t kPerCall = 100000, kPerSegment = 300;
  size_t left_;
};

}  // namespace qtraj
