// Many trajectories sampled at shared times.
#pragma once

#include "curve/series_call.hpp"

namespace qtraj {

// Writes all rows, those at fault with NaN; the outcome is that of the first row at fault, in the order of the outputs.
// Rows of a trajectory at many times are sampled run by run, like those of `sample`; others in vectors across
// trajectories (curve/sample_series.hpp). Both give the same bits.
Outcome sample_series(const SeriesCall& call, const SampleOutputs<double>& outputs);
Outcome sample_series(const SeriesCall& call, const SampleOutputs<float>& outputs);

}  // namespace qtraj
