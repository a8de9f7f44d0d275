#include "functions/algebra.hpp"

#include "arguments.hpp"
#include "functions/derivatives.hpp"
#include "functions/exponential.hpp"
#include "functions/rotation_matrix.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// Functions of one input.
template <size_t InWidth, size_t OutWidth, class Real>
qtraj_status map(Outcome (*core)(const UnaryRows<InWidth, OutWidth>&, size_t), const Real* in, size_t count, Real* out,
                 size_t* bad_index) {
  const UnaryRows<InWidth, OutWidth> rows = {input<InWidth>(in, count), output<OutWidth>(out, count)};
  return call({rows.in, rows.out}, {}, bad_index, [&] { return core(rows, count); });
}

// Functions of two inputs with counts of their own.
template <size_t AWidth, size_t BWidth, size_t OutWidth, class Real>
qtraj_status map_pairs(Outcome (*core)(const BinaryRows<AWidth, BWidth, OutWidth>&, size_t), const Real* a,
                       size_t a_count, const Real* b, size_t b_count, size_t count, Real* out, size_t* bad_index) {
  const BinaryRows<AWidth, BWidth, OutWidth> rows = {input<AWidth>(a, rows_of(a_count, count)),
                                                     input<BWidth>(b, rows_of(b_count, count)),
                                                     output<OutWidth>(out, count)};
  return call({rows.a, rows.b, rows.out}, {is_one_or(count, a_count) && is_one_or(count, b_count)}, bad_index,
              [&] { return core(rows, count); });
}

template <class Real>
qtraj_status rotate_vectors(const Real* q_wb, size_t q_count, const Real* v_body, size_t v_count, size_t count,
                            Real* v_world_out, size_t* bad_index) {
  const RotateRows rows = {input<4>(q_wb, rows_of(q_count, count)), input<3>(v_body, rows_of(v_count, count)),
                           output<3>(v_world_out, count)};
  return call({rows.q_wb, rows.v_body, rows.v_world}, {is_one_or(count, q_count) && is_one_or(count, v_count)},
              bad_index, [&] { return rotate(rows, count); });
}

template <class Real>
qtraj_status from_matrices(const Real* matrix, size_t count, double limit, Real* q_out, Real* distance_out,
                           size_t* bad_index) {
  const MatrixRows rows = {input<9>(matrix, count), limit == 0 ? kMatrixLimit : limit, output<4>(q_out, count),
                           output<1>(distance_out, count)};
  return call({rows.matrix, rows.q, optional(rows.distance)}, {true, is_matrix_limit(limit)}, bad_index,
              [&] { return q_from_matrix(rows, count); });
}

// The second of two arrays that are NULL together is as optional as both are.
Argument required_with(const void* other, const Argument& argument) { return other ? argument : optional(argument); }

}  // namespace

extern "C" {

qtraj_status qtraj_multiply(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                            double* q_out, size_t* bad_index) {
  return map_pairs<4, 4, 4>(multiply, a, a_count, b, b_count, count, q_out, bad_index);
}

qtraj_status qtraj_multiply_f32(const float* a, size_t a_count, const float* b, size_t b_count, size_t count,
                                float* q_out, size_t* bad_index) {
  return map_pairs<4, 4, 4>(multiply, a, a_count, b, b_count, count, q_out, bad_index);
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

qtraj_status qtraj_dot(const double* a, size_t a_count, const double* b, size_t b_count, size_t count, double* dot_out,
                       size_t* bad_index) {
  return map_pairs<4, 4, 1>(dot, a, a_count, b, b_count, count, dot_out, bad_index);
}

qtraj_status qtraj_exp(const double* v, size_t count, double* q_out, size_t* bad_index) {
  return map<3, 4>(qtraj::exp, v, count, q_out, bad_index);
}

qtraj_status qtraj_exp_f32(const float* v, size_t count, float* q_out, size_t* bad_index) {
  return map<3, 4>(qtraj::exp, v, count, q_out, bad_index);
}

qtraj_status qtraj_log(const double* q, size_t count, double* v_out, size_t* bad_index) {
  return map<4, 3>(qtraj::log, q, count, v_out, bad_index);
}

qtraj_status qtraj_log_f32(const float* q, size_t count, float* v_out, size_t* bad_index) {
  return map<4, 3>(qtraj::log, q, count, v_out, bad_index);
}

qtraj_status qtraj_pow(const double* q, const double* exponent, size_t exponent_count, size_t count, double* q_out,
                       size_t* bad_index) {
  return map_pairs<4, 1, 4>(qtraj::pow, q, count, exponent, exponent_count, count, q_out, bad_index);
}

qtraj_status qtraj_rotate(const double* q_wb, size_t q_count, const double* v_body, size_t v_count, size_t count,
                          double* v_world_out, size_t* bad_index) {
  return rotate_vectors(q_wb, q_count, v_body, v_count, count, v_world_out, bad_index);
}

qtraj_status qtraj_rotate_f32(const float* q_wb, size_t q_count, const float* v_body, size_t v_count, size_t count,
                              float* v_world_out, size_t* bad_index) {
  return rotate_vectors(q_wb, q_count, v_body, v_count, count, v_world_out, bad_index);
}

qtraj_status qtraj_distance(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                            double* angle_out, size_t* bad_index) {
  return map_pairs<4, 4, 1>(distance, a, a_count, b, b_count, count, angle_out, bad_index);
}

qtraj_status qtraj_distance_f32(const float* a, size_t a_count, const float* b, size_t b_count, size_t count,
                                float* angle_out, size_t* bad_index) {
  return map_pairs<4, 4, 1>(distance, a, a_count, b, b_count, count, angle_out, bad_index);
}

qtraj_status qtraj_rotation_angle(const double* a, size_t a_count, const double* b, size_t b_count, size_t count,
                                  double* angle_out, size_t* bad_index) {
  return map_pairs<4, 4, 1>(rotation_angle, a, a_count, b, b_count, count, angle_out, bad_index);
}

qtraj_status qtraj_rotation_vector_from_q(const double* q, size_t count, double* r_out, size_t* bad_index) {
  return map<4, 3>(rotation_vector_from_q, q, count, r_out, bad_index);
}

qtraj_status qtraj_rotation_vector_from_q_f32(const float* q, size_t count, float* r_out, size_t* bad_index) {
  return map<4, 3>(rotation_vector_from_q, q, count, r_out, bad_index);
}

qtraj_status qtraj_q_from_rotation_vector(const double* r, size_t count, double* q_out, size_t* bad_index) {
  return map<3, 4>(q_from_rotation_vector, r, count, q_out, bad_index);
}

qtraj_status qtraj_q_from_rotation_vector_f32(const float* r, size_t count, float* q_out, size_t* bad_index) {
  return map<3, 4>(q_from_rotation_vector, r, count, q_out, bad_index);
}

qtraj_status qtraj_matrix_from_q(const double* q_wb, size_t count, double* matrix_out, size_t* bad_index) {
  return map<4, 9>(matrix_from_q, q_wb, count, matrix_out, bad_index);
}

qtraj_status qtraj_matrix_from_q_f32(const float* q_wb, size_t count, float* matrix_out, size_t* bad_index) {
  return map<4, 9>(matrix_from_q, q_wb, count, matrix_out, bad_index);
}

qtraj_status qtraj_q_from_matrix(const double* matrix, size_t count, double limit, double* q_out, double* distance_out,
                                 size_t* bad_index) {
  return from_matrices(matrix, count, limit, q_out, distance_out, bad_index);
}

qtraj_status qtraj_q_from_matrix_f32(const float* matrix, size_t count, double limit, float* q_out, float* distance_out,
                                     size_t* bad_index) {
  return from_matrices(matrix, count, limit, q_out, distance_out, bad_index);
}

qtraj_status qtraj_derivatives_from_rates(int32_t frame, const double* q_wb, const double* omega, const double* alpha,
                                          size_t count, double* dq_out, double* ddq_out, size_t* bad_index) {
  const RatesToDerivatives rows = {static_cast<Frame>(frame),
                                   input<4>(q_wb, count),
                                   input<3>(omega, count),
                                   input<3>(alpha, count),
                                   {output<4>(dq_out, count), output<4>(ddq_out, count)}};
  return call({rows.q_wb, rows.omega, required_with(ddq_out, rows.alpha), rows.derivatives.first,
               required_with(alpha, rows.derivatives.second)},
              {true, is_known(rows.frame)}, bad_index, [&] { return derivatives_from_rates(rows, count); });
}

qtraj_status qtraj_rates_from_derivatives(int32_t frame, const double* q_wb, const double* dq, const double* ddq,
                                          size_t count, double* omega_out, double* alpha_out, size_t* bad_index) {
  const DerivativesToRates rows = {static_cast<Frame>(frame),
                                   input<4>(q_wb, count),
                                   input<4>(dq, count),
                                   input<4>(ddq, count),
                                   {output<3>(omega_out, count), output<3>(alpha_out, count)}};
  return call(
      {rows.q_wb, rows.dq, required_with(alpha_out, rows.ddq), rows.rates.first, required_with(ddq, rows.rates.second)},
      {true, is_known(rows.frame)}, bad_index, [&] { return rates_from_derivatives(rows, count); });
}

}  // extern "C"
