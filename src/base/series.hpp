// Series of rows, one after the other in shared arrays and told apart by offsets, as lists in columns of tables are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/status.hpp"

namespace qtraj {

struct RowRange {
  size_t first, count;
};

// An offset, read from memory once: were another thread to write it meanwhile, what is used is what was checked.
inline size_t read_offset(const int64_t* offset) {
  return static_cast<size_t>(*static_cast<const volatile int64_t*>(offset));
}

// Series k has the rows from offsets[k] up to offsets[k + 1]. Rows before the first offset and from the last one on
// belong to none: arrays are indexed by the offsets as they are, so that a slice of a table needs no copy.
struct Series {
  const int64_t* offsets;  // [count + 1]; may be null where count is 0
  size_t count;

  // What check finds.
  size_t first_row = 0, end_row = 0;  // of all series
  size_t longest = 0;                 // rows

  size_t rows() const { return end_row - first_row; }

  // To be called first. count, with the index of the first series whose offsets are negative or decrease.
  Outcome check();
};

// Reads series that were checked, one after the other. Were offsets written since, no series would reach outside the
// rows of all or be longer than the longest.
class SeriesReader {
 public:
  explicit SeriesReader(const Series& series)
      : offset_(series.offsets), row_(series.first_row), end_row_(series.end_row), longest_(series.longest) {}

  RowRange next() {
    const size_t offset = read_offset(++offset_), first = row_, most = std::min(longest_, end_row_ - first);
    row_ = offset < first ? first : first + std::min(offset - first, most);
    return {first, row_ - first};
  }

 private:
  const int64_t* offset_;  // of the next series; null where there is none
  size_t row_, end_row_, longest_;
};

// Calls of_series(k) for each series, writes the status that it gives to statuses[k], where there are any, and returns
// the first that is not ok.
template <class OfSeries>
Outcome for_each_series(size_t count, int32_t* statuses, const OfSeries& of_series) {
  Outcome outcome;
  for (size_t k = 0; k < count; ++k) {
    const Status status = of_series(k);
    if (statuses) statuses[k] = static_cast<int32_t>(status);
    if (status != Status::ok && outcome.status == Status::ok) outcome = {status, k};
  }
  return outcome;
}

}  // namespace qtraj
