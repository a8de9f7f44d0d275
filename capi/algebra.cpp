#include "qtraj/algebra.hpp"

#include "arguments.hpp"
#include "qtraj/derivatives.hpp"
#include "qtraj/exponential.hpp"
#include "qtraj/options.hpp"
#include "qtraj/rotation_matrix.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// Functions of one input.
template <int InputWidth, int OutputWidth>
qtraj_status map(Outcome (*core)(const Rows<InputWidth>&, size_t, const OutputRows<OutputWidth>&), const double* in,
                 size_t count, double* out, size_t* bad_index) {
  return call({input(in, count, InputWidth), output(out, count, OutputWidth)}, {}, bad_index,
              [&] { return core(rows<InputWidth>(in), count, output_rows<OutputWidth>(out)); });
}

// Functions of two inputs with counts of their own.
template <int AWidth, int BWidth, int OutputWidth, class Real>
qtraj_status map(Outcome (*core)(const Rows<AWidth>&, const Rows<BWidth>&, size_t, const OutputRows<OutputWidth>&),
                 const Real* a, size_t a_count, const Real* b, size_t b_count, size_t count, Real* out,
                 size_t* bad_index) {
  return call({input(a, rows_of(a_count, count), AWidth), input(b, rows_of(b_count, count), BWidth),
               output(out, count, OutputWidth)},
              {serves(a_count, count) && serves(b_count, count)}, bad_index, [&] {
                return core(rows<AWidth>(a, a_count), rows<BWidth>(b, b_count), count, output_rows<OutputWidth>(out));
              });
}

// The second of two arrays that are NULL together is as optional as both are.
Argument with(const void* other, const Argument& argument) { return other ? argument : optional(argument); }

}  // namespace

extern "C" {

qtraj_status qtraj_multiply(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                            double* q_out, size_t* bad_index) {
  return map<4, 4, 4>(multiply, a, a_count, b, b_count, count, q_out, bad_index);
}

qtraj_status qtraj_conjugate(const double* q, size_t count, double* q_out, size_t* bad_index) {
  return map<4, 4>(conjugate, q, count, q_out, bad_index);
}

qtraj_status qtraj_inverse(const double* q, size_t count, double* q_out, size_t* bad_index) {
  return map<4, 4>(inverse, q, count, q_out, bad_index);
}

qtraj_status qtraj_norm(const double* q, size_t count, double* norm_out, size_t* bad_index) {
  return map<4, 1>(norm, q, count, norm_out, bad_index);
}

qtraj_status qtraj_dot(const double* a, const double* b, size_t count, double* dot_out, size_t* bad_index) {
  return map<4, 4, 1>(dot, a, count, b, count, count, dot_out, bad_index);
}

qtraj_status qtraj_exp(const double* v, size_t count, double* q_out, size_t* bad_index) {
  return map<3, 4>(qtraj::exp, v, count, q_out, bad_index);
}

qtraj_status qtraj_log(const double* q, size_t count, double* v_out, size_t* bad_index) {
  return map<4, 3>(qtraj::log, q, count, v_out, bad_index);
}

qtraj_status qtraj_pow(const double* q, const double* exponent, size_t exponent_count, size_t count, double* q_out,
                       size_t* bad_index) {
  return map<4, 1, 4>(qtraj::pow, q, count, exponent, exponent_count, count, q_out, bad_index);
}

qtraj_status qtraj_rotate(const double* q_wb, size_t q_count, const double* v_body, size_t v_count, size_t count,
                          double* v_world_out, size_t* bad_index) {
  return map<4, 3, 3>(rotate, q_wb, q_count, v_body, v_count, count, v_world_out, bad_index);
}

qtraj_status qtraj_rotate_f32(const float* q_wb, size_t q_count, const float* v_body, size_t v_count, size_t count,
                              float* v_world_out, size_t* bad_index) {
  return map<4, 3, 3>(rotate, q_wb, q_count, v_body, v_count, count, v_world_out, bad_index);
}

qtraj_status qtraj_distance(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                            double* angle_out, size_t* bad_index) {
  return map<4, 4, 1>(distance, a, a_count, b, b_count, count, angle_out, bad_index);
}

qtraj_status qtraj_rotation_angle(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                                  double* angle_out, size_t* bad_index) {
  return map<4, 4, 1>(rotation_angle, a, a_count, b, b_count, count, angle_out, bad_index);
}

qtraj_status qtraj_rotation_vector_from_q(const double* q, size_t count, double* r_out, size_t* bad_index) {
  return map<4, 3>(rotation_vector_from_q, q, count, r_out, bad_index);
}

qtraj_status qtraj_q_from_rotation_vector(const double* r, size_t count, double* q_out, size_t* bad_index) {
  return map<3, 4>(q_from_rotation_vector, r, count, q_out, bad_index);
}

qtraj_status qtraj_matrix_from_q(const double* q_wb, size_t count, double* matrix_out, size_t* bad_index) {
  return map<4, 9>(matrix_from_q, q_wb, count, matrix_out, bad_index);
}

qtraj_status qtraj_q_from_matrix(const double* matrix, size_t count, double* q_out, size_t* bad_index) {
  return map<9, 4>(q_from_matrix, matrix, count, q_out, bad_index);
}

qtraj_status qtraj_derivatives_from_rates(int32_t frame, const double* q_wb, const double* omega, const double* alpha,
                                          size_t count, double* dq_out, double* ddq_out, size_t* bad_index) {
  const auto asked_frame = static_cast<Frame>(frame);
  return call({input(q_wb, count, 4), input(omega, count, 3), with(ddq_out, input(alpha, count, 3)),
               output(dq_out, count, 4), with(alpha, output(ddq_out, count, 4))},
              {true, is_known(asked_frame)}, bad_index, [&] {
                return derivatives_from_rates(asked_frame, rows<4>(q_wb), rows<3>(omega), rows<3>(alpha), count,
                                              {output_rows<4>(dq_out), output_rows<4>(ddq_out)});
              });
}

qtraj_status qtraj_rates_from_derivatives(int32_t frame, const double* q_wb, const double* dq, const double* ddq,
                                          size_t count, double* omega_out, double* alpha_out, size_t* bad_index) {
  const auto asked_frame = static_cast<Frame>(frame);
  return call({input(q_wb, count, 4), input(dq, count, 4), with(alpha_out, input(ddq, count, 4)),
               output(omega_out, count, 3), with(ddq, output(alpha_out, count, 3))},
              {true, is_known(asked_frame)}, bad_index, [&] {
                return rates_from_derivatives(asked_frame, rows<4>(q_wb), rows<4>(dq), rows<4>(ddq), count,
                                              {output_rows<3>(omega_out), output_rows<3>(alpha_out)});
              });
}

}  // extern "C"
