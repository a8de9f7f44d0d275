// The builders of SLERP.
#include "math/arc.hpp"
#include "methods/key_rates.hpp"
#include "methods/method.hpp"
#include "methods/polynomials.hpp"
#include "methods/turns.hpp"
#include "targets/kernels.hpp"

namespace qtraj {

namespace {

constexpr RowKernel<ArcRows> kArcKernels[] = QTRAJ_OF_EACH_TARGET(arcs);

// Of arcs shorter than this the rate may be 0: half the least number, 2^-1075, times the longest interval, 2^1024.
constexpr double kLeastArc = 0x1p-50;

}  // namespace

// SLERP: the great circle from key to key at constant rate (K. Shoemake, "Animating rotation with quaternion curves",
// SIGGRAPH 1985, section 3.3).
Outcome build_slerp(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<ArcSegment*>(construction.segments);
  for (size_t i = 0; i < keys.segments(); ++i) {
    i += kArcKernels[target()]({keys.arrays(), segments}, i, keys.segments());
    if (i == keys.segments()) break;
    const UnitQuaternion from = keys[i], to = keys[i + 1];
    const Arc arc = arc_between(difference(to, from), sum(from, to));
    segments[i].rate = 2.0 * arc.half_angle / keys.step(i);
    segments[i].half_angle = arc.half_angle;
    // a rate below 2^-1022 is 0 where subnormal numbers are taken as 0, and the arc would not be travelled
    if (segments[i].rate == 0 && arc.half_angle > kLeastArc) return {Status::time_span, i + 1};
    store(arc.m, segments[i].m);
    store(arc.e, segments[i].e);
  }
  construction.set_end_rates([&](size_t, size_t segment) { return chord_rate(keys, segment); });
  return {};
}

// The same with turns: q_i exp(p u), p the half-angle vector of the step.
Outcome build_turning_slerp(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<RotationVectorSegment<3>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    Step step;
    const Outcome outcome = take_step(construction, i, nullptr, step);
    if (outcome.status != Status::ok) return outcome;
    const double h = keys.step(i);
    const EndValues<Vector3> p = {{Vector3::Zero(), step.log}, {step.log, step.log}, {}};
    bound = std::max(bound, set_cubic(keys[i].value, h, p, segments[i]));
    if (i == 0) construction.omega_start = 2.0 / h * step.log;
    construction.omega_end = 2.0 / h * step.log;
  }
  construction.range = range_of(bound);
  return {};
}

}  // namespace qtraj
