#pragma once

#include "qtraj/method.hpp"

namespace qtraj {

// HERMITE: q_i exp(r/2), r the cubic with r(0) = 0, r(h) = R_i = 2 log(q_i* q_{i+1}) and the given body rates w at both
// ends: r'(0) = w_i, r'(h) = Jr^-1(R_i) w_{i+1}. not_finite with a key's index where |h w| exceeds 2^500.
Outcome build_hermite(Construction& construction);

}  // namespace qtraj
