// What a mean is taken of: a caller's orientations and weights, checked once, then read in place by every pass.
#pragma once

#include "qtraj/rows.hpp"

namespace qtraj {

// q / |q| for finite q != 0 of any magnitude, each component within 2 eps of its size.
Quaternion unit(const Quaternion& q);

struct WeightedOrientations {
  Rows<4> q;
  Rows<1> weights;  // data may be null: all 1
  size_t count;
  // A power of two that takes the largest weight to below 4 and, where it is normal, to at least 1: sums of weights do
  // not overflow, and weights below 1e-308 of the largest become 0.
  double weight_scale = 1;

  // Rounding of the caller's type: what ties to within it is a tie.
  double epsilon() const;

  // To be called first: sets weight_scale and finds the first sample at fault. One of weight 0 can be at fault too.
  // Weights that are all 0 are zero_norm, without an index.
  Outcome check();

  double weight(size_t sample) const { return weights.data ? weight_scale * weights[sample][0] : 1.0; }
  Quaternion unit(size_t sample) const { return qtraj::unit(q[sample]); }

  // +-mean, the sign such that its dot product with the first sample of weight above 0 is >= 0; where it is 0, with the
  // next.
  Quaternion with_sign_of_first(const Quaternion& mean) const;
};

}  // namespace qtraj
