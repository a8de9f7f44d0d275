// Sampling vector curves one time after the other: each finds its segment and is evaluated there. The vectors of
// vector_batch.hpp equal it bit for bit, and leave to it what they cannot do: rows at fault, times outside the knots,
// curves of extreme numbers.
#pragma once

#include "base/status.hpp"
#include "curve/sample_call.hpp"
#include "curve/vector_curve.hpp"

namespace qtraj {

// Rows of `dim` numbers to write, float or double; each may be null.
template <class Real>
struct VectorOutputs {
  Real *value, *first, *second;
};
template <class Real>
static inline VectorOutputs<Real> from_row(const VectorOutputs<Real>& outputs, size_t row, size_t dim) {
  const auto at = [&](Real* to) { return to ? to + row * dim : nullptr; };
  return {at(outputs.value), at(outputs.first), at(outputs.second)};
}

// Samples at the times. Every row is written, one at fault with NaN; the outcome is that of the first row at fault.
// `cursor`, a segment index or any other number, says which segment to try first, and receives one that was used.
template <class Real>
using SampleVectorsFunction = Outcome(const VectorCurve& curve, const TimeSource& times, size_t count, size_t& cursor,
                                      const VectorOutputs<Real>& outputs);

// One sample: not_finite, time_range, gap or ok.
Status sample_vector_at(const VectorCurve& curve, double time, size_t& cursor, const VectorOutputs<double>& outputs);
Status sample_vector_at(const VectorCurve& curve, double time, size_t& cursor, const VectorOutputs<float>& outputs);

// Several, one after the other.
SampleVectorsFunction<double> sample_vector_rows;
SampleVectorsFunction<float> sample_vector_rows;

// The keys [key_count][dim], of their own size.
void copy_vector_keys(const VectorCurve& curve, double* values);

}  // namespace qtraj
