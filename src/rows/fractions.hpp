// Times as fractions of intervals, in plain arithmetic and by the core's formula (functions/timed_pairs.cpp): the same
// bits in kernels of either arithmetic.
#pragma once

#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

template <class Number>
QTRAJ_INLINE bool fraction_rows(const FractionRows& rows, size_t row) {
  const Number half(0.5);
  Number time[1], a[1], b[1];
  read_numbers<double>(rows.times, row, time);
  read_numbers<double>(rows.time_a, row, a);
  read_numbers<double>(rows.time_b, row, b);
  const Number all_three[] = {time[0], a[0], b[0]};
  if (!all(is_bounded(all_three))) return false;
  const Number half_step[] = {half * b[0] - half * a[0]};
  if (!all(is_ordinary(half_step))) return false;
  const Number fraction = (half * time[0] - half * a[0]) / half_step[0];
  if (!all(is_inside(fraction)) || !all(Number(0.0) < half_step[0])) return false;
  store_lanes(fraction, rows.fraction + row);
  return true;
}

template <class Number>
size_t fractions(const FractionRows& rows, size_t first, size_t count) {
  return do_rows<Number>(first, count, [&](size_t row) { return fraction_rows<Number>(rows, row); });
}

}  // namespace
}  // namespace qtraj
