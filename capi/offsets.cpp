#include "offsets.hpp"

namespace qtraj::capi {
namespace {

bool fit_memory(const Series& series) {
  size_t bytes;
  return series.count < SIZE_MAX && array_bytes(series.count + 1, sizeof(int64_t), bytes);
}

}  // namespace

bool is_missing(const Series& series) { return series.count > 0 && !series.offsets; }

bool is_missing(const void* data, const Series& series) {
  if (data || series.count == 0 || !series.offsets || !fit_memory(series)) return false;
  return series.offsets[0] != series.offsets[series.count];
}

Outcome check_offsets(std::initializer_list<OffsetRows> all) {
  for (const OffsetRows& rows : all)
    if (!fit_memory(rows.series)) return {Status::size, kNoIndex};
  Outcome outcome;
  for (const OffsetRows& rows : all) {
    const Outcome checked = rows.series.check();
    if (checked.index < outcome.index) outcome = checked;
  }
  if (outcome.status != Status::ok) return outcome;
  for (const OffsetRows& rows : all) {
    size_t bytes;
    if (!array_bytes(rows.series.end_row, rows.row_bytes, bytes)) return {Status::size, kNoIndex};
  }
  return {};
}

Argument offsets_of(const Series& series) {
  return {series.offsets, series.offsets ? series.count + 1 : 0, 1, sizeof(int64_t), false};
}

}  // namespace qtraj::capi
