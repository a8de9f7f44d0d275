#include "curve/extrapolation.hpp"

#include <cmath>

#include "base/floating.hpp"
#include "math/trigonometry.hpp"

namespace qtraj {

void extrapolate(const Extrapolation& side, double time, double* q) {
  if (side.rate == 0) {  // not m * 1 + e * 0, which would lose the sign of a zero
    for (int k = 0; k < 4; ++k) q[k] = side.m[k];
    return;
  }
  const bool past_far = time > side.knot ? time > side.far_time : time < side.far_time;
  const SinCos at = sin_cos(side.rate * ((past_far ? side.far_time : time) - side.knot));
  for (int k = 0; k < 4; ++k) q[k] = side.m[k] * at.cos + side.e[k] * at.sin;
}

WrappedTime wrap_time(const Trajectory& trajectory, double time) {
  const double first = trajectory.before.knot, last = trajectory.after.knot;
  // halved first, so that neither time - first nor turns * period can overflow
  const double half_period = 0.5 * last - 0.5 * first;
  const double half_distance = 0.5 * time - 0.5 * first;
  // so far away that the period is below the resolution of the distance
  if (std::abs(half_distance) * 0x1p-50 > half_period) return {first, false};

  const double quotient = half_distance / half_period;
  double turns = round_to_integer(quotient);
  if (turns > quotient) turns -= 1.0;
  const double half_remainder = half_distance - turns * half_period;
  const double wrapped = first + 2.0 * half_remainder;
  const bool odd = (static_cast<int64_t>(turns) & 1) != 0;
  return {wrapped < first ? first : wrapped > last ? last : wrapped, odd && trajectory.negate_on_wrap};
}

}  // namespace qtraj
