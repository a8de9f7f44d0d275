#include "qtraj/hermite.hpp"

#include "qtraj/given_rates.hpp"
#include "qtraj/rotation_vector_polynomial.hpp"
#include "qtraj/so3.hpp"

namespace qtraj {

Outcome build_hermite(Construction& construction) {
  constexpr double kLimit = 0x1p500;
  const Keyframes& keys = construction.keys;
  auto* segments = static_cast<RotationVectorSegment<3>*>(construction.segments);
  double bound = 0;
  for (size_t i = 0; i < keys.segments(); ++i) {
    const double h = keys.step(i);
    Vector3 start, end;
    if (!given_rise(construction, i, h, kLimit, start)) return {Status::not_finite, i};
    if (!given_rise(construction, i + 1, h, kLimit, end)) return {Status::not_finite, i + 1};
    const Vector3 log = relative_log(keys[i], keys[i + 1]);
    const EndValues<Vector3> p = {
        {Vector3::Zero(), log}, {0.5 * start, 0.5 * inverse_right_jacobian(2.0 * log, end)}, {}};
    bound = std::max(bound, set_cubic(keys[i].value, h, p, segments[i]));
    if (i == 0) construction.omega_start = start / h;
    construction.omega_end = end / h;
  }
  construction.range = range_of(bound);
  return {};
}

}  // namespace qtraj
