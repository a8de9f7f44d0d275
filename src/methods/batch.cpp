#include "methods/batch.hpp"

#include "functions/even_times.hpp"
#include "math/arithmetic.hpp"
#include "targets/sampling.hpp"

namespace qtraj {
namespace {

KeyframeInput part_of(const KeyframeInput& all, const RowRange& keys) {
  return {all.times + keys.first,
          rows_from(all.q_wb, keys.first, keys.count),
          rows_from(all.omega, keys.first, keys.count),
          rows_from(all.alpha, keys.first, keys.count),
          nullptr,
          keys.count};
}

template <size_t Width>
void write_nan_rows(const Output<Width>& array, const RowRange& rows) {
  for (size_t row = rows.first; array.data && row < rows.first + rows.count; ++row) write_nan(array, row);
}

// Samples at times in an array, into the outputs from a row on.
template <class Real>
Status sample_rows(const Trajectory& curve, const double* times, const Batch& batch, const RowRange& rows,
                   size_t& cursor) {
  const BatchOutputs& all = batch.outputs;
  const SampleOutputs<Real> outputs = {static_cast<Real*>(all.q.data), static_cast<Real*>(all.omega.data),
                                       static_cast<Real*>(all.alpha.data), batch.frame};
  return sample(curve, {times, 0, 0}, rows.count, cursor, from_row(outputs, rows.first)).status;
}
Status sample_rows(const Trajectory& curve, const double* times, const Batch& batch, const RowRange& rows,
                   size_t& cursor) {
  return batch.outputs.q.is_float ? sample_rows<float>(curve, times, batch, rows, cursor)
                                  : sample_rows<double>(curve, times, batch, rows, cursor);
}

Status sample_evenly(const Trajectory& curve, const Batch& batch, const RowRange& rows, const BatchMemory& memory) {
  auto* const times = static_cast<double*>(memory.workspace);
  const size_t room = std::min(kEvenTimes, memory.workspace_bytes / sizeof(double));
  const double* const knots = knots_of(curve.timeline);
  Status first = Status::ok;
  size_t cursor = 0;
  for (size_t row = 0; row < rows.count; row += room) {
    const size_t count = std::min(room, rows.count - row);
    write_even_times(knots[0], knots[curve.timeline.key_count - 1], rows.count, row, count, times);
    const Status status = sample_rows(curve, times, batch, {rows.first + row, count}, cursor);
    if (first == Status::ok) first = status;
  }
  return first;
}

// Out of line: what it has on the stack is gone when the curve is sampled, which takes most of the 8 kB there are.
QTRAJ_NOINLINE Status build_series(const Batch& batch, const RowRange& keys, const BatchMemory& memory,
                                   Trajectory** curve) {
  if (keys.count < 2) return Status::too_few;
  return build_trajectory(*batch.options, part_of(batch.input, keys), batch.frame, memory.handle, memory.workspace,
                          curve)
      .status;
}

Status sample_series(const Batch& batch, const RowRange& keys, const RowRange& rows, const BatchMemory& memory) {
  Trajectory* curve = nullptr;
  const Status built = build_series(batch, keys, memory, &curve);
  if (built != Status::ok) {
    write_nan_rows(batch.outputs.q, rows);
    write_nan_rows(batch.outputs.omega, rows);
    write_nan_rows(batch.outputs.alpha, rows);
    return built;
  }
  if (!batch.sample_times) return sample_evenly(*curve, batch, rows, memory);
  size_t cursor = 0;
  return sample_rows(*curve, batch.sample_times + rows.first, batch, rows, cursor);
}

}  // namespace

Outcome sample_batch(const Batch& batch, const BatchMemory& memory) {
  SeriesReader keys(batch.keys), samples(batch.samples);
  return for_each_series(batch.keys.count, batch.statuses, [&](size_t) {
    const RowRange of_keys = keys.next(), of_samples = samples.next();
    return sample_series(batch, of_keys, of_samples, memory);
  });
}

}  // namespace qtraj
