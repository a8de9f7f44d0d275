// The project's vectors and matrices, Eigen types of fixed size, and the only place that includes Eigen: parsing it
// takes most files longer than all else, so that this header is precompiled. Quaternions are w x y z, as in the C API.
#pragma once

#include <Eigen/Core>

namespace qtraj {

using Vector3 = Eigen::Vector3d;
using Quaternion = Eigen::Vector4d;
using Matrix3 = Eigen::Matrix3d;
using Matrix4 = Eigen::Matrix4d;
template <size_t Width>
using Row = Eigen::Matrix<double, static_cast<int>(Width), 1>;

}  // namespace qtraj
