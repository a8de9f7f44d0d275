// A segment for each lane: which one a time belongs to, and its numbers.
#pragma once

#include "times.hpp"
#include "wide.hpp"

namespace qtraj {
namespace {

// Lanes of int64 that accompany a vector of double.
using IndexTag = hn::RebindToSigned<Wide<double>::Tag>;
using Indices = hn::Vec<IndexTag>;

// x86 gathers merge into a register, and one that may be any waits for whatever was left in it: these merge into 0.
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

// Segments of times within the knots, whole vectors, as find_segment has them. Each halving step is done for all times
// before the next: in one search after the other every gather waits for the one before.
inline void find_segments(const KnotIndex& index, const double* times, size_t count, int64_t* found) {
  const IndexTag tag;
  const Wide<double> start(index.guide.start), scale(index.guide.scale), shift(Guide::kShift);
  const auto* first_candidate = reinterpret_cast<const int64_t*>(index.guide.first_candidate);
  for (size_t i = 0; i < count; i += Wide<double>::kLanes) {
    const Wide<double> shifted = (Wide<double>::load(times + i) - start) * scale + shift;
    const Indices bucket = hn::And(hn::BitCast(tag, shifted.lanes), hn::Set(tag, Guide::kBucketBits));
    hn::StoreU(gather(first_candidate, bucket), tag, found + i);
  }
  for (size_t left = index.guide.candidates; left > 1; left -= left / 2) {
    const Indices half = hn::Set(tag, static_cast<int64_t>(left / 2));
    for (size_t i = 0; i < count; i += Wide<double>::kLanes) {
      const Indices low = hn::LoadU(tag, found + i), middle = hn::Add(low, half);
      const WideMask<double> is_past = gather(index.knots, middle) <= Wide<double>::load(times + i);
      hn::StoreU(hn::IfThenElse(hn::RebindMask(tag, is_past.lanes), middle, low), tag, found + i);
    }
  }
}

// Fields first..first + 3 (vectors of two lanes: + 1) of one record for each lane: rows are loaded and transposed,
// which is several times faster than to gather field by field.
constexpr size_t kTransposed = HWY_LANES(double) < 4 ? 2 : 4;

QTRAJ_INLINE void load_transposed(const double* const (&records)[HWY_LANES(double)], size_t first,
                                  Wide<double>* fields) {
  const Wide<double>::Tag tag;
#if HWY_MAX_BYTES == 16
  const auto row0 = hn::LoadU(tag, records[0] + first), row1 = hn::LoadU(tag, records[1] + first);
  fields[0].lanes = hn::InterleaveLower(tag, row0, row1);
  fields[1].lanes = hn::InterleaveUpper(tag, row0, row1);
#elif HWY_MAX_BYTES == 32
  // two fields of one record and of the next but one
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
  // blocks of two lanes: [f0 of 0, 1][f2 of 0, 1] ...
  const auto row0 = row(0), row1 = row(1), row2 = row(2), row3 = row(3);
  const auto even01 = hn::InterleaveLower(tag, row0, row1), odd01 = hn::InterleaveUpper(tag, row0, row1);
  const auto even23 = hn::InterleaveLower(tag, row2, row3), odd23 = hn::InterleaveUpper(tag, row2, row3);
  fields[0].lanes = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(even23), even01);
  fields[1].lanes = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd23), odd01);
  fields[2].lanes = hn::OddEvenBlocks(even23, hn::SwapAdjacentBlocks(even01));
  fields[3].lanes = hn::OddEvenBlocks(odd23, hn::SwapAdjacentBlocks(odd01));
#endif
}

// All fields; the last group may overlap the one before, so that nothing past a record is read.
template <size_t Fields>
QTRAJ_INLINE void load_records(const double* const (&records)[HWY_LANES(double)], Wide<double> (&fields)[Fields]) {
  for (size_t first = 0; first + kTransposed <= Fields; first += kTransposed)
    load_transposed(records, first, fields + first);
  if constexpr (Fields % kTransposed != 0)
    load_transposed(records, Fields - kTransposed, fields + Fields - kTransposed);
}

}  // namespace
}  // namespace qtraj
