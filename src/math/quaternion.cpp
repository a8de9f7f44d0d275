#include "math/quaternion.hpp"

#include <cfloat>

#include "base/floating.hpp"
#include "math/unit_quaternion.hpp"
#include "math/vector_algebra.hpp"

namespace qtraj {

Vector3 rotate(const Quaternion& q, const Vector3& v) {
  double unit[4], turned[3];
  store(q, unit);
  store(v, turned);
  rotate_to_world<Plain>(unit, turned);
  return load(turned);
}

double scale_for(double largest) {
  if (largest < 0x1p-400) return 0x1p600;
  if (largest > 0x1p400) return 0x1p-600;
  return 1.0;
}

Quaternion scaled_to_one(const Quaternion& q) {
  const Quaternion scaled = scale_for(largest_component(q)) * q;
  return normalizing_scale(largest_component(scaled)) * scaled;
}

Normalized normalize(const Quaternion& q) {
  const double scale = scale_for(largest_component(q));
  const Quaternion scaled = scale * q;
  const UnitOf<double> unit = unit_of({scaled[0], scaled[1], scaled[2], scaled[3]});

  Normalized result = {{load(unit.value), load(unit.error)}, 0, 0};
  const double norm = unit.length.value, norm_error = unit.length.error;
  const bool overflows = scale < 1.0 && norm > DBL_MAX * 0x1p-600;
  result.norm = overflows ? DBL_MAX : norm / scale;
  result.norm_error = overflows ? 0 : norm_error / scale;
  return result;
}

DoubleDouble precise_length(const Quaternion& a) {
  if (largest_component(a) == 0) return {0, 0};
  const PreciseLength<double> length = precise_length_of({a[0], a[1], a[2], a[3]});
  return {length.value, length.error};
}

}  // namespace qtraj
