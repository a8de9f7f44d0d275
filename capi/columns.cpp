#include "functions/columns.hpp"

#include "arguments.hpp"

using namespace qtraj;

namespace {

// Columns of `count` numbers each, and rows of all of them.
template <class Column, class Rows>
struct Table {
  Column* const* columns;
  size_t width, count;
  Rows* rows;
};
template <class Column, class Rows>
Table(Column* const*, size_t, size_t, Rows*) -> Table<Column, Rows>;

// Whether two of the columns, of `bytes` each, overlap. Where they lie in one order, as those of a table do, neighbours
// tell; otherwise each is compared with all others.
template <class Real>
bool columns_overlap(Real* const* columns, size_t width, size_t bytes) {
  const auto address = [&](size_t k) { return reinterpret_cast<uintptr_t>(columns[k]); };
  bool ascend = true, descend = true;
  for (size_t k = 1; k < width && (ascend || descend); ++k) {
    ascend = ascend && address(k - 1) < address(k);
    descend = descend && address(k) < address(k - 1);
  }
  for (size_t k = 0; k < width; ++k)
    for (size_t other = k + 1; other < width; ++other) {
      if (capi::overlap({columns[k], bytes}, {columns[other], bytes})) return true;
      if (ascend || descend) break;
    }
  return false;
}

// The order of errors: NULL, SIZE, OVERLAP.
template <bool kColumnsAreWritten, class Column, class Rows>
Status check_table(const Table<Column, Rows>& table) {
  if (table.width == 0 || table.count == 0) return Status::ok;
  if (!table.columns || !table.rows) return Status::null;
  size_t row_bytes, pointer_bytes, column_bytes, bytes;
  // there cannot be so many columns to look at
  if (!capi::array_bytes(table.width, sizeof(void*), pointer_bytes)) return Status::size;
  for (size_t k = 0; k < table.width; ++k)
    if (!table.columns[k]) return Status::null;
  if (!capi::array_bytes(table.count, sizeof(Rows), column_bytes) ||
      !capi::array_bytes(table.width, sizeof(Rows), row_bytes) || !capi::array_bytes(table.count, row_bytes, bytes))
    return Status::size;
  const capi::Bytes rows = {table.rows, bytes}, pointers = {table.columns, pointer_bytes};
  if (!kColumnsAreWritten && capi::overlap(rows, pointers)) return Status::overlap;
  for (size_t k = 0; k < table.width; ++k) {
    const capi::Bytes column = {table.columns[k], column_bytes};
    if (capi::overlap(column, rows) || (kColumnsAreWritten && capi::overlap(column, pointers))) return Status::overlap;
  }
  return kColumnsAreWritten && columns_overlap(table.columns, table.width, column_bytes) ? Status::overlap : Status::ok;
}

template <class Real>
qtraj_status to_rows(const Real* const* columns, size_t width, size_t count, Real* rows_out) {
  const Status status = check_table<false>(Table{columns, width, count, rows_out});
  if (status == Status::ok && width > 0 && count > 0) rows_from_columns({columns, width, rows_out}, count);
  return capi::to_c(status);
}

template <class Real>
qtraj_status to_columns(const Real* rows, size_t width, size_t count, Real* const* columns_out) {
  const Status status = check_table<true>(Table{columns_out, width, count, rows});
  if (status == Status::ok && width > 0 && count > 0) columns_from_rows({rows, width, columns_out}, count);
  return capi::to_c(status);
}

}  // namespace

extern "C" {

qtraj_status qtraj_rows_from_columns(const double* const* columns, size_t width, size_t count, double* rows_out) {
  return to_rows(columns, width, count, rows_out);
}

qtraj_status qtraj_rows_from_columns_f32(const float* const* columns, size_t width, size_t count, float* rows_out) {
  return to_rows(columns, width, count, rows_out);
}

qtraj_status qtraj_columns_from_rows(const double* rows, size_t width, size_t count, double* const* columns_out) {
  return to_columns(rows, width, count, columns_out);
}

qtraj_status qtraj_columns_from_rows_f32(const float* rows, size_t width, size_t count, float* const* columns_out) {
  return to_columns(rows, width, count, columns_out);
}

}  // extern "C"
