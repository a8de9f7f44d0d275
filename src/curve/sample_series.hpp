// Sampling many trajectories at shared times in vectors across trajectories: neighbouring rows, each with the segment
// of its own trajectory. They are sampled together where their segments are of one kind and one range of exponents;
// what vectors cannot do is done one row at a time, as in sample_many.hpp. Each row has the bits of sample_one.hpp.
#pragma once

#include "curve/segment_vectors.hpp"
#include "curve/series_call.hpp"

namespace qtraj {
namespace {

// Rows that are located at once: a bit each tells which of them are to be sampled one at a time.
constexpr size_t kSeriesRows = 32;

struct LocatedRows {
  SegmentKind kind;  // of all rows
  ExponentRange range;
  size_t segment_bytes;
  int64_t* records;  // addresses of segments
  double* elapsed;   // s since their start
  size_t count;
  uint64_t again;  // rows outside the knots, not finite or in a gap: they stand at the start of the first segment
  size_t guess;    // the segment that was found last: neighbours often share their knots
};

// The row of a time that is not in the segment `located.guess`.
QTRAJ_NOINLINE void locate_elsewhere(const Trajectory& trajectory, double time, LocatedRows& located) {
  size_t segment = 0;
  double elapsed = 0;
  bool has_value = is_finite(time) && is_inside(trajectory.timeline, time);
  if (has_value) {
    const KnotIndex index = knot_index(trajectory.timeline);
    segment = located.guess = find_segment(index, time, located.guess);
    elapsed = time - index.knots[segment];
    has_value = !is_gap(trajectory.timeline, index.knots, segment);
  }
  located.records[located.count] = address_of(segments_of<char>(trajectory) + segment * located.segment_bytes);
  located.elapsed[located.count] = elapsed;
  located.again |= uint64_t{!has_value} << located.count;
}

// Looks up rows of the present stretch, until there are `most` or one has segments of another kind or range. How many.
// A row whose time is in the segment found last takes a few comparisons.
QTRAJ_INLINE size_t locate_stretch(const SeriesWalk& walk, size_t most, LocatedRows& located) {
  const size_t stretch = walk.stretch() < most ? walk.stretch() : most;
  for (size_t i = 0; i < stretch; ++i, ++located.count) {
    const Trajectory& trajectory = walk.trajectory(i);
    if (trajectory.kind != located.kind || trajectory.range != located.range) return i;
    const double time = walk.time(i);
    const size_t guess = located.guess;
    const double* const knots = knots_of(trajectory.timeline);
    if (is_finite(time) && guess + 1 < trajectory.timeline.key_count && knots[guess] <= time &&
        time < knots[guess + 1] && time <= trajectory.timeline.last_inside &&
        !is_gap(trajectory.timeline, knots, guess)) {
      located.records[located.count] = address_of(segments_of<char>(trajectory) + guess * located.segment_bytes);
      located.elapsed[located.count] = time - knots[guess];
    } else {
      locate_elsewhere(trajectory, time, located);
    }
  }
  return stretch;
}

// Looks up rows from the present one on, at most kSeriesRows, up to the first whose segments are of another kind or
// range.
QTRAJ_NOINLINE void locate_rows(SeriesWalk& walk, LocatedRows& located) {
  const size_t most = walk.left() < kSeriesRows ? walk.left() : kSeriesRows;
  located.count = 0;
  located.again = 0;
  for (;;) {
    const size_t rows = locate_stretch(walk, most - located.count, located);
    if (rows == 0) return;
    walk.step(rows);
  }
}

// Samples `rows` rows one at a time, those whose bit is set.
template <class Real, SampleAtFunction<Real> kSampleAt>
QTRAJ_NOINLINE void sample_rows_again(SeriesWalk walk, size_t rows, uint64_t chosen, const SampleOutputs<Real>& outputs,
                                      Outcome& outcome) {
  size_t cursor = 0;
  for (size_t i = 0; i < rows; ++i, walk.step()) {
    if (!(chosen >> i & 1)) continue;
    const size_t row = walk.row();
    keep_first(kSampleAt(walk.trajectory(), walk.time(), cursor, from_row(outputs, row)), row, outcome);
  }
}

// The SegmentVectors of one evaluator, as a function: it samples located rows, of which the first is that row of the
// outputs, and marks those to be done again.
struct RowsInVectors {
  size_t lanes;  // 0 where vectors do not pay
  void* vectors;
  void (*sample)(void* vectors, size_t first_row, LocatedRows& located);
};

QTRAJ_NOINLINE void mark_rows(const bool* marked, LocatedRows& located) {
  for (size_t i = 0; i < located.count; ++i) located.again |= uint64_t{marked[i]} << i;
}

template <class Vectors>
void sample_located(void* of_evaluator, size_t first_row, LocatedRows& located) {
  Vectors& vectors = *static_cast<Vectors*>(of_evaluator);
  vectors.begin(first_row);
  vectors.sample_each({0, 1, located.records, nullptr}, 0, located.count);
  if (vectors.has_marks()) mark_rows(vectors.marks(), located);
}

// Samples rows from the present one on, up to the first whose segments are of another kind or range. Of vectors that
// are mostly empty the rows are faster one by one.
template <class Real, SampleAtFunction<Real> kSampleAt>
QTRAJ_NOINLINE void sample_alike(const RowsInVectors& in_vectors, LocatedRows& located, SeriesWalk& walk,
                                 const SampleOutputs<Real>& outputs, Outcome& outcome) {
  while (walk.left() > 0) {
    const SeriesWalk first = walk;
    locate_rows(walk, located);
    const size_t rows = located.count;
    if (rows == 0) return;
    if (in_vectors.lanes == 0 || 4 * rows < in_vectors.lanes) {
      located.again = ~uint64_t{0};
    } else {
      // whole vectors
      for (size_t i = rows; i % in_vectors.lanes != 0; ++i)
        located.records[i] = located.records[rows - 1], located.elapsed[i] = located.elapsed[rows - 1];
      in_vectors.sample(in_vectors.vectors, first.row(), located);
    }
    if (located.again != 0) sample_rows_again<Real, kSampleAt>(first, rows, located.again, outputs, outcome);
  }
}

template <class Arithmetic, class Real, SampleAtFunction<Real> kSampleAt>
Outcome sample_series(const SeriesCall& call, const SampleOutputs<Real>& outputs) {
  Outcome outcome = {Status::ok, kNoIndex};
  SeriesWalk walk(call);
  const size_t count = walk.left();
  while (walk.left() > 0) {
    const Trajectory& trajectory = walk.trajectory();
    if (std::is_same_v<Real, float> && trajectory.range == ExponentRange::any) {
      sample_rows_again<Real, kSampleAt>(walk, 1, 1, outputs, outcome);
      walk.step();
      continue;
    }
    with_evaluator_for<Arithmetic>(trajectory, outputs, [&](const auto& evaluator, auto with_rates) {
      using Vectors = SegmentVectors<std::decay_t<decltype(evaluator)>, Arithmetic, Real, decltype(with_rates)::value>;
      const TimeSource no_times = {nullptr, 0, 0};
      const TimeReader reader(no_times, 0);
      Vectors vectors(evaluator, reader, count, outputs);
      int64_t records[kSeriesRows + Vectors::kLanes];
      LocatedRows located = {trajectory.kind,
                             trajectory.range,
                             sizeof(typename Vectors::Segment),
                             records,
                             vectors.times().in_buffer(0),
                             0,
                             0,
                             0};
      const RowsInVectors in_vectors = {Vectors::kScattersInVectors ? Vectors::kLanes : 0, &vectors,
                                        sample_located<Vectors>};
      sample_alike<Real, kSampleAt>(in_vectors, located, walk, outputs, outcome);
    });
  }
  return outcome;
}

}  // namespace
}  // namespace qtraj
