// What calls with offsets check: the offsets, and the arrays whose rows they tell apart.
#pragma once

#include "arguments.hpp"
#include "base/series.hpp"

namespace qtraj::capi {

// Whether offsets are NULL, or an array though the offsets, as they were passed, say that it has rows.
bool is_missing(const Series& series);
bool is_missing(const void* data, const Series& series);

// SIZE of the offsets themselves, COUNT with the index of the first series at fault, and SIZE of arrays of rows up to
// the last one, `row_bytes` each. Fills the series in.
struct OffsetRows {
  Series& series;
  size_t row_bytes;
};
Outcome check_offsets(std::initializer_list<OffsetRows> all);

// Offsets as an argument, and the rows of an array that they speak of; no others are touched.
Argument offsets_of(const Series& series);
template <class Array>
Argument rows_of(const Array& array, const Series& series) {
  return rows_from(array, series.first_row, series.rows());
}

// An output that may be no other array, or NULL.
inline Argument spare(const Argument& output) { return distinct(optional(output)); }

}  // namespace qtraj::capi
