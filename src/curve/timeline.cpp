#include "curve/timeline.hpp"

#include <cmath>

#include "base/floating.hpp"
#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

DoubleDouble sum_of(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = two_sum(a.value, b.value);
  return two_sum(sum.value, sum.error + (a.error + b.error));
}
DoubleDouble negated(const DoubleDouble& a) { return {-a.value, -a.error}; }
bool is_negative(const DoubleDouble& a) { return a.value < 0; }

// Half the time since the first knot, less a whole number of double periods: in [0, 2 half periods). fmod is exact, so
// that nothing is lost however far the time is. Where the period is no double, the part below its last digit is taken
// off as often as it was left out; past 2^50 of them the phase is 0.
DoubleDouble half_phase(const Timeline& timeline, double time) {
  const DoubleDouble period = timeline.half_period;
  const double twice = 2.0 * period.value;
  const DoubleDouble distance = two_sum(0.5 * time, -0.5 * timeline.before.knot);
  const double whole = std::fmod(distance.value, twice), part = std::fmod(distance.error, twice);
  DoubleDouble phase = two_sum(whole, part);
  if (period.error != 0) {
    // so far away that the digits left out make whole periods
    if (std::abs(distance.value) * 0x1p-50 > twice) return {0.0, 0.0};
    // an eighth of a period at most, so that its rounding error is below that of the wrapped time
    const double turns = round_to_integer((distance.value - whole) / twice);
    phase = sum_of(phase, {-turns * (2.0 * period.error), 0.0});
  }
  const DoubleDouble both = {twice, 2.0 * period.error};
  while (is_negative(phase)) phase = sum_of(phase, both);
  for (;;) {
    const DoubleDouble less = sum_of(phase, negated(both));
    if (is_negative(less)) return phase;
    phase = less;
  }
}

// A time moved by whole periods to within the knots.
Place wrapped(const Timeline& timeline, double time) {
  DoubleDouble phase = half_phase(timeline, time);
  const DoubleDouble in_second = sum_of(phase, negated(timeline.half_period));
  const bool is_odd = !is_negative(in_second);
  if (is_odd) phase = in_second;
  const double within = timeline.before.knot + 2.0 * phase.value;
  return {within > timeline.last_inside ? timeline.last_inside : within, is_odd, nullptr, true};
}

}  // namespace

Place place_outside(const Timeline& timeline, double time) {
  const bool is_before = time < timeline.before.knot;
  const Timeline::Side& side = is_before ? timeline.before : timeline.after;
  const bool repeats = side.rule == Extrapolate::periodic;
  // next to a knot it counts as that knot; the last one of a curve that repeats is the first of the next round
  if (is_before ? time >= side.reach : time <= side.reach) {
    if (!is_before && repeats) return {timeline.before.knot, true, nullptr, true};
    const bool is_apart = side.knot > timeline.last_inside;
    return {side.knot, false, is_apart ? &side : nullptr, true};
  }
  if (repeats) return wrapped(timeline, time);
  return {time, false, &side, side.rule != Extrapolate::error};
}

}  // namespace qtraj
