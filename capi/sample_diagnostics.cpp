#include "arguments.hpp"
#include "diagnostics/samples.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

Samples samples_of(const double* times, const double* q_wb, size_t count) {
  return {input<1>(times, count), input<4>(q_wb, count)};
}

}  // namespace

extern "C" {

qtraj_status qtraj_estimate_omega(int32_t frame, const double* times, const double* q_wb, size_t count,
                                  double* t_mid_out, double* omega_out, size_t* bad_index) {
  const size_t intervals = count > 0 ? count - 1 : 0;
  const Frame in = static_cast<Frame>(frame);
  const Samples samples = samples_of(times, q_wb, count);
  const Output<1> t_mid = output<1>(t_mid_out, intervals);
  const Output<3> omega = output<3>(omega_out, intervals);
  return call({samples.times, samples.q_wb, optional(t_mid), omega}, at_least(2, count, is_known(in)), bad_index,
              [&] { return estimate_omega(samples, in, t_mid, omega); });
}

qtraj_status qtraj_estimate_energy(int32_t frame, const double* times, const double* q_wb, size_t count, double* energy,
                                   size_t* bad_index) {
  const Frame in = static_cast<Frame>(frame);
  const Samples samples = samples_of(times, q_wb, count);
  return call({samples.times, samples.q_wb, output<1>(energy, 1)}, at_least(3, count, is_known(in)), bad_index,
              [&] { return estimate_energy(samples, in, *energy); });
}

qtraj_status qtraj_estimate_jumps(int32_t frame, const double* times, const double* q_wb, size_t count,
                                  const double* knots, size_t knot_count, double* jump_out, size_t* bad_index) {
  const Frame in = static_cast<Frame>(frame);
  const Samples samples = samples_of(times, q_wb, count);
  const Input<1> knot_times = input<1>(knots, knot_count);
  const Output<3> jumps = output<3>(jump_out, knot_count);
  return call({samples.times, samples.q_wb, knot_times, jumps}, at_least(2, count, is_known(in)), bad_index,
              [&] { return estimate_jumps(samples, knots, knot_count, in, jumps); });
}

qtraj_status qtraj_keyframe_errors(const double* key_times, const double* key_q, size_t key_count, const double* times,
                                   const double* q_wb, size_t count, double* error_out, size_t* index_out,
                                   size_t* bad_index) {
  const Samples keys = samples_of(key_times, key_q, key_count), samples = samples_of(times, q_wb, count);
  const Output<1> error = output<1>(error_out, key_count);
  // sample times are read for every row
  return call({keys.times, keys.q_wb, distinct(samples.times), samples.q_wb, error,
               optional(distinct(result(index_out, key_count)))},
              at_least(key_count == 0 ? 0 : 1, count), bad_index,
              [&] { return keyframe_errors(keys, samples, error, index_out); });
}

}  // extern "C"
