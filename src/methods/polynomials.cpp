#include "methods/polynomials.hpp"

#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

template <size_t Degree>
void set_segment(const Quaternion& base, double h, const Vector3 (&c)[Degree + 1],
                 RotationVectorSegment<Degree>& segment) {
  segment.scale = 2.0 / h;
  store(base, segment.base);
  for (size_t term = 0; term <= Degree; ++term) store(c[term], segment.c[term]);
}

}  // namespace

// The bounds are the largest lengths of the Bezier control points, whose convex hull contains the curve.

double set_cubic(const Quaternion& base, double h, const EndValues<Vector3>& p, RotationVectorSegment<3>& segment) {
  Vector3 c[4];
  cubic_through(p, c);
  set_segment<3>(base, h, c, segment);
  const Vector3 inner0 = p.value[0] + (1.0 / 3.0) * p.first[0], inner1 = p.value[1] - (1.0 / 3.0) * p.first[1];
  return std::sqrt(
      std::max({dot(p.value[0], p.value[0]), dot(p.value[1], p.value[1]), dot(inner0, inner0), dot(inner1, inner1)}));
}

double set_quintic(const Quaternion& base, double h, const EndValues<Vector3>& p, RotationVectorSegment<5>& segment) {
  Vector3 c[6];
  quintic_through<Vector3>(p, 0.5 * (p.value[1] - p.value[0]), 0.5 * (p.value[1] + p.value[0]), c);
  set_segment<5>(base, h, c, segment);
  const Vector3 first0 = p.value[0] + 0.2 * p.first[0], first1 = p.value[1] - 0.2 * p.first[1];
  const Vector3 second0 = p.value[0] + 0.4 * p.first[0] + 0.05 * p.second[0];
  const Vector3 second1 = p.value[1] - 0.4 * p.first[1] + 0.05 * p.second[1];
  return std::max(
      {length(p.value[0]), length(p.value[1]), length(first0), length(first1), length(second0), length(second1)});
}

ExponentRange range_of(double bound) {
  if (bound <= 0.5 * kPi) return ExponentRange::quarter_turn;
  if (bound <= kPi) return ExponentRange::half_turn;
  if (bound <= 2.0 * kPi) return ExponentRange::full_turn;
  return ExponentRange::any;
}

}  // namespace qtraj
