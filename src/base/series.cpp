#include "base/series.hpp"

namespace qtraj {

Outcome Series::check() {
  if (count == 0) return {};
  constexpr size_t kMost = INT64_MAX;  // from there on an offset is negative
  first_row = end_row = read_offset(offsets);
  if (first_row > kMost) return {Status::count, 0};
  for (size_t k = 0; k < count; ++k) {
    const size_t begin = end_row;
    end_row = read_offset(offsets + k + 1);
    if (end_row < begin || end_row > kMost) return {Status::count, k};
    longest = std::max(longest, end_row - begin);
  }
  return {};
}

}  // namespace qtraj
