// The builder of SLERP.
#include "math/arc.hpp"
#include "methods/key_rates.hpp"
#include "methods/method.hpp"

namespace qtraj {

// SLERP: the great circle from key to key at constant rate (K. Shoemake, "Animating rotation with quaternion curves",
// SIGGRAPH 1985, section 3.3).
Outcome build_slerp(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<ArcSegment*>(construction.segments);
  for (size_t i = 0; i < keys.segments(); ++i) {
    const UnitQuaternion from = keys[i], to = keys[i + 1];
    const Arc arc = arc_between(difference(to, from), sum(from, to));
    segments[i].rate = 2.0 * arc.half_angle / keys.step(i);
    segments[i].half_angle = arc.half_angle;
    store(arc.m, segments[i].m);
    store(arc.e, segments[i].e);
  }
  construction.omega_start = chord_rate(keys, 0);
  construction.omega_end = chord_rate(keys, keys.segments() - 1);
  return {};
}

}  // namespace qtraj
