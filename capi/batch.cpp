#include "methods/batch.hpp"

#include "offsets.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// Arguments of a call, float or double alike.
struct Call {
  const qtraj_options* options;
  Batch batch;  // without its options
  void* memory;
  size_t bytes;
  size_t* bad_index;

  // Whether any series can have a curve, which takes memory.
  bool has_curves() const { return batch.keys.longest >= 2; }
};

// Outputs of a call, float or double.
template <class Real>
struct Outputs {
  Real *q, *omega, *alpha;
};

template <class Real>
Batch make_batch(int32_t frame, size_t count, const int64_t* key_offsets, const double* key_times, const Real* key_q_wb,
                 const Real* key_omega, const Real* key_alpha, const int64_t* sample_offsets,
                 const double* sample_times, const Outputs<Real>& outputs, int32_t* status_out) {
  return {nullptr,
          static_cast<Frame>(frame),
          {key_offsets, count},
          {sample_offsets, count},
          {key_times, input<4>(key_q_wb, 0), input<3>(key_omega, 0), input<3>(key_alpha, 0), nullptr, 0},
          sample_times,
          {output<4>(outputs.q, 0), output<3>(outputs.omega, 0), output<3>(outputs.alpha, 0)},
          status_out};
}

bool is_null(const Call& call) {
  const Batch& batch = call.batch;
  const BatchOutputs& outputs = batch.outputs;
  const void* const any_output = outputs.q.data       ? outputs.q.data
                                 : outputs.omega.data ? outputs.omega.data
                                                      : outputs.alpha.data;
  return !call.options || is_missing(batch.keys) || is_missing(batch.samples) ||
         is_missing(batch.input.times, batch.keys) || is_missing(batch.input.q_wb.data, batch.keys) ||
         is_missing(any_output, batch.samples);
}

// NULL, HANDLE, COUNT, SIZE, VALUE, INPUT_MISSING and INPUT_UNWANTED; finds what the longest curve takes. Without keys
// no rates are asked for.
Outcome check_input(Call& call, CurveSize& size) {
  Batch& batch = call.batch;
  const Status handle = is_null(call) ? Status::null : check_handle(call.options);
  if (handle != Status::ok) return {handle, kNoIndex};
  batch.options = &call.options->core;
  const size_t row_bytes = 4 * (batch.input.q_wb.is_float ? sizeof(float) : sizeof(double));
  const Outcome offsets = check_offsets({{batch.keys, row_bytes}, {batch.samples, row_bytes}});
  if (offsets.status != Status::ok) return offsets;
  if (call.has_curves() && !trajectory_size(*batch.options, batch.keys.longest, size)) return {Status::size, kNoIndex};
  if (!is_known(batch.frame)) return {Status::value, kNoIndex};
  if (batch.keys.rows() == 0) return {};
  return {check_settings(*batch.options, batch.input, batch.frame), kNoIndex};
}

// How the memory of a call is used: a handle and a workspace.
struct Layout {
  size_t handle, workspace;  // bytes

  BatchMemory in(void* memory) const { return {memory, static_cast<char*>(memory) + handle, workspace}; }
};

// BUFFER. The workspace is as large as even times want it where there is room.
Status find_layout(const Call& call, const CurveSize& size, Layout& layout) {
  if (!call.has_curves()) return Status::ok;
  const size_t of_times = call.batch.sample_times ? 0 : kEvenTimes * sizeof(double);
  layout = {size.handle, std::max(size.workspace, of_times)};
  if (!call.memory) return Status::ok;
  if (call.bytes < size.all() || !is_aligned(call.memory)) return Status::buffer;
  layout.workspace = std::min(layout.workspace, call.bytes - size.handle);
  return Status::ok;
}

Status check_overlaps(const Call& call, const Layout& layout) {
  const Batch& batch = call.batch;
  const KeyframeInput& keys = batch.input;
  const BatchOutputs& outputs = batch.outputs;
  return check_overlap(
      {Argument(call.options, 1, 1, sizeof *call.options, false), offsets_of(batch.keys), offsets_of(batch.samples),
       rows_of(input<1>(keys.times, 0), batch.keys), rows_of(keys.q_wb, batch.keys), rows_of(keys.omega, batch.keys),
       rows_of(keys.alpha, batch.keys), rows_of(input<1>(batch.sample_times, 0), batch.samples),
       distinct({call.memory, layout.handle + layout.workspace, 1, 1, true}),
       distinct(rows_of(outputs.q, batch.samples)), distinct(rows_of(outputs.omega, batch.samples)),
       distinct(rows_of(outputs.alpha, batch.samples)), distinct(result(batch.statuses, batch.keys.count))});
}

Outcome run(const Call& call, const Layout& layout) {
  if (call.memory || !call.has_curves()) return sample_batch(call.batch, layout.in(call.memory));
  void* const memory = allocate(layout.handle + layout.workspace);
  if (!memory) return {Status::no_memory, kNoIndex};
  const Outcome outcome = sample_batch(call.batch, layout.in(memory));
  release(memory);
  return outcome;
}

qtraj_status batch_sample(Call&& call) {
  if (call.bad_index) *call.bad_index = kNoIndex;
  CurveSize size = {0, 0};
  Layout layout = {0, 0};
  Outcome outcome = check_input(call, size);
  if (outcome.status == Status::ok) outcome.status = find_layout(call, size, layout);
  if (outcome.status == Status::ok) outcome.status = check_overlaps(call, layout);
  if (outcome.status == Status::ok) outcome = run(call, layout);
  return report(outcome, call.bad_index);
}

// Without rates the frame is of nothing.
template <class Real>
Batch without_rates(size_t count, const int64_t* key_offsets, const double* key_times, const Real* key_q_wb,
                    const int64_t* sample_offsets, const double* sample_times, Real* q_out, int32_t* status_out) {
  constexpr const Real* kNone = nullptr;
  return make_batch<Real>(QTRAJ_FRAME_BODY, count, key_offsets, key_times, key_q_wb, kNone, kNone, sample_offsets,
                          sample_times, {q_out, nullptr, nullptr}, status_out);
}

}  // namespace

extern "C" {

qtraj_status qtraj_batch_sample(const qtraj_options* options, size_t count, const int64_t* key_offsets,
                                const double* key_times, const double* key_q_wb, const int64_t* sample_offsets,
                                const double* sample_times, void* memory, size_t bytes, double* q_out,
                                int32_t* status_out, size_t* bad_index) {
  return batch_sample(
      {options, without_rates(count, key_offsets, key_times, key_q_wb, sample_offsets, sample_times, q_out, status_out),
       memory, bytes, bad_index});
}

qtraj_status qtraj_batch_sample_f32(const qtraj_options* options, size_t count, const int64_t* key_offsets,
                                    const double* key_times, const float* key_q_wb, const int64_t* sample_offsets,
                                    const double* sample_times, void* memory, size_t bytes, float* q_out,
                                    int32_t* status_out, size_t* bad_index) {
  return batch_sample(
      {options, without_rates(count, key_offsets, key_times, key_q_wb, sample_offsets, sample_times, q_out, status_out),
       memory, bytes, bad_index});
}

qtraj_status qtraj_batch_sample_rates(const qtraj_options* options, int32_t frame, size_t count,
                                      const int64_t* key_offsets, const double* key_times, const double* key_q_wb,
                                      const double* key_omega, const double* key_alpha, const int64_t* sample_offsets,
                                      const double* sample_times, void* memory, size_t bytes, double* q_out,
                                      double* omega_out, double* alpha_out, int32_t* status_out, size_t* bad_index) {
  return batch_sample({options,
                       make_batch<double>(frame, count, key_offsets, key_times, key_q_wb, key_omega, key_alpha,
                                          sample_offsets, sample_times, {q_out, omega_out, alpha_out}, status_out),
                       memory, bytes, bad_index});
}

qtraj_status qtraj_batch_sample_rates_f32(const qtraj_options* options, int32_t frame, size_t count,
                                          const int64_t* key_offsets, const double* key_times, const float* key_q_wb,
                                          const float* key_omega, const float* key_alpha, const int64_t* sample_offsets,
                                          const double* sample_times, void* memory, size_t bytes, float* q_out,
                                          float* omega_out, float* alpha_out, int32_t* status_out, size_t* bad_index) {
  return batch_sample({options,
                       make_batch<float>(frame, count, key_offsets, key_times, key_q_wb, key_omega, key_alpha,
                                         sample_offsets, sample_times, {q_out, omega_out, alpha_out}, status_out),
                       memory, bytes, bad_index});
}

}  // extern "C"
