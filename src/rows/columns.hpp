// Tables as columns and as rows: numbers are moved, whatever their bits. Columns are interleaved by vectors up to four
// of them; of more, a square of four rows and four columns, or two and two, is transposed at a time, the last columns
// again with the ones before them where their number is no multiple.
#pragma once

#include "rows/arguments.hpp"
#include "rows/wide_rows.hpp"

namespace qtraj {
namespace {

// Rows of many columns are done in blocks of about so many numbers, which stay in the first cache while columns go
// through them.
constexpr size_t kBlockNumbers = 2048;

// ---- Squares ----

// As many numbers as a square has rows and columns: 32 bytes, or 16 where vectors have no more.
template <class Real>
constexpr size_t kSide = HWY_LANES(Real) < 4 ? HWY_LANES(Real) : 4;
template <class Real>
using SideTag = hn::FixedTag<Real, kSide<Real>>;
template <class Real>
using Side = hn::Vec<SideTag<Real>>;

// The transpose: lane j of vector i becomes lane i of vector j.
template <class Real>
QTRAJ_INLINE void transpose(Side<Real> (&v)[2]) {
  const SideTag<Real> tag;
  const auto lower = hn::InterleaveLower(tag, v[0], v[1]), upper = hn::InterleaveUpper(tag, v[0], v[1]);
  v[0] = lower, v[1] = upper;
}
template <class Real>
QTRAJ_INLINE void transpose(Side<Real> (&v)[4]) {
  const SideTag<Real> tag;
  // of each block of 128 bits
  const auto lower01 = hn::InterleaveLower(tag, v[0], v[1]), upper01 = hn::InterleaveUpper(tag, v[0], v[1]);
  const auto lower23 = hn::InterleaveLower(tag, v[2], v[3]), upper23 = hn::InterleaveUpper(tag, v[2], v[3]);
  v[0] = hn::ConcatLowerLower(tag, lower23, lower01);
  if constexpr (sizeof(Real) == sizeof(double)) {
    v[1] = hn::ConcatLowerLower(tag, upper23, upper01);
    v[2] = hn::ConcatUpperUpper(tag, lower23, lower01);
  } else {
    v[1] = hn::ConcatUpperUpper(tag, lower23, lower01);
    v[2] = hn::ConcatLowerLower(tag, upper23, upper01);
  }
  v[3] = hn::ConcatUpperUpper(tag, upper23, upper01);
}

// Calls move(first column, first row) for the squares of whole rows of squares; returns how many rows these are.
template <class Real, class Move>
QTRAJ_INLINE size_t for_each_square(size_t width, size_t count, const Move& move) {
  constexpr size_t kNumbers = kSide<Real>;
  const size_t whole = count - count % kNumbers, squares = kBlockNumbers / kNumbers / width;
  const size_t block_rows = kNumbers * (squares > 1 ? squares : 1);
  for (size_t block = 0; block < whole; block += block_rows) {
    const size_t end = whole - block < block_rows ? whole : block + block_rows;
    for (size_t next = 0; next < width; next += kNumbers) {
      const size_t column = width - next < kNumbers ? width - kNumbers : next;
      for (size_t row = block; row < end; row += kNumbers) move(column, row);
    }
  }
  return whole;
}

template <class Real>
size_t squares_to_rows(const RowsOfColumns<Real>& table, size_t count) {
  return for_each_square<Real>(table.width, count, [&](size_t column, size_t row) {
    const SideTag<Real> tag;
    Side<Real> v[kSide<Real>];
    for (size_t k = 0; k < kSide<Real>; ++k) v[k] = hn::LoadU(tag, table.columns[column + k] + row);
    transpose<Real>(v);
    Real* const to = table.rows + row * table.width + column;
    for (size_t k = 0; k < kSide<Real>; ++k) hn::StoreU(v[k], tag, to + k * table.width);
  });
}

template <class Real>
size_t squares_to_columns(const ColumnsOfRows<Real>& table, size_t count) {
  return for_each_square<Real>(table.width, count, [&](size_t column, size_t row) {
    const SideTag<Real> tag;
    Side<Real> v[kSide<Real>];
    const Real* const from = table.rows + row * table.width + column;
    for (size_t k = 0; k < kSide<Real>; ++k) v[k] = hn::LoadU(tag, from + k * table.width);
    transpose<Real>(v);
    for (size_t k = 0; k < kSide<Real>; ++k) hn::StoreU(v[k], tag, table.columns[column + k] + row);
  });
}

// ---- Two to four columns, whole vectors of them ----

template <class Real>
QTRAJ_INLINE void store_interleaved(const Wide<Real> (&v)[2], Real* to) {
  hn::StoreInterleaved2(v[0].lanes, v[1].lanes, typename Wide<Real>::Tag(), to);
}
template <class Real>
QTRAJ_INLINE void load_interleaved(const Real* from, Wide<Real> (&v)[2]) {
  hn::LoadInterleaved2(typename Wide<Real>::Tag(), from, v[0].lanes, v[1].lanes);
}
template <size_t Width, class Real>
size_t interleave(const RowsOfColumns<Real>& table, size_t count) {
  constexpr size_t kLanes = Wide<Real>::kLanes;
  const Real* columns[Width];
  for (size_t k = 0; k < Width; ++k) columns[k] = table.columns[k];
  size_t row = 0;
  for (; count - row >= kLanes; row += kLanes) {
    Wide<Real> v[Width];
    for (size_t k = 0; k < Width; ++k) v[k] = Wide<Real>::load(columns[k] + row);
    store_interleaved(v, table.rows + Width * row);
  }
  return row;
}

template <size_t Width, class Real>
size_t deinterleave(const ColumnsOfRows<Real>& table, size_t count) {
  constexpr size_t kLanes = Wide<Real>::kLanes;
  Real* columns[Width];
  for (size_t k = 0; k < Width; ++k) columns[k] = table.columns[k];
  size_t row = 0;
  for (; count - row >= kLanes; row += kLanes) {
    Wide<Real> v[Width];
    load_interleaved(table.rows + Width * row, v);
    for (size_t k = 0; k < Width; ++k) v[k].store(columns[k] + row);
  }
  return row;
}

// ---- Any width of 2 or more: how many rows were done, all but those that fill no vector ----

template <class Real>
size_t vectors_to_rows(const RowsOfColumns<Real>& table, size_t count) {
  switch (table.width) {
    case 2:
      return interleave<2>(table, count);
    case 3:
      return interleave<3>(table, count);
    case 4:
      return interleave<4>(table, count);
    default:
      return squares_to_rows(table, count);
  }
}

template <class Real>
size_t vectors_to_columns(const ColumnsOfRows<Real>& table, size_t count) {
  switch (table.width) {
    case 2:
      return deinterleave<2>(table, count);
    case 3:
      return deinterleave<3>(table, count);
    case 4:
      return deinterleave<4>(table, count);
    default:
      return squares_to_columns(table, count);
  }
}

}  // namespace
}  // namespace qtraj
