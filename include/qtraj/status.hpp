#pragma once

#include <cstddef>
#include <cstdint>

namespace qtraj {

// How a call ended. capi/ translates these, one to one, to the codes of qtraj.h.
enum class Status {
  ok,
  null,
  count,
  size,
  option,
  buffer,
  overlap,
  no_memory,
  not_finite,
  zero_norm,
  time_order,
  time_range,
  negative_weight,
  not_closed,
  not_rotation,
  ambiguous,
  no_convergence,
};

constexpr size_t kNoIndex = SIZE_MAX;

// A status and the index of the element at fault; kNoIndex where no single element is.
struct Outcome {
  Status status = Status::ok;
  size_t index = kNoIndex;
};

}  // namespace qtraj
