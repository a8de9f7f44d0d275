// Sampling into double, and scalar code for single samples. Compiled for every target; sampling into float is a file of
// its own, because each takes the compiler long.
#include "targets/compiled.hpp"

#if defined(QTRAJ_VECTORS)
#include "curve/sample_many.hpp"
#include "curve/sample_series.hpp"
#else
#include "curve/sample_one.hpp"
#endif

namespace qtraj {
namespace QTRAJ_TARGET {

#if defined(QTRAJ_VECTORS)

Outcome sample(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor,
               const SampleOutputs<double>& outputs) {
  const VzeroupperAtExit at_exit;
  return sample_many<Arithmetic, double, QTRAJ_SCALAR::sample, QTRAJ_SCALAR::sample_at>(trajectory, times, count,
                                                                                        cursor, outputs);
}

Outcome sample_series(const SeriesCall& call, const SampleOutputs<double>& outputs) {
  const VzeroupperAtExit at_exit;
  return qtraj::sample_series<Arithmetic, double, QTRAJ_SCALAR::sample_at>(call, outputs);
}

#else

Outcome sample(const Trajectory& trajectory, const TimeSource& times, size_t count, size_t& cursor,
               const SampleOutputs<double>& outputs) {
  const VzeroupperAtExit at_exit;
  return sample_one_by_one<Arithmetic, double, evaluate_in_double>(trajectory, times, count, cursor, outputs);
}

Outcome sample_series(const SeriesCall& call, const SampleOutputs<double>& outputs) {
  const VzeroupperAtExit at_exit;
  return sample_series_one_by_one<Arithmetic, double, evaluate_in_double>(call, outputs);
}

Status sample_at(const Trajectory& trajectory, double time, size_t& cursor, const SampleOutputs<double>& outputs) {
  const VzeroupperAtExit at_exit;
  return sample_one<Arithmetic, double, evaluate_in_double>(trajectory, time, cursor, outputs);
}

Status evaluate_in_double(const Trajectory& trajectory, size_t segment, double elapsed, bool negate,
                          const SampleOutputs<double>& outputs, size_t row) {
  const VzeroupperAtExit at_exit;
  return row_evaluator<Arithmetic, double, evaluate_in_double>(trajectory, outputs)(trajectory, segment, elapsed,
                                                                                    negate, outputs, row);
}

#endif

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
