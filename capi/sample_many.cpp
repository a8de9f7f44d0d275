#include "arguments.hpp"
#include "functions/series.hpp"
#include "math/arithmetic.hpp"

using namespace qtraj;

namespace {

// NULL before HANDLE, whichever trajectory they are found at.
Status check_handles(const SeriesCall& call) {
  Status worst = Status::ok;
  for (size_t k = 0; k < call.series; ++k) {
    const Status handle = capi::check_handle(call.trajectories[k]);
    if (handle == Status::null) return handle;
    if (handle != Status::ok) worst = handle;
  }
  return worst;
}

// The outputs of a call, and the bytes of a number in them.
struct Written {
  const void *q, *omega, *alpha;
  size_t real_bytes;
};

// Whether any of the arrays would be larger than can be.
bool sizes_overflow(const SeriesCall& call, const Written& written, capi::Bytes (&arrays)[5]) {
  const size_t rows = call.count > 0 && call.series > SIZE_MAX / call.count ? SIZE_MAX : call.series * call.count;
  arrays[0].data = written.q, arrays[1].data = written.omega, arrays[2].data = written.alpha;
  arrays[3].data = call.trajectories, arrays[4].data = call.times;
  arrays[2].count = 0;
  if (!capi::array_bytes(rows, 4 * written.real_bytes, arrays[0].count) ||
      !capi::array_bytes(rows, 3 * written.real_bytes, arrays[1].count) ||
      !capi::array_bytes(call.series, sizeof(void*), arrays[3].count) ||
      !capi::array_bytes(call.count, sizeof(double), arrays[4].count))
    return true;
  arrays[2].count = arrays[1].count;
  return false;
}

// Not inlined: what it needs of the stack is given back before sampling begins.
QTRAJ_NOINLINE Status check_arrays(const SeriesCall& call, const Written& written, Frame frame) {
  const bool no_output = !written.q && !written.omega && !written.alpha;
  if (call.series > 0 && (!call.trajectories || (call.count > 0 && (!call.times || no_output)))) return Status::null;
  // an array of so many trajectories there cannot be
  if (call.series > static_cast<size_t>(PTRDIFF_MAX) / sizeof(void*)) return Status::size;
  const Status handles = check_handles(call);
  if (handles != Status::ok) return handles;
  capi::Bytes arrays[5];
  if (sizes_overflow(call, written, arrays)) return Status::size;
  if (!is_known(frame) || !is_known(call.layout)) return Status::value;
  for (size_t output = 0; output < 3; ++output)
    for (size_t other = output + 1; other < 5; ++other)
      if (capi::overlap(arrays[output], arrays[other])) return Status::overlap;
  return Status::ok;
}

template <class Real>
qtraj_status sample_many(const SeriesCall& call, const SampleOutputs<Real>& outputs, size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  const Status status = check_arrays(call, {outputs.q, outputs.omega, outputs.alpha, sizeof(Real)}, outputs.frame);
  if (status != Status::ok) return capi::to_c(status);
  return capi::report(sample_series(call, outputs), bad_index);
}

}  // namespace

extern "C" {

qtraj_status qtraj_sample_many(const qtraj_trajectory* const* trajectories, size_t series, int32_t frame,
                               const double* times, size_t count, int32_t layout, double* q_out, double* omega_out,
                               double* alpha_out, size_t* bad_index) {
  return sample_many<double>({trajectories, series, times, count, static_cast<Layout>(layout)},
                             {q_out, omega_out, alpha_out, static_cast<Frame>(frame)}, bad_index);
}

qtraj_status qtraj_sample_many_f32(const qtraj_trajectory* const* trajectories, size_t series, int32_t frame,
                                   const double* times, size_t count, int32_t layout, float* q_out, float* omega_out,
                                   float* alpha_out, size_t* bad_index) {
  return sample_many<float>({trajectories, series, times, count, static_cast<Layout>(layout)},
                            {q_out, omega_out, alpha_out, static_cast<Frame>(frame)}, bad_index);
}

}  // extern "C"
