#include "base/series.hpp"

namespace qtraj {

Outcome Series::check() {
  if (count == 0) return {};
  int64_t begin = offsets[0];
  if (begin < 0) return {Status::count, 0};
  first_row = end_row = static_cast<size_t>(begin);
  for (size_t k = 0; k < count; ++k) {
    const int64_t end = offsets[k + 1];
    if (end < begin) return {Status::count, k};
    longest = std::max(longest, static_cast<size_t>(end - begin));
    begin = end;
  }
  end_row = static_cast<size_t>(begin);
  return {};
}

}  // namespace qtraj
