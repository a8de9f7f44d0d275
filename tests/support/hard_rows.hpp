// A million rows of hard inputs, made once a program, and what is the worst of them against a bound.
#ifndef QTRAJ_TESTS_HARD_ROWS_HPP
#define QTRAJ_TESTS_HARD_ROWS_HPP

#include <cfloat>
#include <vector>

#include "support/hard_inputs.hpp"
#include "support/long_double.hpp"

namespace test {

constexpr size_t kHardRows = 1000000;
constexpr double kEps = DBL_EPSILON, kLeast = 5e-324;

// Largest error in units of its bound, and where.
struct Worst {
  double ratio = 0;
  size_t row = 0;

  void add(size_t at, double error, double bound) {
    if (error <= ratio * bound) return;
    // not a number would make every later comparison false
    ratio = std::isnan(error) ? std::numeric_limits<double>::infinity() : error / bound;
    row = at;
  }
};

template <class Array>
void append(std::vector<double>& rows, const Array& row) {
  rows.insert(rows.end(), row.begin(), row.end());
}

// Directions, angles and norms from tables whose sizes have no common divisor: a million different combinations.
class HardRows {
 public:
  HardRows(uint64_t seed, double decades) : random_(seed), stride_(seed) {
    for (size_t k = 0; k < kDirections; ++k) directions_.push_back(hard_direction(random_));
    for (size_t k = 0; k < kTurns; ++k) turns_.push_back(about({0, 0, 1}, 2.0 * hard_angle(random_)));
    for (size_t k = 0; k < kNorms; ++k) norms_.push_back(hard_norm(random_, decades));
  }

  Quaternion unit(size_t row) const {
    const Quaternion& turn = turns_[row % kTurns];
    const Vector& axis = directions_[row % kDirections];
    return {turn[0], turn[3] * axis[0], turn[3] * axis[1], turn[3] * axis[2]};
  }
  // in another order for every seed: all pairs of norms meet
  double norm(size_t row) const { return norms_[(row + row / kNorms * stride_) % kNorms]; }

  // Quaternions of norms 10^-decades to 10^decades: all of components -1, 0 and 1, then hard ones.
  std::vector<double> quaternions() const {
    std::vector<double> rows;
    rows.reserve(4 * kHardRows);
    for (int digits = 0; digits < 4 * 81; ++digits) {
      const int d = digits % 81;
      const Quaternion q = {d % 3 - 1.0, d / 3 % 3 - 1.0, d / 9 % 3 - 1.0, d / 27 - 1.0};
      if (d != 40) append(rows, scaled(norm(static_cast<size_t>(digits)), q));
    }
    for (size_t row = 0; rows.size() < 4 * kHardRows; ++row) append(rows, scaled(norm(row), unit(row)));
    return rows;
  }

  // The same, each at a hard angle of R^4 from +- the row of q.
  std::vector<double> neighbours(const std::vector<double>& q) const {
    std::vector<double> rows;
    rows.reserve(q.size());
    for (size_t row = 0; row < kHardRows; ++row) {
      const double* at = &q[4 * row];
      const double scale = 1 / std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2]), std::abs(at[3])});
      const Quaternion from = {scale * at[0], scale * at[1], scale * at[2], scale * at[3]};
      append(rows, scaled(row % 3 == 0 ? -norm(row) : norm(row), multiply(from, unit(row))));
    }
    return rows;
  }

  // Vectors of lengths 10^-decades to 10^decades in hard directions.
  std::vector<double> vectors() const {
    std::vector<double> rows;
    rows.reserve(3 * kHardRows);
    for (size_t row = 0; row < kHardRows; ++row) {
      const Vector& direction = directions_[row % kDirections];
      append(rows, Vector{norm(row) * direction[0], norm(row) * direction[1], norm(row) * direction[2]});
    }
    return rows;
  }

 private:
  static constexpr size_t kDirections = 4093, kTurns = 4099, kNorms = 4091;
  Random random_;
  size_t stride_;
  std::vector<Vector> directions_;
  std::vector<Quaternion> turns_;
  std::vector<double> norms_;
};

inline const std::vector<double>& hard_quaternions() {
  static const std::vector<double> rows = HardRows(20, 160).quaternions();
  return rows;
}
inline const std::vector<double>& hard_neighbours() {
  static const std::vector<double> rows = HardRows(21, 160).neighbours(hard_quaternions());
  return rows;
}

// The largest absolute component is past DBL_MAX.
template <class Array>
bool overflows(const Array& reference) {
  for (const wide::Real component : reference)
    if (std::abs(component) > DBL_MAX) return true;
  return false;
}

}  // namespace test

#endif
