// Rotation matrices both ways: error bounds on a million rows, every branch, and what is no rotation.
#include <qtraj.h>

#include "support/catch.hpp"
#include "support/hard_rows.hpp"

namespace {

using namespace test;

using Matrix = std::array<wide::Real, 9>;  // row-major

// Of a unit quaternion, by squares where the library takes differences from 1.
Matrix reference_matrix(const wide::Quaternion& q) {
  const wide::Real w = q[0], x = q[1], y = q[2], z = q[3];
  return {w * w + x * x - y * y - z * z, 2 * (x * y - w * z),           2 * (x * z + w * y),
          2 * (x * y + w * z),           w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
          2 * (x * z - w * y),           2 * (y * z + w * x),           w * w - x * x - y * y + z * z};
}

// The quaternion of the rotation nearest to m: the top eigenvector of I. Bar-Itzhack's matrix (J. Guidance 23 (2000),
// 1085), by power iteration. Its other eigenvalues are near -1, so that with 1 added they die out: in 6 steps up to
// a distance of 1e-3, in 40 up to 1/2, where they are below 0.4 of the top one.
wide::Quaternion nearest_orientation(const double* m, int steps = 6) {
  using wide::Real;
  const Real xx = m[0], xy = m[1], xz = m[2], yx = m[3], yy = m[4], yz = m[5], zx = m[6], zy = m[7], zz = m[8];
  const Real k[4][4] = {{1 + xx + yy + zz, zy - yz, xz - zx, yx - xy},
                        {zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx},
                        {xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy},
                        {yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz}};
  size_t start = 0;
  for (size_t i = 1; i < 4; ++i)
    if (k[i][i] > k[start][start]) start = i;
  wide::Quaternion q = {k[0][start], k[1][start], k[2][start], k[3][start]};
  for (int step = 0; step < steps; ++step) {
    wide::Quaternion next;
    for (size_t i = 0; i < 4; ++i)
      next[i] = 0.25L * (k[i][0] * q[0] + k[i][1] * q[1] + k[i][2] * q[2] + k[i][3] * q[3]);
    q = next;
  }
  return wide::scaled(q[0] < 0 ? -1 : 1, wide::normalized(q));
}

// Of q and -q the nearer to the reference, for w at rounding of 0.
double error_up_to_sign(const double* q, const wide::Quaternion& reference) {
  return std::min(wide::error(q, reference), wide::error(q, wide::scaled(-1, reference)));
}

TEST_CASE("C API: matrices of quaternions are within 3 eps, and quaternions of those within 1 eps", "[capi][matrix]") {
  const std::vector<double>& q = hard_quaternions();
  std::vector<double> matrix(9 * kHardRows), back(4 * kHardRows);
  REQUIRE(qtraj_matrix_from_q(q.data(), kHardRows, matrix.data(), nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_q_from_matrix(matrix.data(), kHardRows, 0, back.data(), nullptr, nullptr) == QTRAJ_OK);
  Worst worst, worst_back, worst_round_trip;
  size_t wrong_sign = 0;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Quaternion unit = wide::normalized(wide::quaternion(&q[4 * row]));
    worst.add(row, wide::error(&matrix[9 * row], reference_matrix(unit)), 3 * kEps);
    worst_back.add(row, error_up_to_sign(&back[4 * row], nearest_orientation(&matrix[9 * row])), kEps);
    worst_round_trip.add(row, error_up_to_sign(&back[4 * row], unit), 1.5 * kEps);
    wrong_sign += !(back[4 * row] >= 0);
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_back.ratio <= 1);
  CHECK(worst_round_trip.ratio <= 1);
  CHECK(wrong_sign == 0);
}

TEST_CASE("C API: matrices of float and their quaternions are computed in double and rounded once", "[capi][matrix]") {
  const std::vector<double> wide_q = HardRows(44, 30).quaternions();
  const std::vector<float> q(wide_q.begin(), wide_q.end());
  std::vector<float> matrix(9 * kHardRows), back(4 * kHardRows), distance(kHardRows);
  REQUIRE(qtraj_matrix_from_q_f32(q.data(), kHardRows, matrix.data(), nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_q_from_matrix_f32(matrix.data(), kHardRows, 0, back.data(), distance.data(), nullptr) == QTRAJ_OK);
  Worst worst, worst_back;
  size_t wrong_distance = 0;
  for (size_t row = 0; row < kHardRows; ++row) {
    const Quaternion given = {q[4 * row], q[4 * row + 1], q[4 * row + 2], q[4 * row + 3]};
    const Matrix reference = reference_matrix(wide::normalized(wide::quaternion(given.data())));
    worst.add(row, wide::error(&matrix[9 * row], reference), 0.25 * FLT_EPSILON + 3 * kEps);
    const std::vector<double> rounded(&matrix[9 * row], &matrix[9 * row] + 9);
    const Quaternion returned = {back[4 * row], back[4 * row + 1], back[4 * row + 2], back[4 * row + 3]};
    worst_back.add(row, error_up_to_sign(returned.data(), nearest_orientation(rounded.data())),
                   0.25 * FLT_EPSILON + kEps);
    wrong_distance += !(distance[row] >= 0 && distance[row] <= 3 * FLT_EPSILON);
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_back.ratio <= 1);
  CHECK(wrong_distance == 0);
}

TEST_CASE("C API: a matrix slightly off gives the nearest rotation, within 1 eps", "[capi][matrix]") {
  const HardRows hard(41, 0);
  Random random(42);
  constexpr size_t kRows = 1000000;
  std::vector<double> matrix, q(4 * kRows);
  matrix.reserve(9 * kRows);
  for (size_t row = 0; row < kRows; ++row) {
    const Matrix exact = reference_matrix(wide::normalized(wide::quaternion(hard.unit(row).data())));
    // noise of up to 1e-3 in the root of the sum of squares
    const double size = std::pow(10.0, random.uniform(-16, -3)) / 3;
    for (const wide::Real element : exact)
      matrix.push_back(static_cast<double>(element) + size * random.uniform(-1, 1));
  }
  REQUIRE(qtraj_q_from_matrix(matrix.data(), kRows, 0, q.data(), nullptr, nullptr) == QTRAJ_OK);
  Worst worst;
  for (size_t row = 0; row < kRows; ++row)
    worst.add(row, error_up_to_sign(&q[4 * row], nearest_orientation(&matrix[9 * row])), kEps);
  CHECK(worst.ratio <= 1);
}

TEST_CASE("C API: exact rotations by quarter and third turns give exact quaternions", "[capi][matrix][singular]") {
  // all 24 rotations of the cube: signed permutations of determinant 1
  const int permutations[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  int rotations = 0;
  for (int p = 0; p < 6; ++p)
    for (int signs = 0; signs < 8; ++signs) {
      double matrix[9] = {}, back[9], q[4] = {7, 7, 7, 7};
      int determinant = p < 3 ? 1 : -1;
      for (int row = 0; row < 3; ++row) {
        const int sign = signs >> row & 1 ? -1 : 1;
        determinant *= sign;
        matrix[3 * row + permutations[p][row]] = sign;
      }
      size_t fault = 7;
      const qtraj_status status = qtraj_q_from_matrix(matrix, 1, 0, q, nullptr, &fault);
      CAPTURE(p, signs);
      if (determinant < 0) {
        CHECK(status == QTRAJ_E_NOT_ROTATION);
        CHECK(fault == 0);
        CHECK((std::isnan(q[0]) && std::isnan(q[3])));
        continue;
      }
      ++rotations;
      CHECK(status == QTRAJ_OK);
      const double root = std::sqrt(0.5);
      for (const double component : q)
        CHECK((component == 0 || std::abs(component) == 0.5 || std::abs(component) == 1 ||
               std::abs(std::abs(component) - root) <= kEps));
      if (q[0] == 0) CHECK(*std::max_element(q, q + 4) > 0.7);
      REQUIRE(qtraj_matrix_from_q(q, 1, back, nullptr) == QTRAJ_OK);
      for (int k = 0; k < 9; ++k) CHECK(std::abs(back[k] - matrix[k]) <= 2 * kEps);
    }
  CHECK(rotations == 24);
}

TEST_CASE("C API: matrices more than 1e-3 from a rotation are NOT_ROTATION", "[capi][matrix][errors]") {
  Random random(43);
  for (int i = 0; i < 2000; ++i) {
    double rotation[9], matrix[9], q[4];
    REQUIRE(qtraj_matrix_from_q(hard_orientation(random).data(), 1, rotation, nullptr) == QTRAJ_OK);
    const auto status_of = [&](auto&& element) {
      for (int k = 0; k < 9; ++k) matrix[k] = element(k);
      size_t fault = 7;
      const qtraj_status status = qtraj_q_from_matrix(matrix, 1, 0, q, nullptr, &fault);
      CHECK(fault == (status == QTRAJ_OK ? SIZE_MAX : 0));
      CHECK(std::isnan(q[0]) == (status != QTRAJ_OK));
      return status;
    };
    // a stretch: its distance is the stretch times the root of 3, or, along one axis, the stretch
    const double root3 = std::sqrt(3.0);
    for (const double sign : {1.0, -1.0}) {
      CHECK(status_of([&](int k) { return rotation[k] * (1 + sign * 0.999e-3 / root3); }) == QTRAJ_OK);
      CHECK(status_of([&](int k) { return rotation[k] * (1 + sign * 1.001e-3 / root3); }) == QTRAJ_E_NOT_ROTATION);
      CHECK(status_of([&](int k) { return rotation[k] * (k % 3 == i % 3 ? 1 + sign * 0.999e-3 : 1); }) == QTRAJ_OK);
      CHECK(status_of([&](int k) { return rotation[k] * (k % 3 == i % 3 ? 1 + sign * 1.001e-3 : 1); }) ==
            QTRAJ_E_NOT_ROTATION);
    }
    CHECK(status_of([&](int k) { return -rotation[k]; }) == QTRAJ_E_NOT_ROTATION);
    CHECK(status_of([&](int k) { return 2 * rotation[k]; }) == QTRAJ_E_NOT_ROTATION);
    CHECK(status_of([&](int k) { return rotation[k] / 2; }) == QTRAJ_E_NOT_ROTATION);
    CHECK(status_of([&](int k) { return k == i % 9 ? 1e200 : rotation[k]; }) == QTRAJ_E_NOT_ROTATION);
    CHECK(status_of([&](int) { return 0.0; }) == QTRAJ_E_NOT_ROTATION);
    CHECK(status_of([&](int) { return 5e-324; }) == QTRAJ_E_NOT_ROTATION);
    CHECK(status_of([&](int) { return DBL_MAX; }) == QTRAJ_E_NOT_ROTATION);
  }
}

TEST_CASE("C API: a matrix as far off as the largest limit gives the nearest rotation within 2 eps, and its distance",
          "[capi][matrix]") {
  const HardRows hard(44, 0);
  Random random(45);
  constexpr size_t kRows = 200000;
  std::vector<double> matrix, q(4 * kRows), distance(kRows);
  for (size_t row = 0; row < kRows; ++row) {
    const Matrix exact = reference_matrix(wide::normalized(wide::quaternion(hard.unit(row).data())));
    std::array<double, 9> noise;
    double square = 0;
    for (double& element : noise) {
      element = random.normal();
      square += element * element;
    }
    const double size = std::pow(10.0, random.uniform(-3, std::log10(0.499))) / std::sqrt(square);
    for (size_t k = 0; k < 9; ++k) matrix.push_back(static_cast<double>(exact[k]) + size * noise[k]);
    // now and then far in one direction
    if (row % 4 == 0)
      for (size_t k = 0; k < 9; ++k)
        matrix[9 * row + k] = static_cast<double>(exact[k]) * (k % 3 == row % 3 ? (row % 8 ? 0.5005 : 1.4995) : 1.0);
  }
  REQUIRE(qtraj_q_from_matrix(matrix.data(), kRows, 0.5, q.data(), distance.data(), nullptr) == QTRAJ_OK);
  Worst worst, worst_distance;
  for (size_t row = 0; row < kRows; ++row) {
    const double* m = &matrix[9 * row];
    const wide::Quaternion nearest = nearest_orientation(m, 40);
    worst.add(row, error_up_to_sign(&q[4 * row], nearest), 2 * kEps);
    const Matrix rotation = reference_matrix(nearest);
    wide::Real square = 0;
    for (size_t k = 0; k < 9; ++k) square += (m[k] - rotation[k]) * (m[k] - rotation[k]);
    const wide::Real error = std::abs(distance[row] - std::sqrt(square));
    worst_distance.add(row, static_cast<double>(error), 4 * kEps);
  }
  CAPTURE(worst.row, worst_distance.row);
  CHECK(worst.ratio <= 1);
  CHECK(worst_distance.ratio <= 1);
}

TEST_CASE("C API: matrices of three decimals pass with a limit of 2e-3", "[capi][matrix]") {
  Random random(46);
  size_t refused_by_default = 0;
  for (int i = 0; i < 20000; ++i) {
    double matrix[9], q[4], distance;
    REQUIRE(qtraj_matrix_from_q(hard_orientation(random).data(), 1, matrix, nullptr) == QTRAJ_OK);
    for (double& element : matrix) element = std::round(1000 * element) / 1000;
    CHECK(qtraj_q_from_matrix(matrix, 1, 2e-3, q, &distance, nullptr) == QTRAJ_OK);
    CHECK(distance <= 1.5e-3);
    const qtraj_status status = qtraj_q_from_matrix(matrix, 1, 0, q, nullptr, nullptr);
    CHECK((status == QTRAJ_OK) == (distance <= 1e-3));
    refused_by_default += status != QTRAJ_OK;
  }
  CHECK(refused_by_default > 0);
}

TEST_CASE("C API: a matrix that the limit refuses has a distance all the same, up to 1/2", "[capi][matrix][errors]") {
  double matrix[9] = {1.25, 0, 0, 0, 1, 0, 0, 0, 1}, q[4], distance = 7;
  CHECK(qtraj_q_from_matrix(matrix, 1, 0.2, q, &distance, nullptr) == QTRAJ_E_NOT_ROTATION);
  CHECK(std::isnan(q[0]));
  CHECK(std::abs(distance - 0.25) <= 4 * kEps);
  CHECK(qtraj_q_from_matrix(matrix, 1, 0.26, q, &distance, nullptr) == QTRAJ_OK);
  CHECK(q[0] == 1);
  for (const double element : {1.51, -1.0, 0.0, 1e300, double(NAN)}) {
    matrix[0] = element;
    distance = 7;
    CHECK(qtraj_q_from_matrix(matrix, 1, 0.5, q, &distance, nullptr) ==
          (std::isnan(element) ? QTRAJ_E_NOT_FINITE : QTRAJ_E_NOT_ROTATION));
    CHECK((std::isnan(distance) && std::isnan(q[0])));
  }
}

TEST_CASE("C API: a limit that is none is VALUE", "[capi][matrix][errors]") {
  const double matrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double q[4] = {7, 7, 7, 7}, distance = 7;
  for (const double limit : {-1e-300, 0.5000001, 1.0, double(INFINITY), double(NAN)}) {
    CHECK(qtraj_q_from_matrix(matrix, 1, limit, q, &distance, nullptr) == QTRAJ_E_VALUE);
    CHECK((q[0] == 7 && distance == 7));
  }
  CHECK(qtraj_q_from_matrix(matrix, 1, 0.5, q, q + 3, nullptr) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_q_from_matrix(matrix, 1, 5e-324, q, &distance, nullptr) == QTRAJ_OK);
  CHECK(distance == 0);
}

}  // namespace
