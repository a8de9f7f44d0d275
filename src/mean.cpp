#include "qtraj/mean.hpp"

namespace qtraj {
namespace {

// Eigenvalues and, in columns, eigenvectors of a symmetric matrix by cyclic Jacobi rotations (G. Golub, C. Van Loan,
// "Matrix Computations", 8.5.5): only + - * / sqrt, and accurate to rounding.
struct Eigensystem {
  Eigen::Matrix4d values;  // diagonal
  Eigen::Matrix4d vectors = Eigen::Matrix4d::Identity();
};

// Makes element (p, q) zero.
void rotate_plane(Eigensystem& system, int p, int q) {
  Eigen::Matrix4d& a = system.values;
  if (a(p, q) == 0) return;
  // tangent of the smaller angle; half_difference may dwarf a(p, q), so neither is divided by the other's square
  const double half_difference = 0.5 * (a(q, q) - a(p, p));
  const double largest = std::max(std::abs(half_difference), std::abs(a(p, q)));  // squares of the rest may vanish
  const double x = half_difference / largest, y = a(p, q) / largest;
  const double radius = std::sqrt(x * x + y * y);
  const double tangent = y / (x >= 0 ? x + radius : x - radius);
  const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent), sine = tangent * cosine;

  a(p, p) -= tangent * a(p, q);
  a(q, q) += tangent * a(p, q);
  a(p, q) = a(q, p) = 0;
  for (int k = 0; k < 4; ++k) {
    if (k != p && k != q) {
      const double kp = a(k, p), kq = a(k, q);
      a(k, p) = a(p, k) = cosine * kp - sine * kq;
      a(k, q) = a(q, k) = sine * kp + cosine * kq;
    }
    const double vp = system.vectors(k, p), vq = system.vectors(k, q);
    system.vectors(k, p) = cosine * vp - sine * vq;
    system.vectors(k, q) = sine * vp + cosine * vq;
  }
}

Eigensystem eigensystem(const Eigen::Matrix4d& symmetric) {
  Eigensystem system;
  system.values = symmetric;
  // convergence is quadratic: five sweeps reach rounding, the sixth rotates by nothing
  for (int sweep = 0; sweep < 6; ++sweep)
    for (int p = 0; p < 3; ++p)
      for (int q = p + 1; q < 4; ++q) rotate_plane(system, p, q);
  return system;
}

}  // namespace

void OrientationScatter::add(const Quaternion& unit, double weight) {
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) sum_(row, column) += weight * unit[row] * unit[column];
}

Status OrientationScatter::top_eigenvector(double epsilon, Quaternion& mean) const {
  const Eigensystem system = eigensystem(sum_);
  int top = 0;
  for (int k = 1; k < 4; ++k)
    if (system.values(k, k) > system.values(top, top)) top = k;
  double sum_of_weights = 0, second = 0;
  for (int k = 0; k < 4; ++k) {
    sum_of_weights += sum_(k, k);
    if (k != top) second = std::max(second, system.values(k, k));
  }
  mean = system.vectors.col(top);
  const bool tie = system.values(top, top) - second <= 64.0 * epsilon * sum_of_weights;
  return tie ? Status::ambiguous : Status::ok;
}

}  // namespace qtraj
