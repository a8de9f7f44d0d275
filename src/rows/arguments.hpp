// The arguments of kernels over rows: callers' arrays and what goes with them. All kernels have one signature,
//   size_t kernel(const Rows& rows, size_t first, size_t count).
// A kernel does rows from `first` on and returns how many: all up to `count`, or those before the first row that is not
// ordinary (row_loop.hpp). That row goes back to the core, which does it and calls the kernel again from the next one
// on (functions/for_each_row.hpp). Whether a row is ordinary depends on the row alone, not on its neighbours in a
// vector.
#pragma once

#include "base/array.hpp"
#include "base/settings.hpp"
#include "curve/segment.hpp"
#include "math/block_sum.hpp"

namespace qtraj {

template <class Rows>
using RowKernel = size_t (*)(const Rows& rows, size_t first, size_t count);

// q between a and b.
struct PairRows {
  Input<4> a, b;
  Input<1> fraction;
  Path path;
  Output<4> q;
};

// Times as fractions of intervals, from time_a on. Intervals that are empty, tiny or extreme, and times that are not
// inside theirs, are not ordinary.
struct FractionRows {
  Input<1> times, time_a, time_b;
  double* fraction;
};

// exp(scale v), scale a power of two.
struct ExpRows {
  Input<3> v;
  double scale;
  Output<4> q;
};

// The angle between a and b in R^4, or that by which the body turns: twice that to the nearer of b and -b.
struct AngleRows {
  Input<4> a, b;
  bool is_turn;  // arrays of double only
  Output<1> angle;
};

struct RotateRows {
  Input<4> q_wb;
  Input<3> v_body;
  Output<3> v_world;
};

// Times `begin`, `begin` + 1, ... of `count` even ones (functions/even_times.hpp), the ends as they are computed too;
// `scale` is the power of two that takes the larger end to [1, 2). First and last in order.
struct EvenTimeRows {
  double first, last, scale;
  size_t count, begin;
  double* times;
};

// Seconds from `origin`. Stamps more than 2^53 ns from it are not ordinary.
struct NanosecondRows {
  const int64_t* ns;
  int64_t origin;
  double* seconds;
};

// Derivatives of q / |q| from rates, and back; alpha and the second derivative may have no data.
struct RatesToDerivatives {
  Frame frame;
  Input<4> q_wb;
  Input<3> omega, alpha;
  OutputPair<4> derivatives;
};
struct DerivativesToRates {
  Frame frame;
  Input<4> q_wb, dq, ddq;
  OutputPair<3> rates;
};

// Mean rates from each row to the next one, `count` of rows that are one more; t_mid may have no data. Neighbours about
// half a turn apart, and times that are out of order or extreme, are not ordinary.
struct MeanRateRows {
  Frame frame;
  Input<1> times;
  Input<4> q_wb;
  Output<1> t_mid;
  Output<3> omega;
};

// Matrices, row-major, quaternions, and how far a matrix is from the nearest rotation (data may be null).
struct MatrixRows {
  Input<9> matrix;
  double limit;  // how far it may be; not 0
  Output<4> q;
  Output<1> distance;
};

struct NormalizeRows {
  Input<4> q;
  Output<4> q_out;
};

// Keys made continuous in sign with the row before `first`, which is done; flips counts the rows that are negated.
struct ContinuousRows {
  Input<4> q;
  Output<4> q_out;
  size_t* flips;
};

// A table as columns of `count` numbers each, and as rows of `width` numbers.
template <class Real>
struct RowsOfColumns {
  const Real* const* columns;  // [width]
  size_t width;
  Real* rows;
};
template <class Real>
struct ColumnsOfRows {
  const Real* rows;
  size_t width;
  Real* const* columns;  // [width]
};

// What cleaning of keyframes found; users see it through the getters.
struct KeyframeReport {
  size_t sign_flips = 0;
  double worst_norm_error = 0;
  double least_dot = 1;
};

// Keys made unit and, unless signs are kept, continuous in sign with the key before `first`, which is done. Two keys
// half a turn apart are not ordinary.
struct CleanRows {
  Input<4> q;
  bool keeps_signs;
  double (*unit)[4];
  double (*unit_error)[4];  // rounding errors of unit
  KeyframeReport* report;
};

// The keys of a curve (methods/keyframes.hpp), for kernels over its segments: segment i lies between keys i and i + 1.
struct KeyArrays {
  const double* times;
  const double (*q)[4];
  const double (*q_error)[4];
};

// Arcs from key to key. Those between nearly opposite keys, and those whose rate would be 0, are not ordinary.
struct ArcRows {
  KeyArrays keys;
  ArcSegment* segments;
};

// Cubics from key to key with given rates (HERMITE). Segments whose steps may make whole turns, whose keys are more
// than half a turn apart or whose rates are extreme are not ordinary.
struct HermiteRows {
  KeyArrays keys;
  Input<3> omega;
  bool is_world;          // the frame of omega
  bool turns_from_rates;  // as the rates say, or by none of them
  double epsilon;         // of the type that keys came in
  RotationVectorSegment<3>* segments;
  double* bound;  // raised to that of |p| over the segments
};

// SQUAD in three passes (rows/squad.hpp): over segments the outer arcs and the logs, over keys the half rates by the
// tangent rule, over segments all else.
struct SquadRows {
  KeyArrays keys;
  Tangent rule;            // not GIVEN
  double (*half_rate)[3];  // of keys
  double (*log)[3];        // of segments
  NestedArcsSegment* segments;
};

// Rotations from a to b, unit quaternions in double-double. All rows are ordinary.
struct RelativeRotationRows {
  Input<4> a, a_error, b, b_error;
  double (*rotation)[4];  // sin_part and angle (so3.hpp)
};

// Numbers in records, the pointers to those of the first record and `stride` doubles from one record to the next. A
// rotation vector of more than half a turn is not ordinary.
struct JacobianRecords {
  const double* r;   // [3], a rotation vector
  double* jacobian;  // [9], Jr(r), column by column
  double* turning;   // [3], the factors of beta
  size_t stride;
};

// The samples of a mean.
struct SampleRows {
  Input<4> q;
  Input<1> weights;     // data null: all 1
  double weight_scale;  // a power of two
  bool is_padded;       // rows of weight 0 are padding of the last lanes
  bool stays_open;      // the block of a sum that these rows begin goes on with those of the next call
};

// The largest of the weights up to one that is not finite or negative: `largest` is raised to it.
struct WeightRows {
  Input<1> weights;
  double* largest;
};

// Sums over samples, in whole blocks (block_sum.hpp): up to the first block with a sample that is not ordinary or has
// weight 0, or whose rows do not fill the lanes. Weights are finite and not negative.
//
// Scatter: the upper triangle of sum w q q^T, q made unit, row by row.
using ScatterSums = BlockSum<10>;
struct ScatterRows {
  SampleRows samples;
  ScatterSums* sums;
};
// In the notation of log_moments.hpp: W, f, sum w r, the upper triangle of sum w (1 - d cot d) u u^T; largest d^2.
struct LogSums {
  BlockSum<11> sums;
  double largest_square = 0;
};
struct LogRows {
  SampleRows samples;
  const double* base;  // [4], unit
  LogSums* sums;
};

}  // namespace qtraj
