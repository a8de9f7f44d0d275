#include "methods/key_rotations.hpp"

#include "targets/kernels.hpp"

namespace qtraj {

namespace {

constexpr RowKernel<RelativeRotationRows> kRotationKernels[] = QTRAJ_OF_EACH_TARGET(relative_rotations);

}  // namespace

void RotationBlock::fill_steps(const Keyframes& keys, size_t first, size_t count) {
  const auto block = [&](const double(*from)[4], size_t key) { return input<4>(from[key], count); };
  const RelativeRotationRows rotations = {block(keys.q, first - 1), block(keys.q_remainder, first - 1),
                                          block(keys.q, first), block(keys.q_remainder, first), rows};
  kRotationKernels[target()](rotations, 0, count);
}

void RotationBlock::fill_from(const UnitQuaternion& from, const Keyframes& keys, size_t first, size_t count) {
  const RelativeRotationRows rotations = {input<4>(from.value.data(), 1), input<4>(from.error.data(), 1),
                                          input<4>(keys.q[first], count), input<4>(keys.q_remainder[first], count),
                                          rows};
  kRotationKernels[target()](rotations, 0, count);
}

}  // namespace qtraj
