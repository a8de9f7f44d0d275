#pragma once

#include "qtraj/method.hpp"

namespace qtraj {

// NLERP: the chord from key to key, projected to the sphere. Rate at both ends of a segment:
// omega_body = (2/h) Im(q_i* q_{i+1}), larger in between.
Outcome build_nlerp(Construction& construction);

}  // namespace qtraj
