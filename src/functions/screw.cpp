#include "functions/screw.hpp"

#include <algorithm>

#include "math/trigonometry.hpp"

namespace qtraj {
namespace {

// fraction * angle; an angle so large that it has no digits left is cut off instead of overflowing.
double part_of(double angle, double fraction) {
  constexpr double kFar = 0x1p60;
  return 4.0 * std::min(std::max(0.25 * fraction * angle, -kFar), kFar);
}

// sin x / x. Below 1e-9 it is 1 to rounding, and x may have lost digits.
double sinc(double x) { return std::abs(x) < 1e-9 ? 1.0 : sin_cos(x).sin / x; }

}  // namespace

Screw::Screw(const Pair& pair, const Vector3& p_a, const Vector3& p_b)
    : turn_(pair),
      p_a_(p_a),
      p_b_(p_b),
      half_angle_(atan2(pair.sine, pair.cosine)),
      is_ambiguous_(std::abs(pair.cosine) <= kHalfTurnCosine * pair.sine) {
  const Vector3 axis = rotate(pair.a, pair.axis);
  const Scaled<Vector3> difference = sum(scale(p_b), scale(Vector3(-p_a)));
  along_ = {dot(axis, difference.value) * axis, difference.steps};
  across_ = {difference.value - along_.value, difference.steps};
  normal_ = {cross(axis, across_.value), difference.steps};
  stretch_ = 1.0 / sinc(half_angle_);
}

Status Screw::at(double fraction, Pose& pose) const {
  const Status status = turn_.at(fraction, pose.q);
  const bool from_a = fraction <= 0.5;
  const double from_other_end = from_a ? fraction - 1.0 : fraction, part = from_a ? fraction : fraction - 1.0;
  pose.p = from_a ? p_a_ : p_b_;
  if (part != 0) {
    const SinCos turn = sin_cos(part_of(half_angle_, from_other_end));
    const double across = sinc(part_of(half_angle_, part)) * stretch_;
    const Vector3 way = along_.value + (across * turn.cos) * across_.value + (across * turn.sin) * normal_.value;
    const Scaled<Row<1>> steps = scale(Row<1>(part));
    pose.p = unscale(sum(scale(pose.p), scale(Vector3(steps.value[0] * way), steps.steps + along_.steps)));
  }
  return is_ambiguous_ ? Status::ambiguous : status;
}

namespace {

// The two outputs as one row.
struct PoseOutput {
  Output<4> q;
  Output<3> p;
};
bool holds(const PoseOutput& arrays, const Pose& pose) { return holds(arrays.q, pose.q) && holds(arrays.p, pose.p); }
void write_row(const PoseOutput& arrays, size_t row, const Pose& pose) {
  write_row(arrays.q, row, pose.q);
  write_row(arrays.p, row, pose.p);
}
void write_nan(const PoseOutput& arrays, size_t row) {
  write_nan(arrays.q, row);
  write_nan(arrays.p, row);
}
Pose zero_row(const PoseOutput&) { return {Quaternion::Zero(), Vector3::Zero()}; }

Status read_screw(const ScrewRows& rows, size_t row, Screw& screw) {
  if (!is_finite(rows.p_a, row) || !is_finite(rows.p_b, row)) return Status::not_finite;
  Pair pair;
  const Status status = read_pair(rows.q_a, rows.q_b, row, Path::shortest, pair);
  if (status == Status::ok) screw = Screw(pair, row_of(rows.p_a, row), row_of(rows.p_b, row));
  return status;
}

}  // namespace

Outcome screw_pairs(const ScrewRows& rows, size_t count) {
  const bool is_one = rows.q_a.rows == 1 && rows.q_b.rows == 1;
  Screw screw;
  Status status = Status::ok;
  bool has_screw = false;
  return for_each_row(count, PoseOutput{rows.q, rows.p}, [&](size_t row, Pose& pose) {
    if (!has_screw || !is_one) status = read_screw(rows, row, screw);
    has_screw = true;
    if (!is_finite(rows.fraction, row)) return Status::not_finite;
    return status == Status::ok ? screw.at(number_of(rows.fraction, row), pose) : status;
  });
}

}  // namespace qtraj
