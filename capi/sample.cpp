#include "kernel/kernel.hpp"
#include "translate.hpp"

using namespace qtraj;

namespace {

template <class Real>
auto kernel_sample() {
  if constexpr (sizeof(Real) == sizeof(double))
    return kernel().sample;
  else
    return kernel().sample_f32;
}

template <class Real>
qtraj_status sample(const qtraj_trajectory* trajectory, const TimeSource& times, bool times_missing, size_t count,
                    Real* q_out, size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  if (!trajectory || (count > 0 && (times_missing || !q_out))) return QTRAJ_E_NULL;
  size_t q_bytes, time_bytes;
  if (!capi::array_bytes(count, 4 * sizeof(Real), q_bytes) || !capi::array_bytes(count, sizeof(double), time_bytes))
    return QTRAJ_E_SIZE;
  if (capi::overlap({q_out, q_bytes}, {times.array, time_bytes})) return QTRAJ_E_OVERLAP;
  size_t cursor = 0;
  return capi::report(kernel_sample<Real>()(trajectory->core, times, count, cursor, q_out), bad_index);
}

template <class Real>
qtraj_status sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor, Real* q_out) {
  if (!trajectory || !q_out) return QTRAJ_E_NULL;
  size_t start = 0;
  return capi::to_c(kernel_sample<Real>()(trajectory->core, {&time, 0, 0}, 1, cursor ? *cursor : start, q_out).status);
}

}  // namespace

extern "C" {

qtraj_status qtraj_sample(const qtraj_trajectory* trajectory, const double* times, size_t count, double* q_out,
                          size_t* bad_index) {
  return sample(trajectory, {times, 0, 0}, !times, count, q_out, bad_index);
}

qtraj_status qtraj_sample_f32(const qtraj_trajectory* trajectory, const double* times, size_t count, float* q_out,
                              size_t* bad_index) {
  return sample(trajectory, {times, 0, 0}, !times, count, q_out, bad_index);
}

qtraj_status qtraj_sample_uniform(const qtraj_trajectory* trajectory, double start, double step, size_t count,
                                  double* q_out, size_t* bad_index) {
  return sample(trajectory, {nullptr, start, step}, false, count, q_out, bad_index);
}

qtraj_status qtraj_sample_uniform_f32(const qtraj_trajectory* trajectory, double start, double step, size_t count,
                                      float* q_out, size_t* bad_index) {
  return sample(trajectory, {nullptr, start, step}, false, count, q_out, bad_index);
}

qtraj_status qtraj_sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor, double* q_out) {
  return sample_at(trajectory, time, cursor, q_out);
}

qtraj_status qtraj_sample_at_f32(const qtraj_trajectory* trajectory, double time, size_t* cursor, float* q_out) {
  return sample_at(trajectory, time, cursor, q_out);
}

}  // extern "C"
