// A vector of samples, one row per lane: its rates converted to time, and the rows written. What sample_output.hpp is
// for one row.
#pragma once

#include "curve/sample_output.hpp"
#include "simd/prefetch.hpp"
#include "simd/transpose.hpp"

namespace qtraj {
namespace {

template <class Real>
struct WideRow {
  Wide<Real> q[4];
  Rates<Wide<Real>> rates;
};

template <class Real>
QTRAJ_NOINLINE void copy_numbers(const Real* from, size_t count, Real* to) {
  for (size_t k = 0; k < count; ++k) to[k] = from[k];
}

// Writes `rows` <= kLanes rows. All lanes are written where the output has so many rows left from this one on.
template <class Real, size_t Size>
QTRAJ_INLINE void write_wide(const Wide<Real> (&v)[Size], Real* to, size_t row, size_t rows, size_t left) {
  constexpr size_t kLanes = Wide<Real>::kLanes;
  prefetch_output<Real, Size, kLanes>(to, row, row + left);
  if (left >= kLanes) return store_interleaved(v, to + Size * row);
  Real lanes[Size * Wide<Real>::kLanes];
  store_interleaved(v, lanes);
  copy_numbers(lanes, Size * rows, to + Size * row);
}

// Lanes in which a number is NaN or its magnitude past the limit become 0 in all numbers; false where there are any.
template <size_t Size>
QTRAJ_INLINE bool limit_lanes(double limit, Wide<double> (&numbers)[Size]) {
  const Wide<double> zero(0.0), largest(limit);
  WideMask<double> within = absolute(numbers[0]) <= largest;
  for (size_t k = 1; k < Size; ++k) within = within & (absolute(numbers[k]) <= largest);
  if (all(within)) return true;
  for (Wide<double>& number : numbers) number = select(within, number, zero);
  return false;
}

// Converts rates per unit of x to rates in time by `times` factors of scale. Lanes past kSafeRate, or past the range of
// float, become 0, and the result is false: scalar code does them again and detects an overflow without raising
// FE_OVERFLOW. Small rates (kSmallRates in evaluator.hpp) are not checked, because for them the scale alone decides.
constexpr double kSafeRate = 0x1p300;

template <bool kSmallRates, class Real>
QTRAJ_INLINE bool scale_rates(const Doubles<Real>& scale, int times, Wide<Real> (&rates)[3]) {
  Doubles<Real> values[3] = {Doubles<Real>::of(rates[0]), Doubles<Real>::of(rates[1]), Doubles<Real>::of(rates[2])};
  bool safe = true;
  for (size_t part = 0; part < Doubles<Real>::kParts; ++part) {
    Wide<double> products[3] = {values[0].part[part], values[1].part[part], values[2].part[part]};
    Wide<double> factor[1] = {scale.part[part]};
    if (!kSmallRates) safe = limit_lanes(kSafeRate, products) && safe;
    safe = limit_lanes(kSafeRate, factor) && safe;
    for (int step = 0; step < times; ++step)
      for (Wide<double>& product : products) product = product * factor[0];
    if (sizeof(Real) < sizeof(double)) safe = limit_lanes(largest_of<Real>(), products) && safe;
    for (size_t k = 0; k < 3; ++k) values[k].part[part] = products[k];
  }
  for (size_t k = 0; k < 3; ++k) rates[k] = values[k].rounded();
  return safe;
}

// Converts body rates per unit of x to rates in time and in the frame asked for; false where a lane must be done again.
template <class Arithmetic, bool kSmallRates, class Real>
QTRAJ_INLINE bool finish_rates(const Doubles<Real>& scale, const RateRequest& request, WideRow<Real>& row) {
  if (request.frame == Frame::world) {
    rotate_to_world<Arithmetic>(row.q, row.rates.omega);
    if (request.alpha) rotate_to_world<Arithmetic>(row.q, row.rates.alpha);
  }
  const bool omega_is_safe = !request.omega || scale_rates<kSmallRates>(scale, 1, row.rates.omega);
  const bool alpha_is_safe = !request.alpha || scale_rates<kSmallRates>(scale, 2, row.rates.alpha);
  return omega_is_safe && alpha_is_safe;
}

}  // namespace
}  // namespace qtraj
