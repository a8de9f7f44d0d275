// Columns to rows and back, beside a plain loop and beside memcpy of as many bytes.
#include "support.hpp"

namespace bench {
namespace {

template <size_t Width>
struct Columns {
  std::vector<double> numbers;
  std::vector<double*> pointers;

  explicit Columns(size_t count) : numbers(Width * count, 1.0) {
    for (size_t k = 0; k < Width; ++k) pointers.push_back(&numbers[k * count]);
  }
};

// Of the table's width, as a program has it that knows it.
template <size_t Width>
__attribute__((noinline)) void loop_to_rows(double* const* columns, size_t count, double* rows) {
  for (size_t row = 0; row < count; ++row)
    for (size_t k = 0; k < Width; ++k) rows[Width * row + k] = columns[k][row];
}
template <size_t Width>
__attribute__((noinline)) void loop_to_columns(const double* rows, size_t count, double* const* columns) {
  for (size_t row = 0; row < count; ++row)
    for (size_t k = 0; k < Width; ++k) columns[k][row] = rows[Width * row + k];
}

// Both directions between columns of our own and the output as the rows.
template <size_t Width>
void add_width(size_t count) {
  const auto add_work = [=](const std::string& direction, const char* who, const auto& move) {
    const Case table = {direction + std::to_string(Width) + "_f64", 0, count};
    add<double>(
        table, who,
        [=] { return [=, columns = std::make_shared<Columns<Width>>(count)](double* rows) { move(*columns, rows); }; },
        Width);
  };
  add_work("rows_from_columns_", "ours", [=](const Columns<Width>& columns, double* rows) {
    must_be_ok(qtraj_rows_from_columns(const_cast<const double* const*>(columns.pointers.data()), Width, count, rows));
  });
  add_work("rows_from_columns_", "loop", [=](const Columns<Width>& columns, double* rows) {
    loop_to_rows<Width>(columns.pointers.data(), count, rows);
  });
  add_work("rows_from_columns_", "memcpy", [=](const Columns<Width>& columns, double* rows) {
    std::memcpy(rows, columns.numbers.data(), Width * count * sizeof(double));
  });
  add_work("columns_from_rows_", "ours", [=](const Columns<Width>& columns, double* rows) {
    must_be_ok(qtraj_columns_from_rows(rows, Width, count, columns.pointers.data()));
  });
  add_work("columns_from_rows_", "loop", [=](const Columns<Width>& columns, double* rows) {
    loop_to_columns<Width>(rows, count, columns.pointers.data());
  });
  add_work("columns_from_rows_", "memcpy", [=](const Columns<Width>& columns, double* rows) {
    std::memcpy(columns.pointers[0], rows, Width * count * sizeof(double));
  });
}

}  // namespace

void add_tables() {
  for (const size_t count : {size_t{1000}, size_t{10000}, size_t{1000000}}) {
    add_width<3>(count);
    add_width<4>(count);
    add_width<7>(count);
  }
}

}  // namespace bench
