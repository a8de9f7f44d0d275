// A program with its own Eigen, with vectors and exceptions and without optimisation, beside the library's copy in
// libqtraj.a, and a namespace of the library's name with a function that the library has too: all must keep working.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <iostream>

#include "qtraj.h"

namespace qtraj {
// inline, so that a symbol of the library with this name would replace it in silence
inline double atan2(double, double) { return 42; }
}  // namespace qtraj

int main() {
  const Eigen::Quaterniond a(0.5, 0.5, -0.5, 0.5);
  const Eigen::Quaterniond b(Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()));
  Eigen::Matrix4d outer = a.coeffs() * a.coeffs().transpose() + b.coeffs() * b.coeffs().transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(outer);
  const Eigen::MatrixXd dynamic = Eigen::MatrixXd::Identity(50, 50) * 2.0;
  if (std::abs(solver.eigenvalues().sum() - 2.0) > 1e-14) return 1;
  if (std::abs(dynamic.inverse().trace() - 25.0) > 1e-12) return 1;

  const double times[] = {0.0, 1.0};
  const double keys[] = {a.w(), a.x(), a.y(), a.z(), b.w(), b.x(), b.y(), b.z()};
  qtraj_trajectory* trajectory = nullptr;
  if (qtraj_create(QTRAJ_SLERP, times, keys, 2, &trajectory, nullptr)) return 1;
  for (double time = 0.0; time <= 1.0; time += 0.125) {
    double q[4];
    if (qtraj_sample(trajectory, &time, 1, q, nullptr)) return 1;
    const Eigen::Quaterniond difference = a.slerp(time, b).conjugate() * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
    if (!(difference.vec().norm() <= 2e-15)) {
      std::cout << "off by " << difference.vec().norm() << " at " << time << " s\n";
      return 1;
    }
  }
  qtraj_destroy(trajectory);

  double angle;
  if (qtraj_rotation_angle(keys, 1, keys + 4, 1, 1, &angle, nullptr)) return 1;
  if (std::abs(angle - a.angularDistance(b)) > 1e-15 || qtraj::atan2(1, 1) != 42) return 1;
  std::cout << "qtraj " << qtraj_version() << '\n';
}
