// Runs: neighbours among sorted times that lie in one segment.
#pragma once

#include "curve/knot_lookup.hpp"
#include "curve/sample_call.hpp"

namespace qtraj {
namespace {

// Calls visit(segment, begin, end) for each segment that has times of a chunk (ChunkTimes, sorted), those from `begin`
// up to `end`. False, with nothing done, where times are outside the knots or runs would on average be shorter than
// `least_run`. `cursor` receives the last segment.
template <class Times, class Visit>
QTRAJ_INLINE bool for_each_run(const Times& times, const KnotIndex& index, const Timeline& timeline, size_t least_run,
                               size_t& cursor, const Visit& visit) {
  const size_t rows = times.rows();
  const double first_time = read_once(times[0]), last_time = read_once(times[rows - 1]);
  if (first_time < index.knots[0] || last_time > timeline.last_inside) return false;
  if (!(first_time <= last_time)) return false;
  const size_t first = find_segment(index, first_time, cursor);
  const size_t last = find_segment(index, last_time, first);
  cursor = last;
  if ((last - first) * least_run >= rows) return false;
  for (size_t segment = first, begin = 0; segment <= last; ++segment) {
    const size_t end = segment == last ? rows : times.first_at_or_after(index.knots[segment + 1], begin);
    if (begin < end) visit(segment, begin, end);
    begin = end;
  }
  return true;
}

}  // namespace
}  // namespace qtraj
