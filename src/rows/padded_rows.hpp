// Rows in vectors of which the last may be filled in part: the lanes that are left over hold its last row once more. So
// every lane has numbers that can be computed with, and few rows are done as fast as many. It is how kernels do the
// keys and segments of a constructor (rows/clean_keys.hpp, rows/segments.hpp), which are few more often than not.
#pragma once

#include "rows/row_loop.hpp"

namespace qtraj {
namespace {

// Calls operation(row, lanes), which does that many rows from `row` on and returns how many it did: fewer where one is
// left to the core, at which the loop ends. Returns how many rows were done.
template <class Number, class Operation>
QTRAJ_INLINE size_t do_padded(size_t first, size_t count, const Operation& operation) {
  size_t row = first;
  while (row < count) {
    const size_t left = count - row, lanes = left < kLanesOf<Number> ? left : kLanesOf<Number>;
    const size_t done = operation(row, lanes);
    row += done;
    if (done < lanes) break;
  }
  return row - first;
}

// The bits of the first `lanes` lanes.
QTRAJ_INLINE unsigned first_lanes(size_t lanes) { return (1u << lanes) - 1; }

// How many of them come before the first one in which the condition holds.
template <class Condition>
QTRAJ_INLINE size_t lanes_before(Condition condition, size_t lanes) {
  const unsigned bits = lane_bits(condition) & first_lanes(lanes);
  return bits == 0 ? lanes : static_cast<size_t>(__builtin_ctz(bits));
}

// The rows of a whole vector: the caller's where there are as many, else a copy.
template <class Number, size_t Width, class Real>
QTRAJ_NOINLINE void copy_padded(const Real* from, size_t lanes, Real* copy) {
  for (size_t lane = 0; lane < kLanesOf<Number>; ++lane)
    std::memcpy(copy + Width * lane, from + Width * (lane < lanes ? lane : lanes - 1), Width * sizeof(Real));
}
template <class Number, size_t Width, class Real>
QTRAJ_INLINE const Real* padded(const Real* from, size_t lanes, Real* copy) {
  if (lanes == kLanesOf<Number>) return from;
  copy_padded<Number, Width>(from, lanes, copy);
  return copy;
}

template <class Number, size_t Width>
QTRAJ_INLINE void load_padded(const double* from, size_t lanes, Number (&to)[Width]) {
  double copy[kLanesOf<Number> * Width];
  convert_rows(padded<Number, Width>(from, lanes, copy), 0, to);
}
// False, with `to` unusable, where the numbers cannot be converted.
template <class Real, class Number, size_t Width>
QTRAJ_INLINE bool load_padded_from(const Input<Width>& array, size_t row, size_t lanes, Number (&to)[Width]) {
  Real copy[kLanesOf<Number> * Width];
  const Real* from = padded<Number, Width>(static_cast<const Real*>(array.data) + Width * row, lanes, copy);
  if (!can_convert(from, 0, to)) return false;
  convert_rows(from, 0, to);
  return true;
}
template <class Number, size_t Width>
QTRAJ_INLINE bool load_padded(const Input<Width>& array, size_t row, size_t lanes, Number (&to)[Width]) {
  return array.is_float ? load_padded_from<float>(array, row, lanes, to)
                        : load_padded_from<double>(array, row, lanes, to);
}

template <class Number>
QTRAJ_INLINE Number load_padded(const double* from, size_t lanes, Number) {
  Number numbers[1];
  load_padded(from, lanes, numbers);
  return numbers[0];
}

// Stores `lanes` rows. Unrolled: of a loop GCC 12 makes `rep movs`, which takes longer to begin than all stores
// together.
template <class Number, size_t Width>
QTRAJ_INLINE void store_padded(const Number (&from)[Width], double* to, size_t lanes) {
  if (lanes == kLanesOf<Number>) return store_rows(from, to, 0);
  double rows[kLanesOf<Number>][Width];
  store_rows(from, rows[0], 0);
  each_of<kLanesOf<Number>>([&](size_t lane) {
    if (lane < lanes) std::memcpy(to + Width * lane, rows[lane], sizeof rows[lane]);
  });
}

// The fields of a record as an array.
template <class Record>
constexpr size_t kFieldsOf = sizeof(Record) / sizeof(double);
template <class Number, class Record>
QTRAJ_INLINE auto& fields_of(Record& record) {
  return reinterpret_cast<Number(&)[sizeof(Record) / sizeof(Number)]>(record);
}

QTRAJ_NOINLINE inline void copy_apart(const double (*rows)[4], size_t count, double* to, size_t stride) {
  for (size_t row = 0; row < count; ++row) std::memcpy(to + stride * row, rows[row], sizeof rows[row]);
}

// Load and store fields of `lanes` records, `stride` doubles from one to the next. They are stored four at a time: the
// last four may overlap those before.
template <class Number, size_t Fields>
QTRAJ_INLINE void load_fields(const double* from, size_t stride, size_t lanes, Number (&fields)[Fields]) {
  const double* records[kLanesOf<Number>];
  for (size_t lane = 0; lane < kLanesOf<Number>; ++lane)
    records[lane] = from + stride * (lane < lanes ? lane : lanes - 1);
  load_records(records, fields);
}
template <class Number, size_t Fields>
QTRAJ_INLINE void store_fields(const Number (&fields)[Fields], double* to, size_t stride, size_t lanes) {
  constexpr size_t kGroups = (Fields + 3) / 4;
  const auto first_of = [](size_t group) { return 4 * group + 4 <= Fields ? 4 * group : Fields - 4; };
  const auto for_each_group = [&](const auto& store) {
    each_of<kGroups>([&](size_t group) {
      const size_t first = first_of(group);
      const Number four[] = {fields[first], fields[first + 1], fields[first + 2], fields[first + 3]};
      store(four, group);
    });
  };
  if (lanes == kLanesOf<Number>)
    return for_each_group([&](auto& four, size_t group) { store_rows_apart(four, to + first_of(group), stride); });
  for_each_group([&](auto& four, size_t group) {
    double rows[kLanesOf<Number>][4];
    store_rows(four, rows[0], 0);
    copy_apart(rows, lanes, to + first_of(group), stride);
  });
}

}  // namespace
}  // namespace qtraj
