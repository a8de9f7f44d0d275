// Rows of a caller's arrays, one per lane of a vector of double, from arrays of double or float: the vector overloads
// of row_loop.hpp.
#pragma once

#include "rows/row_loop.hpp"
#include "simd/transpose.hpp"

namespace qtraj {
namespace {

template <>
constexpr size_t kLanesOf<Wide<double>> = Wide<double>::kLanes;
template <>
constexpr size_t kLanesOf<Wide<float>> = Wide<float>::kLanes;

QTRAJ_INLINE unsigned lane_bits(WideMask<double> mask) {
  uint8_t bits[8] = {};
  hn::StoreMaskBits(Wide<double>::Tag(), mask.lanes, bits);
  return bits[0];
}
QTRAJ_INLINE WideMask<double> lanes_of(unsigned bits, Wide<double>) {
  const uint8_t bytes[8] = {static_cast<uint8_t>(bits)};
  return {hn::LoadMaskBits(Wide<double>::Tag(), bytes)};
}

QTRAJ_INLINE Wide<double> load_lanes(const double* from, Wide<double>) { return Wide<double>::load(from); }
QTRAJ_INLINE void store_lanes(Wide<double> a, double* to) { a.store(to); }

QTRAJ_INLINE Wide<double> lane_numbers(Wide<double>) { return Wide<double>::of(hn::Iota(Wide<double>::Tag(), 0)); }

QTRAJ_INLINE bool load_elapsed(const int64_t* stamps, int64_t origin, Wide<double>& elapsed) {
  const IndexTag tag;
  const auto is_past = [&](Indices a, int64_t limit) {
    return hn::Or(hn::Gt(a, hn::Set(tag, limit)), hn::Lt(a, hn::Set(tag, -limit)));
  };
  const Indices given = hn::LoadU(tag, stamps), from = hn::Set(tag, origin), difference = hn::Sub(given, from);
  const auto is_long =
      hn::Or(is_past(difference, kLargestElapsed), hn::Or(is_past(given, kLargestStamp), is_past(from, kLargestStamp)));
  elapsed = Wide<double>::of(hn::ConvertTo(Wide<double>::Tag(), difference));
  return hn::AllFalse(tag, is_long);
}

QTRAJ_INLINE Wide<double> preceded_by(double first, Wide<double> a) {
  const Wide<double>::Tag tag;
  alignas(64) static constexpr int64_t kBefore[] = {0, 0, 1, 2, 3, 4, 5, 6};
  const auto moved = hn::TableLookupLanes(a.lanes, hn::SetTableIndices(tag, kBefore));
  return select(lanes_of(1u, a), Wide<double>(first), Wide<double>::of(moved));
}

// A vector with as many floats as Wide<double> has lanes.
using FloatTag = hn::Rebind<float, Wide<double>::Tag>;

QTRAJ_INLINE Wide<double> promoted(hn::Vec<FloatTag> lanes) {
  return Wide<double>::of(hn::PromoteTo(Wide<double>::Tag(), lanes));
}
QTRAJ_INLINE hn::Vec<FloatTag> demoted(Wide<double> a) { return hn::DemoteTo(FloatTag(), a.lanes); }

QTRAJ_INLINE void convert_rows(const double* from, size_t row, Wide<double> (&to)[1]) {
  to[0] = Wide<double>::load(from + row);
}
template <class Real, size_t Width>
QTRAJ_INLINE void convert_rows(const Real* from, size_t row, Wide<Real> (&to)[Width]) {
  load_interleaved(from + Width * row, to);
}
QTRAJ_INLINE void convert_rows(const float* from, size_t row, Wide<double> (&to)[4]) {
#if HWY_TARGET == HWY_AVX3
  load_interleaved(from + 4 * row, to);
#else
  hn::Vec<FloatTag> v0, v1, v2, v3;
  hn::LoadInterleaved4(FloatTag(), from + 4 * row, v0, v1, v2, v3);
  to[0] = promoted(v0), to[1] = promoted(v1), to[2] = promoted(v2), to[3] = promoted(v3);
#endif
}
QTRAJ_INLINE void convert_rows(const float* from, size_t row, Wide<double> (&to)[1]) {
  to[0] = promoted(hn::LoadU(FloatTag(), from + row));
}
QTRAJ_INLINE void convert_rows(const float* from, size_t row, Wide<double> (&to)[3]) {
  hn::Vec<FloatTag> v0, v1, v2;
  hn::LoadInterleaved3(FloatTag(), from + 3 * row, v0, v1, v2);
  to[0] = promoted(v0), to[1] = promoted(v1), to[2] = promoted(v2);
}

// Rows of float that are computed with in float.
QTRAJ_INLINE void convert_rows(const float* from, size_t row, Wide<float> (&to)[1]) {
  to[0] = Wide<float>::load(from + row);
}
template <size_t Width>
QTRAJ_INLINE bool can_convert(const float*, size_t, const Wide<float> (&)[Width]) {
  return true;
}

template <size_t Width>
QTRAJ_INLINE bool can_convert(const float* from, size_t row, const Wide<double> (&)[Width]) {
  const hn::RebindToUnsigned<FloatTag> tag;
  const auto exponent = hn::Set(tag, 0x7f800000u);
  auto largest = hn::Zero(tag);
  for (size_t k = 0; k < Width; ++k) {
    const auto bits = hn::BitCast(tag, hn::LoadU(FloatTag(), from + Width * row + k * Wide<double>::kLanes));
    largest = hn::Max(largest, hn::And(bits, exponent));
  }
  return hn::AllFalse(tag, hn::Eq(largest, exponent));
}

template <class Real, size_t Width>
QTRAJ_INLINE void store_rows(const Wide<Real> (&from)[Width], Real* to, size_t row) {
  store_interleaved(from, to + Width * row);
}
template <class Real>
QTRAJ_INLINE void store_rows(const Wide<Real> (&from)[1], Real* to, size_t row) {
  from[0].store(to + row);
}
QTRAJ_INLINE void store_rows(const Wide<double> (&from)[1], float* to, size_t row) {
  hn::StoreU(demoted(from[0]), FloatTag(), to + row);
}
QTRAJ_INLINE void store_rows(const Wide<double> (&from)[3], float* to, size_t row) {
  hn::StoreInterleaved3(demoted(from[0]), demoted(from[1]), demoted(from[2]), FloatTag(), to + 3 * row);
}
QTRAJ_INLINE void store_rows(const Wide<double> (&from)[4], float* to, size_t row) {
  hn::StoreInterleaved4(demoted(from[0]), demoted(from[1]), demoted(from[2]), demoted(from[3]), FloatTag(),
                        to + 4 * row);
}

QTRAJ_INLINE void store_rows_apart(const Wide<double> (&from)[4], double* to, size_t stride) {
#if HWY_TARGET == HWY_AVX3
  // each vector in memory is two rows
  static constexpr LaneTable<double> kLower = alternating<double>(0, 1), kUpper = alternating<double>(4, 1);
  static constexpr LaneTable<double> kLowerPairs = alternating<double>(0, 2), kUpperPairs = alternating<double>(4, 2);
  const Wide<double> lower01 = pick(from[0], kLower, from[1]), lower23 = pick(from[2], kLower, from[3]);
  const Wide<double> upper01 = pick(from[0], kUpper, from[1]), upper23 = pick(from[2], kUpper, from[3]);
  const auto store_two = [&](Wide<double> rows, size_t first) {
    _mm256_storeu_pd(to + stride * first, _mm512_castpd512_pd256(rows.lanes.raw));
    _mm256_storeu_pd(to + stride * (first + 1), _mm512_extractf64x4_pd(rows.lanes.raw, 1));
  };
  store_two(pick(lower01, kLowerPairs, lower23), 0);
  store_two(pick(lower01, kUpperPairs, lower23), 2);
  store_two(pick(upper01, kLowerPairs, upper23), 4);
  store_two(pick(upper01, kUpperPairs, upper23), 6);
#else
  double rows[Wide<double>::kLanes][4];
  store_rows(from, rows[0], 0);
  for (size_t lane = 0; lane < Wide<double>::kLanes; ++lane)
    std::memcpy(to + stride * lane, rows[lane], sizeof rows[0]);
#endif
}

// ---- Bits ----

using BitsTag = hn::RebindToUnsigned<Wide<double>::Tag>;

QTRAJ_INLINE WideMask<double> is_in_order(uint64_t least, hn::Vec<BitsTag> bits, uint64_t past) {
  // compared as signed integers, which every target can do
  const IndexTag tag;
  const auto value = hn::BitCast(tag, bits);
  const auto at_least = hn::Gt(value, hn::Set(tag, static_cast<int64_t>(least - 1)));
  return {
      hn::RebindMask(Wide<double>::Tag(), hn::And(at_least, hn::Lt(value, hn::Set(tag, static_cast<int64_t>(past)))))};
}

// The upper half of the largest magnitude.
template <size_t Size>
QTRAJ_INLINE hn::Vec<BitsTag> largest_upper_half(const Wide<double> (&v)[Size]) {
  // the maximum of each 32-bit half: limits depend on the upper halves alone
  const hn::Repartition<uint32_t, Wide<double>::Tag> halves;
  const BitsTag tag;
  auto largest = hn::Zero(halves);
  for (const Wide<double>& component : v) {
    const auto magnitude = hn::And(hn::BitCast(tag, component.lanes), hn::Set(tag, kMagnitudeBits));
    largest = hn::Max(largest, hn::BitCast(halves, magnitude));
  }
  return hn::ShiftRight<32>(hn::BitCast(tag, largest));
}
template <size_t Size>
QTRAJ_INLINE WideMask<double> is_ordinary(const Wide<double> (&v)[Size]) {
  return is_in_order(kLeastOrdinary >> 32, largest_upper_half(v), kPastOrdinary >> 32);
}
template <size_t Size>
QTRAJ_INLINE WideMask<double> is_bounded(const Wide<double> (&v)[Size]) {
  return is_in_order(0, largest_upper_half(v), kPastOrdinary >> 32);
}

template <size_t Size>
QTRAJ_INLINE Wide<double> power_of_largest(const Wide<double> (&v)[Size]) {
  const BitsTag tag;
  const auto exponent = hn::And(hn::ShiftLeft<32>(largest_upper_half(v)), hn::Set(tag, kInfinityBits));
  return Wide<double>::of(hn::BitCast(Wide<double>::Tag(), exponent));
}
template <size_t Size>
QTRAJ_INLINE WideMask<double> is_below(const Wide<double> (&v)[Size], double power) {
  return is_in_order(0, largest_upper_half(v), bits_of(power) >> 32);
}

// The bits of the largest magnitude.
using FloatBitsTag = hn::RebindToSigned<Wide<float>::Tag>;
template <size_t Size>
QTRAJ_INLINE hn::Vec<FloatBitsTag> largest_bits(const Wide<float> (&v)[Size]) {
  const FloatBitsTag bits;
  auto largest = hn::Zero(bits);
  for (const Wide<float>& component : v) largest = hn::Max(largest, hn::BitCast(bits, hn::Abs(component.lanes)));
  return largest;
}
template <size_t Size>
QTRAJ_INLINE WideMask<float> is_ordinary(const Wide<float> (&v)[Size]) {
  const FloatBitsTag bits;
  const auto largest = largest_bits(v);
  const auto at_least = hn::Gt(largest, hn::Set(bits, static_cast<int32_t>(kLeastOrdinaryFloat - 1)));
  const auto below = hn::Lt(largest, hn::Set(bits, static_cast<int32_t>(kPastOrdinaryFloat)));
  return {hn::RebindMask(Wide<float>::Tag(), hn::And(at_least, below))};
}
template <size_t Size>
QTRAJ_INLINE WideMask<float> is_below(const Wide<float> (&v)[Size], float power) {
  const auto limit = hn::Set(FloatBitsTag(), static_cast<int32_t>(bits_of(power)));
  return {hn::RebindMask(Wide<float>::Tag(), hn::Lt(largest_bits(v), limit))};
}

QTRAJ_INLINE Wide<double> flip_signs(Wide<double> a, Wide<double> of) {
  return Wide<double>::of(hn::Xor(a.lanes, hn::And(hn::SignBit(Wide<double>::Tag()), of.lanes)));
}

// Whether any of the components has one of the bits.
template <class Real, class Bits, size_t Size>
QTRAJ_INLINE WideMask<Real> has_bits(const Wide<Real> (&v)[Size], Bits wanted) {
  const hn::RebindToUnsigned<typename Wide<Real>::Tag> tag;
  auto bits = hn::BitCast(tag, v[0].lanes);
  for (size_t k = 1; k + 1 < Size; k += 2)
    bits = hn::Or3(bits, hn::BitCast(tag, v[k].lanes), hn::BitCast(tag, v[k + 1].lanes));
  if (Size % 2 == 0) bits = hn::Or(bits, hn::BitCast(tag, v[Size - 1].lanes));
  const auto found = hn::And(bits, hn::Set(tag, wanted));
  return {hn::RebindMask(typename Wide<Real>::Tag(), hn::Ne(found, hn::Zero(tag)))};
}
template <size_t Size>
QTRAJ_INLINE WideMask<double> reaches_two(const Wide<double> (&v)[Size]) {
  return has_bits(v, kTwoBit);
}
template <size_t Size>
QTRAJ_INLINE WideMask<float> reaches_two(const Wide<float> (&v)[Size]) {
  return has_bits(v, kTwoBitFloat);
}
template <size_t Size>
QTRAJ_INLINE WideMask<double> is_large(const Wide<double> (&v)[Size]) {
  return has_bits(v, kLargeBits);
}
template <size_t Size>
QTRAJ_INLINE WideMask<float> is_large(const Wide<float> (&v)[Size]) {
  return has_bits(v, kLargeBitsFloat);
}

// The scalar overload, which the function below would otherwise hide.
using qtraj::is_finite;
QTRAJ_INLINE WideMask<double> is_finite(Wide<double> a) {
  const BitsTag tag;
  return is_in_order(0, hn::And(hn::BitCast(tag, a.lanes), hn::Set(tag, kMagnitudeBits)), kInfinityBits);
}

QTRAJ_INLINE WideMask<double> is_inside(Wide<double> fraction) {
  return is_in_order(1, hn::BitCast(BitsTag(), fraction.lanes), kOneBits);
}

}  // namespace
}  // namespace qtraj
