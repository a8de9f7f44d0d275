// Rows of samples side by side: rates in time, and how they are written.
#pragma once

#include "rows.hpp"
#include "wide.hpp"

namespace qtraj {
namespace {

template <class Real>
struct WideRow {
  Wide<Real> q[4], omega[3], alpha[3];
};

QTRAJ_INLINE void store_interleaved(const Wide<double> (&v)[4], double* to) {
  hn::StoreInterleaved4(v[0].lanes, v[1].lanes, v[2].lanes, v[3].lanes, Wide<double>::Tag(), to);
}
QTRAJ_INLINE void store_interleaved(const Wide<float> (&v)[4], float* to) {
  hn::StoreInterleaved4(v[0].lanes, v[1].lanes, v[2].lanes, v[3].lanes, Wide<float>::Tag(), to);
}
template <class Real>
QTRAJ_INLINE void store_interleaved(const Wide<Real> (&v)[3], Real* to) {
  hn::StoreInterleaved3(v[0].lanes, v[1].lanes, v[2].lanes, typename Wide<Real>::Tag(), to);
}

// Writes `rows` <= kLanes rows; all lanes may be written where there is room.
template <class Real, size_t Size>
QTRAJ_INLINE void write_wide(const Wide<Real> (&v)[Size], Real* to, size_t row, size_t rows, bool room) {
  if (room) return store_interleaved(v, to + Size * row);
  Real lanes[Size * Wide<Real>::kLanes];
  store_interleaved(v, lanes);
  for (size_t k = 0; k < Size * rows; ++k) to[Size * row + k] = lanes[k];
}

// Rates of a segment's parameter to rates in time. Magnitudes past kSafeRate, or what float cannot hold, are left to
// the scalar code, which tells an overflow without making one: those lanes become 0, and `safe` false.
constexpr double kSafeRate = 0x1p300;

template <class Real>
QTRAJ_INLINE Wide<Real> scaled_rate(Wide<Real> rate, const Doubles<Real>& scale, int times, bool& safe) {
  const Wide<double> zero(0.0), limit(kSafeRate), largest(largest_of<Real>());
  Doubles<Real> value = Doubles<Real>::of(rate);
  for (size_t part = 0; part < Doubles<Real>::kParts; ++part) {
    Wide<double>& v = value.part[part];
    const WideMask<double> small = (absolute(v) <= limit) & (scale.part[part] <= limit);
    v = select(small, v, zero);
    const Wide<double> factor = select(small, scale.part[part], zero);
    for (int step = 0; step < times; ++step) v = v * factor;
    const WideMask<double> fits = absolute(v) <= largest;
    v = select(fits, v, zero);
    safe = safe && all(small & fits);
  }
  return value.rounded();
}

// Takes body rates to time and frame; false where a lane must be done again.
template <class Arithmetic, class Real>
QTRAJ_INLINE bool finish_rates(const Wide<Real> (&q)[4], Rates<Wide<Real>>& rates, const Doubles<Real>& scale,
                               const Wanted& wanted, WideRow<Real>& row) {
  if (wanted.frame == Frame::world) {
    rotate_to_world<Arithmetic>(q, rates.omega);
    rotate_to_world<Arithmetic>(q, rates.alpha);
  }
  bool safe = true;
  for (size_t k = 0; k < 3; ++k) {
    if (wanted.omega) row.omega[k] = scaled_rate(rates.omega[k], scale, 1, safe);
    if (wanted.alpha) row.alpha[k] = scaled_rate(rates.alpha[k], scale, 2, safe);
  }
  return safe;
}

}  // namespace
}  // namespace qtraj
