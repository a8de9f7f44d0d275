#include "arguments.hpp"
#include "diagnostics/curve.hpp"
#include "diagnostics/rate_mismatch.hpp"

using namespace qtraj;
using capi::to_c;

namespace {

void write(double value, double* out) {
  if (out) *out = value;
}

// One number of a trajectory; the output is left alone on an error.
qtraj_status scalar(const qtraj_trajectory* trajectory, double* out, Outcome (*compute)(const Trajectory&, double&)) {
  const Status handle = out ? capi::check_handle(trajectory) : Status::null;
  if (handle != Status::ok) return to_c(handle);
  return to_c(compute(trajectory->core, *out).status);
}

}  // namespace

extern "C" {

qtraj_status qtraj_curve_least_norm(const qtraj_trajectory* trajectory, double* norm, double* time) {
  const Status handle = norm ? capi::check_handle(trajectory) : Status::null;
  if (handle != Status::ok) return to_c(handle);
  const LeastNorm least = least_norm(trajectory->core);
  *norm = least.norm;
  write(least.time, time);
  return QTRAJ_OK;
}

qtraj_status qtraj_curve_jumps(const qtraj_trajectory* trajectory, int32_t frame, double* omega_jump,
                               double* alpha_jump) {
  const Status handle = capi::check_handle(trajectory);
  if (handle != Status::ok) return to_c(handle);
  if (!is_known(static_cast<Frame>(frame))) return QTRAJ_E_VALUE;
  const size_t bytes = 3 * trajectory->core.timeline.key_count * sizeof(double);
  if (capi::overlap({omega_jump, bytes}, {alpha_jump, bytes})) return QTRAJ_E_OVERLAP;
  return to_c(curve_jumps(trajectory->core, static_cast<Frame>(frame), omega_jump, alpha_jump).status);
}

qtraj_status qtraj_curve_peak_rates(const qtraj_trajectory* trajectory, double* omega_peak, double* omega_time,
                                    double* alpha_peak, double* alpha_time) {
  const Status handle = capi::check_handle(trajectory);
  if (handle != Status::ok) return to_c(handle);
  Peak omega = {}, alpha = {};
  Outcome outcome;
  if (omega_peak || omega_time) outcome = peak_omega(trajectory->core, omega);
  if (outcome.status == Status::ok && (alpha_peak || alpha_time)) outcome = peak_alpha(trajectory->core, alpha);
  if (outcome.status != Status::ok) return to_c(outcome.status);
  write(omega.value, omega_peak);
  write(omega.time, omega_time);
  write(alpha.value, alpha_peak);
  write(alpha.time, alpha_time);
  return QTRAJ_OK;
}

qtraj_status qtraj_rate_bounds(const qtraj_trajectory* trajectory, double* omega, double* alpha) {
  const Status handle = omega || alpha ? capi::check_handle(trajectory) : Status::null;
  if (handle != Status::ok) return to_c(handle);
  Peak of_omega = {}, of_alpha = {};
  Outcome outcome;
  if (omega) outcome = peak_omega(trajectory->core, of_omega);
  if (outcome.status == Status::ok && alpha) outcome = peak_alpha(trajectory->core, of_alpha);
  if (outcome.status != Status::ok) return to_c(outcome.status);
  write(of_omega.bound, omega);
  write(of_alpha.bound, alpha);
  return QTRAJ_OK;
}

qtraj_status qtraj_curve_energy(const qtraj_trajectory* trajectory, double* energy) {
  return scalar(trajectory, energy, qtraj::energy);
}

qtraj_status qtraj_curve_total_angle(const qtraj_trajectory* trajectory, double* angle) {
  return scalar(trajectory, angle, qtraj::total_angle);
}

qtraj_status qtraj_rate_mismatch(const qtraj_trajectory* trajectory, double* angle, size_t* index) {
  const Status handle = angle ? capi::check_handle(trajectory) : Status::null;
  if (handle != Status::ok) return to_c(handle);
  RateMismatch worst;
  const Outcome outcome = rate_mismatch(trajectory->core, worst);
  if (outcome.status != Status::ok) return to_c(outcome.status);
  *angle = worst.angle;
  if (index) *index = worst.segment;
  return QTRAJ_OK;
}

}  // extern "C"
