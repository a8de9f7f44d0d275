// Times and means of many series of rows.
#include "functions/step_times.hpp"
#include "means/eigen_mean.hpp"
#include "offsets.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// As many rows as an array of quaternions can have.
constexpr size_t kMostRows = static_cast<size_t>(PTRDIFF_MAX) / (4 * sizeof(double));

bool is_null(const StepSeries& series) {
  return is_missing(series.keys) || is_missing(series.key_times, series.keys) ||
         (series.keys.count > 0 && !series.step.data);
}

Argument key_times_of(const StepSeries& series) { return rows_of(input<1>(series.key_times, 0), series.keys); }

qtraj_status batch_mean(GroupedOrientations samples, const Output<4>& means, double* eigengap, int32_t* status_out,
                        size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  Series& groups = samples.groups;
  if (is_missing(groups) || is_missing(samples.q.data, groups) || (groups.count > 0 && !means.data))
    return QTRAJ_E_NULL;
  const Outcome offsets = check_offsets({{groups, 4 * (samples.q.is_float ? sizeof(float) : sizeof(double))}});
  if (offsets.status != Status::ok) return report(offsets, bad_index);
  return call({offsets_of(groups), rows_of(samples.q, groups), optional(rows_of(samples.weights, groups)),
               distinct(means), spare(result(eigengap, groups.count)), spare(result(status_out, groups.count))},
              {}, bad_index, [&] { return mean_eigen_of_each(samples, means, eigengap, status_out); });
}

}  // namespace

extern "C" {

qtraj_status qtraj_batch_step_offsets(size_t count, const int64_t* key_offsets, const double* key_times,
                                      const double* step, size_t step_count, int64_t* sample_offsets_out,
                                      int32_t* status_out, size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  StepSeries series = {{key_offsets, count}, key_times, input<1>(step, rows_of(step_count, count))};
  if (is_null(series) || (count > 0 && !sample_offsets_out)) return QTRAJ_E_NULL;
  if (!is_one_or(count, step_count)) return QTRAJ_E_COUNT;
  const Outcome offsets = check_offsets({{series.keys, sizeof(double)}});
  if (offsets.status != Status::ok || !sample_offsets_out) return report(offsets, bad_index);
  return call({offsets_of(series.keys), key_times_of(series), series.step,
               distinct(result(sample_offsets_out, count + 1)), spare(result(status_out, count))},
              {}, bad_index, [&] { return step_offsets(series, kMostRows, sample_offsets_out, status_out); });
}

qtraj_status qtraj_batch_times(size_t count, const int64_t* key_offsets, const double* key_times, const double* step,
                               size_t step_count, const int64_t* sample_offsets, double* times_out, int32_t* status_out,
                               size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  StepSeries series = {{key_offsets, count}, key_times, input<1>(step, rows_of(step_count, count))};
  Series samples = {sample_offsets, count};
  if (is_null(series) || is_missing(samples) || is_missing(times_out, samples)) return QTRAJ_E_NULL;
  if (!is_one_or(count, step_count)) return QTRAJ_E_COUNT;
  const Outcome offsets = check_offsets({{series.keys, sizeof(double)}, {samples, sizeof(double)}});
  if (offsets.status != Status::ok) return report(offsets, bad_index);
  return call({offsets_of(series.keys), offsets_of(samples), key_times_of(series), series.step,
               distinct(rows_of(output<1>(times_out, 0), samples)), spare(result(status_out, count))},
              {}, bad_index, [&] { return step_times(series, samples, times_out, status_out); });
}

qtraj_status qtraj_batch_mean_eigen(size_t count, const int64_t* offsets, const double* q, const double* weights,
                                    double* mean_out, double* eigengap, int32_t* status_out, size_t* bad_index) {
  return batch_mean({input<4>(q, 0), input<1>(weights, 0), {offsets, count}}, output<4>(mean_out, count), eigengap,
                    status_out, bad_index);
}

qtraj_status qtraj_batch_mean_eigen_f32(size_t count, const int64_t* offsets, const float* q, const float* weights,
                                        float* mean_out, double* eigengap, int32_t* status_out, size_t* bad_index) {
  return batch_mean({input<4>(q, 0), input<1>(weights, 0), {offsets, count}}, output<4>(mean_out, count), eigengap,
                    status_out, bad_index);
}

}  // extern "C"
