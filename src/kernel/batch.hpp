// Sampling many times at once, in vectors. Times are taken in chunks. A chunk of increasing times that stays for a
// while in each segment is sampled run by run, the segment's numbers the same in all lanes; in any other chunk each
// lane has a segment of its own. Both do to each sample what sample.hpp does, to the last bit, so that it does not
// matter which way a chunk goes. Rows that vectors cannot do (times outside the knots or not finite, rates that
// overflow) are done again one at a time.
#pragma once

#include "chunk_times.hpp"
#include "sample.hpp"
#include "wide_rows.hpp"
#include "wide_segments.hpp"

namespace qtraj {
namespace {

template <class Evaluator, class Arithmetic, class Real, bool kWithRates>
class Batch {
 public:
  Batch(const Evaluator& evaluator, const Trajectory& trajectory, const TimeReader& source, size_t count,
        const SampleOutputs<Real>& outputs)
      : evaluator_(evaluator),
        trajectory_(trajectory),
        wanted_(wanted_of(outputs)),
        index_(knot_index(trajectory)),
        segments_(segments_of<Segment>(trajectory)),
        source_(source),
        times_(source, count),
        count_(count),
        outputs_(outputs) {}

  Outcome sample(size_t& cursor) {
    Outcome outcome = {Status::ok, kNoIndex};
    for (first_row_ = 0; first_row_ < count_; first_row_ += kChunk) {
      const size_t rows = count_ - first_row_ < kChunk ? count_ - first_row_ : kChunk;
      bool all_inside = true;
      has_marks_ = false;
      if (!times_.read(first_row_, rows) || !sample_runs(cursor)) {
        all_inside = times_.clamp(index_.knots[0], index_.knots[index_.segments]);
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
  using Begun = typename Evaluator::template Begun<Number>;
  using Time = Wide<double>;
  static constexpr size_t kLanes = Number::kLanes, kTimeLanes = Time::kLanes;
  using RunTask = EvaluatorTask<kWithRates, true>;
  using StagedTask = EvaluatorTask<kWithRates, false>;
  // Vectors of a run that are begun before the first of them is finished: each step of a sample waits for the one
  // before, and a processor has too few instructions under way to fill that time with the next vector's.
  static constexpr size_t kGroup = Evaluator::template kInTwoSteps<kWithRates> ? 32 / kTimeLanes : 1;
  static constexpr size_t kFields = sizeof(Segment) / sizeof(double);

  // ---- Sorted times: run by run ----

  // Rows from which a run takes less time than as many with a segment for each lane. Half a vector, but a whole one
  // with rates and where half would be a single row.
  static constexpr size_t kLeastRun = kWithRates || kLanes < 4 ? kLanes : kLanes / 2;

  // False, and nothing done, where runs would on average be shorter or times are outside the knots.
  bool sample_runs(size_t& cursor) {
    const size_t rows = times_.rows();
    if (times_[0] < index_.knots[0] || times_[rows - 1] > index_.knots[index_.segments]) return false;
    const size_t first = find_segment(index_, times_[0], cursor);
    const size_t last = find_segment(index_, times_[rows - 1], first);
    cursor = last;
    if ((last - first) * kLeastRun >= rows) return false;
    for (size_t segment = first, begin = 0; segment <= last; ++segment) {
      const size_t end = segment == last ? rows : times_.first_at_or_after(index_.knots[segment + 1], begin);
      if (begin < end) sample_run(segment, begin, end);
      begin = end;
    }
    return true;
  }

  // The times from `begin` to `end`.
  void sample_run(size_t segment, size_t begin, size_t end) {
    const Segment& record = segments_[segment];
    const auto* fields = reinterpret_cast<const double*>(&record);
    WideSegment wide;
    read_segment<Number>([&](size_t k) { return Number(static_cast<Real>(fields[k])); }, wide);
    const Time knot(index_.knots[segment]), scale(Evaluator::scale(record)), offset(Evaluator::offset(record));
    Doubles<Real> scales;
    for (Time& part : scales.part) part = scale;
    double rest[kLanes];
    const auto begin_at = [&](size_t i, Begun& begun) {
      const double* times = times_.from(i);
      if (end - i < kLanes) {
        times_.fill_up(i, end, rest);
        times = rest;
      }
      Doubles<Real> x;
      for (size_t part = 0; part < Doubles<Real>::kParts; ++part)
        x.part[part] = parameter<Arithmetic>(Time::load(times + part * kTimeLanes) - knot, scale, offset);
      times_.prefetch(i);
      evaluator_.template begin<RunTask>(wide, x.rounded(), begun);
      return x.rounded();
    };
    for (size_t group = begin; group < end; group += kGroup * kLanes) {
      const size_t left = (end - group + kLanes - 1) / kLanes;
      const size_t vectors = kGroup == 1 || left >= kGroup ? kGroup : left;
      Number x[kGroup];
      Begun begun[kGroup];
      for (size_t k = 0; k < vectors; ++k) x[k] = begin_at(group + k * kLanes, begun[k]);
      for (size_t k = 0; k < vectors; ++k) finish<RunTask>(wide, x[k], begun[k], scales, group + k * kLanes, end);
    }
  }

  // ---- Other times: a segment for each lane ----

  // Not inline: with rates, GCC makes it 9 % slower within its caller.
  __attribute__((noinline)) void sample_staged(size_t rows) {
    find_segments(index_, times_.from(0), rows + kLanes - kTimeLanes, found_);
    for (size_t i = 0; i < rows; i += kLanes) {
      WideSegment wide;
      Doubles<Real> x, scales;
      load_segments(i, wide, scales, x);
      times_.prefetch(i);
      Begun begun;
      evaluator_.template begin<StagedTask>(wide, x.rounded(), begun);
      finish<StagedTask>(wide, x.rounded(), begun, scales, i, rows);
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
    x = parameter<Arithmetic>(Time::load(times_.from(at)) - knot, scale, Evaluator::kHasOffset ? fields[1] : Time(1.0));
  }

  // One vector of samples, of which those before `end` count. Rows past it, where there are any, are written too and
  // corrected later.
  template <class Task>
  QTRAJ_INLINE void finish(const WideSegment& segment, Number x, const Begun& begun, const Doubles<Real>& scales,
                           size_t i, size_t end) {
    const size_t row = first_row_ + i, rows = end - i < kLanes ? end - i : kLanes;
    const size_t left = count_ - row;
    WideRow<Real> wide;
    if constexpr (kWithRates) {
      Rates<Number> rates;
      evaluator_.template finish_rates<Task>(segment, x, begun, wanted_.alpha, wide.q, rates);
      if (!finish_rates<Arithmetic, Evaluator::kSmallRates>(wide.q, rates, scales, wanted_, wide)) mark_again(i, rows);
      if (outputs_.omega) write_wide(wide.omega, outputs_.omega, row, rows, left);
      if (outputs_.alpha) write_wide(wide.alpha, outputs_.alpha, row, rows, left);
      if (outputs_.q) write_wide(wide.q, outputs_.q, row, rows, left);
    } else {
      evaluator_.template finish<Task>(segment, x, begun, wide.q);
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
      if (inside && !(has_marks_ && marked_[i])) continue;
      const size_t row = first_row_ + i;
      const Status status = sample_row<Arithmetic, kWithRates>(evaluator_, trajectory_, time, cursor, outputs_, row);
      keep_first(status, row, outcome);
    }
  }

  const Evaluator evaluator_;
  const Trajectory& trajectory_;
  const Wanted wanted_;
  const KnotIndex index_;
  const Segment* segments_;
  const TimeReader& source_;
  ChunkTimes<kLanes> times_;
  const size_t count_;
  const SampleOutputs<Real>& outputs_;

  // Of the chunk.
  size_t first_row_ = 0;
  bool has_marks_ = false;  // some row inside the knots is marked to be done again
  bool marked_[kChunk];
  int64_t found_[kChunk + kLanes];  // segments of the times
};

template <class Arithmetic, class Real>
Outcome sample_batch(const Trajectory& trajectory, const TimeSource& source, size_t count, size_t& cursor,
                     const SampleOutputs<Real>& outputs) {
  if (count < Wide<Real>::kLanes) return sample<Arithmetic>(trajectory, source, count, cursor, outputs);
  return with_evaluator_for<Arithmetic>(trajectory, outputs, [&](const auto& evaluator, auto with_rates) {
    using Evaluator = std::decay_t<decltype(evaluator)>;
    if constexpr (std::is_same_v<typename Evaluator::template Working<Real>, Real>) {
      constexpr bool kWithRates = decltype(with_rates)::value;
      const TimeReader times(source, count);
      return Batch<Evaluator, Arithmetic, Real, kWithRates>(evaluator, trajectory, times, count, outputs)
          .sample(cursor);
    } else {
      return sample<Arithmetic>(trajectory, source, count, cursor, outputs);
    }
  });
}

template <class Arithmetic, class Real>
constexpr SampleKernels<Real> kBatchSamples = {sample_batch<Arithmetic, Real>, sample_at<Arithmetic, Real>};

}  // namespace
}  // namespace qtraj
