#pragma once

#include "qtraj/method.hpp"

namespace qtraj {

// SLERP: the great circle from key to key at constant rate (K. Shoemake, "Animating rotation with quaternion curves",
// SIGGRAPH 1985, section 3.3).
Outcome build_slerp(Construction& construction);

}  // namespace qtraj
