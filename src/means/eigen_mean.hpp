// The eigen mean of orientations, and the spectrum of their scatter matrix, from which the Karcher mean starts.
#pragma once

#include <limits>

#include "base/series.hpp"
#include "base/status.hpp"
#include "math/block_sum.hpp"
#include "math/quaternion.hpp"
#include "means/weighted_orientations.hpp"

namespace qtraj {

// Eigenvalues of a scatter matrix, in decreasing order, and its eigenvectors, orthonormal to rounding.
struct Spectrum {
  double values[4];
  Quaternion vectors[4];  // signs as found
  double sum_of_weights;

  // (l1 - l2) / sum of weights, in [0, 1]: 1 where all orientations are equal.
  double eigengap() const;
  // Whether the two largest eigenvalues are equal to rounding: any vector of their plane is then a top eigenvector.
  bool ties(double epsilon) const { return eigengap() <= 64.0 * epsilon; }
};

// A scatter matrix by its upper triangle, row by row.
using ScatterTriangle = double[10];
Spectrum spectrum_of(const ScatterTriangle& scatter);

// The scatter matrix: the sum of w q q^T over samples, their quaternions made unit.
class OrientationScatter {
 public:
  // Adds a sample: finite q != 0 of any norm, weight above 0.
  void add(const Quaternion& q, double weight);

  // Adds all samples of weight above 0; false where one is at fault.
  bool add(const WeightedOrientations& samples);

  void read(ScatterTriangle& scatter);
  Spectrum spectrum();

  // Its top eigenvector: the mean that minimises the weighted sum of squared chordal distances (F. L. Markley et al.,
  // "Averaging quaternions", J. Guidance 30 (2007), eq. 12). Sign as found. ambiguous where the two largest eigenvalues
  // tie to 64 epsilon of the sum of weights.
  Status top_eigenvector(double epsilon, Quaternion& mean);

 private:
  void add_part(const SampleRows& rows);

  BlockSum<10> sum_;   // upper triangle, row by row
  SampleBlock block_;  // samples not yet in the sum
};

// The first pass over samples: scales their weights and finds the first sample at fault. Those of weight 0 are left
// out.
Outcome scatter_of(WeightedOrientations& samples, OrientationScatter& scatter);

struct EigenMean {
  Outcome outcome;
  Quaternion q = Quaternion::Constant(std::numeric_limits<double>::quiet_NaN());
  double eigengap = std::numeric_limits<double>::quiet_NaN();
};

// Top eigenvector of sum w q q^T over the normalised samples; the sign is that of the first sample of weight above 0.
// Each component within 4e-16 + 4e-16 / eigengap, for any number of samples, float samples too before the rounding to
// float. Bits do not depend on the signs of the samples but for the sign of the mean.
//
// Singular: where the two largest eigenvalues tie (eigengap <= 64 eps of the samples' type) the mean is ambiguous, and
// one of the top eigenvectors is given. A sample at fault or weights that are all 0: q and eigengap are NaN.
EigenMean mean_eigen(WeightedOrientations samples);

// The same of each of many groups of samples.
struct GroupedOrientations {
  Input<4> q;        // indexed by the offsets
  Input<1> weights;  // indexed by the offsets; data may be null: all 1
  Series groups;     // checked
};
// A row of the means, and a number of the eigengaps, where there are any, for each group; too_few and NaN where it is
// empty. The outcome is that of the first group at fault.
Outcome mean_eigen_of_each(const GroupedOrientations& samples, const Output<4>& means, double* eigengaps,
                           int32_t* statuses);

}  // namespace qtraj
