#include "methods/end_rate.hpp"

#include "math/so3.hpp"

namespace qtraj {

Vector3 chord_rate(const Keyframes& keys, size_t segment) {
  return (2.0 / keys.step(segment)) * relative_log(keys[segment], keys[segment + 1]);
}

namespace {

constexpr size_t kMost = 3;

// Distance in time from the end knot to its k-th neighbour, in units of the end interval.
struct Neighbours {
  double at[kMost + 1];
};

// l_k'(0) of the Lagrange basis on the nodes 0, at[1], ..., at[count].
double lagrange_slope(const Neighbours& nodes, size_t count, size_t k) {
  double slope = 1.0 / nodes.at[k];
  for (size_t j = 1; j <= count; ++j)
    if (j != k) slope *= -nodes.at[j] / (nodes.at[k] - nodes.at[j]);
  return slope;
}

bool weights_are_small(const Neighbours& nodes, size_t count) {
  double sum = 0;
  for (size_t k = 1; k <= count; ++k) sum += std::abs(lagrange_slope(nodes, count, k));
  return sum <= 20.0;
}

}  // namespace

Vector3 estimated_end_rate(const Keyframes& keys, Side side, size_t most, double epsilon) {
  const bool start = side == Side::start;
  const auto key = [&](size_t k) { return start ? k : keys.count - 1 - k; };
  const double h = keys.step(start ? 0 : keys.segments() - 1);

  Neighbours nodes{};
  size_t count = 0;
  for (size_t k = 1; k <= most && k < keys.count; ++k) {
    // much closer neighbours have too large weights, much farther ones none at all, and their quotients could overflow
    constexpr double kFar = 0x1p300, kNear = 1e-3;
    const double gap = std::abs(keys.times[key(k)] - keys.times[key(k - 1)]);
    const double distance = std::abs(keys.times[key(k)] - keys.times[key(0)]);
    if (gap < kNear * h || distance * (1.0 / kFar) > h) break;
    nodes.at[k] = distance / h;
    if (!weights_are_small(nodes, k)) break;
    count = k;
  }

  Vector3 slope = Vector3::Zero(), half_angle = Vector3::Zero();
  for (size_t k = 1; k <= count; ++k) {
    half_angle = unwrap(relative_rotation(keys[key(0)], keys[key(k)]), half_angle, epsilon);
    slope += lagrange_slope(nodes, count, k) * half_angle;
  }
  return (start ? 2.0 : -2.0) / h * slope;
}

}  // namespace qtraj
