#include "functions/series.hpp"

#include <algorithm>
#include <cstring>

#include "math/arithmetic.hpp"
#include "targets/sampling.hpp"

namespace qtraj {
namespace {

// As many times of one trajectory as are worth a call of their own.
constexpr size_t kManyTimes = 16;
// Times of one trajectory that are sampled at once where rows of all trajectories at a time are neighbours.
constexpr size_t kTimesAtOnce = 128;

constexpr SeriesFunction<double>* kDoubleKernels[] = QTRAJ_OF_EACH_TARGET(sample_series);
constexpr SeriesFunction<float>* kFloatKernels[] = QTRAJ_OF_EACH_TARGET(sample_series);
Outcome sample_across(const SeriesCall& call, const SampleOutputs<double>& outputs) {
  return kDoubleKernels[target()](call, outputs);
}
Outcome sample_across(const SeriesCall& call, const SampleOutputs<float>& outputs) {
  return kFloatKernels[target()](call, outputs);
}

// Of rows at fault the earliest counts.
void keep_earlier(const Outcome& fault, Outcome& outcome) {
  if (fault.index < outcome.index) outcome = fault;
}

template <class Real>
QTRAJ_NOINLINE Outcome sample_series_first(const SeriesCall& call, const SampleOutputs<Real>& outputs) {
  Outcome outcome = {Status::ok, kNoIndex};
  for (size_t k = 0; k < call.series; ++k) {
    size_t cursor = 0;
    const size_t first = k * call.count;
    const Outcome one = sample(call.trajectory(k), {call.times, 0, 0}, call.count, cursor, from_row(outputs, first));
    if (one.status != Status::ok) keep_earlier({one.status, first + one.index}, outcome);
  }
  return outcome;
}

// Moves `count` rows that begin at row `from` to every `stride`-th row from row `to` on.
template <size_t Width, class Real>
void spread(Real* rows, size_t from, size_t count, size_t to, size_t stride) {
  if (!rows) return;
  for (size_t i = 0; i < count; ++i)
    std::memcpy(rows + Width * (to + stride * i), rows + Width * (from + i), Width * sizeof(Real));
}

// How many times from `first` on make a block: as many as leave room for that many rows after it.
size_t times_of_block(const SeriesCall& call, size_t first) {
  const size_t left = call.count - first;
  return std::min(kTimesAtOnce, left - left / (call.series + 1) - 1);
}

// Blocks of times, in each of them one trajectory after the other: it is sampled to rows after the block, which are
// written later, and its rows are moved from there to their places. Returns how many times were done. (Not inlined: it
// stands below the largest frames of all.)
template <class Real>
QTRAJ_NOINLINE size_t sample_blocks(const SeriesCall& call, const SampleOutputs<Real>& outputs, Outcome& outcome) {
  size_t first = 0;
  for (size_t times; (times = times_of_block(call, first)) >= kManyTimes; first += times) {
    const size_t block = first * call.series, after = block + times * call.series;
    for (size_t k = 0; k < call.series; ++k) {
      size_t cursor = 0;
      const Outcome one =
          sample(call.trajectory(k), {call.times + first, 0, 0}, times, cursor, from_row(outputs, after));
      if (one.status != Status::ok) keep_earlier({one.status, block + one.index * call.series + k}, outcome);
      spread<4>(outputs.q, after, times, block + k, call.series);
      spread<3>(outputs.omega, after, times, block + k, call.series);
      spread<3>(outputs.alpha, after, times, block + k, call.series);
    }
  }
  return first;
}

template <class Real>
Outcome sample_time_first(const SeriesCall& call, const SampleOutputs<Real>& outputs) {
  Outcome outcome = {Status::ok, kNoIndex};
  const size_t first = sample_blocks(call, outputs, outcome), row = first * call.series;
  const SeriesCall rest = {call.trajectories, call.series, call.times + first, call.count - first, call.layout};
  const Outcome last = sample_across(rest, from_row(outputs, row));
  if (last.status != Status::ok) keep_earlier({last.status, row + last.index}, outcome);
  return outcome;
}

template <class Real>
Outcome sample_rows(const SeriesCall& call, const SampleOutputs<Real>& outputs) {
  if (call.series == 0 || call.count == 0) return {Status::ok, kNoIndex};
  if (call.count < kManyTimes) return sample_across(call, outputs);
  const bool is_series_first = call.layout == Layout::series_first || call.series == 1;
  return is_series_first ? sample_series_first(call, outputs) : sample_time_first(call, outputs);
}

}  // namespace

Outcome sample_series(const SeriesCall& call, const SampleOutputs<double>& outputs) {
  return sample_rows(call, outputs);
}
Outcome sample_series(const SeriesCall& call, const SampleOutputs<float>& outputs) {
  return sample_rows(call, outputs);
}

}  // namespace qtraj
