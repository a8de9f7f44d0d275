// Averages of orientations.
#pragma once

#include "qtraj/quaternion.hpp"
#include "qtraj/status.hpp"

namespace qtraj {

// Sum of w q q^T over samples.
class OrientationScatter {
 public:
  void add(const Quaternion& unit, double weight);

  // Its top eigenvector: the mean that minimises the weighted sum of squared chordal distances (F. L. Markley et al.,
  // "Averaging quaternions", J. Guidance 30 (2007), eq. 12). Sign as found. ambiguous where the two largest eigenvalues
  // tie to 64 epsilon of the sum of weights.
  Status top_eigenvector(double epsilon, Quaternion& mean) const;

 private:
  Eigen::Matrix4d sum_ = Eigen::Matrix4d::Zero();
};

}  // namespace qtraj
