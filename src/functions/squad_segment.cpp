#include "functions/squad_segment.hpp"

#include "functions/pairs.hpp"

namespace qtraj {
namespace {

struct SquadCurve {
  Slerp keys, controls;

  Status at(double u, Quaternion& q) const {
    Quaternion p, c;
    keys.at(u, p);
    controls.at(u, c);
    const Slerp between(make_pair(p, c, Path::as_given));
    // far beyond where the rounding of p and c leaves the third arc any meaning: no overflow
    constexpr double kFar = 0x1p500;
    const double near_u = std::min(std::max(u, -kFar), kFar);
    between.at(2.0 * near_u * (1.0 - near_u), q);
    const bool is_ambiguous = keys.is_ambiguous() || controls.is_ambiguous() || between.is_ambiguous();
    return is_ambiguous ? Status::ambiguous : Status::ok;
  }
};

Status read_curve(const SquadSegmentRows& segment, SquadCurve& curve) {
  Pair keys, controls;
  const Status of_keys = read_pair(segment.q0, segment.q1, 0, Path::as_given, keys);
  const Status of_controls = read_pair(segment.a, segment.b, 0, Path::as_given, controls);
  // not_finite before zero_norm, wherever they are
  if (of_keys == Status::not_finite || of_controls == Status::not_finite) return Status::not_finite;
  if (of_keys != Status::ok || of_controls != Status::ok) return Status::zero_norm;
  curve = {Slerp(keys), Slerp(controls)};
  return Status::ok;
}

}  // namespace

Outcome squad_segment(const SquadSegmentRows& segment, size_t count) {
  if (count == 0) return {};
  SquadCurve curve;
  const Status status = read_curve(segment, curve);
  return for_each_row(count, segment.q, [&](size_t row, Quaternion& q) {
    if (!is_finite(segment.fraction, row)) return Status::not_finite;
    if (status != Status::ok) return status;
    return curve.at(number_of(segment.fraction, row), q);
  });
}

}  // namespace qtraj
