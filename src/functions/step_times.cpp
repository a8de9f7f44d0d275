#include "functions/step_times.hpp"

#include "base/times.hpp"
#include "curve/sample_call.hpp"
#include "curve/uniform_count.hpp"

namespace qtraj {
namespace {

// What the times of a series are made of.
struct Grid {
  double first, last, step;

  Status check() const {
    if (!is_finite(first) || !is_finite(last) || !is_finite(step)) return Status::not_finite;
    if (step <= 0) return Status::value;
    return check_time(first, first, last);
  }
};

Status find_grid(const StepSeries& series, size_t index, const RowRange& keys, Grid& grid) {
  if (keys.count < 2) return Status::too_few;
  const double* const times = series.key_times + keys.first;
  grid = {read_once(times[0]), read_once(times[keys.count - 1]), number_of(series.step, index)};
  return grid.check();
}

}  // namespace

Outcome step_offsets(const StepSeries& series, size_t most_rows, int64_t* offsets, int32_t* statuses) {
  SeriesReader keys(series.keys);
  size_t end = 0;
  offsets[0] = 0;
  return for_each_series(series.keys.count, statuses, [&](size_t k) {
    Grid grid;
    size_t rows = 0;
    Status status = find_grid(series, k, keys.next(), grid);
    if (status == Status::ok) status = uniform_count(reached_span(grid.first, grid.last), grid.first, grid.step, rows);
    if (status == Status::ok && rows > most_rows - end) status = Status::size;
    if (status == Status::ok) end += rows;
    offsets[k + 1] = static_cast<int64_t>(end);
    return status;
  });
}

Outcome step_times(const StepSeries& series, const Series& rows, double* times, int32_t* statuses) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  SeriesReader keys(series.keys), ranges(rows);
  return for_each_series(series.keys.count, statuses, [&](size_t k) {
    Grid grid;
    Status status = find_grid(series, k, keys.next(), grid);
    const RowRange range = ranges.next();
    double* const out = times + range.first;
    if (status != Status::ok) {
      std::fill_n(out, range.count, kNaN);
      return status;
    }
    const TimeSource source = {nullptr, grid.first, grid.step};
    const TimeReader reader(source, range.count);
    for (size_t i = 0; i < range.count; ++i) {
      const double time = reader[i];
      out[i] = is_finite(time) ? time : kNaN;
      if (!is_finite(time)) status = Status::not_finite;
    }
    return status;
  });
}

}  // namespace qtraj
