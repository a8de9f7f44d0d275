// The times of a chunk of a batch: read or made, checked, and brought into vectors.
#pragma once

#include <cstring>
#include <limits>

#include "curve/sample_call.hpp"
#include "simd/prefetch.hpp"
#include "simd/wide.hpp"

namespace qtraj {
namespace {

constexpr size_t kChunk = 512;

// kLanes: how many samples are done at once, one vector of times or several.
template <size_t kLanes>
class ChunkTimes {
 public:
  ChunkTimes(const TimeReader& source, size_t count) : source_(source), count_(count) {}

  // The times of the rows from `first_row` on. Whether all are finite and in order, none before the one before it.
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
  double operator[](size_t i) const { return times_[i]; }
  const double* from(size_t i) const { return times_ + i; }

  // Copies the times to the buffer, where those outside the knots or not finite become the first knot, and the last
  // vector is filled. Whether all were inside.
  QTRAJ_NOINLINE bool clamp(double first_knot, double last_knot) {
    const Time first(first_knot), last(last_knot);
    if (times_ != buffer_) std::memcpy(buffer_, times_, rows_ * sizeof(double));
    for (size_t i = rows_; i < rows_ + kLanes; ++i) buffer_[i] = first_knot;
    times_ = buffer_;
    WideMask<double> all_inside = first <= first;
    for (size_t i = 0; i < rows_; i += kTimeLanes) {
      const Time time = Time::load(buffer_ + i);
      const Time finite = select(is_not_finite(time), Time(-kLargest), time);
      const WideMask<double> inside = (first <= finite) & (finite <= last);
      all_inside = all_inside & inside;
      select(inside, finite, first).store(buffer_ + i);
    }
    return all(all_inside);
  }

  // First of the sorted times in [begin, rows) that is not before a knot. Vector by vector: where it is asked for often
  // it is near, and halving steps would be guessed wrong.
  size_t first_at_or_after(double knot, size_t begin) const {
    const Time limit(knot);
    for (; rows_ - begin >= kTimeLanes; begin += kTimeLanes) {
      const size_t before = hn::CountTrue(Time::Tag(), (Time::load(times_ + begin) < limit).lanes);
      if (before < kTimeLanes) return begin + before;
    }
    while (begin < rows_ && times_[begin] < knot) ++begin;
    return begin;
  }

  // The sorted times from `begin` to `end`, fewer than kLanes, filled up with the last of them. Written as vectors
  // where so many times are left of the chunk: a load would wait until single numbers are in the cache.
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

  // Asks for the times a chunk ahead of a vector's: the next chunk begins with a look at all of them.
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

  // Told by the bits: a comparison with NaN would raise FE_INVALID.
  QTRAJ_INLINE static WideMask<double> is_not_finite(Time time) {
    const hn::RebindToUnsigned<Time::Tag> bits;
    const auto exponent = hn::Set(bits, 0x7ff0000000000000u);
    return {hn::RebindMask(Time::Tag(), hn::Eq(hn::And(hn::BitCast(bits, time.lanes), exponent), exponent))};
  }

  using Bits = hn::RebindToSigned<Time::Tag>;
  using BitsOf = hn::Vec<Bits>;
  QTRAJ_INLINE static BitsOf bits_of_time(Time time) { return hn::BitCast(Bits(), time.lanes); }

  // Whether, as integers that `key` makes of them, no time is above the one after it.
  template <class Key>
  QTRAJ_INLINE bool ascend(const Key& key) const {
    constexpr size_t kBlock = 128;
    WideMask<double> found = Time(1.0) <= Time(0.0);
    const auto look = [&](Time time, Time next) {
      found = found | WideMask<double>{hn::RebindMask(Time::Tag(), hn::Gt(key(time), key(next)))};
    };
    const auto look_at = [&](size_t i) { look(Time::load(times_ + i), Time::load(times_ + i + 1)); };
    const size_t pairs = rows_ - 1, whole = pairs - pairs % kTimeLanes;
    // times in no order are told from the first block
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

  // Times are ordered as their bits are where none is negative; else the bits of the negative ones, but their sign, are
  // inverted first. NaN and infinities then stand at the ends. Not by comparing numbers, as NaN would raise FE_INVALID.
  // -0 after 0 counts as disorder, which costs time and nothing else.
  bool are_in_order() const {
    if (!is_finite(times_[0]) || !is_finite(times_[rows_ - 1])) return false;
    if (!__builtin_signbit(times_[0])) return ascend([](Time time) { return bits_of_time(time); });
    return ascend([](Time time) {
      const BitsOf bits = bits_of_time(time), rest = hn::Set(Bits(), std::numeric_limits<int64_t>::max());
      return hn::Xor(bits, hn::And(hn::BroadcastSignBit(bits), rest));
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
