// Inputs that find errors: random ones of every size, and those at and beside the singular points.
#ifndef QTRAJ_TESTS_HARD_INPUTS_HPP
#define QTRAJ_TESTS_HARD_INPUTS_HPP

#include "support/random.hpp"

namespace test {

// An angle, rad: spread over [0, pi], or at or close to 0, pi/2 and pi, down to distances of 1e-18.
inline double hard_angle(Random& random) {
  constexpr double kQuarters[] = {0.0, 1.5707963267948966, 3.141592653589793};
  if (random.uniform(0, 1) < 0.4) return random.uniform(0.0, 3.141592653589793);
  const double center = kQuarters[static_cast<size_t>(random.uniform(0, 3))];
  if (random.uniform(0, 1) < 0.1) return center;
  const double distance = std::pow(10.0, random.uniform(-18.0, -0.5));
  return center == 0 || (center < 2 && random.uniform(0, 1) < 0.5) ? center + distance : center - distance;
}

// A direction: random, an axis, or in a plane of axes.
inline Vector hard_direction(Random& random) {
  Vector v = random.direction();
  const double kind = random.uniform(0, 1);
  if (kind < 0.6) return v;
  if (kind < 0.7) return {v[0] < 0 ? -1.0 : 1.0, 0, 0};
  if (kind < 0.8) return {0, 0, v[2] < 0 ? -1.0 : 1.0};
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1]);
  return {v[0] / length, v[1] / length, 0};
}

// A unit quaternion at a hard angle (of S^3) from 1.
inline Quaternion hard_orientation(Random& random) { return about(hard_direction(random), 2.0 * hard_angle(random)); }

// The same at a hard angle from another.
inline Quaternion hard_neighbour(Random& random, const Quaternion& q) { return multiply(q, hard_orientation(random)); }

// A norm: 1, close to 1, about as close as kernels take it for 1, or down to 10^-decades and up to 10^decades.
inline double hard_norm(Random& random, double decades) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.3) return 1.0;
  if (kind < 0.4) return 1.0 + 1e-4 * random.normal();
  if (kind < 0.5) return 1.0 + 0x1p-20 * random.normal();
  return std::pow(10.0, random.uniform(-decades, decades));
}

inline Quaternion scaled(double norm, const Quaternion& q) {
  return {norm * q[0], norm * q[1], norm * q[2], norm * q[3]};
}

}  // namespace test

#endif
