// Rows of samples side by side: rates in time, and how they are written.
#pragma once

#include "curve/sample_output.hpp"
#include "simd/prefetch.hpp"
#include "simd/transpose.hpp"

namespace qtraj {
namespace {

template <class Real>
struct WideRow {
  Wide<Real> q[4], omega[3], alpha[3];
};

template <class Real>
QTRAJ_NOINLINE void copy_numbers(const Real* from, size_t count, Real* to) {
  for (size_t k = 0; k < count; ++k) to[k] = from[k];
}

// Writes `rows` <= kLanes rows; all lanes may be written where as many rows are left of the output from this one on.
template <class Real, size_t Size>
QTRAJ_INLINE void write_wide(const Wide<Real> (&v)[Size], Real* to, size_t row, size_t rows, size_t left) {
  constexpr size_t kLanes = Wide<Real>::kLanes;
  prefetch_output<Real, Size, kLanes>(to, row, row + left);
  if (left >= kLanes) return store_interleaved(v, to + Size * row);
  Real lanes[Size * Wide<Real>::kLanes];
  store_interleaved(v, lanes);
  copy_numbers(lanes, Size * rows, to + Size * row);
}

// Lanes with a number of magnitude past the limit, or NaN, become 0 in all numbers; false where there are any.
template <size_t Size>
QTRAJ_INLINE bool limit_lanes(double limit, Wide<double> (&numbers)[Size]) {
  const Wide<double> zero(0.0), largest(limit);
  WideMask<double> within = absolute(numbers[0]) <= largest;
  for (size_t k = 1; k < Size; ++k) within = within & (absolute(numbers[k]) <= largest);
  if (all(within)) return true;
  for (Wide<double>& number : numbers) number = select(within, number, zero);
  return false;
}

// Rates of a segment's parameter to rates in time, by `times` factors of its scale. Magnitudes past kSafeRate, or what
// float cannot hold, are left to the scalar code, which tells an overflow without making one: those lanes become 0, and
// the result is false. Small rates (evaluator.hpp) are not looked at: for a whole run the scale alone decides.
constexpr double kSafeRate = 0x1p300;

template <bool kSmallRates, class Real>
QTRAJ_INLINE bool scale_rates(const Wide<Real> (&rates)[3], const Doubles<Real>& scale, int times,
                              Wide<Real> (&scaled)[3]) {
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
  for (size_t k = 0; k < 3; ++k) scaled[k] = values[k].rounded();
  return safe;
}

// Takes body rates to time and frame; false where a lane must be done again.
template <class Arithmetic, bool kSmallRates, class Real>
QTRAJ_INLINE bool finish_rates(const Wide<Real> (&q)[4], Rates<Wide<Real>>& rates, const Doubles<Real>& scale,
                               const RateRequest& request, WideRow<Real>& row) {
  if (request.frame == Frame::world) {
    rotate_to_world<Arithmetic>(q, rates.omega);
    if (request.alpha) rotate_to_world<Arithmetic>(q, rates.alpha);
  }
  const bool omega_is_safe = !request.omega || scale_rates<kSmallRates>(rates.omega, scale, 1, row.omega);
  const bool alpha_is_safe = !request.alpha || scale_rates<kSmallRates>(rates.alpha, scale, 2, row.alpha);
  return omega_is_safe && alpha_is_safe;
}

}  // namespace
}  // namespace qtraj
