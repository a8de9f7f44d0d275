// Vectors of samples of one kind of segment, evaluated and written: runs, whose rows all lie in one segment, and rows
// with a segment of their own in each lane. Which segments these are, others find: sample_many.hpp for the times of one
// trajectory, sample_series.hpp for those of many.
#pragma once

#include "curve/chunk_times.hpp"
#include "curve/sample_one.hpp"
#include "curve/wide_output.hpp"

namespace qtraj {
namespace {

inline int64_t address_of(const void* record) { return reinterpret_cast<intptr_t>(record); }
inline const double* record_at(int64_t address) {
  return reinterpret_cast<const double*>(static_cast<intptr_t>(address));
}

// A segment for each row. That of row i has its record at the address `base` + `stride` `at`[i], and starts at the time
// `knots`[`at`[i]], or where there are no knots at 0. `at` is padded to whole vectors.
struct SegmentOfEachRow {
  int64_t base;
  int64_t stride;
  const int64_t* at;
  const double* knots;
};

// Samples chunks of at most kChunk rows. Rows that vectors cannot do, because a rate overflows, are marked, for the
// caller to do them again one at a time.
template <class Evaluator, class Arithmetic, class Real, bool kWithRates>
class SegmentVectors {
 public:
  using Segment = typename Evaluator::template SegmentOf<double>;
  static constexpr size_t kChunk = Evaluator::kChunk;
  static constexpr size_t kLanes = Wide<Real>::kLanes;
  using Times = ChunkTimes<kLanes, kChunk>;
  // Whether it pays to load a segment per lane.
  static constexpr bool kScattersInVectors = Wide<double>::kLanes > 2 || kWithRates ||
                                             Evaluator::kWork > (std::is_same_v<Real, double> ? 2 : 1);

  // count: the rows of the outputs.
  SegmentVectors(const Evaluator& evaluator, const TimeReader& source, size_t count, const SampleOutputs<Real>& outputs)
      : evaluator_(evaluator),
        request_(rate_request(outputs)),
        times_(source, count),
        count_(count),
        outputs_(outputs) {}

  // Begins a chunk, whose first row is this row of the outputs.
  void begin(size_t first_row) {
    first_row_ = first_row;
    has_marks_ = false;
  }
  // The times of the chunk: of runs as they are, of other rows since the start of their segment.
  Times& times() { return times_; }

  // Samples the rows from `begin` to `end`, all in one segment, which starts at `first_time`.
  QTRAJ_NOINLINE void sample_run(const Segment& record, double first_time, size_t begin, size_t end) {
    WideSegment wide;
    Doubles<Real> scales;
    broadcast(record, wide, scales);
    const Time knot(first_time), offset(Evaluator::offset(record));
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

  // Samples the rows from `begin` to `end`; segments.at[0] is that of row `begin`.
  QTRAJ_NOINLINE void sample_each(const SegmentOfEachRow& segments, size_t begin, size_t end) {
    WideSegment wide;
    Doubles<Real> scales;
    if constexpr (kWithRates) {
      sample_with_rates(begin, end, wide, scales, &segments, Time(0.0), Time(1.0));
    } else {
      for (size_t i = begin; i < end; i += kLanes) {
        Doubles<Real> x;
        load_segments(segments, i - begin, i, wide, scales, x);
        times_.prefetch(i);
        Partial partial;
        evaluator_.template start<ScatteredMode>(wide, x.rounded(), partial);
        finish<ScatteredMode>(wide, x.rounded(), partial, scales, i, end);
      }
    }
  }

  QTRAJ_NOINLINE void mark_again(size_t i, size_t rows) {
    if (!has_marks_)
      for (bool& mark : marked_) mark = false;
    has_marks_ = true;
    for (size_t k = i; k < i + rows; ++k) marked_[k] = true;
  }
  bool has_marks() const { return has_marks_; }
  bool is_marked(size_t i) const { return has_marks_ && marked_[i]; }
  const bool* marks() const { return marked_; }  // where there are any

 private:
  using WideSegment = typename Evaluator::template SegmentOf<Wide<Real>>;
  using Number = Wide<Real>;
  using Partial = typename Evaluator::template PartialOf<Number, kWithRates>;
  using Time = Wide<double>;
  static constexpr size_t kTimeLanes = Time::kLanes;
  using RunMode = SampleMode<kWithRates, true>;
  using ScatteredMode = SampleMode<kWithRates, false>;
  // How many vectors of a run are started before the first of them is finished. A sample is one long dependency chain,
  // and the out-of-order window is too small to overlap it with the next vector's.
  static constexpr size_t kInterleaved = Evaluator::template kInTwoSteps<kWithRates> ? 32 / kTimeLanes : 1;
  static constexpr size_t kFields = sizeof(Segment) / sizeof(double);

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

  // One loop for scattered times and, unless the evaluator has kOwnLoopWithRates, for runs: with rates the evaluation
  // takes most of the time and of the library's code. With `segments` it loads one for each lane, without them it
  // samples a run, whose segment is already broadcast and starts at the knot.
  QTRAJ_NOINLINE void sample_with_rates(size_t begin, size_t end, WideSegment& wide, Doubles<Real>& scales,
                                        const SegmentOfEachRow* segments, Time knot, Time offset) {
    const size_t at_once = segments ? 1 : kInterleaved;
    for (size_t group = begin; group < end; group += at_once * kLanes) {
      const size_t left = (end - group + kLanes - 1) / kLanes, vectors = left < at_once ? left : at_once;
      Number x[kInterleaved];
      Partial partial[kInterleaved];
      for (size_t k = 0; k < vectors; ++k) {
        const size_t i = group + k * kLanes;
        Doubles<Real> of_segments;
        if (segments) {
          load_segments(*segments, i - begin, i, wide, scales, of_segments);
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

  // Loads the segments `first`, `first` + 1, ..., of the vector of rows i, i + 1, ..., and the parameters x of the
  // rows' times.
  QTRAJ_INLINE void load_segments(const SegmentOfEachRow& segments, size_t first, size_t i, WideSegment& wide,
                                  Doubles<Real>& scales, Doubles<Real>& x) const {
    const int64_t* const at = segments.at + first;
    static_assert(sizeof(WideSegment) == kFields * sizeof(Number));
    constexpr size_t kParts = Doubles<Real>::kParts;
    auto& fields = reinterpret_cast<Number(&)[kFields]>(wide);
    const double* records[kParts][kTimeLanes];
    for (size_t part = 0; part < kParts; ++part)
      for (size_t lane = 0; lane < kTimeLanes; ++lane)
        records[part][lane] = record_at(segments.base + segments.stride * at[part * kTimeLanes + lane]);
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
      Time elapsed = Time::load(times_.from(i + part * kTimeLanes));
      if (segments.knots) elapsed = elapsed - gather(segments.knots, hn::LoadU(IndexTag(), at + part * kTimeLanes));
      x.part[part] =
          parameter<Arithmetic>(elapsed, scales.part[part], Evaluator::kHasOffset ? offsets.part[part] : Time(1.0));
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

  const Evaluator evaluator_;
  const RateRequest request_;
  Times times_;
  const size_t count_;
  const SampleOutputs<Real>& outputs_;

  // The state of the present chunk.
  size_t first_row_ = 0;
  bool has_marks_ = false;  // some row is marked to be done again
  bool marked_[kChunk];
};

}  // namespace
}  // namespace qtraj
