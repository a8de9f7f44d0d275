#include "functions/poses.hpp"

#include "arguments.hpp"
#include "math/arithmetic.hpp"

using namespace qtraj;

namespace {

template <class Real>
struct Call {
  const qtraj_trajectory* trajectory;
  const qtraj_vector_curve* positions;
  PoseOutputs<Real> outputs;
};

template <class Real>
PoseOutputs<Real> outputs(int32_t frame, Real* q, Real* omega, Real* alpha, Real* p, Real* v, Real* a) {
  return {{q, omega, alpha, static_cast<Frame>(frame)}, {p, v, a}};
}

// The order of errors: NULL, HANDLE, SIZE, VALUE, OVERLAP. Not inlined: its arrays would stand on the stack of the
// call.
template <class Real>
QTRAJ_NOINLINE Status check(const Call<Real>& call, const double* times, size_t count, bool times_missing) {
  const PoseOutputs<Real>& outputs = call.outputs;
  const bool no_output = !outputs.has_orientation() && !outputs.has_position();
  if (count > 0 && (times_missing || no_output)) return Status::null;
  if (!call.trajectory || !call.positions) return Status::null;
  for (const Status handle : {capi::check_handle(call.trajectory), capi::check_handle(call.positions)})
    if (handle != Status::ok) return handle;
  size_t time_bytes, q_bytes, rate_bytes, p_bytes;
  if (!capi::array_bytes(count, sizeof(double), time_bytes) || !capi::array_bytes(count, 4 * sizeof(Real), q_bytes) ||
      !capi::array_bytes(count, 3 * sizeof(Real), rate_bytes) ||
      !capi::array_bytes(count, call.positions->core.dim * sizeof(Real), p_bytes))
    return Status::size;
  if (!is_known(outputs.orientation.frame)) return Status::value;
  const bool clash = capi::overlap_any({{times, time_bytes},
                                        {outputs.orientation.q, q_bytes},
                                        {outputs.orientation.omega, rate_bytes},
                                        {outputs.orientation.alpha, rate_bytes},
                                        {outputs.position.value, p_bytes},
                                        {outputs.position.first, p_bytes},
                                        {outputs.position.second, p_bytes}});
  return clash ? Status::overlap : Status::ok;
}

template <class Real>
qtraj_status sample(const Call<Real>& call, const double* times, size_t count, size_t* bad_index) {
  if (bad_index) *bad_index = kNoIndex;
  const Status status = check(call, times, count, !times);
  if (status != Status::ok) return capi::to_c(status);
  return capi::report(sample_poses(call.trajectory->core, call.positions->core, times, count, call.outputs), bad_index);
}

template <class Real>
qtraj_status sample_at(const Call<Real>& call, double time, size_t* cursor) {
  const Status status = check(call, nullptr, 1, false);
  if (status != Status::ok) return capi::to_c(status);
  size_t start = 0;
  return capi::to_c(
      sample_pose_at(call.trajectory->core, call.positions->core, time, cursor ? *cursor : start, call.outputs));
}

}  // namespace

extern "C" {

qtraj_status qtraj_sample_poses(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions, int32_t frame,
                                const double* times, size_t count, double* q_out, double* omega_out, double* alpha_out,
                                double* p_out, double* v_out, double* a_out, size_t* bad_index) {
  return sample<double>({trajectory, positions, outputs(frame, q_out, omega_out, alpha_out, p_out, v_out, a_out)},
                        times, count, bad_index);
}

qtraj_status qtraj_sample_poses_f32(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                    int32_t frame, const double* times, size_t count, float* q_out, float* omega_out,
                                    float* alpha_out, float* p_out, float* v_out, float* a_out, size_t* bad_index) {
  return sample<float>({trajectory, positions, outputs(frame, q_out, omega_out, alpha_out, p_out, v_out, a_out)}, times,
                       count, bad_index);
}

qtraj_status qtraj_sample_pose_at(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                  int32_t frame, double time, size_t* cursor, double* q_out, double* omega_out,
                                  double* alpha_out, double* p_out, double* v_out, double* a_out) {
  return sample_at<double>({trajectory, positions, outputs(frame, q_out, omega_out, alpha_out, p_out, v_out, a_out)},
                           time, cursor);
}

qtraj_status qtraj_sample_pose_at_f32(const qtraj_trajectory* trajectory, const qtraj_vector_curve* positions,
                                      int32_t frame, double time, size_t* cursor, float* q_out, float* omega_out,
                                      float* alpha_out, float* p_out, float* v_out, float* a_out) {
  return sample_at<float>({trajectory, positions, outputs(frame, q_out, omega_out, alpha_out, p_out, v_out, a_out)},
                          time, cursor);
}

}  // extern "C"
