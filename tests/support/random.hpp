// Random keyframes for tests: fixed seeds, the same numbers with every standard library.
#ifndef QTRAJ_TESTS_RANDOM_HPP
#define QTRAJ_TESTS_RANDOM_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace test {

using Quaternion = std::array<double, 4>;
using Vector = std::array<double, 3>;

// splitmix64 (Vigna): std::uniform_real_distribution is not the same everywhere.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  double uniform(double low, double high) {
    state_ += 0x9e3779b97f4a7c15u;
    uint64_t bits = state_;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * static_cast<double>((bits ^ (bits >> 31)) >> 11) * 0x1p-53;
  }

  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return radius * std::cos(uniform(0.0, 6.283185307179586));
  }

  Vector direction() {
    const Vector v = {normal(), normal(), normal()};
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
  }

  Quaternion orientation() {
    const Quaternion q = {normal(), normal(), normal(), normal()};
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
  }

 private:
  uint64_t state_;
};

inline Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

inline Quaternion about(const Vector& axis, double angle) {
  const double s = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), axis[0] * s, axis[1] * s, axis[2] * s};
}

// A turn by at most `largest` rad. One draw a statement: compilers take arguments of a call in different orders.
inline Quaternion turn_within(Random& random, double largest) {
  const double angle = random.uniform(0.0, largest);
  return about(random.direction(), angle);
}

// q v q*.
inline Vector rotate(const Quaternion& q, const Vector& v) {
  const Quaternion turned = multiply(multiply(q, {0, v[0], v[1], v[2]}), {q[0], -q[1], -q[2], -q[3]});
  return {turned[1], turned[2], turned[3]};
}

struct Keys {
  std::vector<double> times, q;

  size_t count() const { return times.size(); }
  Quaternion orientation(size_t key) const { return {q[4 * key], q[4 * key + 1], q[4 * key + 2], q[4 * key + 3]}; }
  void add(double time, const Quaternion& orientation) {
    times.push_back(time);
    q.insert(q.end(), orientation.begin(), orientation.end());
  }
};

// A walk of rotations of at most `largest_step`, rad, at intervals in [shortest, longest], s.
inline Keys random_walk(Random& random, size_t count, double largest_step, double shortest, double longest) {
  Keys keys;
  Quaternion q = random.orientation();
  double time = random.uniform(-5.0, 5.0);
  for (size_t key = 0; key < count; ++key) {
    keys.add(time, q);
    time += random.uniform(shortest, longest);
    q = multiply(q, turn_within(random, largest_step));
  }
  return keys;
}

}  // namespace test

#endif
