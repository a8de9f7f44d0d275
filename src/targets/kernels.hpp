// The kernels: the same functions in the namespace of every target, compiled from the same files for each.
//
// Times and rows that vectors leave are done one after the other by scalar code in the same arithmetic: of plain
// targets by the target scalar, of fused ones by scalar_fused, which is there for nothing else.
#pragma once

#include "curve/series_call.hpp"
#include "curve/vector_rows.hpp"
#include "rows/arguments.hpp"
#include "targets/targets.hpp"

namespace qtraj {

#define QTRAJ_DECLARE_KERNELS(name, arithmetic, runs_here, unused)                           \
  namespace name {                                                                           \
  SampleFunction<double> sample;                                                             \
  SampleFunction<float> sample;                                                              \
  SampleVectorsFunction<double> sample_vectors;                                              \
  SampleVectorsFunction<float> sample_vectors;                                               \
  SeriesFunction<double> sample_series;                                                      \
  SeriesFunction<float> sample_series;                                                       \
  size_t multiply(const BinaryRows<4, 4, 4>& rows, size_t first, size_t count);              \
  size_t dot(const BinaryRows<4, 4, 1>& rows, size_t first, size_t count);                   \
  size_t conjugate(const UnaryRows<4, 4>& rows, size_t first, size_t count);                 \
  size_t inverse(const UnaryRows<4, 4>& rows, size_t first, size_t count);                   \
  size_t norm(const UnaryRows<4, 1>& rows, size_t first, size_t count);                      \
  size_t matrix_from_q(const UnaryRows<4, 9>& rows, size_t first, size_t count);             \
  size_t q_from_matrix(const MatrixRows& rows, size_t first, size_t count);                  \
  size_t log(const UnaryRows<4, 3>& rows, size_t first, size_t count);                       \
  size_t rotation_vectors(const UnaryRows<4, 3>& rows, size_t first, size_t count);          \
  size_t exp(const ExpRows& rows, size_t first, size_t count);                               \
  size_t angles(const AngleRows& rows, size_t first, size_t count);                          \
  size_t pow(const BinaryRows<4, 1, 4>& rows, size_t first, size_t count);                   \
  size_t slerp(const PairRows& pairs, size_t first, size_t count);                           \
  size_t nlerp(const PairRows& pairs, size_t first, size_t count);                           \
  size_t fractions(const FractionRows& rows, size_t first, size_t count);                    \
  size_t mean_rates(const MeanRateRows& rows, size_t first, size_t count);                   \
  size_t rotate(const RotateRows& rows, size_t first, size_t count);                         \
  size_t derivatives_from_rates(const RatesToDerivatives& rows, size_t first, size_t count); \
  size_t rates_from_derivatives(const DerivativesToRates& rows, size_t first, size_t count); \
  size_t even_times(const EvenTimeRows& rows, size_t first, size_t count);                   \
  size_t seconds_from_ns(const NanosecondRows& rows, size_t first, size_t count);            \
  size_t normalize(const NormalizeRows& rows, size_t first, size_t count);                   \
  size_t make_continuous(const ContinuousRows& rows, size_t first, size_t count);            \
  size_t rows_from_columns(const RowsOfColumns<double>& table, size_t count);                \
  size_t rows_from_columns(const RowsOfColumns<float>& table, size_t count);                 \
  size_t columns_from_rows(const ColumnsOfRows<double>& table, size_t count);                \
  size_t columns_from_rows(const ColumnsOfRows<float>& table, size_t count);                 \
  size_t clean_keys(const CleanRows& rows, size_t first, size_t count);                      \
  size_t arcs(const ArcRows& rows, size_t first, size_t count);                              \
  size_t hermite(const HermiteRows& rows, size_t first, size_t count);                       \
  size_t squad_chords(const SquadRows& rows, size_t first, size_t count);                    \
  size_t squad_half_rates(const SquadRows& rows, size_t first, size_t count);                \
  size_t squad_segments(const SquadRows& rows, size_t first, size_t count);                  \
  size_t relative_rotations(const RelativeRotationRows& rows, size_t first, size_t count);   \
  size_t jacobians(const JacobianRecords& records, size_t first, size_t count);              \
  size_t raise_to_weights(const WeightRows& rows, size_t first, size_t count);               \
  size_t add_scatter(const ScatterRows& rows, size_t first, size_t count);                   \
  size_t add_logs(const LogRows& rows, size_t first, size_t count);                          \
  }
QTRAJ_EACH_TARGET(QTRAJ_DECLARE_KERNELS, )
QTRAJ_DECLARE_KERNELS(scalar_fused, fused, , )
#undef QTRAJ_DECLARE_KERNELS

// What is never done in vectors: one sample (sample_at), and a row of double within a given segment, up to its very
// ends (evaluate_in_double).
#define QTRAJ_DECLARE_SCALAR(name)                                                                     \
  namespace name {                                                                                     \
  SampleAtFunction<double> sample_at;                                                                  \
  SampleAtFunction<float> sample_at;                                                                   \
  Status evaluate_in_double(const Trajectory& trajectory, size_t segment, double elapsed, bool negate, \
                            const SampleOutputs<double>& outputs, size_t row);                         \
  }
QTRAJ_DECLARE_SCALAR(scalar)
QTRAJ_DECLARE_SCALAR(scalar_fused)
#undef QTRAJ_DECLARE_SCALAR

}  // namespace qtraj
