// Passes over the samples of a mean. Plain arithmetic in a fixed order (block_rows.hpp): the same bits in all kernels.
// A quaternion of any ordinary norm stands for its unit one, and none is normalised.
#pragma once

#include <type_traits>

#include "block_rows.hpp"
#include "near_one.hpp"
#include "nearest_log.hpp"

namespace qtraj {
namespace {

// ---- Weights ----

template <class Real, class Number>
QTRAJ_INLINE bool raise_to_rows(const SampleArrays& samples, size_t row, Number& largest) {
  Number weight[1];
  if (!load_numbers<Real>({samples.weights, false}, row, weight) || !all(is_finite(weight[0]))) return false;
  if (any(weight[0] < Number(0.0))) return false;
  largest = select(largest < weight[0], weight[0], largest);
  return true;
}

template <class Vector>
size_t raise_to_weights(const SampleArrays& samples, double& largest) {
  Vector largest_of_vectors(largest);
  double largest_of_rows = largest;
  const size_t rows = do_rows<Vector>(samples.single, 0, samples.count, [&](size_t row, auto number, auto real) {
    if constexpr (std::is_same_v<decltype(number), Vector>)
      return raise_to_rows<decltype(real)>(samples, row, largest_of_vectors);
    else
      return raise_to_rows<decltype(real)>(samples, row, largest_of_rows);
  });
  const double of_vectors = largest_lane(largest_of_vectors);
  largest = of_vectors < largest_of_rows ? largest_of_rows : of_vectors;
  return rows;
}

// ---- Sums ----

// Samples `row`, `row` + 1, ...; false where they are not ordinary or do not count.
template <class Real, class Number>
QTRAJ_INLINE bool load_samples(const SampleArrays& samples, size_t row, Number (&q)[4], Number& weight) {
  if (!load_rows<Real>({samples.q, false}, row, q)) return false;
  weight = Number(1.0);
  if (!samples.weights) return true;
  Number given[1];
  if (!load_numbers<Real>({samples.weights, false}, row, given)) return false;
  weight = Number(samples.weight_scale) * given[0];
  return samples.is_padded || all(Number(0.0) < weight);
}

// w q q^T / |q|^2.
template <class Number>
QTRAJ_INLINE void scatter_terms(const Number (&q)[4], Number weight, Number (&terms)[10]) {
  const Number square = dot<Plain>(q, q), excess = square - Number(1.0);
  const auto is_near = is_near_one(excess);
  Number inverse = inverse_near_one<Plain>(excess);
  if (!all(is_near)) inverse = select(is_near, inverse, Number(1.0) / square);
  const Number scale = weight * inverse;
  size_t at = 0;
  for (size_t row = 0; row < 4; ++row) {
    const Number scaled = scale * q[row];
    for (size_t column = row; column < 4; ++column) terms[at++] = scaled * q[column];
  }
}

template <class Real, class Vector>
QTRAJ_INLINE bool add_scatter_block(const SampleArrays& samples, size_t first, size_t rows, ScatterSums& sums) {
  const auto terms_of = [&](size_t row, Vector(&terms)[10]) {
    Vector q[4], weight;
    if (!load_samples<Real>(samples, first + row, q, weight)) return false;
    scatter_terms(q, weight, terms);
    return true;
  };
  return add_block<Vector>(rows, terms_of, sums);
}

template <class Vector>
size_t add_scatter(const SampleArrays& samples, size_t first, ScatterSums& sums) {
  return do_blocks(first, samples.count, [&](size_t row, size_t rows) {
    return samples.single ? add_scatter_block<float, Vector>(samples, row, rows, sums)
                          : add_scatter_block<double, Vector>(samples, row, rows, sums);
  });
}

// w, w d^2, w d, w r and w [u u^T + d cot d (I - u u^T)], u = r/d.
template <class Number>
QTRAJ_INLINE void log_terms(const NearestLogOf<Number>& at, Number weight, Number (&terms)[12]) {
  const Number across = weight * at.across, along = (weight - across) * at.inverse;
  terms[0] = weight;
  terms[2] = weight * at.angle;
  terms[1] = terms[2] * at.angle;
  for (size_t k = 0; k < 3; ++k) terms[3 + k] = weight * at.log[k];
  size_t next = 6;
  for (size_t row = 0; row < 3; ++row) {
    const Number scaled = along * at.vector[row];
    terms[next++] = scaled * at.vector[row] + across;
    for (size_t column = row + 1; column < 3; ++column) terms[next++] = scaled * at.vector[column];
  }
}

template <class Real, class Vector>
QTRAJ_INLINE bool add_log_block(const SampleArrays& samples, size_t first, size_t rows, const double (&base)[4],
                                LogSums& sums) {
  const Vector from[4] = {Vector(base[0]), Vector(base[1]), Vector(base[2]), Vector(base[3])};
  Vector farthest(sums.farthest);
  const auto terms_of = [&](size_t row, Vector(&terms)[12]) {
    Vector q[4], weight;
    if (!load_samples<Real>(samples, first + row, q, weight)) return false;
    const NearestLogOf<Vector> at = nearest_log_of(from, q);
    log_terms(at, weight, terms);
    farthest = select(farthest < at.angle, at.angle, farthest);
    return true;
  };
  if (!add_block<Vector>(rows, terms_of, sums.sums)) return false;
  sums.farthest = largest_lane(farthest);
  return true;
}

template <class Vector>
size_t add_logs(const SampleArrays& samples, size_t first, const double (&base)[4], LogSums& sums) {
  return do_blocks(first, samples.count, [&](size_t row, size_t rows) {
    return samples.single ? add_log_block<float, Vector>(samples, row, rows, base, sums)
                          : add_log_block<double, Vector>(samples, row, rows, base, sums);
  });
}

}  // namespace
}  // namespace qtraj
