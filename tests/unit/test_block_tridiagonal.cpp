#include <cmath>
#include <vector>

#include "math/block_tridiagonal.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using qtraj::Matrix3;
using qtraj::Vector3;

Matrix3 random_matrix(test::Random& random, double size) {
  Matrix3 matrix;
  for (int k = 0; k < 9; ++k) matrix.data()[k] = random.uniform(-size, size);
  return matrix;
}

struct Row {
  Matrix3 lower, diagonal;
  double upper;
  Vector3 right;
};

struct System {
  std::vector<Row> rows;

  Matrix3 lower(size_t i) const { return rows[i].lower; }
  Matrix3 diagonal(size_t i) const { return rows[i].diagonal; }
  double upper(size_t i) const { return rows[i].upper; }
  Vector3 right(size_t i, const Vector3& before) const { return rows[i].right - rows[i].lower * before; }
};

System random_system(test::Random& random, size_t count) {
  System system = {std::vector<Row>(count)};
  for (Row& row : system.rows) {
    row.lower = random_matrix(random, 0.5);
    row.upper = random.uniform(-0.5, 0.5);
    row.diagonal = 4.0 * Matrix3::Identity() + random_matrix(random, 0.5);
    row.right = Vector3(random.normal(), random.normal(), random.normal());
  }
  return system;
}

// Storage of a solution, and the largest residual of its equations.
struct Solution {
  explicit Solution(size_t count) : x(count), partial(3 * count), inverse(9 * count), column(9 * count) {}
  qtraj::BlockSpace space() {
    return {reinterpret_cast<double(*)[3]>(partial.data()), reinterpret_cast<double(*)[9]>(inverse.data()),
            reinterpret_cast<double(*)[9]>(column.data())};
  }
  // Each must be taken once.
  auto taker() {
    for (Vector3& row : x) row.setConstant(std::nan(""));
    return [this](size_t i, const Vector3& value) { x[i] = std::isnan(x[i][0]) ? value : Vector3::Constant(1e300); };
  }

  double residual(const System& system, bool cyclic) const {
    const std::vector<Row>& rows = system.rows;
    const size_t count = rows.size();
    double largest = 0;
    for (size_t i = 0; i < count; ++i) {
      Vector3 rest = rows[i].right - rows[i].diagonal * x[i];
      if (cyclic || i > 0) rest -= rows[i].lower * x[(i + count - 1) % count];
      if (cyclic || i + 1 < count) rest -= rows[i].upper * x[(i + 1) % count];
      largest = std::max(largest, rest.norm());
    }
    return largest;
  }

  std::vector<Vector3> x;
  std::vector<double> partial, inverse, column;
};

}  // namespace

TEST_CASE("block systems are solved to rounding, tridiagonal and cyclic", "[block_tridiagonal]") {
  test::Random random(1);
  for (size_t count = 2; count <= 12; ++count) {
    System system = random_system(random, count);
    CAPTURE(count);
    Solution open(count), closed(count);
    REQUIRE(qtraj::factorize_tridiagonal(0, count, system, open.space()));
    REQUIRE(qtraj::factorize_cyclic(count, system, closed.space()));
    // the factors serve any right side
    for (int k = 0; k < 2; ++k) {
      for (Row& row : system.rows) row.right = Vector3(random.normal(), random.normal(), random.normal());
      qtraj::solve_tridiagonal(0, count, system, open.space(), open.taker());
      CHECK(open.residual(system, false) <= 1e-14);
      qtraj::solve_cyclic(count, system, closed.space(), closed.taker());
      CHECK(closed.residual(system, true) <= 1e-14);
    }
  }
}

TEST_CASE("a singular pivot block is told", "[block_tridiagonal][singular]") {
  test::Random random(2);
  System system = random_system(random, 3);
  Solution solution(3);
  REQUIRE(qtraj::factorize_cyclic(3, system, solution.space()));
  system.rows[0].diagonal.row(1) = system.rows[0].diagonal.row(0);
  CHECK_FALSE(qtraj::factorize_tridiagonal(0, 3, system, solution.space()));
  system = random_system(random, 3);
  system.rows[1].diagonal.setZero();
  CHECK_FALSE(qtraj::factorize_cyclic(3, system, solution.space()));
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
