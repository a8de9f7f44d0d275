// Sampling many times at once, in vectors. Times are taken in chunks. A chunk of increasing times that stays for a
// while in each segment is sampled run by run, the segment's numbers the same in all lanes; in any other chunk each
// lane has a segment of its own. Both do to each sample what sample.hpp does, to the last bit, so that it does not
// matter which way a chunk goes. Rows that vectors cannot do (times outside the knots or not finite, rates that
// overflow) are done again one at a time.
#pragma once

#include "sample.hpp"
#include "wide_rows.hpp"
#include "wide_segments.hpp"

namespace qtraj {
namespace {

constexpr size_t kChunk = 512;
// Samples of a segment from which a run is worth its setting up, in vectors.
constexpr size_t kLeastRun = 2;

template <class Evaluator, class Arithmetic, class Real, bool kWithRates>
class Batch {
 public:
  Batch(const Evaluator& evaluator, const Trajectory& trajectory, const TimeReader& source, size_t count,
        const SampleOutputs<Real>& outputs)
      : evaluator_(evaluator),
        sampler_(evaluator, trajectory, wanted_of(outputs)),
        wanted_(wanted_of(outputs)),
        index_(knot_index(trajectory)),
        segments_(segments_of<Segment>(trajectory)),
        source_(source),
        count_(count),
        outputs_(outputs) {}

  Outcome sample(size_t& cursor) {
    Outcome outcome = {Status::ok, kNoIndex};
    for (first_row_ = 0; first_row_ < count_; first_row_ += kChunk) {
      const size_t rows = count_ - first_row_ < kChunk ? count_ - first_row_ : kChunk;
      bool all_inside = true;
      has_marks_ = false;
      if (!find_sorted_times(rows) || !sample_runs(rows, cursor)) {
        all_inside = clamp_times(rows);
        sample_staged(rows);
      }
      if (!all_inside || has_marks_) sample_again(rows, cursor, outcome);
    }
    return outcome;
  }

 private:
  using Segment = typename Evaluator::template SegmentOf<double>;
  using WideSegment = typename Evaluator::template SegmentOf<Wide<Real>>;
  using Number = Wide<Real>;
  using Time = Wide<double>;
  static constexpr size_t kLanes = Number::kLanes, kTimeLanes = Time::kLanes;
  static constexpr size_t kFields = sizeof(Segment) / sizeof(double);

  // ---- Times ----

  // Points times_ to the times of the chunk. Whether all are within the knots and none is before the one before it.
  bool find_sorted_times(size_t rows) {
    if (source_.source().array) {
      times_ = source_.source().array + first_row_;
    } else {
      generate_times(rows);
      times_ = buffer_;
    }
    return all_finite(rows) && times_[0] >= index_.knots[0] && times_[rows - 1] <= index_.knots[index_.segments] &&
           is_sorted(rows);
  }

  void generate_times(size_t rows) {
    if (!source_.is_plain_uniform()) {
      for (size_t i = 0; i < rows; ++i) buffer_[i] = source_[first_row_ + i];
      return;
    }
    const Time start(source_.source().start), step(source_.source().step);
    const Time first(static_cast<double>(first_row_));
    for (size_t i = 0; i < rows; i += kTimeLanes) {
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

  bool all_finite(size_t rows) const {
    WideMask<double> none = Time(1.0) <= Time(0.0), not_finite = none;
    size_t i = 0;
    for (; i + kTimeLanes <= rows; i += kTimeLanes) not_finite = not_finite | is_not_finite(Time::load(times_ + i));
    bool finite = !any(not_finite);
    for (; i < rows; ++i) finite = finite && is_finite(times_[i]);
    return finite;
  }

  // Finite times.
  bool is_sorted(size_t rows) const {
    WideMask<double> sorted = Time(0.0) <= Time(0.0);
    size_t i = 0;
    for (; i + kTimeLanes < rows; i += kTimeLanes)
      sorted = sorted & (Time::load(times_ + i) <= Time::load(times_ + i + 1));
    bool rest = true;
    for (; i + 1 < rows; ++i) rest = rest && times_[i] <= times_[i + 1];
    return rest && all(sorted);
  }

  // Copies the times to the buffer, where those outside the knots or not finite become the first knot, and the last
  // vector is filled. Whether all were inside.
  bool clamp_times(size_t rows) {
    const Time first(index_.knots[0]), last(index_.knots[index_.segments]);
    if (times_ != buffer_) std::memcpy(buffer_, times_, rows * sizeof(double));
    for (size_t i = rows; i < rows + kLanes; ++i) buffer_[i] = index_.knots[0];
    times_ = buffer_;
    WideMask<double> all_inside = first <= first;
    for (size_t i = 0; i < rows; i += kTimeLanes) {
      const Time time = Time::load(buffer_ + i);
      const Time finite = select(is_not_finite(time), Time(-kLargest), time);
      const WideMask<double> inside = (first <= finite) & (finite <= last);
      all_inside = all_inside & inside;
      select(inside, finite, first).store(buffer_ + i);
    }
    return all(all_inside);
  }

  // Asks for times a chunk ahead of a vector's: the next chunk begins with a look at all of them.
  QTRAJ_INLINE void prefetch_times(size_t row) const {
    constexpr size_t kLine = 64 / sizeof(double);
    const double* const times = source_.source().array;
    if (!times || count_ - row < kChunk + kLanes) return;
    for (size_t k = 0; k < kLanes; k += kLine) __builtin_prefetch(times + row + kChunk + k);
  }

  // ---- Sorted times: run by run ----

  // False, and nothing done, where runs would be too short.
  bool sample_runs(size_t rows, size_t& cursor) {
    const size_t first = find_segment(index_, times_[0], cursor);
    const size_t last = find_segment(index_, times_[rows - 1], first);
    cursor = last;
    if ((last - first) * kLeastRun * kLanes >= rows) return false;
    for (size_t segment = first, begin = 0; segment <= last; ++segment) {
      const size_t end = segment == last ? rows : first_at_or_after(index_.knots[segment + 1], begin, rows);
      if (begin < end) sample_run(segment, begin, end);
      begin = end;
    }
    return true;
  }

  // First of the sorted times in [begin, end) that is not before a knot.
  size_t first_at_or_after(double knot, size_t begin, size_t end) const {
    while (begin < end) {
      const size_t middle = begin + (end - begin) / 2;
      if (times_[middle] < knot)
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }

  void sample_run(size_t segment, size_t begin, size_t end) {
    const Segment& record = segments_[segment];
    const auto* fields = reinterpret_cast<const double*>(&record);
    WideSegment wide;
    read_segment<Number>([&](size_t k) { return Number(static_cast<Real>(fields[k])); }, wide);
    const Time knot(index_.knots[segment]), scale(Evaluator::scale(record)), offset(Evaluator::offset(record));
    Doubles<Real> scales;
    for (Time& part : scales.part) part = scale;
    double rest[kLanes];
    for (size_t i = begin; i < end; i += kLanes) {
      const double* times = times_ + i;
      if (end - i < kLanes) {
        for (size_t k = 0; k < kLanes; ++k) rest[k] = times_[i + k < end ? i + k : end - 1];
        times = rest;
      }
      Doubles<Real> x;
      for (size_t part = 0; part < Doubles<Real>::kParts; ++part)
        x.part[part] = parameter<Arithmetic>(Time::load(times + part * kTimeLanes) - knot, scale, offset);
      sample_lanes(wide, x.rounded(), scales, i, end);
    }
  }

  // ---- Other times: a segment for each lane ----

  void sample_staged(size_t rows) {
    find_segments(index_, times_, rows + kLanes - kTimeLanes, found_);
    for (size_t i = 0; i < rows; i += kLanes) {
      WideSegment wide;
      Doubles<Real> x, scales;
      load_segments(i, wide, scales, x);
      sample_lanes(wide, x.rounded(), scales, i, rows);
    }
  }

  // The segments found for a vector of times, and these in units of their segments.
  QTRAJ_INLINE void load_segments(size_t i, WideSegment& wide, Doubles<Real>& scales, Doubles<Real>& x) const {
    if constexpr (std::is_same_v<Real, double>) {
      static_assert(sizeof(WideSegment) == kFields * sizeof(Time));
      load_fields(i, reinterpret_cast<Time(&)[kFields]>(wide), scales.part[0], x.part[0]);
    } else {
      Time fields[Doubles<Real>::kParts][kFields];
      for (size_t part = 0; part < Doubles<Real>::kParts; ++part)
        load_fields(i + part * kTimeLanes, fields[part], scales.part[part], x.part[part]);
      read_segment<Number>([&](size_t k) { return Doubles<Real>{{fields[0][k], fields[1][k]}}.rounded(); }, wide);
    }
  }
  QTRAJ_INLINE void load_fields(size_t at, Time (&fields)[kFields], Time& scale, Time& x) const {
    const double* records[kTimeLanes];
    for (size_t lane = 0; lane < kTimeLanes; ++lane)
      records[lane] = reinterpret_cast<const double*>(segments_ + found_[at + lane]);
    load_records(records, fields);
    scale = fields[0];
    const Time knot = gather(index_.knots, hn::LoadU(IndexTag(), found_ + at));
    x = parameter<Arithmetic>(Time::load(times_ + at) - knot, scale, Evaluator::kHasOffset ? fields[1] : Time(1.0));
  }

  // One vector of samples, of which those before `end` count. Rows past it, where there are any, are written too and
  // corrected later.
  QTRAJ_INLINE void sample_lanes(const WideSegment& segment, Number x, const Doubles<Real>& scales, size_t i,
                                 size_t end) {
    const size_t row = first_row_ + i, rows = end - i < kLanes ? end - i : kLanes;
    const size_t left = count_ - row;
    WideRow<Real> wide;
    prefetch_times(row);
    if constexpr (kWithRates) {
      Rates<Number> rates;
      evaluator_.sample_rates(segment, x, wanted_.alpha, wide.q, rates);
      if (!finish_rates<Arithmetic, Evaluator::kSmallRates>(wide.q, rates, scales, wanted_, wide)) mark_again(i, rows);
      if (outputs_.omega) write_wide(wide.omega, outputs_.omega, row, rows, left);
      if (outputs_.alpha) write_wide(wide.alpha, outputs_.alpha, row, rows, left);
      if (outputs_.q) write_wide(wide.q, outputs_.q, row, rows, left);
    } else {
      evaluator_.sample(segment, x, wide.q);
      write_wide(wide.q, outputs_.q, row, rows, left);
    }
  }

  // ---- Rows done again ----

  void mark_again(size_t i, size_t rows) {
    if (!has_marks_)
      for (bool& mark : marked_) mark = false;
    has_marks_ = true;
    for (size_t k = i; k < i + rows; ++k) marked_[k] = true;
  }

  void sample_again(size_t rows, size_t& cursor, Outcome& outcome) {
    for (size_t i = 0; i < rows; ++i) {
      const double time = source_[first_row_ + i];
      const bool inside = is_finite(time) && time >= index_.knots[0] && time <= index_.knots[index_.segments];
      if (!inside || (has_marks_ && marked_[i])) sample_row(sampler_, time, first_row_ + i, cursor, outputs_, outcome);
    }
  }

  const Evaluator evaluator_;
  const Sampler<Evaluator, Arithmetic, Real, kWithRates> sampler_;
  const Wanted wanted_;
  const KnotIndex index_;
  const Segment* segments_;
  const TimeReader& source_;
  const size_t count_;
  const SampleOutputs<Real>& outputs_;

  // Of the chunk.
  size_t first_row_ = 0;
  const double* times_ = nullptr;  // the caller's, or in buffer_
  bool has_marks_ = false;         // some row inside the knots is marked to be done again
  bool marked_[kChunk];
  double buffer_[kChunk + kLanes];
  int64_t found_[kChunk + kLanes];  // segments of the times
};

template <class Arithmetic, class Real>
Outcome sample_batch(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor,
                     const SampleOutputs<Real>& outputs) {
  if (count < Wide<Real>::kLanes) return sample<Arithmetic>(trajectory, source, count, cursor, outputs);
  return with_evaluator<Arithmetic>(trajectory, [&](const auto& evaluator) {
    using Evaluator = std::decay_t<decltype(evaluator)>;
    if constexpr (std::is_same_v<typename Evaluator::template Working<Real>, Real>) {
      const TimeReader times(source, count);
      if (outputs.omega || outputs.alpha)
        return Batch<Evaluator, Arithmetic, Real, true>(evaluator, trajectory, times, count, outputs).sample(cursor);
      return Batch<Evaluator, Arithmetic, Real, false>(evaluator, trajectory, times, count, outputs).sample(cursor);
    } else {
      return sample<Arithmetic>(trajectory, source, count, cursor, outputs);
    }
  });
}

}  // namespace
}  // namespace qtraj
