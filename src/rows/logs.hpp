// The pass of a Karcher mean over the samples (means/log_moments.hpp), in the fixed order of sums.hpp and the target's
// arithmetic: all fused targets give the same bits, and all plain ones.
#pragma once

#include "rows/means.hpp"
#include "rows/nearest_log.hpp"

namespace qtraj {
namespace {

// A tile is a part of the rows of one block of a sum. Three short loops go over it, and this is what each leaves for
// the next. A log is one long dependency chain, and the out-of-order window is too small to overlap it with those of
// other rows; short loops are bound by throughput instead of latency.
constexpr size_t kTileRows = 32;
struct LogTile {
  // Of the first loop.
  double vector[3][kTileRows], sine_squared[kTileRows];  // of RelativeOf
  double weight[kTileRows];
  // Of the first loop, and in their places of the second.
  union {
    double inverse[kTileRows];  // of RelativeOf
    double factor[kTileRows];   // times the vector it is the log
  };
  union {
    double versine[kTileRows];
    double curvature[kTileRows];  // (1 - d cot d) / sine_squared
  };
};

// Prefetch alternates between two loops over a tile, each prefetching every other vector of rows: memory is then busy
// during both.
template <class Real, class Vector>
QTRAJ_INLINE void prefetch_alternately(const SampleRows& samples, size_t first, size_t row, size_t loop) {
  constexpr size_t kLanes = kLanesOf<Vector>;
  if (row / kLanes % 2 == loop) prefetch_samples<Real, kLanes>(samples, first + row);
}

// The first loop; false where a sample is not ordinary or has weight 0.
template <class Arithmetic, class Real, bool kWeighted, class Vector>
QTRAJ_INLINE bool relate_tile(const SampleRows& samples, size_t first, size_t rows, const double* base, LogTile& tile) {
  const Vector from[4] = {Vector(base[0]), Vector(base[1]), Vector(base[2]), Vector(base[3])};
  for (size_t row = 0; row < rows; row += kLanesOf<Vector>) {
    Vector q[4], weight;
    RelativeOf<Vector> to;
    prefetch_alternately<Real, Vector>(samples, first, row, 0);
    if (!load_samples<Real, kWeighted>(samples, first + row, q, weight) || !relate<Arithmetic>(from, q, to))
      return false;
    for (size_t k = 0; k < 3; ++k) store_lanes(to.q[k + 1], &tile.vector[k][row]);
    if constexpr (kWeighted) store_lanes(weight, &tile.weight[row]);
    store_lanes(to.sine_squared, &tile.sine_squared[row]);
    store_lanes(to.inverse, &tile.inverse[row]);
    store_lanes(versine_of<Arithmetic>(to), &tile.versine[row]);
  }
  return true;
}

// The second loop.
template <class Arithmetic, class Real, class Vector>
QTRAJ_INLINE void find_log_factors(const SampleRows& samples, size_t first, size_t rows, LogTile& tile) {
  const Vector one(1.0);
  for (size_t row = 0; row < rows; row += kLanesOf<Vector>) {
    prefetch_alternately<Real, Vector>(samples, first, row, 1);
    const Vector versine = load_lanes(&tile.versine[row], Vector()), ratio = evaluate<Arithmetic, AcosRatio>(versine);
    // ratio cos d = d cot d; where sin d is 0 the vector is 0 as well, and any finite quotient will do
    const Vector sine_squared = load_lanes(&tile.sine_squared[row], Vector()) + Vector(0x1p-700);
    store_lanes(ratio * load_lanes(&tile.inverse[row], Vector()), &tile.factor[row]);
    store_lanes(Arithmetic::multiply_add(ratio, versine - one, one) / sine_squared, &tile.curvature[row]);
  }
}

// The third loop adds the terms w, w d^2, w r and w (1 - d cot d) u u^T, u = r/d.
template <class Arithmetic, bool kWeighted, class Vector>
QTRAJ_INLINE void add_log_terms(const LogTile& tile, size_t row, Vector (&sum)[11], Vector& largest_square) {
  const auto load = [&](const double(&numbers)[kTileRows]) { return load_lanes(&numbers[row], Vector()); };
  const Vector weight = kWeighted ? load(tile.weight) : Vector(1.0), factor = load(tile.factor);
  const Vector x = load(tile.vector[0]), y = load(tile.vector[1]), z = load(tile.vector[2]);

  const Vector angle_squared = factor * factor * load(tile.sine_squared), toward = weight * factor;
  const Vector along = weight * load(tile.curvature), from_x = along * x, from_y = along * y, from_z = along * z;
  largest_square = maximum(largest_square, angle_squared);
  const Vector left[] = {weight, weight, toward, toward, toward, from_x, from_x, from_x, from_y, from_y, from_z};
  const Vector right[] = {Vector(1.0), angle_squared, x, y, z, x, y, z, y, z, z};
  add_products<Arithmetic>(left, right, sum);
}

template <class Arithmetic, class Real, bool kWeighted, class Vector>
QTRAJ_INLINE bool add_log_block(const SampleRows& samples, size_t first, size_t rows, const double* base,
                                LogSums& sums) {
  LogTile tile;
  Vector largest_square(sums.largest_square);
  const auto add_terms = [&](size_t row, Vector(&sum)[11]) {
    add_log_terms<Arithmetic, kWeighted>(tile, row, sum, largest_square);
    return true;
  };
  for (size_t done = 0; done < rows; done += kTileRows) {
    const size_t in_tile = rows - done < kTileRows ? rows - done : kTileRows;
    if (!relate_tile<Arithmetic, Real, kWeighted, Vector>(samples, first + done, in_tile, base, tile))
      return discard_block(sums.sums);
    find_log_factors<Arithmetic, Real, Vector>(samples, first + done, in_tile, tile);
    add_rows<Vector>(in_tile, add_terms, sums.sums);
  }
  if (!samples.stays_open) close_block<Vector>(sums.sums);
  sums.largest_square = largest_lane(largest_square);
  return true;
}

template <class Arithmetic, class Number>
size_t add_logs(const LogRows& rows, size_t first, size_t count) {
  return add_blocks(rows.samples, first, count, [&](size_t row, size_t block, auto real, auto is_weighted) {
    return add_log_block<Arithmetic, decltype(real), decltype(is_weighted)::value, Number>(rows.samples, row, block,
                                                                                           rows.base, *rows.sums);
  });
}

}  // namespace
}  // namespace qtraj
