#include "qtraj/sample_diagnostics.hpp"

#include "arguments.hpp"
#include "qtraj/options.hpp"

using namespace qtraj;
using capi::input, capi::optional, capi::output;

namespace {

bool is_known_frame(int32_t frame) { return is_known(static_cast<Frame>(frame)); }

Samples samples(const double* times, const double* q_wb, size_t count) { return {times, capi::rows<4>(q_wb), count}; }

}  // namespace

extern "C" {

qtraj_status qtraj_estimate_omega(int32_t frame, const double* times, const double* q_wb, size_t count,
                                  double* t_mid_out, double* omega_out, size_t* bad_index) {
  const size_t intervals = count > 0 ? count - 1 : 0;
  return capi::call({input(times, count, 1), input(q_wb, count, 4), optional(output(t_mid_out, intervals, 1)),
                     output(omega_out, intervals, 3)},
                    {count >= 2, is_known_frame(frame)}, bad_index, [&] {
                      return estimate_omega(samples(times, q_wb, count), static_cast<Frame>(frame),
                                            capi::output_rows<1>(t_mid_out), capi::output_rows<3>(omega_out));
                    });
}

qtraj_status qtraj_estimate_energy(int32_t frame, const double* times, const double* q_wb, size_t count, double* energy,
                                   size_t* bad_index) {
  return capi::call({input(times, count, 1), input(q_wb, count, 4), output(energy, 1, 1)},
                    {count >= 3, is_known_frame(frame)}, bad_index,
                    [&] { return estimate_energy(samples(times, q_wb, count), static_cast<Frame>(frame), *energy); });
}

qtraj_status qtraj_estimate_jumps(int32_t frame, const double* times, const double* q_wb, size_t count,
                                  const double* knots, size_t knot_count, double* jump_out, size_t* bad_index) {
  return capi::call(
      {input(times, count, 1), input(q_wb, count, 4), input(knots, knot_count, 1), output(jump_out, knot_count, 3)},
      {count >= 2, is_known_frame(frame)}, bad_index, [&] {
        return estimate_jumps(samples(times, q_wb, count), knots, knot_count, static_cast<Frame>(frame),
                              capi::output_rows<3>(jump_out));
      });
}

qtraj_status qtraj_keyframe_errors(const double* key_times, const double* key_q, size_t key_count, const double* times,
                                   const double* q_wb, size_t count, double* error_out, size_t* index_out,
                                   size_t* bad_index) {
  // sample times are read for every row
  return capi::call(
      {input(key_times, key_count, 1), input(key_q, key_count, 4), capi::apart(input(times, count, 1)),
       input(q_wb, count, 4), output(error_out, key_count, 1), optional(capi::apart(output(index_out, key_count, 1)))},
      {count >= 1 || key_count == 0}, bad_index, [&] {
        return keyframe_errors(samples(key_times, key_q, key_count), samples(times, q_wb, count),
                               capi::output_rows<1>(error_out), index_out);
      });
}

}  // extern "C"
