#include "means/eigen_mean.hpp"

#include <utility>

#include "targets/kernels.hpp"

namespace qtraj {
namespace {

constexpr RowKernel<ScatterRows> kScatterKernels[] = QTRAJ_OF_EACH_TARGET(add_scatter);

// Eigenvalues and, in columns, eigenvectors of a symmetric matrix by cyclic Jacobi rotations (G. Golub, C. Van Loan,
// "Matrix Computations", 8.5.5): accurate to rounding, and made of + - * / sqrt only.
struct Eigensystem {
  Matrix4 values;  // diagonal
  Matrix4 vectors = Matrix4::Identity();
};

// One Jacobi rotation: makes element (p, q) zero.
void rotate_plane(Eigensystem& system, int p, int q) {
  Matrix4& a = system.values;
  if (a(p, q) == 0) return;
  // the tangent of the smaller angle; half_difference may dwarf a(p, q), so that neither is divided by the other's
  // square
  const double half_difference = 0.5 * (a(q, q) - a(p, p));
  const double largest = std::max(std::abs(half_difference), std::abs(a(p, q)));  // unscaled squares may underflow
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

Eigensystem eigensystem(const Matrix4& symmetric) {
  Eigensystem system;
  system.values = symmetric;
  // convergence is quadratic: five sweeps reach rounding, the sixth rotates by nothing
  for (int sweep = 0; sweep < 6; ++sweep)
    for (int p = 0; p < 3; ++p)
      for (int q = p + 1; q < 4; ++q) rotate_plane(system, p, q);
  return system;
}

}  // namespace

double Spectrum::eigengap() const {
  // with equal samples, rounding errors may leave the second eigenvalue below 0 and the first above the sum
  return std::min((values[0] - std::max(values[1], 0.0)) / sum_of_weights, 1.0);
}

void OrientationScatter::add_part(const SampleRows& rows) { kScatterKernels[target()]({rows, &sum_}, 0, rows.q.rows); }

void OrientationScatter::add(const Quaternion& q, double weight) {
  if (block_.is_complete())
    add_part(block_.last_part());
  else if (block_.is_full())
    add_part(block_.next_part());
  block_.add(q, weight);
}

bool OrientationScatter::add(const WeightedOrientations& samples) {
  return samples.sum([this](const SampleRows& rows, size_t first, size_t count) {
    return kScatterKernels[target()]({rows, &sum_}, first, count);
  });
}

void OrientationScatter::read(ScatterTriangle& scatter) {
  add_part(block_.last_part());
  for (size_t at = 0; at < 10; ++at) scatter[at] = sum_.value(at);
}

Spectrum OrientationScatter::spectrum() {
  ScatterTriangle scatter;
  read(scatter);
  return spectrum_of(scatter);
}

Spectrum spectrum_of(const ScatterTriangle& triangle) {
  Matrix4 scatter;
  size_t at = 0;
  for (int row = 0; row < 4; ++row)
    for (int column = row; column < 4; ++column) scatter(row, column) = scatter(column, row) = triangle[at++];
  const Eigensystem system = eigensystem(scatter);

  int order[] = {0, 1, 2, 3};
  for (int k = 1; k < 4; ++k)
    for (int j = k; j > 0 && system.values(order[j], order[j]) > system.values(order[j - 1], order[j - 1]); --j)
      std::swap(order[j], order[j - 1]);
  Spectrum spectrum;
  spectrum.sum_of_weights = 0;
  for (int k = 0; k < 4; ++k) {
    spectrum.values[k] = system.values(order[k], order[k]);
    spectrum.vectors[k] = system.vectors.col(order[k]);
    spectrum.sum_of_weights += scatter(k, k);
  }
  return spectrum;
}

Status OrientationScatter::top_eigenvector(double epsilon, Quaternion& mean) {
  const Spectrum found = spectrum();
  mean = found.vectors[0];
  return found.ties(epsilon) ? Status::ambiguous : Status::ok;
}

Outcome scatter_of(WeightedOrientations& samples, OrientationScatter& scatter) {
  // only where there is a fault it is asked which one comes first
  return samples.scale_weights() && scatter.add(samples) ? Outcome() : samples.first_fault();
}

EigenMean mean_eigen(WeightedOrientations samples) {
  EigenMean mean;
  OrientationScatter scatter;
  mean.outcome = scatter_of(samples, scatter);
  if (mean.outcome.status != Status::ok) return mean;
  const Spectrum spectrum = scatter.spectrum();
  mean.q = samples.with_sign_of_first(unit(spectrum.vectors[0]));
  mean.eigengap = spectrum.eigengap();
  if (spectrum.ties(samples.epsilon())) mean.outcome.status = Status::ambiguous;
  return mean;
}

Outcome mean_eigen_of_each(const GroupedOrientations& samples, const Output<4>& means, double* eigengaps,
                           int32_t* statuses) {
  SeriesReader groups(samples.groups);
  return for_each_series(samples.groups.count, statuses, [&](size_t k) {
    const RowRange rows = groups.next();
    EigenMean mean;
    mean.outcome.status = Status::too_few;
    if (rows.count > 0)
      mean = mean_eigen({rows_from(samples.q, rows.first, rows.count),
                         rows_from(samples.weights, rows.first, rows.count), rows.count});
    write_row(means, k, mean.q);
    if (eigengaps) eigengaps[k] = mean.eigengap;
    return mean.outcome.status;
  });
}

}  // namespace qtraj
