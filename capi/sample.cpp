#include "arguments.hpp"
#include "curve/uniform_count.hpp"
#include "curve/unnormalized.hpp"
#include "functions/even_times.hpp"
#include "targets/sampling.hpp"

using namespace qtraj;

namespace {

// The arrays of a call: where samples go and where their times come from.
template <class Real>
struct Call {
  const qtraj_trajectory* trajectory;
  TimeSource times;
  size_t count;
  SampleOutputs<Real> outputs;
};

template <class Real>
SampleOutputs<Real> outputs(Real* q_out) {
  return {q_out, nullptr, nullptr, Frame::body};
}
template <class Real>
SampleOutputs<Real> outputs(int32_t frame, Real* q_out, Real* omega_out, Real* alpha_out) {
  return {q_out, omega_out, alpha_out, static_cast<Frame>(frame)};
}

template <class Real>
Status check_arrays(const Call<Real>& call, bool times_missing) {
  const SampleOutputs<Real>& outputs = call.outputs;
  const bool no_output = !outputs.q && !outputs.omega && !outputs.alpha;
  if (call.count > 0 && (times_missing || no_output)) return Status::null;
  const Status handle = capi::check_handle(call.trajectory);
  if (handle != Status::ok) return handle;
  size_t time_bytes, q_bytes, rate_bytes;
  if (!capi::array_bytes(call.count, sizeof(double), time_bytes) ||
      !capi::array_bytes(call.count, 4 * sizeof(Real), q_bytes) ||
      !capi::array_bytes(call.count, 3 * sizeof(Real), rate_bytes))
    return Status::size;
  if (!is_known(outputs.frame)) return Status::value;
  return capi::overlap_any({{call.times.array, time_bytes},
                            {outputs.q, q_bytes},
                            {outputs.omega, rate_bytes},
                            {outputs.alpha, rate_bytes}})
             ? Status::overlap
             : Status::ok;
}

template <class Real>
qtraj_status sample(const Call<Real>& call, bool times_missing, size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  const Status status = check_arrays(call, times_missing);
  if (status != Status::ok) return capi::to_c(status);
  size_t cursor = 0;
  return capi::report(qtraj::sample(call.trajectory->core, call.times, call.count, cursor, call.outputs), bad_index);
}

// One time by value: of its arrays only two outputs can overlap.
template <class Real>
qtraj_status sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor,
                       const SampleOutputs<Real>& outputs) {
  const bool no_output = !outputs.q && !outputs.omega && !outputs.alpha;
  const Status handle = no_output ? Status::null : capi::check_handle(trajectory);
  if (handle != Status::ok) return capi::to_c(handle);
  if (!is_known(outputs.frame)) return QTRAJ_E_VALUE;
  if (outputs.omega || outputs.alpha) {
    const capi::Bytes q = {outputs.q, 4 * sizeof(Real)}, omega = {outputs.omega, 3 * sizeof(Real)},
                      alpha = {outputs.alpha, 3 * sizeof(Real)};
    if (capi::overlap(q, omega) || capi::overlap(q, alpha) || capi::overlap(omega, alpha)) return QTRAJ_E_OVERLAP;
  }
  size_t start = 0;
  return capi::to_c(qtraj::sample_at(trajectory->core, time, cursor ? *cursor : start, outputs));
}

// The order of errors: NULL, HANDLE, SIZE, SETTING, OVERLAP.
Status check_unnormalized(const qtraj_trajectory* trajectory, const double* times, size_t count,
                          const UnnormalizedOutputs& outputs) {
  const bool no_output = !outputs.value && !outputs.first && !outputs.second;
  if (count > 0 && (!times || no_output)) return Status::null;
  const Status handle = capi::check_handle(trajectory);
  if (handle != Status::ok) return handle;
  size_t time_bytes, row_bytes;
  if (!capi::array_bytes(count, sizeof(double), time_bytes) || !capi::array_bytes(count, 4 * sizeof(double), row_bytes))
    return Status::size;
  if (!is_unnormalized(trajectory->core)) return Status::setting;
  return capi::overlap_any(
             {{times, time_bytes}, {outputs.value, row_bytes}, {outputs.first, row_bytes}, {outputs.second, row_bytes}})
             ? Status::overlap
             : Status::ok;
}

}  // namespace

extern "C" {

qtraj_status qtraj_sample(const qtraj_trajectory* trajectory, const double* times, size_t count, double* q_out,
                          size_t* bad_index) {
  return sample<double>({trajectory, {times, 0, 0}, count, outputs(q_out)}, !times, bad_index);
}

qtraj_status qtraj_sample_f32(const qtraj_trajectory* trajectory, const double* times, size_t count, float* q_out,
                              size_t* bad_index) {
  return sample<float>({trajectory, {times, 0, 0}, count, outputs(q_out)}, !times, bad_index);
}

qtraj_status qtraj_sample_rates(const qtraj_trajectory* trajectory, int32_t frame, const double* times, size_t count,
                                double* q_out, double* omega_out, double* alpha_out, size_t* bad_index) {
  return sample<double>({trajectory, {times, 0, 0}, count, outputs(frame, q_out, omega_out, alpha_out)}, !times,
                        bad_index);
}

qtraj_status qtraj_sample_rates_f32(const qtraj_trajectory* trajectory, int32_t frame, const double* times,
                                    size_t count, float* q_out, float* omega_out, float* alpha_out, size_t* bad_index) {
  return sample<float>({trajectory, {times, 0, 0}, count, outputs(frame, q_out, omega_out, alpha_out)}, !times,
                       bad_index);
}

qtraj_status qtraj_sample_uniform(const qtraj_trajectory* trajectory, double start, double step, size_t count,
                                  double* q_out, size_t* bad_index) {
  return sample<double>({trajectory, {nullptr, start, step}, count, outputs(q_out)}, false, bad_index);
}

qtraj_status qtraj_sample_uniform_f32(const qtraj_trajectory* trajectory, double start, double step, size_t count,
                                      float* q_out, size_t* bad_index) {
  return sample<float>({trajectory, {nullptr, start, step}, count, outputs(q_out)}, false, bad_index);
}

qtraj_status qtraj_uniform_count(const qtraj_trajectory* trajectory, double start, double step, size_t* count) {
  const Status handle = count ? capi::check_handle(trajectory) : Status::null;
  if (count) *count = 0;
  if (handle != Status::ok) return capi::to_c(handle);
  return capi::to_c(uniform_count(trajectory->core.timeline, start, step, *count));
}

qtraj_status qtraj_sample_unnormalized(const qtraj_trajectory* trajectory, const double* times, size_t count,
                                       double* p_out, double* dp_out, double* ddp_out, size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  const UnnormalizedOutputs outputs = {p_out, dp_out, ddp_out};
  const Status status = check_unnormalized(trajectory, times, count, outputs);
  if (status != Status::ok) return capi::to_c(status);
  return capi::report(sample_unnormalized(trajectory->core, times, count, outputs), bad_index);
}

qtraj_status qtraj_even_times(double first, double last, size_t count, double* times_out) {
  return capi::call({output<1>(times_out, count)}, {}, nullptr, [&] {
    return Outcome{even_times(first, last, count, times_out), kNoIndex};
  });
}

qtraj_status qtraj_segment_times(const qtraj_trajectory* trajectory, size_t per_segment, double* times_out) {
  if (!times_out) return QTRAJ_E_NULL;
  const Status handle = capi::check_handle(trajectory);
  if (handle != Status::ok) return capi::to_c(handle);
  if (per_segment < 2) return QTRAJ_E_TOO_FEW;
  const size_t segments = trajectory->core.timeline.key_count - 1, steps = per_segment - 1;
  size_t bytes;
  if (steps > SIZE_MAX / segments - 1 || !capi::array_bytes(segments * steps + 1, sizeof(double), bytes))
    return QTRAJ_E_SIZE;
  segment_times(knots_of(trajectory->core.timeline), trajectory->core.timeline.key_count, per_segment, times_out);
  return QTRAJ_OK;
}

qtraj_status qtraj_sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor, double* q_out) {
  return sample_at(trajectory, time, cursor, outputs(q_out));
}

qtraj_status qtraj_sample_at_f32(const qtraj_trajectory* trajectory, double time, size_t* cursor, float* q_out) {
  return sample_at(trajectory, time, cursor, outputs(q_out));
}

qtraj_status qtraj_sample_rates_at(const qtraj_trajectory* trajectory, int32_t frame, double time, size_t* cursor,
                                   double* q_out, double* omega_out, double* alpha_out) {
  return sample_at(trajectory, time, cursor, outputs(frame, q_out, omega_out, alpha_out));
}

qtraj_status qtraj_sample_rates_at_f32(const qtraj_trajectory* trajectory, int32_t frame, double time, size_t* cursor,
                                       float* q_out, float* omega_out, float* alpha_out) {
  return sample_at(trajectory, time, cursor, outputs(frame, q_out, omega_out, alpha_out));
}

}  // extern "C"
