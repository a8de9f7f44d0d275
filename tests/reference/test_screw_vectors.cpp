// Screw motions between poses against values computed at 60 digits (screw.py).
#include <qtraj.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace {

struct ScrewRow {
  double q_a[4], p_a[3], q_b[4], p_b[3], u, q[4], p[3];
};

std::vector<ScrewRow> read_rows() {
  std::ifstream stream(QTRAJ_REFERENCE_DIR "/screw.txt");
  REQUIRE(stream.is_open());
  std::vector<ScrewRow> rows;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    ScrewRow row;
    const auto read = [&](double* to, size_t count) {
      for (size_t k = 0; k < count; ++k) REQUIRE(fields >> to[k]);
    };
    read(row.q_a, 4), read(row.p_a, 3), read(row.q_b, 4), read(row.p_b, 3);
    read(&row.u, 1), read(row.q, 4), read(row.p, 3);
    rows.push_back(row);
  }
  return rows;
}

double length(const double* v, size_t size) {
  double sum = 0;
  for (size_t k = 0; k < size; ++k) sum += v[k] * v[k];
  return std::sqrt(sum);
}

// Half the angle between the two orientations, rad, in [0, pi/2].
double half_angle(const ScrewRow& row) {
  double angle = 0;
  REQUIRE(qtraj_rotation_angle(row.q_a, 1, row.q_b, 1, 1, &angle, nullptr) == QTRAJ_OK);
  return angle / 2;
}

// Errors of q and of p in units of their bounds.
struct Errors {
  double q, p;
};
Errors errors_of(const ScrewRow& row, const double* q, const double* p, double epsilon) {
  const bool from_a = row.u <= 0.5;
  const double part = std::abs(from_a ? row.u : row.u - 1);
  double way[3];
  for (size_t k = 0; k < 3; ++k) way[k] = row.p_b[k] - row.p_a[k];
  const double q_bound = 6e-16 + 7e-16 * std::abs(row.u) * half_angle(row) + epsilon;
  const double p_bound = (DBL_EPSILON + epsilon) * length(from_a ? row.p_a : row.p_b, 3) +
                         16 * DBL_EPSILON * part * length(way, 3) + epsilon * length(row.p, 3);
  Errors errors = {0, 0};
  for (size_t k = 0; k < 4; ++k) errors.q = std::max(errors.q, std::abs(q[k] - row.q[k]) / q_bound);
  for (size_t k = 0; k < 3; ++k) errors.p = std::max(errors.p, std::abs(p[k] - row.p[k]) / p_bound);
  return errors;
}

}  // namespace

TEST_CASE("screw motions agree with the exponential of a twist at 60 digits within their bounds", "[screw]") {
  Errors worst = {0, 0};
  for (const ScrewRow& row : read_rows()) {
    double q[4], p[3];
    REQUIRE(qtraj_screw_pairs(row.q_a, row.p_a, 1, row.q_b, row.p_b, 1, &row.u, 1, 1, q, p, nullptr) == QTRAJ_OK);
    const Errors errors = errors_of(row, q, p, 0);
    CAPTURE(row.u, half_angle(row), errors.q, errors.p);
    CHECK((errors.q <= 1 && errors.p <= 1));
    worst = {std::max(worst.q, errors.q), std::max(worst.p, errors.p)};
    if (row.u == 1)
      for (size_t k = 0; k < 3; ++k) CHECK(p[k] == row.p_b[k]);
    if (row.u == 0)
      for (size_t k = 0; k < 3; ++k) CHECK(p[k] == row.p_a[k]);
  }
  INFO("largest errors, of their bounds: q " << worst.q << ", p " << worst.p);
  // the bounds are not far off
  CHECK((worst.q > 0.05 && worst.p > 0.05));
}
