// The kernels that turn columns into rows and back (rows/columns.hpp). Compiled for every target. Scalar code does
// nothing: the core does the rows that vectors leave.
#include "targets/compiled.hpp"

#if defined(QTRAJ_VECTORS)
#include "rows/columns.hpp"
#endif

namespace qtraj {
namespace QTRAJ_TARGET {

#if defined(QTRAJ_VECTORS)

size_t rows_from_columns(const RowsOfColumns<double>& table, size_t count) {
  const VzeroupperAtExit at_exit;
  return vectors_to_rows(table, count);
}

size_t rows_from_columns(const RowsOfColumns<float>& table, size_t count) {
  const VzeroupperAtExit at_exit;
  return vectors_to_rows(table, count);
}

size_t columns_from_rows(const ColumnsOfRows<double>& table, size_t count) {
  const VzeroupperAtExit at_exit;
  return vectors_to_columns(table, count);
}

size_t columns_from_rows(const ColumnsOfRows<float>& table, size_t count) {
  const VzeroupperAtExit at_exit;
  return vectors_to_columns(table, count);
}

#else

size_t rows_from_columns(const RowsOfColumns<double>&, size_t) { return 0; }
size_t rows_from_columns(const RowsOfColumns<float>&, size_t) { return 0; }
size_t columns_from_rows(const ColumnsOfRows<double>&, size_t) { return 0; }
size_t columns_from_rows(const ColumnsOfRows<float>&, size_t) { return 0; }

#endif

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
