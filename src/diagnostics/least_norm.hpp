#pragma once

#include "curve/trajectory.hpp"

namespace qtraj {

// Smallest norm of a normalised segment before it is normalised, and where; 1 at the first knot for other kinds.
struct LeastNorm {
  double norm, time;
};
LeastNorm least_norm(const Trajectory& trajectory);

}  // namespace qtraj
