// Sampling of many times in vectors, chunk by chunk. A chunk of increasing times with enough samples per segment is
// sampled run by run, a run being the samples in one segment, which is broadcast to all lanes. In any other chunk the
// times are scattered, and each lane has a segment of its own. Both do to each sample what sample_one.hpp does, to the
// last bit, so that the choice is one of speed alone. Rows that vectors cannot do (times outside the knots or not
// finite, rates that overflow) are done again one at a time.
#pragma once

#include "curve/find_segments.hpp"
#include "curve/runs.hpp"
#include "curve/segment_vectors.hpp"

namespace qtraj {
namespace {

// kSample and kSampleAt: scalar sampling (sample_one.hpp) in the same arithmetic.
template <class Evaluator, class Arithmetic, class Real, bool kWithRates, SampleFunction<Real> kSample,
          SampleAtFunction<Real> kSampleAt>
class Batch {
 public:
  Batch(const Evaluator& evaluator, const Trajectory& trajectory, const TimeReader& source, size_t count,
        const SampleOutputs<Real>& outputs)
      : trajectory_(trajectory),
        index_(knot_index(trajectory.timeline)),
        segments_(segments_of<Segment>(trajectory)),
        source_(source),
        count_(count),
        outputs_(outputs),
        vectors_(evaluator, source, count, outputs) {}

  Outcome sample(size_t& cursor) {
    Outcome outcome = {Status::ok, kNoIndex};
    for (size_t first_row = 0; first_row < count_; first_row += kChunk) {
      const size_t rows = count_ - first_row < kChunk ? count_ - first_row : kChunk;
      vectors_.begin(first_row);
      if (times_.read(first_row, rows) && sample_runs(cursor)) {
        if (vectors_.has_marks()) sample_again(first_row, rows, cursor, outcome);
      } else if constexpr (Vectors::kScattersInVectors) {
        const bool all_inside = times_.clamp(index_.knots[0], trajectory_.timeline.last_inside);
        sample_scattered(rows);
        if (!all_inside || vectors_.has_marks()) sample_again(first_row, rows, cursor, outcome);
      } else {
        sample_without_vectors(first_row, rows, cursor, outcome);
      }
    }
    return outcome;
  }

 private:
  using Vectors = SegmentVectors<Evaluator, Arithmetic, Real, kWithRates>;
  using Segment = typename Vectors::Segment;
  using Time = Wide<double>;
  static constexpr size_t kChunk = Vectors::kChunk, kSearched = Evaluator::kSearched;
  static constexpr size_t kLanes = Vectors::kLanes, kTimeLanes = Time::kLanes;

  // ---- Sorted times: run by run ----

  // The number of rows from which a run is faster than the same rows with a segment per lane: half a vector, but a
  // whole one with rates and where half would be a single row.
  static constexpr size_t kLeastRun = kWithRates || kLanes < 4 ? kLanes : kLanes / 2;

  // False, with nothing done, where runs would on average be shorter than that or times are outside the knots.
  bool sample_runs(size_t& cursor) {
    return for_each_run(times_, index_, trajectory_.timeline, kLeastRun, cursor,
                        [&](size_t segment, size_t begin, size_t end) {
                          if (is_gap(trajectory_.timeline, index_.knots, segment))
                            vectors_.mark_again(begin, end - begin);
                          else
                            vectors_.sample_run(segments_[segment], index_.knots[segment], begin, end);
                        });
  }

  // ---- Other times: a segment for each lane ----

  QTRAJ_NOINLINE void sample_scattered(size_t rows) {
    int64_t found[kSearched + kLanes];  // segments of the times
    for (size_t begin = 0; begin < rows; begin += kSearched) {
      const size_t end = rows - begin < kSearched ? rows : begin + kSearched;
      find_segments(index_, times_.from(begin), end - begin + kLanes - kTimeLanes, found);
      mark_gaps(begin, end, found);
      vectors_.sample_each({address_of(segments_), sizeof(Segment), found, index_.knots}, begin, end);
    }
  }

  // ---- Rows done again ----

  void mark_gaps(size_t begin, size_t end, const int64_t* found) {
    if (trajectory_.timeline.longest_gap == __builtin_inf()) return;
    for (size_t i = begin; i < end; ++i)
      if (is_gap(trajectory_.timeline, index_.knots, static_cast<size_t>(found[i - begin]))) vectors_.mark_again(i, 1);
  }

  QTRAJ_NOINLINE void sample_again(size_t first_row, size_t rows, size_t& cursor, Outcome& outcome) {
    for (size_t i = 0; i < rows; ++i) {
      const size_t row = first_row + i;
      const double time = source_[row];
      const bool inside = is_finite(time) && is_inside(trajectory_.timeline, time);
      if (inside && !vectors_.is_marked(i)) continue;
      keep_first(kSampleAt(trajectory_, time, cursor, from_row(outputs_, row)), row, outcome);
    }
  }

  void sample_without_vectors(size_t first_row, size_t rows, size_t& cursor, Outcome& outcome) {
    const TimeSource times = {times_.from(0), 0, 0};
    const Outcome chunk = kSample(trajectory_, times, rows, cursor, from_row(outputs_, first_row));
    keep_first(chunk.status, first_row + chunk.index, outcome);
  }

  const Trajectory& trajectory_;
  const KnotIndex index_;
  const Segment* segments_;
  const TimeReader& source_;
  const size_t count_;
  const SampleOutputs<Real>& outputs_;
  Vectors vectors_;
  typename Vectors::Times& times_ = vectors_.times();
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
