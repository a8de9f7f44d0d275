// Moments of weighted orientations: what an eigen mean takes of its samples. Those of parts are merged by adding them,
// so that parts may be elsewhere, or at another time.
#pragma once

#include "means/eigen_mean.hpp"

namespace qtraj {

// The sum of the weights w, then the upper triangle, row by row, of sum w q q^T over the samples, q made unit.
constexpr size_t kMomentCount = 11;

// Adds those of the samples to `moments` [11]; all or, on an error, nothing. The sum of weights is exact to 1 eps of
// it, and for samples without weights while it is below 2^53; of the triangle each element is within 4e-16 of the sum
// of weights, as in mean_eigen. Adding to what is there rounds once more, by 1.2e-16 of the result.
//
// not_finite, zero_norm, negative_weight: the first sample at fault. not_finite without an index: what is there is not
// finite, or a sum overflows. Weights that are all 0 add 0.
Outcome add_moments(WeightedOrientations samples, double* moments);

// The mean that they have, with w >= 0, where w is 0 with the first other component above 0. Each component is within
//   4e-16 + (4e-16 + 1.2e-16 d) / eigengap
// of that of all samples, d the most sums, in add_moments and of arrays, that the moments of a sample went through:
// rounding one sum is a change of the matrix by at most eps/2 of its norm, and a change E turns the eigenvector by
// |E| / (l1 - l2) in the first order.
//
// value: no moments, as the trace is not the sum of weights, or an eigenvalue is negative, by more than
// kMomentsTolerance of that sum. not_finite, negative_weight (their sum), zero_norm (it is 0): the mean is NaN.
// ambiguous as of mean_eigen, to 64 eps of double.
EigenMean mean_from_moments(const double* moments);

// What rounding may do to sums of some 1e8 arrays.
constexpr double kMomentsTolerance = 1e-8;

}  // namespace qtraj
