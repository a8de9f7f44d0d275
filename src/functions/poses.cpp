#include "functions/poses.hpp"

#include "math/arithmetic.hpp"

namespace qtraj {
namespace {

template <class Real>
void fill_with_nan(Real* row, size_t size) {
  for (size_t k = 0; row && k < size; ++k) row[k] = static_cast<Real>(__builtin_nan(""));
}

template <class Real>
PoseOutputs<Real> from_row(const PoseOutputs<Real>& outputs, size_t row, size_t dim) {
  return {from_row(outputs.orientation, row), from_row(outputs.position, row, dim)};
}

// Not inlined: a pose alone is to take little stack.
template <class Real>
QTRAJ_NOINLINE Status missing_pose(Status status, const PoseOutputs<Real>& outputs, size_t dim) {
  fill_with_nan(outputs.orientation.q, 4);
  fill_with_nan(outputs.orientation.omega, 3);
  fill_with_nan(outputs.orientation.alpha, 3);
  for (Real* row : {outputs.position.value, outputs.position.first, outputs.position.second}) fill_with_nan(row, dim);
  return status;
}

template <class Real>
Status sample_at_both(const Trajectory& trajectory, const VectorCurve& positions, double time, size_t& cursor,
                      const PoseOutputs<Real>& outputs) {
  const Status of_trajectory = sample_at(trajectory, time, cursor, outputs.orientation);
  if (of_trajectory != Status::ok) return missing_pose(of_trajectory, outputs, positions.dim);
  size_t guess = cursor;
  const Status of_positions = sample_vector_at(positions, time, guess, outputs.position);
  return of_positions == Status::ok ? Status::ok : missing_pose(of_positions, outputs, positions.dim);
}

// Both curves in vectors. Where one of them has no value somewhere, which is rare, all is done again row by row.
template <class Real>
Outcome sample_both(const Trajectory& trajectory, const VectorCurve& positions, const TimeSource& source, size_t count,
                    const PoseOutputs<Real>& outputs) {
  size_t cursor = 0;
  if (outputs.has_orientation() && outputs.has_position()) {
    const Outcome of_trajectory = sample(trajectory, source, count, cursor, outputs.orientation);
    if (of_trajectory.status == Status::ok &&
        sample(positions, source, count, cursor, outputs.position).status == Status::ok)
      return {};
  }
  const TimeReader times(source, count);
  Outcome outcome;
  for (size_t i = 0; i < count; ++i) {
    const Status status = sample_at_both(trajectory, positions, times[i], cursor, from_row(outputs, i, positions.dim));
    if (status != Status::ok && outcome.status == Status::ok) outcome = {status, i};
  }
  return outcome;
}

}  // namespace

Outcome sample_poses(const Trajectory& trajectory, const VectorCurve& positions, const TimeSource& times, size_t count,
                     const PoseOutputs<double>& outputs) {
  return sample_both(trajectory, positions, times, count, outputs);
}
Outcome sample_poses(const Trajectory& trajectory, const VectorCurve& positions, const TimeSource& times, size_t count,
                     const PoseOutputs<float>& outputs) {
  return sample_both(trajectory, positions, times, count, outputs);
}

Status sample_pose_at(const Trajectory& trajectory, const VectorCurve& positions, double time, size_t& cursor,
                      const PoseOutputs<double>& outputs) {
  return sample_at_both(trajectory, positions, time, cursor, outputs);
}
Status sample_pose_at(const Trajectory& trajectory, const VectorCurve& positions, double time, size_t& cursor,
                      const PoseOutputs<float>& outputs) {
  return sample_at_both(trajectory, positions, time, cursor, outputs);
}

}  // namespace qtraj
