#include "qtraj/key_rotations.hpp"

#include "kernel/kernel.hpp"

namespace qtraj {

void RotationBlock::fill_steps(const Keyframes& keys, size_t first, size_t count) {
  const size_t from = first - 1;
  kernel().rows.relative_rotations(
      {{keys.q[from], false}, {keys.q_remainder[from], false}, keys.q[first], keys.q_remainder[first], rows}, 0, count);
}

void RotationBlock::fill_from(const UnitQuaternion& from, const Keyframes& keys, size_t first, size_t count) {
  kernel().rows.relative_rotations(
      {{from.value.data(), true}, {from.error.data(), true}, keys.q[first], keys.q_remainder[first], rows}, 0, count);
}

}  // namespace qtraj
