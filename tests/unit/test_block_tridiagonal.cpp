#include <vector>

#include "qtraj/block_tridiagonal.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using qtraj::BlockRow;
using qtraj::Matrix3;
using qtraj::Vector3;

Matrix3 random_matrix(test::Random& random, double size) {
  Matrix3 matrix;
  for (int k = 0; k < 9; ++k) matrix.data()[k] = random.uniform(-size, size);
  return matrix;
}

std::vector<BlockRow> random_rows(test::Random& random, size_t count) {
  std::vector<BlockRow> rows(count);
  for (BlockRow& row : rows) {
    row.lower = random_matrix(random, 0.5);
    row.upper = random_matrix(random, 0.5);
    row.diagonal = 4.0 * Matrix3::Identity() + random_matrix(random, 0.5);
    row.right = Vector3(random.normal(), random.normal(), random.normal());
  }
  return rows;
}

// Storage of a solution, and the largest residual of its equations.
struct Solution {
  explicit Solution(size_t count) : x(3 * count), upper(9 * count), column(9 * count) {}
  qtraj::BlockSpace space() {
    return {reinterpret_cast<double(*)[3]>(x.data()), reinterpret_cast<double(*)[9]>(upper.data()),
            reinterpret_cast<double(*)[9]>(column.data())};
  }
  Vector3 at(size_t i) const { return {x[3 * i], x[3 * i + 1], x[3 * i + 2]}; }

  double residual(const std::vector<BlockRow>& rows, bool cyclic) const {
    const size_t count = rows.size();
    double largest = 0;
    for (size_t i = 0; i < count; ++i) {
      Vector3 rest = rows[i].right - rows[i].diagonal * at(i);
      if (cyclic || i > 0) rest -= rows[i].lower * at((i + count - 1) % count);
      if (cyclic || i + 1 < count) rest -= rows[i].upper * at((i + 1) % count);
      largest = std::max(largest, rest.norm());
    }
    return largest;
  }

  std::vector<double> x, upper, column;
};

}  // namespace

TEST_CASE("block systems are solved to rounding, tridiagonal and cyclic", "[block_tridiagonal]") {
  test::Random random(1);
  for (size_t count = 2; count <= 12; ++count) {
    const std::vector<BlockRow> rows = random_rows(random, count);
    const auto row = [&](size_t i) { return rows[i]; };
    CAPTURE(count);
    Solution open(count), closed(count);
    REQUIRE(qtraj::solve_tridiagonal(count, row, open.space()));
    CHECK(open.residual(rows, false) <= 1e-14);
    REQUIRE(qtraj::solve_cyclic(count, row, closed.space()));
    CHECK(closed.residual(rows, true) <= 1e-14);
  }
}

TEST_CASE("a singular pivot block is told", "[block_tridiagonal][singular]") {
  test::Random random(2);
  std::vector<BlockRow> rows = random_rows(random, 3);
  rows[0].diagonal.row(1) = rows[0].diagonal.row(0);
  Solution solution(3);
  CHECK_FALSE(qtraj::solve_tridiagonal(
      3, [&](size_t i) { return rows[i]; }, solution.space()));
}

TEST_CASE("inverses of small matrices are right to rounding", "[block_tridiagonal]") {
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Matrix3 matrix = 2.0 * Matrix3::Identity() + random_matrix(random, 0.6);
    Matrix3 inverse;
    REQUIRE(qtraj::invert(matrix, inverse));
    CHECK((matrix * inverse - Matrix3::Identity()).norm() <= 1e-14);
  }
  Matrix3 inverse;
  CHECK_FALSE(qtraj::invert(Matrix3::Zero(), inverse));
}
