// The samples of a mean, and the pass of the eigen mean over them: plain arithmetic in the fixed order of sums.hpp, the
// same bits in all kernels. A quaternion of any ordinary norm stands for its unit one; the terms are divided by |q|^2
// instead of normalising it.
#pragma once

#include "math/unit_quaternion.hpp"
#include "rows/sums.hpp"
#include "simd/prefetch.hpp"

namespace qtraj {
namespace {

// ---- Weights ----

template <class Number>
size_t raise_to_weights(const WeightRows& rows, size_t first, size_t count) {
  return do_rows_for_largest<Number>(
      rows.weights.is_float, first, count, *rows.largest, [&](size_t row, Number& largest, auto real) {
        Number weight[1];
        if (!load_own_numbers<decltype(real)>(rows.weights, row, weight) || !all(is_finite(weight[0]))) return false;
        if (any(weight[0] < Number(0.0))) return false;
        largest = maximum(largest, weight[0]);
        return true;
      });
}

// ---- Sums ----

// Prefetches kRows samples three blocks after `row`.
template <class Real, size_t kRows>
QTRAJ_INLINE void prefetch_samples(const SampleRows& samples, size_t row) {
  constexpr size_t kRowsAhead = 3 * kBlockRows;
  if (samples.q.rows - row < kRowsAhead + kRows) return;
  prefetch_for_reading(static_cast<const Real*>(samples.q.data) + 4 * (row + kRowsAhead), 4 * kRows * sizeof(Real));
}

// Loads samples `row`, `row` + 1, ...; false where one has weight 0 and is no padding, or is not ordinary and has a
// component of magnitude 2 or more. Of all others that are not ordinary |q|^2 is far from 1: callers test for these
// only where they find such a square.
template <class Real, bool kWeighted, class Number>
QTRAJ_INLINE bool load_samples(const SampleRows& samples, size_t row, Number (&q)[4], Number& weight) {
  if (!load_own_numbers<Real>(samples.q, row, q)) return false;
  if (any(reaches_two(q)) && !all(is_ordinary(q))) return false;
  weight = Number(1.0);
  if constexpr (!kWeighted) return true;
  Number given[1];
  if (!load_own_numbers<Real>(samples.weights, row, given)) return false;
  weight = Number(samples.weight_scale) * given[0];
  return samples.is_padded || all(Number(0.0) < weight);
}

// Adds the terms w q q^T / |q|^2, upper triangle; false where a q is not ordinary.
template <class Number>
QTRAJ_INLINE bool add_scatter_terms(const Number (&q)[4], Number weight, Number (&sum)[10]) {
  const Number square = dot_product<Plain>(q, q), excess = square - Number(1.0);
  const auto is_near = is_near_one(excess);
  Number inverse = inverse_near_one<Plain>(excess);
  if (!all(is_near)) {
    if (!all(is_ordinary(q))) return false;
    inverse = select(is_near, inverse, Number(1.0) / square);
  }
  const Number scale = weight * inverse, s[4] = {scale * q[0], scale * q[1], scale * q[2], scale * q[3]};
  const Number left[] = {s[0], s[0], s[0], s[0], s[1], s[1], s[1], s[2], s[2], s[3]};
  const Number right[] = {q[0], q[1], q[2], q[3], q[1], q[2], q[3], q[2], q[3], q[3]};
  add_products<Plain>(left, right, sum);
  return true;
}

template <class Real, bool kWeighted, class Vector>
QTRAJ_INLINE bool add_scatter_block(const SampleRows& samples, size_t first, size_t rows, ScatterSums& sums) {
  const auto add_terms = [&](size_t row, Vector(&sum)[10]) {
    Vector q[4], weight;
    prefetch_samples<Real, kLanesOf<Vector>>(samples, first + row);
    return load_samples<Real, kWeighted>(samples, first + row, q, weight) && add_scatter_terms(q, weight, sum);
  };
  if (!add_rows<Vector>(rows, add_terms, sums)) return discard_block(sums);
  if (!samples.stays_open) close_block<Vector>(sums);
  return true;
}

// Adds the blocks of samples from `first` on, each by add_block(row, rows, real, is_weighted): `real` has the type of
// the arrays' numbers, is_weighted is std::true_type where there are weights.
template <class AddBlock>
QTRAJ_INLINE size_t add_blocks(const SampleRows& samples, size_t first, size_t count, const AddBlock& add_block) {
  const auto add = [&](auto real, auto is_weighted) {
    return do_blocks(first, count, [&](size_t row, size_t rows) { return add_block(row, rows, real, is_weighted); });
  };
  if (samples.weights.data)
    return samples.q.is_float ? add(float(), std::true_type()) : add(double(), std::true_type());
  return samples.q.is_float ? add(float(), std::false_type()) : add(double(), std::false_type());
}

template <class Number>
size_t add_scatter(const ScatterRows& rows, size_t first, size_t count) {
  return add_blocks(rows.samples, first, count, [&](size_t row, size_t block, auto real, auto is_weighted) {
    return add_scatter_block<decltype(real), decltype(is_weighted)::value, Number>(rows.samples, row, block,
                                                                                   *rows.sums);
  });
}

}  // namespace
}  // namespace qtraj
