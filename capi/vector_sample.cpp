#include <cstring>

#include "arguments.hpp"
#include "curve/uniform_count.hpp"
#include "targets/sampling.hpp"

using namespace qtraj;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Real>
struct Call {
  const qtraj_vector_curve* curve;
  TimeSource times;
  size_t count;
  VectorOutputs<Real> outputs;

  bool has_output() const { return outputs.value || outputs.first || outputs.second; }
};

// The order of errors: NULL, HANDLE, SIZE, OVERLAP.
template <class Real>
Status check(const Call<Real>& call, bool times_missing) {
  if (call.count > 0 && (times_missing || !call.has_output())) return Status::null;
  const Status handle = capi::check_handle(call.curve);
  if (handle != Status::ok) return handle;
  size_t time_bytes, row_bytes;
  if (!capi::array_bytes(call.count, sizeof(double), time_bytes) ||
      !capi::array_bytes(call.count, call.curve->core.dim * sizeof(Real), row_bytes))
    return Status::size;
  const VectorOutputs<Real>& outputs = call.outputs;
  return capi::overlap_any({{call.times.array, time_bytes},
                            {outputs.value, row_bytes},
                            {outputs.first, row_bytes},
                            {outputs.second, row_bytes}})
             ? Status::overlap
             : Status::ok;
}

template <class Real>
qtraj_status sample(const Call<Real>& call, bool times_missing, size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  const Status status = check(call, times_missing);
  if (status != Status::ok) return capi::to_c(status);
  size_t cursor = 0;
  return capi::report(qtraj::sample(call.curve->core, call.times, call.count, cursor, call.outputs), bad_index);
}

// One time by value: of its arrays only two outputs can overlap.
template <class Real>
qtraj_status sample_at(const qtraj_vector_curve* curve, double time, size_t* cursor,
                       const VectorOutputs<Real>& outputs) {
  const bool no_output = !outputs.value && !outputs.first && !outputs.second;
  const Status handle = no_output ? Status::null : capi::check_handle(curve);
  if (handle != Status::ok) return capi::to_c(handle);
  if (outputs.first || outputs.second) {
    const size_t bytes = curve->core.dim * sizeof(Real);
    if (capi::overlap_any({{outputs.value, bytes}, {outputs.first, bytes}, {outputs.second, bytes}}))
      return QTRAJ_E_OVERLAP;
  }
  size_t start = 0;
  return capi::to_c(sample_vector_at(curve->core, time, cursor ? *cursor : start, outputs));
}

const VectorCurve* core_of(const qtraj_vector_curve* curve) {
  return capi::check_handle(curve) == Status::ok ? &curve->core : nullptr;
}

}  // namespace

extern "C" {

qtraj_status qtraj_vector_sample(const qtraj_vector_curve* curve, const double* times, size_t count, double* value_out,
                                 double* first_out, double* second_out, size_t* bad_index) {
  return sample<double>({curve, {times, 0, 0}, count, {value_out, first_out, second_out}}, !times, bad_index);
}

qtraj_status qtraj_vector_sample_f32(const qtraj_vector_curve* curve, const double* times, size_t count,
                                     float* value_out, float* first_out, float* second_out, size_t* bad_index) {
  return sample<float>({curve, {times, 0, 0}, count, {value_out, first_out, second_out}}, !times, bad_index);
}

qtraj_status qtraj_vector_sample_uniform(const qtraj_vector_curve* curve, double start, double step, size_t count,
                                         double* value_out, double* first_out, double* second_out, size_t* bad_index) {
  return sample<double>({curve, {nullptr, start, step}, count, {value_out, first_out, second_out}}, false, bad_index);
}

qtraj_status qtraj_vector_sample_uniform_f32(const qtraj_vector_curve* curve, double start, double step, size_t count,
                                             float* value_out, float* first_out, float* second_out, size_t* bad_index) {
  return sample<float>({curve, {nullptr, start, step}, count, {value_out, first_out, second_out}}, false, bad_index);
}

qtraj_status qtraj_vector_sample_at(const qtraj_vector_curve* curve, double time, size_t* cursor, double* value_out,
                                    double* first_out, double* second_out) {
  return sample_at<double>(curve, time, cursor, {value_out, first_out, second_out});
}

qtraj_status qtraj_vector_sample_at_f32(const qtraj_vector_curve* curve, double time, size_t* cursor, float* value_out,
                                        float* first_out, float* second_out) {
  return sample_at<float>(curve, time, cursor, {value_out, first_out, second_out});
}

qtraj_status qtraj_vector_uniform_count(const qtraj_vector_curve* curve, double start, double step, size_t* count) {
  const Status handle = count ? capi::check_handle(curve) : Status::null;
  if (count) *count = 0;
  if (handle != Status::ok) return capi::to_c(handle);
  return capi::to_c(uniform_count(curve->core.timeline, start, step, *count));
}

int32_t qtraj_vector_method(const qtraj_vector_curve* curve) {
  const VectorCurve* core = core_of(curve);
  return core ? static_cast<int32_t>(core->method) : 0;
}

size_t qtraj_vector_key_count(const qtraj_vector_curve* curve) {
  const VectorCurve* core = core_of(curve);
  return core ? core->timeline.key_count : 0;
}

size_t qtraj_vector_dim(const qtraj_vector_curve* curve) {
  const VectorCurve* core = core_of(curve);
  return core ? core->dim : 0;
}

double qtraj_vector_start_time(const qtraj_vector_curve* curve) {
  const VectorCurve* core = core_of(curve);
  return core ? core->timeline.before.knot : kNaN;
}

double qtraj_vector_end_time(const qtraj_vector_curve* curve) {
  const VectorCurve* core = core_of(curve);
  return core ? core->timeline.after.knot : kNaN;
}

qtraj_status qtraj_vector_keys(const qtraj_vector_curve* curve, double* times_out, double* values_out) {
  const Status handle = capi::check_handle(curve);
  if (handle != Status::ok) return capi::to_c(handle);
  const VectorCurve& core = curve->core;
  const size_t count = core.timeline.key_count, time_bytes = count * sizeof(double),
               value_bytes = core.dim * time_bytes;
  if (capi::overlap({times_out, time_bytes}, {values_out, value_bytes})) return QTRAJ_E_OVERLAP;
  if (times_out) std::memcpy(times_out, knots_of(core.timeline), time_bytes);
  if (values_out) copy_vector_keys(core, values_out);
  return QTRAJ_OK;
}

}  // extern "C"
