// A proof that a local Karcher mean is the global one.
#pragma once

#include "means/eigen_mean.hpp"
#include "means/log_moments.hpp"

namespace qtraj {

// Whether f has its one global minimum at m, up to the step that a descent left there: true is a proof, false says
// nothing. `at_mean` are the moments about m, `spectrum` that of the samples. The notation is that of log_moments.hpp;
// `tie` = 64 eps of the samples' type is the angle that is noise.
//
// (1) All d < pi/4: the samples lie in a ball in which f has one critical point, the global minimum (B. Afsari,
//     "Riemannian L^p center of mass", Proc. AMS 139 (2011), with injectivity radius pi/2).
// Otherwise any x with f(x) <= f(m) lies within S of m, S the smaller of
//     2 dbar, dbar the weighted mean of d, since d_i(x) >= |d(m, x) - d_i|;
//     d(m, e1) + acos sqrt((t - l2)/(l1 - l2)), l the eigenvalues over W, t = cos^2 sqrt(f/W): as cos^2 sqrt(y) is
//     convex in y, x^T M x / W, which is the mean of cos^2 d_i(x), is at least t.
// (2) max d + 2 dbar < pi/2: no sample is ever at pi/2 from such an x, so f is strictly convex on the way to it.
// (3) On the way, at distance s, each sample adds to the second derivative of f/2 at least x cot x at x = d_i + s, and
//     once it can have been passed at pi/2 takes at most pi from the first derivative. Checked for all s up to S in 64
//     steps: the slope from m outwards stays positive.
bool is_global_minimum(const WeightedOrientations& samples, const Spectrum& spectrum, const Quaternion& mean,
                       const LogMoments& at_mean);

}  // namespace qtraj
