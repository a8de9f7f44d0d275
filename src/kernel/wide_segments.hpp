// A segment for each lane: which one a time belongs to, and its numbers.
#pragma once

#include "times.hpp"
#include "wide.hpp"

namespace qtraj {
namespace {

// Lanes of int64 that accompany a vector of double.
using IndexTag = hn::RebindToSigned<Wide<double>::Tag>;
using Indices = hn::Vec<IndexTag>;

QTRAJ_INLINE Wide<double> gather(const double* from, Indices at) {
  return Wide<double>::of(hn::GatherIndex(Wide<double>::Tag(), from, at));
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
#else
#if HWY_MAX_BYTES == 32
  const auto row = [&](size_t lane) { return hn::LoadU(tag, records[lane] + first); };
#else
  const hn::Half<Wide<double>::Tag> half;
  const auto row = [&](size_t lane) {
    return hn::Combine(tag, hn::LoadU(half, records[lane + 4] + first), hn::LoadU(half, records[lane] + first));
  };
#endif
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

// Segments of times within the knots, by the guide.
QTRAJ_INLINE Indices find_segments(const KnotIndex& index, Wide<double> time) {
  const IndexTag tag;
  const Wide<double> shifted =
      (time - Wide<double>(index.guide.start)) * Wide<double>(index.guide.scale) + Wide<double>(Guide::kShift);
  const Indices bucket = hn::And(hn::BitCast(tag, shifted.lanes), hn::Set(tag, (int64_t{1} << 52) - 1));
  Indices low = hn::GatherIndex(tag, reinterpret_cast<const int64_t*>(index.guide.first_candidate), bucket);
  const Indices last = hn::Set(tag, static_cast<int64_t>(index.segments - 1));
  for (size_t step = size_t{1} << index.guide.steps; (step >>= 1) > 0;) {
    const Indices middle = hn::Min(hn::Add(low, hn::Set(tag, static_cast<int64_t>(step))), last);
    const Wide<double> knot = gather(index.knots, middle);
    low = hn::IfThenElse(hn::RebindMask(tag, (knot <= time).lanes), middle, low);
  }
  return low;
}

}  // namespace
}  // namespace qtraj
