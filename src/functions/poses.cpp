#include "functions/poses.hpp"

#include <algorithm>

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

// Rows in vectors, where both curves are asked for and have values; false, and rows that may have been written, where
// they have not.
template <class Real>
bool sample_in_vectors(const Trajectory& trajectory, const VectorCurve& positions, const TimeSource& times,
                       size_t count, const PoseOutputs<Real>& outputs) {
  if (!outputs.has_orientation() || !outputs.has_position()) return false;
  size_t cursor = 0;
  return sample(trajectory, times, count, cursor, outputs.orientation).status == Status::ok &&
         sample(positions, times, count, cursor, outputs.position).status == Status::ok;
}

// Block by block; one in which a curve has no value somewhere is done again row by row.
template <class Real>
Outcome sample_both(const Trajectory& trajectory, const VectorCurve& positions, const double* times, size_t count,
                    const PoseOutputs<Real>& outputs) {
  constexpr size_t kBlock = 1024;
  size_t cursor = 0;
  Outcome outcome;
  for (size_t first = 0; first < count; first += kBlock) {
    const size_t rows = std::min(kBlock, count - first);
    const TimeSource source = {times + first, 0, 0};
    if (sample_in_vectors(trajectory, positions, source, rows, from_row(outputs, first, positions.dim))) continue;
    const TimeReader read(source, rows);
    for (size_t row = first; row < first + rows; ++row) {
      const Status status =
          sample_at_both(trajectory, positions, read[row - first], cursor, from_row(outputs, row, positions.dim));
      if (status != Status::ok && outcome.status == Status::ok) outcome = {status, row};
    }
  }
  return outcome;
}

}  // namespace

Outcome sample_poses(const Trajectory& trajectory, const VectorCurve& positions, const double* times, size_t count,
                     const PoseOutputs<double>& outputs) {
  return sample_both(trajectory, positions, times, count, outputs);
}
Outcome sample_poses(const Trajectory& trajectory, const VectorCurve& positions, const double* times, size_t count,
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
