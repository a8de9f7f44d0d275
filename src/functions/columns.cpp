#include "functions/columns.hpp"

#include <cstring>

#include "targets/kernels.hpp"

namespace qtraj {
namespace {

// Kernels do rows from the first on and return how many.
template <class Real>
using ToRows = size_t (*)(const RowsOfColumns<Real>& table, size_t count);
template <class Real>
using ToColumns = size_t (*)(const ColumnsOfRows<Real>& table, size_t count);
constexpr ToRows<double> kToRowsOfDouble[] = QTRAJ_OF_EACH_TARGET(rows_from_columns);
constexpr ToRows<float> kToRowsOfFloat[] = QTRAJ_OF_EACH_TARGET(rows_from_columns);
constexpr ToColumns<double> kToColumnsOfDouble[] = QTRAJ_OF_EACH_TARGET(columns_from_rows);
constexpr ToColumns<float> kToColumnsOfFloat[] = QTRAJ_OF_EACH_TARGET(columns_from_rows);

// Calls move(column, row) for the rows from `first` on, in blocks that stay in the cache while columns go through them.
template <class Move>
void for_each_number(size_t width, size_t first, size_t count, const Move& move) {
  constexpr size_t kBlock = 64;
  for (size_t block = first; block < count; block += kBlock) {
    const size_t end = count - block < kBlock ? count : block + kBlock;
    for (size_t column = 0; column < width; ++column)
      for (size_t row = block; row < end; ++row) move(column, row);
  }
}

template <class Real>
void to_rows(ToRows<Real> kernel, const RowsOfColumns<Real>& table, size_t count) {
  if (table.width == 1) {
    std::memcpy(table.rows, table.columns[0], count * sizeof(Real));
    return;
  }
  for_each_number(table.width, kernel(table, count), count, [&](size_t column, size_t row) {
    std::memcpy(table.rows + row * table.width + column, table.columns[column] + row, sizeof(Real));
  });
}

template <class Real>
void to_columns(ToColumns<Real> kernel, const ColumnsOfRows<Real>& table, size_t count) {
  if (table.width == 1) {
    std::memcpy(table.columns[0], table.rows, count * sizeof(Real));
    return;
  }
  for_each_number(table.width, kernel(table, count), count, [&](size_t column, size_t row) {
    std::memcpy(table.columns[column] + row, table.rows + row * table.width + column, sizeof(Real));
  });
}

}  // namespace

void rows_from_columns(const RowsOfColumns<double>& table, size_t count) {
  to_rows(kToRowsOfDouble[target()], table, count);
}
void rows_from_columns(const RowsOfColumns<float>& table, size_t count) {
  to_rows(kToRowsOfFloat[target()], table, count);
}
void columns_from_rows(const ColumnsOfRows<double>& table, size_t count) {
  to_columns(kToColumnsOfDouble[target()], table, count);
}
void columns_from_rows(const ColumnsOfRows<float>& table, size_t count) {
  to_columns(kToColumnsOfFloat[target()], table, count);
}

}  // namespace qtraj
