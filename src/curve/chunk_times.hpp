// The times of one chunk of a batch: read from the caller's array or generated, checked for order, and padded to whole
// vectors. sample_many.hpp samples at them.
#pragma once

#include <cstdint>
#include <cstring>

#include "curve/sample_call.hpp"
#include "simd/prefetch.hpp"
#include "simd/wide.hpp"

namespace qtraj {
namespace {

// kLanes: the lanes of a vector of samples, whose times fill one vector of doubles or two. kChunk: the most times in a
// chunk.
template <size_t kLanes, size_t kChunk>
class ChunkTimes {
 public:
  ChunkTimes(const TimeReader& source, size_t count) : source_(source), count_(count) {}

  // Reads the times of `rows` rows from `first_row` on. Whether all are finite and none is before its predecessor.
  bool read(size_t first_row, size_t rows) {
    first_row_ = first_row;
    rows_ = rows;
    if (source_.source().array) {
      times_ = source_.source().array + first_row;
    } else {
      generate();
      times_ = buffer_;
    }
    return are_in_order();
  }

  size_t rows() const { return rows_; }
  const double& operator[](size_t i) const { return times_[i]; }
  const double* from(size_t i) const { return times_ + i; }
  // The buffer from i on, for `rows` numbers and the padding of the last vector; it is read from once it was asked for.
  double* in_buffer(size_t i) {
    times_ = buffer_;
    return buffer_ + i;
  }

  // Copies the times to the buffer, replaces those that are not finite or outside the knots by the first knot, and pads
  // the last vector. Whether all were inside.
  QTRAJ_NOINLINE bool clamp(double first_knot, double last_knot) {
    // outside the knots: their span is finite, so that they cannot reach both ends of the range
    const Time first(first_knot), last(last_knot), outside(last_knot < kLargest ? kLargest : -kLargest);
    if (times_ != buffer_) std::memcpy(buffer_, times_, rows_ * sizeof(double));
    for (size_t i = rows_; i < rows_ + kLanes; ++i) buffer_[i] = first_knot;
    times_ = buffer_;
    WideMask<double> all_inside = first <= first;
    for (size_t i = 0; i < rows_; i += kTimeLanes) {
      const Time time = Time::load(buffer_ + i);
      const Time finite = select(is_not_finite(time), outside, time);
      const WideMask<double> inside = (first <= finite) & (finite <= last);
      all_inside = all_inside & inside;
      select(inside, finite, first).store(buffer_ + i);
    }
    return all(all_inside);
  }

  // Index of the first of the sorted times in [begin, rows) that is not before a knot. A linear scan by vectors: where
  // this is called often the answer is near, and a binary search would mispredict its branches.
  size_t first_at_or_after(double knot, size_t begin) const {
    const Time limit(knot);
    for (; rows_ - begin >= kTimeLanes; begin += kTimeLanes) {
      const size_t before = hn::CountTrue(Time::Tag(), (Time::load(times_ + begin) < limit).lanes);
      if (before < kTimeLanes) return begin + before;
    }
    while (begin < rows_ && times_[begin] < knot) ++begin;
    return begin;
  }

  // Copies the sorted times from `begin` to `end`, fewer than kLanes, and pads them with the last one. Whole vectors
  // are stored where the chunk has so many times left: a vector load cannot be forwarded from several scalar stores, so
  // that store forwarding would fail.
  void fill_up(size_t begin, size_t end, double (&filled)[kLanes]) const {
    if (rows_ - begin < kLanes) {
      for (size_t k = 0; k < kLanes; ++k) filled[k] = times_[begin + k < end ? begin + k : end - 1];
      return;
    }
    const Time last(times_[end - 1]);
    for (size_t k = 0; k < kLanes; k += kTimeLanes) {
      const Time time = Time::load(times_ + begin + k);
      select(time <= last, time, last).store(filled + k);
    }
  }

  // Prefetches the times one chunk ahead of this vector's, because the next chunk begins with a pass over all of them.
  QTRAJ_INLINE void prefetch(size_t i) const {
    const double* const times = source_.source().array;
    const size_t row = first_row_ + i;
    if (!times || count_ - row < kChunk + kLanes) return;
    prefetch_for_reading(times + row + kChunk, kLanes * sizeof(double));
  }

 private:
  using Time = Wide<double>;
  static constexpr size_t kTimeLanes = Time::kLanes;

  void generate() {
    if (!source_.is_plain_uniform()) {
      for (size_t i = 0; i < rows_; ++i) buffer_[i] = source_[first_row_ + i];
      return;
    }
    const Time start(source_.source().start), step(source_.source().step);
    const Time first(static_cast<double>(first_row_));
    for (size_t i = 0; i < rows_; i += kTimeLanes) {
      const Time row = first + Time::of(hn::Iota(Time::Tag(), static_cast<double>(i)));
      (start + row * step).store(buffer_ + i);
    }
  }

  // Tests the exponent bits: a comparison with a NaN would raise FE_INVALID.
  QTRAJ_INLINE static WideMask<double> is_not_finite(Time time) {
    const hn::RebindToUnsigned<Time::Tag> bits;
    const auto exponent = hn::Set(bits, 0x7ff0000000000000u);
    return {hn::RebindMask(Time::Tag(), hn::Eq(hn::And(hn::BitCast(bits, time.lanes), exponent), exponent))};
  }

  using Bits = hn::RebindToSigned<Time::Tag>;
  using BitsOf = hn::Vec<Bits>;
  QTRAJ_INLINE static BitsOf bits_of_time(Time time) { return hn::BitCast(Bits(), time.lanes); }

  // Whether no time is above the one after it, compared as the integers that `key` makes of them.
  template <class Key>
  QTRAJ_INLINE bool ascend(const Key& key) const {
    constexpr size_t kBlock = 128;
    WideMask<double> found = Time(1.0) <= Time(0.0);
    const auto look = [&](Time time, Time next) {
      found = found | WideMask<double>{hn::RebindMask(Time::Tag(), hn::Gt(key(time), key(next)))};
    };
    const auto look_at = [&](size_t i) { look(Time::load(times_ + i), Time::load(times_ + i + 1)); };
    const size_t pairs = rows_ - 1, whole = pairs - pairs % kTimeLanes;
    // an early exit after each block: of times in no order it takes the first one
    for (size_t block = 0; block < whole; block += kBlock) {
      const size_t end = block + kBlock < whole ? block + kBlock : whole;
      for (size_t i = block; i < end; i += kTimeLanes) look_at(i);
      if (any(found)) return false;
    }
    if (pairs >= kTimeLanes) {
      look_at(pairs - kTimeLanes);
    } else {
      for (size_t i = 0; i < pairs; ++i) look(Time(times_[i]), Time(times_[i + 1]));
    }
    return !any(found);
  }

  // Compares times by their bits, because a comparison of numbers would raise FE_INVALID for a NaN. Read as integers
  // the bits are in the order of the times where none is negative; otherwise all bits but the sign of the negative ones
  // are inverted first. NaN and infinities then sort to the ends, which are checked. -0 after 0 counts as disorder,
  // which costs time and nothing else.
  bool are_in_order() const {
    if (!is_finite(times_[0]) || !is_finite(times_[rows_ - 1])) return false;
    if (!__builtin_signbit(times_[0])) return ascend([](Time time) { return bits_of_time(time); });
    return ascend([](Time time) {
      const BitsOf bits = bits_of_time(time), all_but_sign = hn::Set(Bits(), INT64_MAX);
      return hn::Xor(bits, hn::And(hn::BroadcastSignBit(bits), all_but_sign));
    });
  }

  const TimeReader& source_;
  const size_t count_;
  size_t first_row_ = 0, rows_ = 0;
  const double* times_ = nullptr;  // the caller's, or in buffer_
  double buffer_[kChunk + kLanes];
};

}  // namespace
}  // namespace qtraj
