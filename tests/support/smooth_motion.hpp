// A smooth rotation with its world rates in closed form, for orders of accuracy.
#ifndef QTRAJ_TESTS_SMOOTH_MOTION_HPP
#define QTRAJ_TESTS_SMOOTH_MOTION_HPP

#include "support/random.hpp"

namespace test {

struct SmoothMotion {
  Quaternion q;
  Vector omega_world, alpha_world;
};

// q = Rz(a) Ry(b) Rx(c) with angles that are sines of time; over the first 8 s never more than 1.9 rad from where it
// is at time 0, so that LOG_SPLINE has no trouble with its chart.
// The axes turn with the rotations to their left: omega = a' z + b' y1 + c' x2, y1 = Rz y, x2 = Rz Ry x, and
// alpha = a'' z + b'' y1 + c'' x2 + a' z x b' y1 + (a' z + b' y1) x c' x2.
inline SmoothMotion smooth_motion(double time) {
  struct Angle {
    double value, rate, acceleration;
  };
  const auto wave = [&](double size, double frequency, double phase) {
    const double s = std::sin(frequency * time + phase), c = std::cos(frequency * time + phase);
    return Angle{size * s, size * frequency * c, -size * frequency * frequency * s};
  };
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto times = [](double factor, const Vector& v) { return Vector{factor * v[0], factor * v[1], factor * v[2]}; };
  const auto sum = [](const Vector& a, const Vector& b) { return Vector{a[0] + b[0], a[1] + b[1], a[2] + b[2]}; };

  const Angle a = wave(0.9, 1.3, 0.3), b = wave(0.6, 1.7, 1.1), c = wave(0.8, 1.1, 2.0);
  const Quaternion about_z = about({0, 0, 1}, a.value), about_zy = multiply(about_z, about({0, 1, 0}, b.value));
  const Vector z = {0, 0, 1}, y1 = rotate(about_z, {0, 1, 0}), x2 = rotate(about_zy, {1, 0, 0});
  const Vector turning_z = times(a.rate, z), turning_y = sum(turning_z, times(b.rate, y1));

  SmoothMotion motion;
  motion.q = multiply(about_zy, about({1, 0, 0}, c.value));
  motion.omega_world = sum(turning_y, times(c.rate, x2));
  motion.alpha_world = sum(sum(times(a.acceleration, z), times(b.acceleration, y1)), times(c.acceleration, x2));
  motion.alpha_world = sum(motion.alpha_world, cross(turning_z, times(b.rate, y1)));
  motion.alpha_world = sum(motion.alpha_world, cross(turning_y, times(c.rate, x2)));
  return motion;
}

}  // namespace test

#endif
