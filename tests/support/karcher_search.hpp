// The least sum of w d^2 by brute force: many starts all over the rotations, steepest descents from the best of them.
#ifndef QTRAJ_TESTS_KARCHER_SEARCH_HPP
#define QTRAJ_TESTS_KARCHER_SEARCH_HPP

#include "support/capi_means.hpp"

namespace capi {

// Unit samples with their weights over the sum of weights: plain numbers, as this runs millions of times unoptimised.
struct UnitSamples {
  size_t count;
  double q[64][4], weight[64];
};
template <class Real>
UnitSamples unit_samples(const Samples<Real>& samples) {
  UnitSamples result = {};
  result.count = samples.count();
  double sum_of_weights = 0;
  for (size_t i = 0; i < result.count; ++i) sum_of_weights += samples.weight(i);
  for (size_t i = 0; i < result.count; ++i) {
    double square = 0;
    for (size_t k = 0; k < 4; ++k) square += double(samples.q[4 * i + k]) * double(samples.q[4 * i + k]);
    for (size_t k = 0; k < 4; ++k) result.q[i][k] = double(samples.q[4 * i + k]) / std::sqrt(square);
    result.weight[i] = samples.weight(i) / sum_of_weights;
  }
  return result;
}

inline double dot4(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

// Sum of w d^2 over the sum of weights.
template <class Real>
double squares_at(const UnitSamples& samples, const Real* mean) {
  const double m[4] = {double(mean[0]), double(mean[1]), double(mean[2]), double(mean[3])};
  double sum = 0;
  for (size_t i = 0; i < samples.count; ++i) {
    const double cosine = std::abs(dot4(samples.q[i], m)), angle = cosine < 1 ? std::acos(cosine) : 0;
    sum += samples.weight[i] * angle * angle;
  }
  return sum;
}

// Unit steps from m, until they are short enough that 1e-9 is all that is left to gain.
inline double least_squares_from(const UnitSamples& samples, const double* start) {
  double m[4] = {start[0], start[1], start[2], start[3]};
  for (int step = 0; step < 200; ++step) {
    double log[4] = {0, 0, 0, 0};
    for (size_t i = 0; i < samples.count; ++i) {
      const double cosine = dot4(samples.q[i], m), nearest = cosine < 0 ? -cosine : cosine;
      if (nearest >= 1) continue;
      const double factor = samples.weight[i] * std::acos(nearest) / std::sqrt(1 - nearest * nearest);
      const double sign = cosine < 0 ? -factor : factor;
      for (size_t k = 0; k < 4; ++k) log[k] += sign * (samples.q[i][k] - cosine * m[k]);
    }
    const double length = std::sqrt(dot4(log, log));
    for (size_t k = 0; k < 4; ++k)
      m[k] = m[k] * std::cos(length) + log[k] * (length < 1e-9 ? 1 : std::sin(length) / length);
    if (length < 3e-6) break;
  }
  return squares_at(samples, m);
}

// The directions of the integer points of [-2, 2]^4, one of each pair +-, about 0.3 rad apart.
inline const std::vector<std::array<double, 4>>& grid_of_rotations() {
  static const std::vector<std::array<double, 4>> grid = [] {
    std::vector<std::array<double, 4>> points;
    for (int code = 313; code < 625; ++code) {
      const int c[4] = {code / 125 - 2, code / 25 % 5 - 2, code / 5 % 5 - 2, code % 5 - 2};
      const double length = std::sqrt(double(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3]));
      if (c[0] % 2 == 0 && c[1] % 2 == 0 && c[2] % 2 == 0 && c[3] % 2 == 0) continue;  // twice another point
      points.push_back({c[0] / length, c[1] / length, c[2] / length, c[3] / length});
    }
    return points;
  }();
  return grid;
}

// The least value over all rotations: the grid and the samples are looked at, and of these the lowest 8 that are
// 0.4 rad apart descended from.
inline double global_least_squares(const UnitSamples& samples) {
  const auto& grid = grid_of_rotations();
  const double* points[512];
  double values[512];
  size_t count = 0;
  for (const auto& point : grid) points[count++] = point.data();
  for (size_t i = 0; i < samples.count; ++i) points[count++] = samples.q[i];
  for (size_t p = 0; p < count; ++p) values[p] = squares_at(samples, points[p]);

  double least = 1e9;
  for (int descent = 0; descent < 8; ++descent) {
    size_t lowest = 0;
    for (size_t p = 1; p < count; ++p)
      if (values[p] < values[lowest]) lowest = p;
    if (values[lowest] > 1e8) break;
    least = std::min(least, least_squares_from(samples, points[lowest]));
    for (size_t p = 0; p < count; ++p)
      if (p != lowest && std::abs(dot4(points[p], points[lowest])) > 0.92) values[p] = 1e9;
    values[lowest] = 1e9;
  }
  return least;
}

}  // namespace capi

#endif
