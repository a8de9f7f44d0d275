// The builder of STEP.
#include "methods/method.hpp"

namespace qtraj {

// STEP: each key is held until the next one (glTF 2.0, appendix C.2). Segments are arcs of no length; the last key is
// no part of the last of them (methods/timeline_builder.hpp).
Outcome build_step(Construction& construction) {
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<ArcSegment*>(construction.segments);
  for (size_t i = 0; i < keys.segments(); ++i) {
    segments[i] = {};
    store(keys[i].value, segments[i].m);
  }
  return {};
}

}  // namespace qtraj
