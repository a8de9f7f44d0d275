#include "curve/extrapolation.hpp"

#include "math/trigonometry.hpp"

namespace qtraj {

const GreatCircle& circle_beyond(const Trajectory& trajectory, const Place& place) {
  return place.beyond == &trajectory.timeline.before ? trajectory.before : trajectory.after;
}

void extrapolate(const GreatCircle& circle, double time, double* q) {
  if (circle.rate == 0) {  // not m * 1 + e * 0, which would lose the sign of a zero
    for (int k = 0; k < 4; ++k) q[k] = circle.m[k];
    return;
  }
  const SinCos at = sin_cos(circle.angle(time));
  for (int k = 0; k < 4; ++k) q[k] = circle.m[k] * at.cos + circle.e[k] * at.sin;
}

}  // namespace qtraj
