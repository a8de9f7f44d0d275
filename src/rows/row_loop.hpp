// Rows of a caller's arrays as doubles, or rows of float as floats: one row, or (wide_rows.hpp) one row per lane of a
// vector. Kernels over rows do ordinary rows only. is_ordinary decides which ones these are, and do_rows stops at the
// first other one: it goes back to the core, which knows all cases (functions/for_each_row.hpp).
#pragma once

#include <cstring>
#include <type_traits>

#include "math/arithmetic.hpp"
#include "math/error_free.hpp"
#include "rows/arguments.hpp"

namespace qtraj {
namespace {

template <class Number>
constexpr size_t kLanesOf = 1;

// A lane mask as bits, the first lane in the lowest, and back.
QTRAJ_INLINE unsigned lane_bits(bool condition) { return condition ? 1 : 0; }
QTRAJ_INLINE bool lanes_of(unsigned bits, double) { return bits != 0; }

// The prefix parity: bit i of the result tells whether an odd number of the bits 0 .. i is set.
inline unsigned parities(unsigned bits) {
  for (unsigned shift = 1; shift < 8 * sizeof bits; shift *= 2) bits ^= bits << shift;
  return bits;
}

// Loads from and stores to an array, one number per lane.
QTRAJ_INLINE double load_lanes(const double* from, double) { return *from; }
QTRAJ_INLINE void store_lanes(double a, double* to) { *to = a; }

// The number of each lane: 0, 1, ...
QTRAJ_INLINE double lane_numbers(double) { return 0; }

// The lanes moved up by one, and a number in the first.
QTRAJ_INLINE double preceded_by(double first, double) { return first; }

// The largest of the lanes.
template <class Number>
QTRAJ_INLINE double largest_lane(Number a) {
  double lanes[kLanesOf<Number>];
  store_lanes(a, lanes);
  double largest = lanes[0];
  for (const double lane : lanes) largest = largest < lane ? lane : largest;
  return largest;
}

// A row is ordinary where its largest component is of magnitude 2^-120 to 2^120. It is then finite and not 0, and
// nothing made of it overflows, also in float, or loses digits by underflow. A row that is computed with in float is
// where that magnitude is 2^-30 to 2^30. Tests the bits, because a comparison with a NaN would raise FE_INVALID.
constexpr uint64_t kLeastOrdinary = uint64_t{1023 - 120} << 52, kPastOrdinary = uint64_t{1023 + 120} << 52;
constexpr uint64_t kMagnitudeBits = ~uint64_t{0} >> 1, kOneBits = uint64_t{1023} << 52,
                   kInfinityBits = uint64_t{2047} << 52;
constexpr uint32_t kLeastOrdinaryFloat = uint32_t{127 - 30} << 23, kPastOrdinaryFloat = uint32_t{127 + 30} << 23;
constexpr uint32_t kFloatMagnitudeBits = ~uint32_t{0} >> 1;

inline uint64_t bits_of(double value) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

template <size_t Size>
QTRAJ_INLINE uint64_t largest_bits(const double (&v)[Size]) {
  uint64_t largest = 0;
  for (const double component : v) {
    const uint64_t magnitude = bits_of(component) & kMagnitudeBits;
    largest = magnitude > largest ? magnitude : largest;
  }
  return largest;
}
template <size_t Size>
QTRAJ_INLINE bool is_ordinary(const double (&v)[Size]) {
  return largest_bits(v) - kLeastOrdinary < kPastOrdinary - kLeastOrdinary;
}
// Ordinary or of smaller components, 0 included: for what may lose digits by underflow where its results do.
template <size_t Size>
QTRAJ_INLINE bool is_bounded(const double (&v)[Size]) {
  return largest_bits(v) < kPastOrdinary;
}
// The power of two that is at most the largest magnitude, and more than half of it, of a row that is ordinary.
template <size_t Size>
QTRAJ_INLINE double power_of_largest(const double (&v)[Size]) {
  const uint64_t bits = largest_bits(v) & kInfinityBits;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}
// Every component of a magnitude below that power of two.
template <size_t Size>
QTRAJ_INLINE bool is_below(const double (&v)[Size], double power) {
  return largest_bits(v) < bits_of(power);
}

inline uint32_t bits_of(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}
template <size_t Size>
QTRAJ_INLINE uint32_t largest_bits(const float (&v)[Size]) {
  uint32_t largest = 0;
  for (const float component : v) {
    const uint32_t magnitude = bits_of(component) & kFloatMagnitudeBits;
    largest = magnitude > largest ? magnitude : largest;
  }
  return largest;
}
template <size_t Size>
QTRAJ_INLINE bool is_ordinary(const float (&v)[Size]) {
  return largest_bits(v) - kLeastOrdinaryFloat < kPastOrdinaryFloat - kLeastOrdinaryFloat;
}
template <size_t Size>
QTRAJ_INLINE bool is_below(const float (&v)[Size], float power) {
  return largest_bits(v) < bits_of(power);
}

// a, negated where the sign of `of` is set, also zeros and subnormal numbers that a processor is told to flush.
QTRAJ_INLINE double flip_signs(double a, double of) {
  const uint64_t bits = bits_of(a) ^ (bits_of(of) & ~kMagnitudeBits);
  std::memcpy(&a, &bits, sizeof a);
  return a;
}

// Whether a component is of magnitude 2 or more, or NaN: only these have the highest bit of the exponent set. Whether
// one is of magnitude 2^-511 or more, in float 2^-63: these have that bit or the next.
constexpr uint64_t kTwoBit = uint64_t{1} << 62, kLargeBits = uint64_t{3} << 61;
constexpr uint32_t kTwoBitFloat = uint32_t{1} << 30, kLargeBitsFloat = uint32_t{3} << 29;

template <class Real, size_t Size>
QTRAJ_INLINE auto bits_of_any(const Real (&v)[Size]) {
  auto bits = bits_of(v[0]);
  for (const Real component : v) bits |= bits_of(component);
  return bits;
}
template <size_t Size>
QTRAJ_INLINE bool reaches_two(const double (&v)[Size]) {
  return (bits_of_any(v) & kTwoBit) != 0;
}
template <size_t Size>
QTRAJ_INLINE bool reaches_two(const float (&v)[Size]) {
  return (bits_of_any(v) & kTwoBitFloat) != 0;
}
template <size_t Size>
QTRAJ_INLINE bool is_large(const double (&v)[Size]) {
  return (bits_of_any(v) & kLargeBits) != 0;
}
template <size_t Size>
QTRAJ_INLINE bool is_large(const float (&v)[Size]) {
  return (bits_of_any(v) & kLargeBitsFloat) != 0;
}

// Differences of stamps from an origin as numbers; false where one may not be exact, being past 2^53.
constexpr int64_t kLargestStamp = int64_t{1} << 62, kLargestElapsed = int64_t{1} << 53;
QTRAJ_INLINE bool load_elapsed(const int64_t* stamps, int64_t origin, double& elapsed) {
  const auto is_within = [](int64_t a, int64_t limit) { return -limit <= a && a <= limit; };
  // the difference of two stamps below 2^62 does not overflow
  if (!is_within(*stamps, kLargestStamp) || !is_within(origin, kLargestStamp)) return false;
  const int64_t difference = *stamps - origin;
  elapsed = static_cast<double>(difference);
  return is_within(difference, kLargestElapsed);
}

// 0 < fraction < 1.
QTRAJ_INLINE bool is_inside(double fraction) { return bits_of(fraction) - 1 < kOneBits - 1; }

template <class Real, class Number, size_t Width>
QTRAJ_INLINE void convert_rows(const Real* from, size_t row, Number (&to)[Width]) {
  for (size_t k = 0; k < Width; ++k) to[k] = static_cast<Number>(from[Width * row + k]);
}
template <class Number, class Real, size_t Width>
QTRAJ_INLINE void store_rows(const Number (&from)[Width], Real* to, size_t row) {
  for (size_t k = 0; k < Width; ++k) to[Width * row + k] = static_cast<Real>(from[k]);
}

// Whether rows may be converted to double: floats must be finite, because the conversion of a signalling NaN would
// raise FE_INVALID; doubles need no conversion, nor do floats that stay floats.
template <class Number, size_t Width>
QTRAJ_INLINE bool can_convert(const double*, size_t, const Number (&)[Width]) {
  return true;
}
template <size_t Width>
QTRAJ_INLINE bool can_convert(const float*, size_t, const float (&)[Width]) {
  return true;
}
template <size_t Width>
QTRAJ_INLINE bool can_convert(const float* from, size_t row, const double (&)[Width]) {
  bool finite = true;
  for (size_t k = 0; k < Width; ++k) finite = finite && is_finite(from[Width * row + k]);
  return finite;
}

// Stores rows `stride` numbers from one to the next.
QTRAJ_INLINE void store_rows_apart(const double (&from)[4], double* to, size_t) { store_rows(from, to, 0); }

// Loads the fields of one record per lane.
template <size_t Fields>
QTRAJ_INLINE void load_records(const double* const (&records)[1], double (&fields)[Fields]) {
  for (size_t k = 0; k < Fields; ++k) fields[k] = records[0][k];
}

// Whether one row is broadcast to all rows of a call.
template <size_t Width>
QTRAJ_INLINE bool is_repeated(const Input<Width>& array) {
  return array.rows == 1;
}

// An output as an input: what was written is read again.
template <size_t Width>
QTRAJ_INLINE Input<Width> written(const Output<Width>& array) {
  return {array.data, array.rows, array.is_float};
}

// Reads rows `row`, `row` + 1, ... of an array, or broadcasts its only row. The numbers can be converted.
template <class Real, class Number, size_t Width>
QTRAJ_INLINE void read_numbers(const Input<Width>& array, size_t row, Number (&to)[Width]) {
  const Real* from = static_cast<const Real*>(array.data);
  if (!is_repeated(array)) return convert_rows(from, row, to);
  Element<Number> one[Width];
  convert_rows(from, 0, one);
  for (size_t k = 0; k < Width; ++k) to[k] = Number(one[k]);
}

// The same; false, with `to` unusable, where the numbers cannot be converted.
template <class Real, class Number, size_t Width>
QTRAJ_INLINE bool load_numbers(const Input<Width>& array, size_t row, Number (&to)[Width]) {
  const Real* from = static_cast<const Real*>(array.data);
  const Element<Number> one[Width] = {};
  if (is_repeated(array) ? !can_convert(from, 0, one) : !can_convert(from, row, to)) return false;
  read_numbers<Real>(array, row, to);
  return true;
}

// load_numbers, and below load_rows, of an array that is never broadcast: it has a row of its own for each row of the
// call.
template <class Real, class Number, size_t Width>
QTRAJ_INLINE bool load_own_numbers(const Input<Width>& array, size_t row, Number (&to)[Width]) {
  const Real* from = static_cast<const Real*>(array.data);
  if (!can_convert(from, row, to)) return false;
  convert_rows(from, row, to);
  return true;
}
template <class Real, class Number, size_t Width>
QTRAJ_INLINE bool load_own_rows(const Input<Width>& array, size_t row, Number (&to)[Width]) {
  return load_own_numbers<Real>(array, row, to) && all(is_ordinary(to));
}

// load_numbers; false also where a row is not ordinary, or not bounded.
template <class Real, class Number, size_t Width>
QTRAJ_INLINE bool load_rows(const Input<Width>& array, size_t row, Number (&to)[Width]) {
  return load_numbers<Real>(array, row, to) && all(is_ordinary(to));
}
template <class Real, class Number, size_t Width>
QTRAJ_INLINE bool load_bounded_rows(const Input<Width>& array, size_t row, Number (&to)[Width]) {
  return load_numbers<Real>(array, row, to) && all(is_bounded(to));
}
// load_numbers; false also where a fraction is not between 0 and 1.
template <class Real, class Number>
QTRAJ_INLINE bool load_fractions(const Input<1>& array, size_t row, Number (&to)[1]) {
  return load_numbers<Real>(array, row, to) && all(is_inside(to[0]));
}

// Calls operation(row), which does one row per lane of a Number from that row on, until fewer rows are left or it is
// false: it has then done nothing. Returns how many rows were done.
template <class Number, class Operation>
QTRAJ_INLINE size_t do_rows(size_t first, size_t count, const Operation& operation) {
  size_t row = first;
  while (row + kLanesOf<Number> <= count && operation(row)) row += kLanesOf<Number>;
  return row - first;
}

// The same of arrays of either type, computed with in Number: operation(row, real), `real` of the arrays' type.
template <class Number, class Operation>
size_t do_rows(bool is_float, size_t first, size_t count, const Operation& operation) {
  const auto do_rows_of = [&](auto real) {
    return do_rows<Number>(first, count, [&](size_t row) { return operation(row, real); });
  };
  return is_float ? do_rows_of(float()) : do_rows_of(double());
}

// The same with operation(row, largest, real), which raises `largest`, a Number, to what it finds in rows.
template <class Number, class Operation>
size_t do_rows_for_largest(bool is_float, size_t first, size_t count, double& largest, const Operation& operation) {
  Number raised(largest);
  const size_t rows =
      do_rows<Number>(is_float, first, count, [&](size_t row, auto real) { return operation(row, raised, real); });
  largest = largest_lane(raised);
  return rows;
}

}  // namespace
}  // namespace qtraj
