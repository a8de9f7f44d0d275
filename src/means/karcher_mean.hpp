// The Karcher mean of orientations: the global minimum of the weighted sum of squared rotation angles.
#pragma once

#include <cstdint>

#include "means/weighted_orientations.hpp"

namespace qtraj {

struct KarcherSettings {
  // Length of a step, rad on S^3, at which a descent ends; 4 eps of the samples' type is used where that is larger.
  double tolerance;
  int32_t max_iterations;  // of a descent to the mean

  // tolerance finite and >= 0, max_iterations >= 1.
  bool is_valid() const;
};

struct KarcherMean {
  Outcome outcome;
  Quaternion q = Quaternion::Constant(std::numeric_limits<double>::quiet_NaN());
  int32_t iterations = 0;                                      // of the descent that ended at q
  double residual = std::numeric_limits<double>::quiet_NaN();  // length of its last step, rad on S^3
};

// The orientation m that minimises f = sum w d^2, d the angle on S^3 from m to the nearer of q_i and -q_i, that is half
// the rotation angle; the sign is that of the first sample of weight above 0. Each component within 6e-16 / h, h the
// smallest eigenvalue of the Hessian of f/2 over the sum of weights (1 for a tight set), when the tolerance is 0.
// Bits do not depend on the signs of the samples but for the sign of the mean.
//
// Descent: Newton's step with the exact Hessian; where f would rise, the unit step m exp(sum w r / W), which never
// raises f (R. Hartley, J. Trumpf, Y. Dai, H. Li, "Rotation averaging", IJCV 103 (2013)). It ends after a step
// within the tolerance, or where the unit step is within 4 eps: the gradient is then rounding, and Newton's step that
// rounding times 1/h.
//
// Verdict: from the eigen mean; where the certificate (karcher_certificate.hpp) does not hold there, also from 23 other
// starts around the eigenvectors, and the least f is judged. Each of these has 64 steps, and goes on only where its f
// is then less than that of all before: what serves the proof alone does not grow with max_iterations. ok is proven to
// be the one global minimum; ambiguous, with the best mean found, covers ties and sets so wide that no proof was found.
//
// Singular: two samples a half turn apart are ambiguous at any weights above 0 (weighted_orientations.hpp), as both
// ways round are equally long. A descent from the eigen mean, or to the least f, that reaches max_iterations:
// no_convergence with the last iterate. A sample at fault or weights that are all 0: q and residual are NaN, iterations
// 0.
KarcherMean mean_karcher(WeightedOrientations samples, const KarcherSettings& settings);

}  // namespace qtraj
