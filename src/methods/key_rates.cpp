#include "methods/key_rates.hpp"

#include "math/so3.hpp"

namespace qtraj {

// ---- Given ----

namespace {

// h v; false where a component is past the limit, which is known before any product can overflow.
bool scale(const Vector3& v, double h, double limit, Vector3& scaled) {
  if (h > 1.0 && largest_component(v) > limit / h) return false;
  scaled = h * v;
  return largest_component(scaled) <= limit;
}

Vector3 in_body(const Vector3& v, Frame frame, const Quaternion& q_wb) {
  return frame == Frame::world ? to_body(q_wb, v) : v;
}

}  // namespace

bool scaled_to_body(const Vector3& v, Frame frame, const Quaternion& q_wb, double h, double limit, Vector3& scaled) {
  if (!scale(v, h, limit, scaled)) return false;
  scaled = in_body(scaled, frame, q_wb);
  return true;
}

bool given_scaled_omega(const Construction& construction, size_t key, double h, double limit, Vector3& scaled) {
  return scaled_to_body(row_of(construction.input.omega, construction.input.row_of_key(key)), construction.rate_frame,
                        construction.keys[key].value, h, limit, scaled);
}

bool given_scaled_alpha(const Construction& construction, size_t key, double h, double limit, Vector3& scaled) {
  const Vector3 alpha = row_of(construction.input.alpha, construction.input.row_of_key(key));
  // h alpha may be past the limit where h^2 alpha is not, and vice versa
  Vector3 once;
  constexpr double kAnything = 0x1p1020;
  const double first_limit = h > 1.0 ? limit / h : kAnything;
  if (!scale(alpha, h, first_limit, once) || !scale(once, h, limit, scaled)) return false;
  scaled = in_body(scaled, construction.rate_frame, construction.keys[key].value);
  return true;
}

// ---- From the keys ----

Vector3 chord_rate(const Keyframes& keys, size_t segment) {
  return (2.0 / keys.step(segment)) * relative_log(keys[segment], keys[segment + 1]);
}

namespace {

// Distance in time from the end knot to its k-th neighbour, in units of the end interval.
struct Neighbours {
  double at[kMostNeighbours + 1];
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

Vector3 estimated_end_rate(const Keyframes& keys, Side side, size_t most, double epsilon, const Vector3* steps) {
  const bool start = side == Side::start;
  const auto key = [&](size_t k) { return start ? k : keys.count - 1 - k; };
  const double h = keys.step(start ? 0 : keys.segments() - 1);

  Neighbours nodes{};
  size_t count = 0;
  for (size_t k = 1; k <= most && k < keys.count; ++k) {
    // much closer neighbours would have too large weights, much farther ones have none, and their quotients could
    // overflow
    constexpr double kFar = 0x1p300, kNear = 1e-3;
    const double gap = std::abs(keys.times[key(k)] - keys.times[key(k - 1)]);
    const double distance = std::abs(keys.times[key(k)] - keys.times[key(0)]);
    if (gap < kNear * h || distance * (1.0 / kFar) > h) break;
    nodes.at[k] = distance / h;
    // beside a long gap neighbours can be equally far to rounding: their weights would be infinite
    if (nodes.at[k] <= nodes.at[k - 1]) break;
    if (!weights_are_small(nodes, k)) break;
    count = k;
  }

  Vector3 slope = Vector3::Zero(), half_angle = Vector3::Zero();
  for (size_t k = 1; k <= count; ++k) {
    if (steps) half_angle += steps[k - 1];
    half_angle = unwrap(relative_rotation(keys[key(0)], keys[key(k)]), half_angle, epsilon);
    slope += lagrange_slope(nodes, count, k) * half_angle;
  }
  return (start ? 2.0 : -2.0) / h * slope;
}

}  // namespace qtraj
