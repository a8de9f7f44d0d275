// Evenly spaced times and seconds of nanosecond stamps. Plain arithmetic and exact conversions, by the core's formulas:
// the same bits in the core and in kernels of either arithmetic.
#pragma once

#include "math/weighted_mean.hpp"
#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

// ---- Even times ----

template <class Number>
QTRAJ_INLINE void even_time_rows(const EvenTimeRows& rows, size_t row) {
  const Number intervals(static_cast<double>(rows.count - 1));
  const Number steps = Number(static_cast<double>(rows.begin + row)) + lane_numbers(Number());
  const Number mean = weighted_mean(Number(rows.scale * rows.first), intervals - steps, Number(rows.scale * rows.last),
                                    steps, intervals);
  // a power of two and, as the ends are ordinary, its inverse too
  store_lanes(mean * Number(1.0 / rows.scale), rows.times + row);
}

// Ends so small beside each other that two_product is not exact are not ordinary, nor are ends that are both tiny or
// huge.
inline bool has_ordinary_ends(const EvenTimeRows& rows) {
  const auto is_exact = [&](double end) { return end == 0 || absolute(rows.scale * end) > 0x1p-400; };
  const double ends[] = {rows.first, rows.last};
  return is_ordinary(ends) && is_exact(rows.first) && is_exact(rows.last);
}

template <class Number>
size_t even_times(const EvenTimeRows& rows, size_t first, size_t count) {
  if (!has_ordinary_ends(rows)) return 0;
  return do_rows<Number>(first, count, [&](size_t row) {
    even_time_rows<Number>(rows, row);
    return true;
  });
}

// ---- Nanoseconds ----

template <class Number>
size_t seconds_from_ns(const NanosecondRows& rows, size_t first, size_t count) {
  const Number per_second(1e9);
  return do_rows<Number>(first, count, [&](size_t row) {
    Number elapsed;
    if (!load_elapsed(rows.ns + row, rows.origin, elapsed)) return false;
    store_lanes(elapsed / per_second, rows.seconds + row);
    return true;
  });
}

}  // namespace
}  // namespace qtraj
