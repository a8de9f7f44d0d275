// One-sided derivatives of sampled curves by finite differences of fourth order.
#ifndef QTRAJ_TESTS_DERIVATIVE_HPP
#define QTRAJ_TESTS_DERIVATIVE_HPP

#include "support/trajectory.hpp"

namespace test {

enum class Side { left, right };

// q' at `time` from samples at 0 to 4 times `step` on one side; error step^4 q'''''/5, and rounding 2 eps / step.
inline Quaternion derivative(const Trajectory& trajectory, double time, Side side, double step) {
  constexpr double kWeights[] = {-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -1.0 / 4.0};
  const double signed_step = side == Side::right ? step : -step;
  Quaternion sum = {0, 0, 0, 0};
  for (int i = 0; i < 5; ++i) {
    const Quaternion q = trajectory.at(time + i * signed_step);
    for (size_t k = 0; k < 4; ++k) sum[k] += kWeights[i] * q[k] / signed_step;
  }
  return sum;
}

// q'' likewise; error of third order, rounding 10 eps / step^2.
inline Quaternion second_derivative(const Trajectory& trajectory, double time, Side side, double step) {
  constexpr double kWeights[] = {35.0 / 12.0, -26.0 / 3.0, 19.0 / 2.0, -14.0 / 3.0, 11.0 / 12.0};
  Quaternion sum = {0, 0, 0, 0};
  for (int i = 0; i < 5; ++i) {
    const Quaternion q = trajectory.at(side == Side::right ? time + i * step : time - i * step);
    for (size_t k = 0; k < 4; ++k) sum[k] += kWeights[i] * q[k] / (step * step);
  }
  return sum;
}

// The body rate that goes with q', rad/s: 2 q* q'.
inline Vector body_rate(const Quaternion& q, const Quaternion& dq) {
  const Quaternion product = multiply({q[0], -q[1], -q[2], -q[3]}, dq);
  return {2 * product[1], 2 * product[2], 2 * product[3]};
}

template <size_t Size>
double length(const std::array<double, Size>& v) {
  double sum = 0;
  for (const double component : v) sum += component * component;
  return std::sqrt(sum);
}

template <size_t Size>
double distance(const std::array<double, Size>& a, const std::array<double, Size>& b) {
  std::array<double, Size> difference;
  for (size_t k = 0; k < Size; ++k) difference[k] = a[k] - b[k];
  return length(difference);
}

}  // namespace test

#endif
