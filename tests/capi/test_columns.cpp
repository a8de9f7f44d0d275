// Columns to rows and back: every width and length, any bits, nothing beside the arrays.
#include <cstring>
#include <memory>

#include "support/capi_variants.hpp"
#include "support/guarded.hpp"

using namespace capi;
using test::Guarded;

namespace {

qtraj_status rows_from_columns(const double* const* columns, size_t width, size_t count, double* rows) {
  return qtraj_rows_from_columns(columns, width, count, rows);
}
qtraj_status rows_from_columns(const float* const* columns, size_t width, size_t count, float* rows) {
  return qtraj_rows_from_columns_f32(columns, width, count, rows);
}
qtraj_status columns_from_rows(const double* rows, size_t width, size_t count, double* const* columns) {
  return qtraj_columns_from_rows(rows, width, count, columns);
}
qtraj_status columns_from_rows(const float* rows, size_t width, size_t count, float* const* columns) {
  return qtraj_columns_from_rows_f32(rows, width, count, columns);
}

// Any bits, signalling NaN and subnormal numbers among them.
void fill_with_bits(void* memory, size_t bytes, uint64_t seed) {
  auto* const to = static_cast<unsigned char*>(memory);
  for (size_t i = 0; i < bytes; ++i) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    to[i] = static_cast<unsigned char>(i % 8 > 5 && seed >> 62 == 0 ? 0x7f : seed >> 56);
  }
}

constexpr int kFilling = 0x5a;

// Columns and rows, each at the end of pages that may not be touched beyond.
template <class Real>
struct Table {
  size_t width, count;
  std::vector<std::unique_ptr<Guarded<Real>>> memory;
  std::vector<Real*> columns;
  Guarded<Real> row_memory;
  Real* rows;

  Table(size_t table_width, size_t table_count)
      : width(table_width), count(table_count), row_memory(table_width * table_count + 1) {
    for (size_t k = 0; k < width; ++k) {
      memory.push_back(std::make_unique<Guarded<Real>>(count + 1));
      memory.back()->fill(kFilling);
      columns.push_back(memory.back()->array(count, true));
    }
    row_memory.fill(kFilling);
    rows = row_memory.array(width * count, true);
  }
  const Real* const* inputs() const { return const_cast<const Real* const*>(columns.data()); }
  // Numbers of the rows that are not those of the columns, bit for bit.
  size_t different() const {
    size_t all = 0;
    for (size_t row = 0; row < count; ++row)
      for (size_t k = 0; k < width; ++k)
        all += std::memcmp(rows + row * width + k, columns[k] + row, sizeof(Real)) != 0;
    return all;
  }
  bool nothing_beside() {
    for (size_t k = 0; k < width; ++k)
      if (!memory[k]->holds_around(columns[k], count, kFilling)) return false;
    return row_memory.holds_around(rows, width * count, kFilling);
  }
};

std::vector<size_t> counts_for(size_t width) {
  std::vector<size_t> counts;
  for (size_t count = 1; count <= (width <= 9 ? 37 : 6); ++count) counts.push_back(count);
  for (const size_t count : {63u, 64u, 65u, 301u}) counts.push_back(count);
  return counts;
}

TEST_CASE("C API: columns become rows and rows columns, bit for bit, whatever their number", "[capi][columns]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const size_t width : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 12u, 13u, 31u, 130u})
      for (const size_t count : counts_for(width)) {
        CAPTURE(width, count);
        Table<Real> to_rows(width, count), to_columns(width, count);
        for (size_t k = 0; k < width; ++k) fill_with_bits(to_rows.columns[k], count * sizeof(Real), k);
        CHECK(rows_from_columns(to_rows.inputs(), width, count, to_rows.rows) == QTRAJ_OK);
        CHECK(to_rows.different() == 0);
        CHECK(to_rows.nothing_beside());
        fill_with_bits(to_columns.rows, width * count * sizeof(Real), count);
        CHECK(columns_from_rows(to_columns.rows, width, count, to_columns.columns.data()) == QTRAJ_OK);
        CHECK(to_columns.different() == 0);
        CHECK(to_columns.nothing_beside());
      }
  });
}

TEST_CASE("C API: one column may stand for several in rows", "[capi][columns]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const std::vector<Real> x = {1, 2, 3, 4, 5, 6, 7, 8, 9}, y = {11, 12, 13, 14, 15, 16, 17, 18, 19};
    const Real* columns[] = {x.data(), y.data(), x.data(), x.data() + 1, y.data()};
    std::vector<Real> rows(5 * 8);
    CHECK(rows_from_columns(columns, 5, 8, rows.data()) == QTRAJ_OK);
    size_t wrong = 0;
    for (size_t row = 0; row < 8; ++row)
      for (size_t k = 0; k < 5; ++k) wrong += rows[5 * row + k] != columns[k][row];
    CHECK(wrong == 0);
  });
}

TEST_CASE("C API: tables without rows or columns are OK with NULL arrays", "[capi][columns]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Real* const none = nullptr;
    Real* const no_columns[] = {nullptr, nullptr};
    CHECK(rows_from_columns(static_cast<const Real* const*>(nullptr), 0, 5, none) == QTRAJ_OK);
    CHECK(rows_from_columns(static_cast<const Real* const*>(nullptr), 5, 0, none) == QTRAJ_OK);
    CHECK(rows_from_columns(no_columns, 2, 0, none) == QTRAJ_OK);
    CHECK(columns_from_rows(none, 0, SIZE_MAX, static_cast<Real* const*>(nullptr)) == QTRAJ_OK);
    CHECK(columns_from_rows(none, SIZE_MAX, 0, static_cast<Real* const*>(nullptr)) == QTRAJ_OK);
  });
}

// A table of three columns in one block, as they are, and the statuses of both directions.
template <class Real>
struct Block {
  static constexpr size_t kCount = 6;
  std::vector<Real> numbers = std::vector<Real>(80, Real(7));
  Real* columns[3] = {at(0), at(6), at(12)};
  Real* const* pointers = columns;
  Real* rows = at(18);
  size_t width = 3, count = kCount;

  Block() = default;
  Block(const Block&) = delete;
  Real* at(size_t k) { return numbers.data() + k; }
  void check(qtraj_status to_rows, qtraj_status to_columns) {
    const std::vector<Real> before = numbers;
    CHECK(rows_from_columns(const_cast<const Real* const*>(pointers), width, count, rows) == to_rows);
    if (to_rows != QTRAJ_OK) CHECK(numbers == before);
    const std::vector<Real> between = numbers;
    CHECK(columns_from_rows(rows, width, count, pointers) == to_columns);
    if (to_columns != QTRAJ_OK) CHECK(numbers == between);
  }
};
template <class Change>
void check_block(qtraj_status to_rows, qtraj_status to_columns, const Change& change) {
  for_double_and_float([&](auto zero) {
    Block<decltype(zero)> block;
    change(block);
    block.check(to_rows, to_columns);
  });
}

TEST_CASE("C API: tables at fault are refused in the order NULL, SIZE, OVERLAP", "[capi][columns][errors]") {
  check_block(QTRAJ_OK, QTRAJ_OK, [](auto&) {});
  check_block(QTRAJ_E_NULL, QTRAJ_E_NULL, [](auto& b) { b.pointers = nullptr; });
  check_block(QTRAJ_E_NULL, QTRAJ_E_NULL, [](auto& b) { b.rows = nullptr; });
  check_block(QTRAJ_E_NULL, QTRAJ_E_NULL, [](auto& b) { b.pointers = nullptr, b.width = SIZE_MAX; });
  for (const size_t k : {0u, 2u})
    check_block(QTRAJ_E_NULL, QTRAJ_E_NULL, [&](auto& b) { b.columns[k] = nullptr, b.count = SIZE_MAX; });
  check_block(QTRAJ_E_SIZE, QTRAJ_E_SIZE, [](auto& b) { b.width = SIZE_MAX; });
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 3 + 1, SIZE_MAX / 12 + 1, size_t{PTRDIFF_MAX} / 12 + 1})
    check_block(QTRAJ_E_SIZE, QTRAJ_E_SIZE, [&](auto& b) { b.count = count, b.rows = b.columns[0]; });
  // with one column: no exception for arrays of one shape
  check_block(QTRAJ_E_OVERLAP, QTRAJ_E_OVERLAP, [](auto& b) { b.width = 1, b.rows = b.columns[0]; });
  check_block(QTRAJ_E_OVERLAP, QTRAJ_E_OVERLAP, [](auto& b) { b.rows = b.at(17); });
  check_block(QTRAJ_E_OVERLAP, QTRAJ_E_OVERLAP, [](auto& b) { b.columns[1] = b.at(18 + 17); });
  // columns may share numbers where they are read: beside each other, in either order or in none
  for (const size_t second : {1u, 5u, 7u, 11u})
    check_block(QTRAJ_OK, QTRAJ_E_OVERLAP,
                [&](auto& b) { b.columns[0] = b.at(12), b.columns[1] = b.at(second), b.columns[2] = b.at(6); });
  check_block(QTRAJ_OK, QTRAJ_OK,
              [](auto& b) { b.columns[0] = b.at(12), b.columns[1] = b.at(0), b.columns[2] = b.at(6); });
  check_block(QTRAJ_OK, QTRAJ_OK,
              [](auto& b) { b.columns[0] = b.at(12), b.columns[1] = b.at(6), b.columns[2] = b.at(0); });
  check_block(QTRAJ_OK, QTRAJ_E_OVERLAP, [](auto& b) { b.columns[2] = b.columns[1]; });
}

TEST_CASE("C API: what is written may not overlap the pointers to columns", "[capi][columns][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    std::vector<uint64_t> memory(40), other(40);
    auto* const numbers = reinterpret_cast<Real*>(other.data());
    Real* const columns[] = {numbers, numbers + 8, reinterpret_cast<Real*>(memory.data())};
    std::memcpy(memory.data() + 2, columns, sizeof columns);
    const std::vector<uint64_t> before = memory;
    Real* const* const inside = reinterpret_cast<Real* const*>(memory.data() + 2);
    CHECK(columns_from_rows(numbers + 16, 3, 8, inside) == QTRAJ_E_OVERLAP);
    CHECK(rows_from_columns(const_cast<const Real* const*>(inside), 2, 8, reinterpret_cast<Real*>(memory.data())) ==
          QTRAJ_E_OVERLAP);
    CHECK(memory == before);
  });
}

}  // namespace
