// How a call ended: a status, and the index of the element at fault.
#pragma once

#include <cstddef>
#include <cstdint>

#include "qtraj.h"

namespace qtraj {

// The codes of qtraj.h under shorter names. The C layer returns them as they are.
enum class Status : int32_t {
  ok = QTRAJ_OK,
  null = QTRAJ_E_NULL,
  handle = QTRAJ_E_HANDLE,
  too_few = QTRAJ_E_TOO_FEW,
  count = QTRAJ_E_COUNT,
  size = QTRAJ_E_SIZE,
  value = QTRAJ_E_VALUE,
  setting = QTRAJ_E_SETTING,
  input_missing = QTRAJ_E_INPUT_MISSING,
  input_unwanted = QTRAJ_E_INPUT_UNWANTED,
  buffer = QTRAJ_E_BUFFER,
  overlap = QTRAJ_E_OVERLAP,
  no_memory = QTRAJ_E_NO_MEMORY,
  not_finite = QTRAJ_E_NOT_FINITE,
  zero_norm = QTRAJ_E_ZERO_NORM,
  time_order = QTRAJ_E_TIME_ORDER,
  time_range = QTRAJ_E_TIME_RANGE,
  time_span = QTRAJ_E_TIME_SPAN,
  gap = QTRAJ_E_GAP,
  negative_weight = QTRAJ_E_NEGATIVE_WEIGHT,
  not_closed = QTRAJ_E_NOT_CLOSED,
  not_rotation = QTRAJ_E_NOT_ROTATION,
  rate_too_fast = QTRAJ_E_RATE_TOO_FAST,
  no_convergence = QTRAJ_E_NO_CONVERGENCE,
  ambiguous = QTRAJ_E_AMBIGUOUS,
};

constexpr size_t kNoIndex = SIZE_MAX;

// A status and the index of the element at fault; kNoIndex where no single element is at fault.
struct Outcome {
  Status status = Status::ok;
  size_t index = kNoIndex;
};

}  // namespace qtraj
