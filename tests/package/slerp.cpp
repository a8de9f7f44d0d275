// The C API from C++17: a unique_ptr owns the trajectory.
#include <array>
#include <cmath>
#include <iostream>
#include <memory>

#include "qtraj.h"

int main() {
  const double half = std::sqrt(0.5);
  const std::array<double, 3> key_times = {0.0, 1.0, 3.0};
  const std::array<double, 12> keys = {1, 0, 0, 0, half, 0, 0, half, 0, 0, 0, 1};

  qtraj_trajectory* handle = nullptr;
  if (qtraj_create(QTRAJ_SLERP, key_times.data(), keys.data(), key_times.size(), &handle, nullptr)) return 1;
  const std::unique_ptr<qtraj_trajectory, decltype(&qtraj_destroy)> trajectory(handle, qtraj_destroy);

  for (const auto& [time, degrees] : {std::pair(0.5, 45.0), std::pair(2.0, 135.0)}) {
    std::array<double, 4> q{};
    if (qtraj_sample(trajectory.get(), &time, 1, q.data(), nullptr)) return 1;
    const double half_angle = degrees * std::acos(-1.0) / 360.0;
    const double error = std::hypot(q[0] - std::cos(half_angle), std::hypot(q[1], q[2]), q[3] - std::sin(half_angle));
    if (!(error <= 1e-15)) {
      std::cout << "off by " << error << " at " << time << " s\n";
      return 1;
    }
  }
  std::cout << "qtraj " << qtraj_version() << '\n';
}
