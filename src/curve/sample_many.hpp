// Sampling of many times in vectors, chunk by chunk. A chunk of increasing times with enough samples per segment is
// sampled run by run, a run being the samples in one segment, which is broadcast to all lanes. In any other chunk the
// times are scattered, and each lane has a segment of its own. Both do to each sample what sample_one.hpp does, to the
// last bit, so that the choice is one of speed alone. Rows that vectors cannot do (times outside the knots or not
// finite, rates that overflow) are done again one at a time.
#pragma once

#include "curve/chunk_times.hpp"
#include "curve/find_segments.hpp"
#include "curve/sample_one.hpp"
#include "curve/wide_output.hpp"

namespace qtraj {
namespace {

// kSample and kSampleAt: scalar sampling (sample_one.hpp) in the same arithmetic.
template <class Evaluator, class Arithmetic, class Real, bool kWithRates, SampleFunction<Real> kSample,
          SampleAtFunction<Real> kSampleAt>
class Batch {
 public:
  Batch(const Evaluator& evaluator, const Trajectory& trajectory, const TimeReader& source, size_t count,
        const SampleOutputs<Real>& outputs)
      : evaluator_(evaluator),
        trajectory_(trajectory),
        request_(rate_request(outputs)),
        index_(knot_index(trajectory.timeline)),
        segments_(segments_of<Segment>(trajectory)),
        source_(source),
        times_(source, count),
        count_(count),
        outputs_(outputs) {}

  Outcome sample(size_t& cursor) {
    Outcome outcome = {Status::ok, kNoIndex};
    for (first_row_ = 0; first_row_ < count_; first_row_ += kChunk) {
      const size_t rows = count_ - first_row_ < kChunk ? count_ - first_row_ : kChunk;
      has_marks_ = false;
      if (times_.read(first_row_, rows) && sample_runs(cursor)) {
        if (has_marks_) sample_again(rows, cursor, outcome);
      } else if constexpr (kScattersInVectors) {
        const bool all_inside = times_.clamp(index_.knots[0], trajectory_.timeline.last_inside);
        sample_scattered(rows);
        if (!all_inside || has_marks_) sample_again(rows, cursor, outcome);
      } else {
        sample_without_vectors(rows, cursor, outcome);
      }
    }
    return outcome;
  }

 private:
  using Segment = typename Evaluator::template SegmentOf<double>;
  using WideSegment = typename Evaluator::template SegmentOf<Wide<Real>>;
  using Number = Wide<Real>;
  using Partial = typename Evaluator::template PartialOf<Number, kWithRates>;
  using Time = Wide<double>;
  static constexpr size_t kChunk = Evaluator::kChunk, kSearched = Evaluator::kSearched;
  static constexpr size_t kLanes = Number::kLanes, kTimeLanes = Time::kLanes;
  using RunMode = SampleMode<kWithRates, true>;
  using ScatteredMode = SampleMode<kWithRates, false>;
  // How many vectors of a run are started before the first of them is finished. A sample is one long dependency chain,
  // and the out-of-order window is too small to overlap it with the next vector's.
  static constexpr size_t kInterleaved = Evaluator::template kInTwoSteps<kWithRates> ? 32 / kTimeLanes : 1;
  static constexpr size_t kFields = sizeof(Segment) / sizeof(double);
  // Whether it pays to gather a segment per lane.
  static constexpr bool kScattersInVectors = kTimeLanes > 2 || kWithRates ||
                                             Evaluator::kWork > (std::is_same_v<Real, double> ? 2 : 1);

  // ---- Sorted times: run by run ----

  // The number of rows from which a run is faster than the same rows with a segment per lane: half a vector, but a
  // whole one with rates and where half would be a single row.
  static constexpr size_t kLeastRun = kWithRates || kLanes < 4 ? kLanes : kLanes / 2;

  // False, with nothing done, where runs would on average be shorter than that or times are outside the knots.
  bool sample_runs(size_t& cursor) {
    const size_t rows = times_.rows();
    const double first_time = read_once(times_[0]), last_time = read_once(times_[rows - 1]);
    if (first_time < index_.knots[0] || last_time > trajectory_.timeline.last_inside) return false;
    if (!(first_time <= last_time)) return false;
    const size_t first = find_segment(index_, first_time, cursor);
    const size_t last = find_segment(index_, last_time, first);
    cursor = last;
    if ((last - first) * kLeastRun >= rows) return false;
    for (size_t segment = first, begin = 0; segment <= last; ++segment) {
      const size_t end = segment == last ? rows : times_.first_at_or_after(index_.knots[segment + 1], begin);
      if (begin < end) {
        if (is_gap(trajectory_.timeline, index_.knots, segment))
          mark_again(begin, end - begin);
        else
          sample_run(segment, begin, end);
      }
      begin = end;
    }
    return true;
  }

  // Samples the times from `begin` to `end`, all in one segment.
  QTRAJ_NOINLINE void sample_run(size_t segment, size_t begin, size_t end) {
    const Segment& record = segments_[segment];
    WideSegment wide;
    Doubles<Real> scales;
    broadcast(record, wide, scales);
    const Time knot(index_.knots[segment]), offset(Evaluator::offset(record));
    if constexpr (kWithRates && !Evaluator::template kOwnLoopWithRates<Real>) {
      sample_with_rates(begin, end, wide, scales, nullptr, knot, offset);
    } else {
      const auto start_at = [&](size_t i, Partial& partial) {
        const Number x = position(i, end, knot, scales.part[0], offset);
        times_.prefetch(i);
        evaluator_.template start<RunMode>(wide, x, partial);
        return x;
      };
      for (size_t group = begin; group < end; group += kInterleaved * kLanes) {
        const size_t left = (end - group + kLanes - 1) / kLanes;
        const size_t vectors = kInterleaved == 1 || left >= kInterleaved ? kInterleaved : left;
        Number x[kInterleaved];
        Partial partial[kInterleaved];
        for (size_t k = 0; k < vectors; ++k) x[k] = start_at(group + k * kLanes, partial[k]);
        for (size_t k = 0; k < vectors; ++k) finish<RunMode>(wide, x[k], partial[k], scales, group + k * kLanes, end);
      }
    }
  }

  // Broadcasts one segment to all lanes.
  void broadcast(const Segment& record, WideSegment& wide, Doubles<Real>& scales) const {
    const auto* fields = reinterpret_cast<const double*>(&record);
    read_segment<Number>([&](size_t k) { return Number(static_cast<Real>(fields[k])); }, wide);
    for (Time& part : scales.part) part = Time(Evaluator::scale(record));
  }

  // The parameters x of the times from i on, up to `end`.
  QTRAJ_INLINE Number position(size_t i, size_t end, Time knot, Time scale, Time offset) const {
    double padded[kLanes];
    const double* times = times_.from(i);
    if (end - i < kLanes) {
      times_.fill_up(i, end, padded);
      times = padded;
    }
    Doubles<Real> x;
    for (size_t part = 0; part < Doubles<Real>::kParts; ++part)
      x.part[part] = parameter<Arithmetic>(Time::load(times + part * kTimeLanes) - knot, scale, offset);
    return x.rounded();
  }

  // ---- Other times: a segment for each lane ----

  QTRAJ_NOINLINE void sample_scattered(size_t rows) {
    int64_t found[kSearched + kLanes];  // segments of the times
    WideSegment wide;
    Doubles<Real> scales;
    for (size_t begin = 0; begin < rows; begin += kSearched) {
      const size_t end = rows - begin < kSearched ? rows : begin + kSearched;
      find_segments(index_, times_.from(begin), end - begin + kLanes - kTimeLanes, found);
      mark_gaps(begin, end, found);
      if constexpr (kWithRates) {
        sample_with_rates(begin, end, wide, scales, found, Time(0.0), Time(1.0));
        continue;
      }
      for (size_t i = begin; i < end; i += kLanes) {
        Doubles<Real> x;
        load_segments(found + (i - begin), i, wide, scales, x);
        times_.prefetch(i);
        Partial partial;
        evaluator_.template start<ScatteredMode>(wide, x.rounded(), partial);
        finish<ScatteredMode>(wide, x.rounded(), partial, scales, i, end);
      }
    }
  }

  // One loop for scattered times and, unless the evaluator has kOwnLoopWithRates, for runs: with rates the evaluation
  // takes most of the time and of the library's code. With segments `found` it loads one for each lane, without them it
  // samples a run, whose segment is already broadcast and starts at the knot.
  QTRAJ_NOINLINE void sample_with_rates(size_t begin, size_t end, WideSegment& wide, Doubles<Real>& scales,
                                        const int64_t* found, Time knot, Time offset) {
    const size_t at_once = found ? 1 : kInterleaved;
    for (size_t group = begin; group < end; group += at_once * kLanes) {
      const size_t left = (end - group + kLanes - 1) / kLanes, vectors = left < at_once ? left : at_once;
      Number x[kInterleaved];
      Partial partial[kInterleaved];
      for (size_t k = 0; k < vectors; ++k) {
        const size_t i = group + k * kLanes;
        Doubles<Real> of_segments;
        if (found) {
          load_segments(found + (i - begin), i, wide, scales, of_segments);
          x[k] = of_segments.rounded();
        } else {
          x[k] = position(i, end, knot, scales.part[0], offset);
        }
        times_.prefetch(i);
        evaluator_.template start<ScatteredMode>(wide, x[k], partial[k]);
      }
      for (size_t k = 0; k < vectors; ++k)
        finish<ScatteredMode>(wide, x[k], partial[k], scales, group + k * kLanes, end);
    }
  }

  // Loads the segments found for a vector of times, and the parameters x of the times in them.
  QTRAJ_INLINE void load_segments(const int64_t* found, size_t i, WideSegment& wide, Doubles<Real>& scales,
                                  Doubles<Real>& x) const {
    static_assert(sizeof(WideSegment) == kFields * sizeof(Number));
    constexpr size_t kParts = Doubles<Real>::kParts;
    auto& fields = reinterpret_cast<Number(&)[kFields]>(wide);
    const double* records[kParts][kTimeLanes];
    for (size_t part = 0; part < kParts; ++part)
      for (size_t lane = 0; lane < kTimeLanes; ++lane)
        records[part][lane] = reinterpret_cast<const double*>(segments_ + found[part * kTimeLanes + lane]);
    Doubles<Real> offsets;
    if constexpr (kParts == 1) {
      load_records(records[0], fields);
      scales.part[0] = fields[0];
      offsets.part[0] = fields[1];
    } else if constexpr (kFields <= kFewFields) {
      Time low[kFields], high[kFields];
      load_records(records[0], low);
      load_records(records[1], high);
      for (size_t k = 1; k < kFields; ++k) fields[k] = Doubles<Real>{{low[k], high[k]}}.rounded();
      scales = {{low[0], high[0]}}, offsets = {{low[1], high[1]}};
      fields[0] = Number(Real(0));
    } else {
      load_two_parts(records, fields, scales, offsets);
    }
    for (size_t part = 0; part < kParts; ++part) {
      const size_t at = part * kTimeLanes;
      const Time knot = gather(index_.knots, hn::LoadU(IndexTag(), found + at));
      x.part[part] = parameter<Arithmetic>(Time::load(times_.from(i + at)) - knot, scales.part[part],
                                           Evaluator::kHasOffset ? offsets.part[part] : Time(1.0));
    }
  }
  // Up to so many fields of two vectors of double wait on the stack for each other, which is faster.
  static constexpr size_t kFewFields = 17;
  // Fields of two vectors of double as one vector of float; few at a time, so that they do not wait on the stack for
  // each other. The first two are returned in double as well, and the first, the scale of time, is 0 in float, whose
  // range it may be past.
  QTRAJ_INLINE static void load_two_parts(const double* const (&records)[2][kTimeLanes], Number (&fields)[kFields],
                                          Doubles<Real>& first, Doubles<Real>& second) {
    for (size_t next = 0; next < kFields; next += kTransposed) {
      // the last group may overlap the one before, so that nothing past a record is read
      const size_t from = next + kTransposed <= kFields ? next : kFields - kTransposed;
      Time low[kTransposed], high[kTransposed];
      load_transposed(records[0], from, low);
      load_transposed(records[1], from, high);
      if (next == 0) {
        first = {{low[0], high[0]}}, second = {{low[1], high[1]}};
        low[0] = high[0] = Time(0.0);
      }
      for (size_t k = 0; k < kTransposed; ++k) fields[from + k] = Doubles<Real>{{low[k], high[k]}}.rounded();
    }
  }

  // Finishes and writes a vector of samples, of which those before `end` count. Rows past `end` may be written too: the
  // vectors after this one overwrite them.
  template <class Mode>
  QTRAJ_INLINE void finish(const WideSegment& segment, Number x, const Partial& partial, const Doubles<Real>& scales,
                           size_t i, size_t end) {
    const size_t row = first_row_ + i, rows = end - i < kLanes ? end - i : kLanes;
    const size_t left = count_ - row;
    WideRow<Real> wide;
    if constexpr (kWithRates) {
      evaluator_.template finish_rates<Mode>(segment, x, partial, request_.alpha, wide.q, wide.rates);
      if (!finish_rates<Arithmetic, Evaluator::kSmallRates>(scales, request_, wide)) mark_again(i, rows);
      if (outputs_.omega) write_wide(wide.rates.omega, outputs_.omega, row, rows, left);
      if (outputs_.alpha) write_wide(wide.rates.alpha, outputs_.alpha, row, rows, left);
      if (outputs_.q) write_wide(wide.q, outputs_.q, row, rows, left);
    } else {
      evaluator_.template finish<Mode>(segment, x, partial, wide.q);
      write_wide(wide.q, outputs_.q, row, rows, left);
    }
  }

  // ---- Rows done again ----

  void mark_gaps(size_t begin, size_t end, const int64_t* found) {
    if (trajectory_.timeline.longest_gap == __builtin_inf()) return;
    for (size_t i = begin; i < end; ++i)
      if (is_gap(trajectory_.timeline, index_.knots, static_cast<size_t>(found[i - begin]))) mark_again(i, 1);
  }

  QTRAJ_NOINLINE void mark_again(size_t i, size_t rows) {
    if (!has_marks_)
      for (bool& mark : marked_) mark = false;
    has_marks_ = true;
    for (size_t k = i; k < i + rows; ++k) marked_[k] = true;
  }

  QTRAJ_NOINLINE void sample_again(size_t rows, size_t& cursor, Outcome& outcome) {
    for (size_t i = 0; i < rows; ++i) {
      const double time = source_[first_row_ + i];
      const bool inside = is_finite(time) && is_inside(trajectory_.timeline, time);
      if (inside && !(has_marks_ && marked_[i])) continue;
      const size_t row = first_row_ + i;
      keep_first(kSampleAt(trajectory_, time, cursor, from_row(outputs_, row)), row, outcome);
    }
  }

  void sample_without_vectors(size_t rows, size_t& cursor, Outcome& outcome) {
    const TimeSource times = {times_.from(0), 0, 0};
    const Outcome chunk = kSample(trajectory_, times, rows, cursor, from_row(outputs_, first_row_));
    keep_first(chunk.status, first_row_ + chunk.index, outcome);
  }

  const Evaluator evaluator_;
  const Trajectory& trajectory_;
  const RateRequest request_;
  const KnotIndex index_;
  const Segment* segments_;
  const TimeReader& source_;
  ChunkTimes<kLanes, kChunk> times_;
  const size_t count_;
  const SampleOutputs<Real>& outputs_;

  // The state of the present chunk.
  size_t first_row_ = 0;
  bool has_marks_ = false;  // some row inside the knots is marked to be done again
  bool marked_[kChunk];
};

template <class Arithmetic, class Real, SampleFunction<Real> kSample, SampleAtFunction<Real> kSampleAt>
Outcome sample_many(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor,
                    const SampleOutputs<Real>& outputs) {
  if (count < Wide<Real>::kLanes) return kSample(trajectory, source, count, cursor, outputs);
  if (std::is_same_v<Real, float> && trajectory.range == ExponentRange::any)
    return kSample(trajectory, source, count, cursor, outputs);
  return with_evaluator_for<Arithmetic>(trajectory, outputs, [&](const auto& evaluator, auto with_rates) {
    using Evaluator = std::decay_t<decltype(evaluator)>;
    constexpr bool kWithRates = decltype(with_rates)::value;
    const TimeReader times(source, count);
    return Batch<Evaluator, Arithmetic, Real, kWithRates, kSample, kSampleAt>(evaluator, trajectory, times, count,
                                                                              outputs)
        .sample(cursor);
  });
}

}  // namespace
}  // namespace qtraj
