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
  int64_t* records;  // addresses of segments
  double* elapsed;   // s since their start
  size_t count;
  uint64_t again;  // rows outside the knots, not finite or in a gap: they stand at the start of the first segment
  size_t guess;    // the segment that was found last: neighbours often share their knots
};

// The row of a time that is not in the segment `located.guess`.
QTRAJ_NOINLINE void locate_elsewhere(const Trajectory& trajectory, double time, size_t segment_bytes,
                                     LocatedRows& located) {
  size_t segment = 0;
  double elapsed = 0;
  bool has_value = is_finite(time) && is_inside(trajectory.timeline, time);
  if (has_value) {
    const KnotIndex index = knot_index(trajectory.timeline);
    segment = located.guess = find_segment(index, time, located.guess);
    elapsed = time - index.knots[segment];
    has_value = !is_gap(trajectory.timeline, index.knots, segment);
  }
  located.records[located.count] = address_of(segments_of<char>(trajectory) + segment * segment_bytes);
  located.elapsed[located.count] = elapsed;
  located.again |= uint64_t{!has_value} << located.count;
}

// Looks up rows of the present stretch, until there are `most` or one has segments of another kind or range than
// `like`. How many. A row whose time is in the segment found last takes two comparisons.
QTRAJ_INLINE size_t locate_stretch(const SeriesWalk& walk, size_t most, const Trajectory& like, size_t segment_bytes,
                                   LocatedRows& located) {
  const size_t stretch = walk.stretch() < most ? walk.stretch() : most;
  for (size_t i = 0; i < stretch; ++i, ++located.count) {
    const Trajectory& trajectory = walk.trajectory(i);
    if (trajectory.kind != like.kind || trajectory.range != like.range) return i;
    const double time = walk.time(i);
    const size_t guess = located.guess;
    const double* const knots = knots_of(trajectory.timeline);
    if (is_finite(time) && guess + 1 < trajectory.timeline.key_count && knots[guess] <= time &&
        time < knots[guess + 1] && !is_gap(trajectory.timeline, knots, guess)) {
      located.records[located.count] = address_of(segments_of<char>(trajectory) + guess * segment_bytes);
      located.elapsed[located.count] = time - knots[guess];
    } else {
      locate_elsewhere(trajectory, time, segment_bytes, located);
    }
  }
  return stretch;
}

// Looks up rows from the present one on, at most kSeriesRows, up to the first whose segments are of another kind or
// range than `like`.
QTRAJ_NOINLINE void locate_rows(SeriesWalk& walk, const Trajectory& like, size_t segment_bytes, LocatedRows& located) {
  const size_t most = walk.left() < kSeriesRows ? walk.left() : kSeriesRows;
  located.count = 0;
  located.again = 0;
  for (;;) {
    const size_t rows = locate_stretch(walk, most - located.count, like, segment_bytes, located);
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

// Samples rows from the present one on, up to the first whose segments are of another kind or range.
template <class Arithmetic, class Real, SampleAtFunction<Real> kSampleAt, class Evaluator, bool kWithRates>
QTRAJ_NOINLINE void sample_alike(const Evaluator& evaluator, size_t count, SeriesWalk& walk,
                                 const SampleOutputs<Real>& outputs, Outcome& outcome) {
  using Vectors = SegmentVectors<Evaluator, Arithmetic, Real, kWithRates>;
  constexpr size_t kLanes = Vectors::kLanes;
  const Trajectory& like = walk.trajectory();
  const TimeSource no_times = {nullptr, 0, 0};
  const TimeReader reader(no_times, 0);
  Vectors vectors(evaluator, reader, count, outputs);
  int64_t records[kSeriesRows + kLanes];
  LocatedRows located = {records, vectors.times().in_buffer(0), 0, 0, 0};
  while (walk.left() > 0) {
    const SeriesWalk first = walk;
    locate_rows(walk, like, sizeof(typename Vectors::Segment), located);
    const size_t rows = located.count;
    if (rows == 0) return;
    // so few rows are faster one by one
    if (!Vectors::kScattersInVectors || 4 * rows < kLanes) located.again = ~uint64_t{0};
    if (located.again != ~uint64_t{0}) {
      for (size_t i = rows; i < rows + kLanes; ++i)
        records[i] = records[rows - 1], located.elapsed[i] = located.elapsed[rows - 1];
      vectors.begin(first.row());
      vectors.sample_each({0, 1, records, nullptr}, 0, rows);
      if (vectors.has_marks())
        for (size_t i = 0; i < rows; ++i) located.again |= uint64_t{vectors.is_marked(i)} << i;
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
      sample_alike<Arithmetic, Real, kSampleAt, std::decay_t<decltype(evaluator)>, decltype(with_rates)::value>(
          evaluator, count, walk, outputs, outcome);
    });
  }
  return outcome;
}

}  // namespace
}  // namespace qtraj
