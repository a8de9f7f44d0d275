// The builder of NLERP.
#include "math/so3.hpp"
#include "methods/method.hpp"

namespace qtraj {
namespace {

Vector3 end_rate(const Keyframes& keys, size_t segment) {
  return (2.0 / keys.step(segment)) * relative_rotation(keys[segment], keys[segment + 1]).sin_part;
}

}  // namespace

// NLERP: the chord from key to key, projected to the sphere. Rate at both ends of a segment:
// omega_body = (2/h) Im(q_i* q_{i+1}), larger in between.
Outcome build_nlerp(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<NormalizedSegment<1>*>(construction.segments);
  for (size_t i = 0; i < keys.segments(); ++i) {
    const UnitQuaternion from = keys[i], to = keys[i + 1];
    segments[i].scale = 2.0 / keys.step(i);
    store(0.5 * sum(from, to), segments[i].c[0]);
    store(0.5 * difference(to, from), segments[i].c[1]);
  }
  construction.set_end_rates([&](size_t, size_t segment) { return end_rate(keys, segment); });
  return {};
}

}  // namespace qtraj
