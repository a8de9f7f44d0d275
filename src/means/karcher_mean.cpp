// Based on: R. Hartley, J. Trumpf, Y. Dai, H. Li, "Rotation averaging", IJCV 103 (2013).
#include "means/karcher_mean.hpp"

#include "math/so3.hpp"
#include "means/karcher_certificate.hpp"

namespace qtraj {
namespace {

// The state of a descent: where it stands and how it came there.
struct Descent {
  Quaternion mean;
  LogMoments at_mean;
  int32_t iterations = 0;
  double residual = 0;
  bool converged = false;
};

Vector3 unit_step(const LogMoments& at) { return at.logs / at.weight; }

Vector3 newton_step(const LogMoments& at) {
  Matrix3 inverse;
  return invert(at.hessian, inverse) ? product(inverse, at.logs) : unit_step(at);
}

void move(const WeightedOrientations& samples, const Vector3& step, Descent& descent) {
  descent.mean = unit(multiply(descent.mean, exp_map(step)));
  descent.at_mean = log_moments(samples, descent.mean);
  descent.residual = length(step);
}

Descent start_from(const WeightedOrientations& samples, const Quaternion& start) {
  return {start, log_moments(samples, start)};
}

// Goes on until it converges or has taken so many steps in all.
void descend(const WeightedOrientations& samples, double tolerance_asked, int32_t most, Descent& descent) {
  const double floor = 4.0 * samples.epsilon(), tolerance = std::max(tolerance_asked, floor);
  while (!descent.converged && descent.iterations < most) {
    const Descent before = descent;
    const LogMoments& at = before.at_mean;
    // rounding errors alone move f by this much, because each d is good to about eps
    const double noise = 8.0 * DBL_EPSILON * at.weight * at.root_mean_square();
    move(samples, newton_step(at), descent);
    if (descent.at_mean.squares > at.squares + noise) {
      descent = before;
      move(samples, unit_step(at), descent);
    }
    ++descent.iterations;
    descent.converged = descent.residual <= tolerance || length(unit_step(at)) <= floor;
  }
}

// Descends from another start and keeps the descent with the smaller f. Descents end after 3 to 10 steps as a rule. One
// that creeps, as near a saddle whose curvature vanishes, may go on only where f is already less than the best.
void try_start(const WeightedOrientations& samples, const Quaternion& start, const KarcherSettings& settings,
               Descent& best) {
  constexpr int32_t kTrial = 64;
  Descent descent = start_from(samples, unit(start));
  descend(samples, settings.tolerance, std::min(kTrial, settings.max_iterations), descent);
  if (descent.at_mean.squares >= best.at_mean.squares) return;
  descend(samples, settings.tolerance, settings.max_iterations, descent);
  best = descent;
}

// All starts but the eigen mean: the other eigenvectors e_j, (+-e1 +-e2 +-e3 +-e4)/2, (e_i +- e_j)/sqrt2.
void try_other_starts(const WeightedOrientations& samples, const Spectrum& spectrum, const KarcherSettings& settings,
                      Descent& best) {
  const Quaternion* e = spectrum.vectors;
  for (int j = 1; j < 4; ++j) try_start(samples, e[j], settings, best);
  for (int signs = 0; signs < 8; ++signs) {
    Quaternion start = e[0];
    for (int j = 1; j < 4; ++j) start += (signs >> (j - 1) & 1) != 0 ? Quaternion(-e[j]) : e[j];
    try_start(samples, start, settings, best);
  }
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 4; ++j) {
      try_start(samples, e[i] + e[j], settings, best);
      try_start(samples, e[i] - e[j], settings, best);
    }
}

Status find_minimum(const WeightedOrientations& samples, const Spectrum& spectrum, const KarcherSettings& settings,
                    Descent& best) {
  const auto is_proven = [&] { return is_global_minimum(samples, spectrum, best.mean, best.at_mean); };
  best = start_from(samples, unit(spectrum.vectors[0]));
  descend(samples, settings.tolerance, settings.max_iterations, best);
  if (!best.converged) return Status::no_convergence;
  if (is_proven()) return Status::ok;
  try_other_starts(samples, spectrum, settings, best);
  if (!best.converged) return Status::no_convergence;
  return is_proven() ? Status::ok : Status::ambiguous;
}

// Not inlined: the scatter's sums and samples leave the stack before the descents need it.
__attribute__((noinline)) Outcome spectrum_of(WeightedOrientations& samples, Spectrum& spectrum) {
  OrientationScatter scatter;
  const Outcome outcome = scatter_of(samples, scatter);
  if (outcome.status == Status::ok) spectrum = scatter.spectrum();
  return outcome;
}

}  // namespace

bool KarcherSettings::is_valid() const { return is_finite(tolerance) && tolerance >= 0 && max_iterations >= 1; }

KarcherMean mean_karcher(WeightedOrientations samples, const KarcherSettings& settings) {
  KarcherMean mean;
  Spectrum spectrum;
  mean.outcome = spectrum_of(samples, spectrum);
  if (mean.outcome.status != Status::ok) return mean;
  Descent best;
  mean.outcome.status = find_minimum(samples, spectrum, settings, best);
  mean.q = samples.with_sign_of_first(best.mean);
  mean.iterations = best.iterations;
  mean.residual = best.residual;
  return mean;
}

}  // namespace qtraj
