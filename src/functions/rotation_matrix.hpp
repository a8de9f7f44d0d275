// Rotation matrices, row-major, v_world = M v_body, from quaternions and back.
//
// eps is DBL_EPSILON; bounds are of the absolute error of each component. Faults of a row: not_finite where the input
// is not finite, zero_norm where a quaternion is 0.
#pragma once

#include "functions/for_each_row.hpp"
#include "rows/arguments.hpp"

namespace qtraj {

// M = (w^2 - |v|^2) I + 2 v v^T + 2 w [v] of q / |q| (M. Shuster, "A survey of attitude representations",
// J. Astronautical Sciences 41 (1993); his maps world to body and is the transpose). Within 3 eps.
Outcome matrix_from_q(const UnaryRows<4, 9>& rows, size_t count);

// How far a matrix M may be from the nearest rotation R, |M - R| in the Frobenius norm: what 0 stands for, and the most
// that can be asked for. Up to 1/2 all singular values are 1/2 or more, R is unique and the iteration below finds it.
constexpr double kMatrixLimit = 1e-3, kLargestMatrixLimit = 0.5;
inline bool is_matrix_limit(double limit) { return limit >= 0 && limit <= kLargestMatrixLimit; }

// The unit quaternion, w >= 0, of R: within 1 eps up to a distance of 1e-3, 2 eps up to 1/2; the distance within 4 eps.
// At w = 0, of the two the one whose largest vector component is positive. not_rotation where |M - R| exceeds the
// limit, or the determinant is negative.
//
// R is the limit of M <- M (3 I - M^T M) / 2, which converges quadratically (N. Higham, "Functions of Matrices" (2008),
// chapter 8, the Newton-Schulz iteration); q follows from it by the largest component (M. Shepperd, "Quaternion from
// rotation matrix", J. Guidance 1 (1978)), which is at least 1/2 and so divides without loss.
Outcome q_from_matrix(const MatrixRows& rows, size_t count);

}  // namespace qtraj
