// Rotations between keyframes, block by block: kernels make those of a block at once.
#pragma once

#include "math/so3.hpp"
#include "methods/keyframes.hpp"

namespace qtraj {

constexpr size_t kRotationBlock = 64;
// Rotations to the keys first, first + 1, ..., at most kRotationBlock of them.
struct RotationBlock {
  double rows[kRotationBlock][4];  // sin_part, angle

  // Each from the key before, first >= 1.
  void fill_steps(const Keyframes& keys, size_t first, size_t count);
  // All from one orientation.
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
