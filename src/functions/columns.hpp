// Tables as columns and as rows. Numbers are moved with their bits, NaN and all.
#pragma once

#include "rows/arguments.hpp"

namespace qtraj {

// width and count of 1 or more.
void rows_from_columns(const RowsOfColumns<double>& table, size_t count);
void rows_from_columns(const RowsOfColumns<float>& table, size_t count);
void columns_from_rows(const ColumnsOfRows<double>& table, size_t count);
void columns_from_rows(const ColumnsOfRows<float>& table, size_t count);

}  // namespace qtraj
