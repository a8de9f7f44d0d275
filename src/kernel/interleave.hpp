// Rows of samples from a vector for each of their components, and how they reach memory.
#pragma once

#include "wide.hpp"

namespace qtraj {
namespace {

#if HWY_TARGET == HWY_AVX3
// AVX-512 takes any lanes of two vectors by one instruction: rows of four by 8 of them where unpacking takes 12, rows
// of three by 6 instead of 9.
template <class Real>
struct LaneTable {
  static constexpr size_t kLanes = Wide<Real>::kLanes;
  alignas(64) hwy::MakeSigned<Real> lanes[kLanes];  // those of the second vector follow those of the first
};

// `group` lanes of the first vector, as many of the second, and so on; both from lane `begin` on.
template <class Real>
constexpr LaneTable<Real> alternating(size_t begin, size_t group) {
  LaneTable<Real> table = {};
  for (size_t lane = 0; lane < table.kLanes; ++lane) {
    const size_t turn = lane / group, from = begin + turn / 2 * group + lane % group;
    table.lanes[lane] = static_cast<hwy::MakeSigned<Real>>(turn % 2 * table.kLanes + from);
  }
  return table;
}

// Rows of three, for the vector of memory of that number: its lanes of component 1 from the second vector, then those
// of component 2. The others come from the first vector: before, where their rows stand; then as they are in place.
template <class Real>
constexpr LaneTable<Real> of_three(size_t number, size_t component) {
  LaneTable<Real> table = {};
  for (size_t lane = 0; lane < table.kLanes; ++lane) {
    const size_t at = number * table.kLanes + lane, row = at / 3, other = component == 1 ? row : lane;
    table.lanes[lane] = static_cast<hwy::MakeSigned<Real>>(at % 3 == component ? table.kLanes + row : other);
  }
  return table;
}

QTRAJ_INLINE Wide<double> pick(Wide<double> first, const LaneTable<double>& table, Wide<double> second) {
  return Wide<double>::of({_mm512_permutex2var_pd(first.lanes.raw, _mm512_load_si512(table.lanes), second.lanes.raw)});
}
QTRAJ_INLINE Wide<float> pick(Wide<float> first, const LaneTable<float>& table, Wide<float> second) {
  return Wide<float>::of({_mm512_permutex2var_ps(first.lanes.raw, _mm512_load_si512(table.lanes), second.lanes.raw)});
}

template <class Real>
QTRAJ_INLINE void store_interleaved(const Wide<Real> (&v)[4], Real* to) {
  constexpr size_t kLanes = Wide<Real>::kLanes;
  static constexpr LaneTable<Real> kLower = alternating<Real>(0, 1), kUpper = alternating<Real>(kLanes / 2, 1);
  static constexpr LaneTable<Real> kLowerPairs = alternating<Real>(0, 2),
                                   kUpperPairs = alternating<Real>(kLanes / 2, 2);
  const Wide<Real> lower01 = pick(v[0], kLower, v[1]), lower23 = pick(v[2], kLower, v[3]);
  const Wide<Real> upper01 = pick(v[0], kUpper, v[1]), upper23 = pick(v[2], kUpper, v[3]);
  pick(lower01, kLowerPairs, lower23).store(to);
  pick(lower01, kUpperPairs, lower23).store(to + kLanes);
  pick(upper01, kLowerPairs, upper23).store(to + 2 * kLanes);
  pick(upper01, kUpperPairs, upper23).store(to + 3 * kLanes);
}
template <class Real>
QTRAJ_INLINE void store_interleaved(const Wide<Real> (&v)[3], Real* to) {
  constexpr size_t kLanes = Wide<Real>::kLanes;
  static constexpr LaneTable<Real> kFirstTwo[] = {of_three<Real>(0, 1), of_three<Real>(1, 1), of_three<Real>(2, 1)};
  static constexpr LaneTable<Real> kLast[] = {of_three<Real>(0, 2), of_three<Real>(1, 2), of_three<Real>(2, 2)};
  for (size_t k = 0; k < 3; ++k) pick(pick(v[0], kFirstTwo[k], v[1]), kLast[k], v[2]).store(to + k * kLanes);
}
#else
template <class Real>
QTRAJ_INLINE void store_interleaved(const Wide<Real> (&v)[4], Real* to) {
  hn::StoreInterleaved4(v[0].lanes, v[1].lanes, v[2].lanes, v[3].lanes, typename Wide<Real>::Tag(), to);
}
template <class Real>
QTRAJ_INLINE void store_interleaved(const Wide<Real> (&v)[3], Real* to) {
  hn::StoreInterleaved3(v[0].lanes, v[1].lanes, v[2].lanes, typename Wide<Real>::Tag(), to);
}
#endif

}  // namespace
}  // namespace qtraj
