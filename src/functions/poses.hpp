// Orientations and positions at the same times.
#pragma once

#include "targets/sampling.hpp"

namespace qtraj {

template <class Real>
struct PoseOutputs {
  SampleOutputs<Real> orientation;
  VectorOutputs<Real> position;

  bool has_orientation() const { return orientation.q || orientation.omega || orientation.alpha; }
  bool has_position() const { return position.value || position.first || position.second; }
};

// A row that one of the curves has no value for is NaN in every output; its status is that of the trajectory, or else
// that of the positions. A curve without outputs is asked all the same.
Outcome sample_poses(const Trajectory& trajectory, const VectorCurve& positions, const double* times, size_t count,
                     const PoseOutputs<double>& outputs);
Outcome sample_poses(const Trajectory& trajectory, const VectorCurve& positions, const double* times, size_t count,
                     const PoseOutputs<float>& outputs);

// One of them. `cursor` is the segment of the trajectory, and serves the positions as well.
Status sample_pose_at(const Trajectory& trajectory, const VectorCurve& positions, double time, size_t& cursor,
                      const PoseOutputs<double>& outputs);
Status sample_pose_at(const Trajectory& trajectory, const VectorCurve& positions, double time, size_t& cursor,
                      const PoseOutputs<float>& outputs);

}  // namespace qtraj
