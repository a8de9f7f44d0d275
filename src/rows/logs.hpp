// The pass of a Karcher mean over the samples (means/log_moments.hpp), in the fixed order of sums.hpp and the
// arithmetic of the kernel: the same bits in all kernels of a kind.
#pragma once

#include "rows/means.hpp"
#include "rows/nearest_log.hpp"

namespace qtraj {
namespace {

// What one loop over the rows of a block leaves for the next: each step of the logs waits long for the one before, and
// a processor has too few instructions under way to fill that time with other rows.
struct LogBlock {
  double vector[3][kBlockRows], sine_squared[kBlockRows], weight[kBlockRows];
  double factor[kBlockRows];     // first RelativeOf::inverse, then what makes logs of the vectors
  double curvature[kBlockRows];  // first versine, then (1 - d cot d) / sine_squared
};

// Two loops over a block ask for rows ahead by turns, for every other vector of them: memory then works during both.
template <class Real, class Vector>
QTRAJ_INLINE void prefetch_by_turns(const SampleRows& samples, size_t first, size_t row, size_t loop) {
  constexpr size_t kLanes = kLanesOf<Vector>;
  if (row / kLanes % 2 == loop) prefetch_samples<Real, kLanes>(samples, first + row);
}

template <class Arithmetic, class Real, bool kWeighted, class Vector>
QTRAJ_INLINE bool relate_block(const SampleRows& samples, size_t first, size_t rows, const double* base,
                               LogBlock& block) {
  const Vector from[4] = {Vector(base[0]), Vector(base[1]), Vector(base[2]), Vector(base[3])};
  for (size_t row = 0; row < rows; row += kLanesOf<Vector>) {
    Vector q[4], weight;
    RelativeOf<Vector> to;
    prefetch_by_turns<Real, Vector>(samples, first, row, 0);
    if (!load_samples<Real, kWeighted>(samples, first + row, q, weight) || !relate<Arithmetic>(from, q, to))
      return false;
    for (size_t k = 0; k < 3; ++k) store_lanes(to.q[k + 1], &block.vector[k][row]);
    if constexpr (kWeighted) store_lanes(weight, &block.weight[row]);
    store_lanes(to.sine_squared, &block.sine_squared[row]);
    store_lanes(to.inverse, &block.factor[row]);
    store_lanes(versine_of<Arithmetic>(to), &block.curvature[row]);
  }
  return true;
}

template <class Arithmetic, class Real, class Vector>
QTRAJ_INLINE void find_log_factors(const SampleRows& samples, size_t first, size_t rows, LogBlock& block) {
  const Vector one(1.0);
  for (size_t row = 0; row < rows; row += kLanesOf<Vector>) {
    prefetch_by_turns<Real, Vector>(samples, first, row, 1);
    const Vector versine = load_lanes(&block.curvature[row], Vector()),
                 ratio = evaluate<Arithmetic, AcosRatio>(versine);
    // ratio cos d = d cot d; where sin d is 0 so is the vector, whatever it is multiplied by
    const Vector sine_squared = load_lanes(&block.sine_squared[row], Vector()) + Vector(0x1p-700);
    store_lanes(ratio * load_lanes(&block.factor[row], Vector()), &block.factor[row]);
    store_lanes(Arithmetic::multiply_add(ratio, versine - one, one) / sine_squared, &block.curvature[row]);
  }
}

// Adds w, w d^2, w r and w (1 - d cot d) u u^T, u = r/d.
template <class Arithmetic, bool kWeighted, class Vector>
QTRAJ_INLINE void add_log_terms(const LogBlock& block, size_t row, Vector (&sum)[11], Vector& largest_square) {
  const auto load = [&](const double(&numbers)[kBlockRows]) { return load_lanes(&numbers[row], Vector()); };
  const Vector weight = kWeighted ? load(block.weight) : Vector(1.0), factor = load(block.factor);
  const Vector x = load(block.vector[0]), y = load(block.vector[1]), z = load(block.vector[2]);

  const Vector angle_squared = factor * factor * load(block.sine_squared), toward = weight * factor;
  const Vector along = weight * load(block.curvature), from_x = along * x, from_y = along * y, from_z = along * z;
  largest_square = maximum(largest_square, angle_squared);
  const Vector left[] = {weight, weight, toward, toward, toward, from_x, from_x, from_x, from_y, from_y, from_z};
  const Vector right[] = {Vector(1.0), angle_squared, x, y, z, x, y, z, y, z, z};
  add_products<Arithmetic>(left, right, sum);
}

template <class Arithmetic, class Real, bool kWeighted, class Vector>
QTRAJ_INLINE bool add_log_block(const SampleRows& samples, size_t first, size_t rows, const double* base,
                                LogSums& sums) {
  LogBlock block;
  if (!relate_block<Arithmetic, Real, kWeighted, Vector>(samples, first, rows, base, block)) return false;
  find_log_factors<Arithmetic, Real, Vector>(samples, first, rows, block);
  Vector largest_square(sums.largest_square);
  const auto add_terms = [&](size_t row, Vector(&sum)[11]) {
    add_log_terms<Arithmetic, kWeighted>(block, row, sum, largest_square);
    return true;
  };
  add_block<Vector>(rows, add_terms, sums.sums);
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
