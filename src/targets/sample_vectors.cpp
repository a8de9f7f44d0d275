// Sampling vector curves. Compiled for every target, with the same bits on all of them.
#include "targets/compiled.hpp"

#if defined(QTRAJ_VECTORS)
#include "rows/vector_batch.hpp"
#endif

namespace qtraj {
namespace QTRAJ_TARGET {

#if defined(QTRAJ_VECTORS)
#define QTRAJ_SAMPLE_VECTORS sample_vectors_in_batch
#else
#define QTRAJ_SAMPLE_VECTORS sample_vector_rows
#endif

Outcome sample_vectors(const VectorCurve& curve, const TimeSource& times, size_t count, size_t& cursor,
                       const VectorOutputs<double>& outputs) {
  const VzeroupperAtExit at_exit;
  return QTRAJ_SAMPLE_VECTORS(curve, times, count, cursor, outputs);
}

Outcome sample_vectors(const VectorCurve& curve, const TimeSource& times, size_t count, size_t& cursor,
                       const VectorOutputs<float>& outputs) {
  const VzeroupperAtExit at_exit;
  return QTRAJ_SAMPLE_VECTORS(curve, times, count, cursor, outputs);
}

#undef QTRAJ_SAMPLE_VECTORS

}  // namespace QTRAJ_TARGET
}  // namespace qtraj
