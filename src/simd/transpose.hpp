// Conversion between rows in memory (array of structures) and one vector per field of many rows (structure of arrays):
// gathers, loads with a transposition, interleaved stores.
#pragma once

#include "simd/wide.hpp"

namespace qtraj {
namespace {

// ---- Gathering and loading ----

// A vector of int64 with the lanes of a vector of double.
using IndexTag = hn::RebindToSigned<Wide<double>::Tag>;
using Indices = hn::Vec<IndexTag>;

// An x86 gather merges into its destination register. Were that left undefined, the gather would have a false
// dependency on whatever wrote the register last: these merge into a zeroed register, which has none.
#if HWY_TARGET == HWY_AVX3
QTRAJ_INLINE Indices gather(const int64_t* from, Indices at) {
  return Indices{_mm512_mask_i64gather_epi64(_mm512_setzero_si512(), 0xff, at.raw, from, 8)};
}
QTRAJ_INLINE Wide<double> gather(const double* from, Indices at) {
  return Wide<double>::of({_mm512_mask_i64gather_pd(_mm512_setzero_pd(), 0xff, at.raw, from, 8)});
}
#elif HWY_TARGET == HWY_AVX2
QTRAJ_INLINE Indices gather(const int64_t* from, Indices at) {
  const __m256i all = _mm256_set1_epi64x(-1);
  const auto* numbers = reinterpret_cast<const long long*>(from);
  return Indices{_mm256_mask_i64gather_epi64(_mm256_setzero_si256(), numbers, at.raw, all, 8)};
}
QTRAJ_INLINE Wide<double> gather(const double* from, Indices at) {
  const __m256d all = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
  return Wide<double>::of({_mm256_mask_i64gather_pd(_mm256_setzero_pd(), from, at.raw, all, 8)});
}
#else
QTRAJ_INLINE Indices gather(const int64_t* from, Indices at) { return hn::GatherIndex(IndexTag(), from, at); }
QTRAJ_INLINE Wide<double> gather(const double* from, Indices at) {
  return Wide<double>::of(hn::GatherIndex(Wide<double>::Tag(), from, at));
}
#endif

// Loads fields first..first + 3 (vectors of two lanes: + 1) of one record per lane. Loading rows and transposing them
// is several times faster than one gather per field.
constexpr size_t kTransposed = HWY_LANES(double) < 4 ? 2 : 4;

QTRAJ_INLINE void load_transposed(const double* const (&records)[HWY_LANES(double)], size_t first,
                                  Wide<double>* fields) {
  const Wide<double>::Tag tag;
#if HWY_MAX_BYTES == 16
  const auto row0 = hn::LoadU(tag, records[0] + first), row1 = hn::LoadU(tag, records[1] + first);
  fields[0].lanes = hn::InterleaveLower(tag, row0, row1);
  fields[1].lanes = hn::InterleaveUpper(tag, row0, row1);
#elif HWY_MAX_BYTES == 32
  // lower half: two fields of record `lane`; upper half: those of record `lane` + 2
  const hn::Half<Wide<double>::Tag> half;
  const auto pairs = [&](size_t lane, size_t field) {
    return hn::Combine(tag, hn::LoadU(half, records[lane + 2] + field), hn::LoadU(half, records[lane] + field));
  };
  for (size_t k = 0; k < 4; k += 2) {
    const auto even = pairs(0, first + k), odd = pairs(1, first + k);
    fields[k].lanes = hn::InterleaveLower(tag, even, odd);
    fields[k + 1].lanes = hn::InterleaveUpper(tag, even, odd);
  }
#else
  const hn::Half<Wide<double>::Tag> half;
  const auto row = [&](size_t lane) {
    return hn::Combine(tag, hn::LoadU(half, records[lane + 4] + first), hn::LoadU(half, records[lane] + first));
  };
  // even01 in 128-bit blocks: [field 0 of records 0, 1][field 2 of 0, 1][field 0 of 4, 5][field 2 of 4, 5]
  const auto row0 = row(0), row1 = row(1), row2 = row(2), row3 = row(3);
  const auto even01 = hn::InterleaveLower(tag, row0, row1), odd01 = hn::InterleaveUpper(tag, row0, row1);
  const auto even23 = hn::InterleaveLower(tag, row2, row3), odd23 = hn::InterleaveUpper(tag, row2, row3);
  fields[0].lanes = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(even23), even01);
  fields[1].lanes = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd23), odd01);
  fields[2].lanes = hn::OddEvenBlocks(even23, hn::SwapAdjacentBlocks(even01));
  fields[3].lanes = hn::OddEvenBlocks(odd23, hn::SwapAdjacentBlocks(odd01));
#endif
}

// Loads all fields. The last group may overlap the one before, so that nothing past a record is read.
template <size_t Fields>
QTRAJ_INLINE void load_records(const double* const (&records)[HWY_LANES(double)], Wide<double> (&fields)[Fields]) {
  for (size_t first = 0; first + kTransposed <= Fields; first += kTransposed)
    load_transposed(records, first, fields + first);
  if constexpr (Fields % kTransposed != 0)
    load_transposed(records, Fields - kTransposed, fields + Fields - kTransposed);
}

// ---- Storing ----

#if HWY_TARGET == HWY_AVX3
// AVX-512 permutes any lanes of two vectors by one instruction (vpermt2pd, vpermt2ps): rows of four take 8 of them
// where unpacking takes 12, rows of three 6 instead of 9.
template <class Real>
struct LaneTable {
  static constexpr size_t kLanes = Wide<Real>::kLanes;
  alignas(64) hwy::MakeSigned<Real> lanes[kLanes];  // source lanes; the second vector's are numbered after the first's
};

// Alternates: `group` lanes of the first vector, as many of the second, and so on, both from lane `begin` on.
template <class Real>
constexpr LaneTable<Real> alternating(size_t begin, size_t group) {
  LaneTable<Real> table = {};
  for (size_t lane = 0; lane < table.kLanes; ++lane) {
    const size_t turn = lane / group, from = begin + turn / 2 * group + lane % group;
    table.lanes[lane] = static_cast<hwy::MakeSigned<Real>>(turn % 2 * table.kLanes + from);
  }
  return table;
}

// Rows of three take two permutations for each vector in memory, whose index is `number`. Component 1: its lanes come
// from the second vector, all others from the lanes of their rows in the first. Component 2: its lanes come from the
// second vector, all others stay in place.
template <class Real>
constexpr LaneTable<Real> of_three(size_t number, size_t component) {
  LaneTable<Real> table = {};
  for (size_t lane = 0; lane < table.kLanes; ++lane) {
    const size_t at = number * table.kLanes + lane, row = at / 3, other = component == 1 ? row : lane;
    table.lanes[lane] = static_cast<hwy::MakeSigned<Real>>(at % 3 == component ? table.kLanes + row : other);
  }
  return table;
}

// Every `step`-th number of a sequence from number `begin` on, as far as the sequence goes: it fills two vectors. Lanes
// past it come from the first vector.
template <class Real>
constexpr LaneTable<Real> every(size_t step, size_t begin) {
  LaneTable<Real> table = {};
  for (size_t lane = 0; lane < table.kLanes; ++lane) {
    const size_t from = begin + step * lane;
    table.lanes[lane] = static_cast<hwy::MakeSigned<Real>>(from < 2 * table.kLanes ? from : 0);
  }
  return table;
}

// Rows of three: field `field` of the rows that the first two vectors hold is in its lanes already; the lanes of all
// others come from the third.
template <class Real>
constexpr LaneTable<Real> from_third(size_t field) {
  LaneTable<Real> table = {};
  for (size_t lane = 0; lane < table.kLanes; ++lane) {
    const size_t from = field + 3 * lane;
    table.lanes[lane] =
        static_cast<hwy::MakeSigned<Real>>(from < 2 * table.kLanes ? lane : from - 2 * table.kLanes + table.kLanes);
  }
  return table;
}

// The lower or the upper halves of two vectors.
template <class Real>
constexpr LaneTable<Real> halves(size_t begin) {
  LaneTable<Real> table = {};
  constexpr size_t kHalf = LaneTable<Real>::kLanes / 2;
  for (size_t lane = 0; lane < table.kLanes; ++lane)
    table.lanes[lane] = static_cast<hwy::MakeSigned<Real>>(begin + lane % kHalf + lane / kHalf * table.kLanes);
  return table;
}

// Fields `first` and `first` + 1 of rows of four, of the rows that two vectors hold: those of one field, then the
// other's.
template <class Real>
constexpr LaneTable<Real> two_fields(size_t first) {
  LaneTable<Real> table = {};
  constexpr size_t kHalf = LaneTable<Real>::kLanes / 2;
  for (size_t lane = 0; lane < table.kLanes; ++lane)
    table.lanes[lane] = static_cast<hwy::MakeSigned<Real>>(first + lane / kHalf + 4 * (lane % kHalf));
  return table;
}

QTRAJ_INLINE Wide<double> pick(Wide<double> first, const LaneTable<double>& table, Wide<double> second) {
  return Wide<double>::of({_mm512_permutex2var_pd(first.lanes.raw, _mm512_load_si512(table.lanes), second.lanes.raw)});
}
QTRAJ_INLINE Wide<float> pick(Wide<float> first, const LaneTable<float>& table, Wide<float> second) {
  return Wide<float>::of({_mm512_permutex2var_ps(first.lanes.raw, _mm512_load_si512(table.lanes), second.lanes.raw)});
}

template <class Real>
QTRAJ_INLINE void load_interleaved(const Real* from, Wide<Real> (&v)[3]) {
  constexpr size_t kLanes = Wide<Real>::kLanes;
  static constexpr LaneTable<Real> kFirst[] = {every<Real>(3, 0), every<Real>(3, 1), every<Real>(3, 2)};
  static constexpr LaneTable<Real> kThird[] = {from_third<Real>(0), from_third<Real>(1), from_third<Real>(2)};
  const auto load = [&](size_t part) { return Wide<Real>::load(from + kLanes * part); };
  const Wide<Real> first = load(0), second = load(1), third = load(2);
  for (size_t k = 0; k < 3; ++k) v[k] = pick(pick(first, kFirst[k], second), kThird[k], third);
}

// Loads numbers, and converts floats for a vector of doubles.
template <class Real>
QTRAJ_INLINE Wide<Real> load_as(const Real* from, Wide<Real>) {
  return Wide<Real>::load(from);
}
QTRAJ_INLINE Wide<double> load_as(const float* from, Wide<double>) {
  return Wide<double>::of({_mm512_cvtps_pd(_mm256_loadu_ps(from))});
}

// From rows of the vectors' type, or of float to double.
template <class Memory, class Real>
QTRAJ_INLINE void load_interleaved(const Memory* from, Wide<Real> (&v)[4]) {
  constexpr size_t kLanes = Wide<Real>::kLanes;
  static constexpr LaneTable<Real> kTwoFields[] = {two_fields<Real>(0), two_fields<Real>(2)};
  static constexpr LaneTable<Real> kHalves[] = {halves<Real>(0), halves<Real>(kLanes / 2)};
  const auto load = [&](size_t part) { return load_as(from + kLanes * part, Wide<Real>()); };
  const Wide<Real> part0 = load(0), part1 = load(1), part2 = load(2), part3 = load(3);
  for (size_t k = 0; k < 2; ++k) {
    const Wide<Real> low = pick(part0, kTwoFields[k], part1), high = pick(part2, kTwoFields[k], part3);
    v[2 * k] = pick(low, kHalves[0], high);
    v[2 * k + 1] = pick(low, kHalves[1], high);
  }
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
QTRAJ_INLINE void load_interleaved(const Real* from, Wide<Real> (&v)[3]) {
  hn::LoadInterleaved3(typename Wide<Real>::Tag(), from, v[0].lanes, v[1].lanes, v[2].lanes);
}
QTRAJ_INLINE void load_interleaved(const double* from, Wide<double> (&v)[4]) {
  const double* rows[Wide<double>::kLanes];
  for (size_t lane = 0; lane < Wide<double>::kLanes; ++lane) rows[lane] = from + 4 * lane;
  load_records(rows, v);
}
QTRAJ_INLINE void load_interleaved(const float* from, Wide<float> (&v)[4]) {
  hn::LoadInterleaved4(Wide<float>::Tag(), from, v[0].lanes, v[1].lanes, v[2].lanes, v[3].lanes);
}
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
