#include <cstring>
#include <limits>

#include "arguments.hpp"

using namespace qtraj;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The trajectory that a handle is; nullptr where it is none.
const Trajectory* core_of(const qtraj_trajectory* trajectory) {
  return capi::check_handle(trajectory) == Status::ok ? &trajectory->core : nullptr;
}

}  // namespace

extern "C" {

int32_t qtraj_method(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? static_cast<int32_t>(core->method) : 0;
}

size_t qtraj_key_count(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? core->timeline.key_count : 0;
}

double qtraj_start_time(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? core->timeline.before.knot : kNaN;
}

double qtraj_end_time(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? core->timeline.after.knot : kNaN;
}

size_t qtraj_sign_flips(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? core->sign_flips : 0;
}

double qtraj_worst_norm_error(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? core->worst_norm_error : kNaN;
}

double qtraj_least_dot(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? core->least_dot : kNaN;
}

int32_t qtraj_iterations(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? core->iterations : 0;
}

double qtraj_residual(const qtraj_trajectory* trajectory) {
  const Trajectory* core = core_of(trajectory);
  return core ? core->residual : kNaN;
}

qtraj_status qtraj_keys(const qtraj_trajectory* trajectory, double* times_out, double* q_out) {
  const Status handle = capi::check_handle(trajectory);
  if (handle != Status::ok) return capi::to_c(handle);
  const size_t time_bytes = trajectory->core.timeline.key_count * sizeof(double), q_bytes = 4 * time_bytes;
  if (capi::overlap({times_out, time_bytes}, {q_out, q_bytes})) return QTRAJ_E_OVERLAP;
  if (times_out) std::memcpy(times_out, knots_of(trajectory->core.timeline), time_bytes);
  if (q_out) std::memcpy(q_out, keys_of(trajectory->core), q_bytes);
  return QTRAJ_OK;
}

}  // extern "C"
