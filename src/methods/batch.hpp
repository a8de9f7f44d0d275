// Many curves in one call: the keys of each series are built into the same memory, and the curve is sampled and
// forgotten. What a series gives is what its curve alone would, to the last bit.
#pragma once

#include "base/series.hpp"
#include "methods/build.hpp"

namespace qtraj {

// Rows to write, of the same type of numbers; each may have no data.
struct BatchOutputs {
  Output<4> q;
  Output<3> omega, alpha;
};

// Arrays are indexed by the offsets. Series have been checked, and settings.
struct Batch {
  const Options* options;
  Frame frame;                 // of all rates
  Series keys, samples;        // of the same count
  KeyframeInput input;         // of all keys; its count is not looked at
  const double* sample_times;  // null: evenly from the first to the last knot of each curve, both exact
  BatchOutputs outputs;
  int32_t* statuses;  // [keys.count]; may be null
};

// Memory for the longest series, 8-byte aligned: what trajectory_size tells, or a larger workspace. Once a curve is
// built its even times are made there, kEvenTimes at once where there is room.
struct BatchMemory {
  void* handle;
  void* workspace;
  size_t workspace_bytes;
};
constexpr size_t kEvenTimes = 512;

// Every row is written. A series without a curve, too_few where it has fewer than 2 keys, has rows of NaN; where only
// samples are at fault, only they. The outcome is that of the first series at fault. No memory is touched where no
// series has 2 keys.
Outcome sample_batch(const Batch& batch, const BatchMemory& memory);

}  // namespace qtraj
