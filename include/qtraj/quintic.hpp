#pragma once

#include "qtraj/method.hpp"

namespace qtraj {

// ROTATION_QUINTIC: q_i exp(r/2), r the quintic with the ends of HERMITE and the given body accelerations:
// r''(0) = alpha_i, r''(h) = Jr^-1(R_i) (alpha_{i+1} - beta(R_i, r'(h))), beta of so3.hpp.
// not_finite with a key's index where |h omega| or |h^2 alpha| exceeds 2^240.
Outcome build_rotation_quintic(Construction& construction);

// QUATERNION_QUINTIC: the quintic in R^4 with q' = (0, omega_world/2) q and q'' = (-|omega|^2/4, alpha_world/2) q at
// the keys, normalised (Y. Liu et al., "A quaternion-based trajectory planning", ROBIO 2017, doi
// 10.1109/ROBIO.2017.8324769). not_finite as above.
Outcome build_quaternion_quintic(Construction& construction);

}  // namespace qtraj
