// Rotations between keyframes, for builders. A kernel (rows/keys.hpp) computes them block by block.
#pragma once

#include "math/so3.hpp"
#include "methods/keyframes.hpp"

namespace qtraj {

constexpr size_t kRotationBlock = 64;
// The rotations to keys first, first + 1, ..., at most kRotationBlock of them.
struct RotationBlock {
  double rows[kRotationBlock][4];  // sin_part, angle

  // From the key before each; first >= 1.
  void fill_steps(const Keyframes& keys, size_t first, size_t count);
  // All from the same orientation.
  void fill_from(const UnitQuaternion& from, const Keyframes& keys, size_t first, size_t count);
  RelativeRotation operator[](size_t row) const { return {{rows[row][0], rows[row][1], rows[row][2]}, rows[row][3]}; }
};

// Calls use(segment, log) for every segment in turn, log = relative_log of its keys.
template <class Use>
void for_each_log(const Keyframes& keys, const Use& use) {
  RotationBlock block;
  for (size_t first = 0; first < keys.segments(); first += kRotationBlock) {
    const size_t count = std::min(kRotationBlock, keys.segments() - first);
    block.fill_steps(keys, first + 1, count);
    for (size_t row = 0; row < count; ++row) use(first + row, log_of(block[row]));
  }
}

// Calls use(key, rotation) for every key in turn, rotation = relative_rotation(from, key).
template <class Use>
void for_each_rotation(const UnitQuaternion& from, const Keyframes& keys, const Use& use) {
  RotationBlock block;
  for (size_t first = 0; first < keys.count; first += kRotationBlock) {
    const size_t count = std::min(kRotationBlock, keys.count - first);
    block.fill_from(from, keys, first, count);
    for (size_t row = 0; row < count; ++row) use(first + row, block[row]);
  }
}

}  // namespace qtraj
