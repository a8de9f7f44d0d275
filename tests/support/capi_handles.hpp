// Handles that free themselves, and one name for the double and the float twin of every function of the C API.
#ifndef QTRAJ_TESTS_CAPI_HANDLES_HPP
#define QTRAJ_TESTS_CAPI_HANDLES_HPP

#include <qtraj.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "support/method_settings.hpp"

namespace capi {

struct Destroy {
  void operator()(qtraj_trajectory* trajectory) const { qtraj_destroy(trajectory); }
  void operator()(qtraj_options* options) const { qtraj_options_destroy(options); }
};
using Trajectory = std::unique_ptr<qtraj_trajectory, Destroy>;
using Options = std::unique_ptr<qtraj_options, Destroy>;

// No constant of any enumeration, now or later: values are appended one by one.
constexpr int32_t kUnknown[] = {-1, 1000, INT32_MAX, INT32_MIN};

// Calls body(double()) and body(float()).
template <class Body>
void for_double_and_float(Body&& body) {
  body(double());
  body(float());
}

inline qtraj_status create(int32_t method, const double* times, const double* q, size_t count, qtraj_trajectory** out,
                           size_t* bad_index) {
  return qtraj_create(method, times, q, count, out, bad_index);
}
inline qtraj_status create(int32_t method, const double* times, const float* q, size_t count, qtraj_trajectory** out,
                           size_t* bad_index) {
  return qtraj_create_f32(method, times, q, count, out, bad_index);
}
inline qtraj_status create_with_options(const qtraj_options* options, const double* times, const double* q,
                                        size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return qtraj_create_with_options(options, times, q, count, out, bad_index);
}
inline qtraj_status create_with_options(const qtraj_options* options, const double* times, const float* q, size_t count,
                                        qtraj_trajectory** out, size_t* bad_index) {
  return qtraj_create_with_options_f32(options, times, q, count, out, bad_index);
}
inline qtraj_status create_with_rates(const qtraj_options* options, int32_t frame, const double* times, const double* q,
                                      const double* omega, const double* alpha, size_t count, qtraj_trajectory** out,
                                      size_t* bad_index) {
  return qtraj_create_with_rates(options, frame, times, q, omega, alpha, count, out, bad_index);
}
inline qtraj_status create_with_rates(const qtraj_options* options, int32_t frame, const double* times, const float* q,
                                      const float* omega, const float* alpha, size_t count, qtraj_trajectory** out,
                                      size_t* bad_index) {
  return qtraj_create_with_rates_f32(options, frame, times, q, omega, alpha, count, out, bad_index);
}
inline qtraj_status create_with_tangents(const qtraj_options* options, const double* times, const double* q,
                                         const double* in_tangents, const double* out_tangents, size_t count,
                                         qtraj_trajectory** out, size_t* bad_index) {
  return qtraj_create_with_tangents(options, times, q, in_tangents, out_tangents, count, out, bad_index);
}
inline qtraj_status create_with_tangents(const qtraj_options* options, const double* times, const float* q,
                                         const float* in_tangents, const float* out_tangents, size_t count,
                                         qtraj_trajectory** out, size_t* bad_index) {
  return qtraj_create_with_tangents_f32(options, times, q, in_tangents, out_tangents, count, out, bad_index);
}
inline qtraj_status init(void* memory, size_t bytes, const qtraj_options* options, int32_t frame, const double* times,
                         const double* q, const double* omega, const double* alpha, size_t count,
                         qtraj_trajectory** out, size_t* bad_index) {
  return qtraj_init(memory, bytes, options, frame, times, q, omega, alpha, nullptr, count, out, bad_index);
}
inline qtraj_status init(void* memory, size_t bytes, const qtraj_options* options, int32_t frame, const double* times,
                         const float* q, const float* omega, const float* alpha, size_t count, qtraj_trajectory** out,
                         size_t* bad_index) {
  return qtraj_init_f32(memory, bytes, options, frame, times, q, omega, alpha, nullptr, count, out, bad_index);
}
inline qtraj_status init_with_tangents(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                                       const double* q, const double* in_tangents, const double* out_tangents,
                                       size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return qtraj_init_with_tangents(memory, bytes, options, times, q, in_tangents, out_tangents, count, out, bad_index);
}
inline qtraj_status init_with_tangents(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                                       const float* q, const float* in_tangents, const float* out_tangents,
                                       size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return qtraj_init_with_tangents_f32(memory, bytes, options, times, q, in_tangents, out_tangents, count, out,
                                      bad_index);
}
inline qtraj_status sample(const qtraj_trajectory* trajectory, const double* times, size_t count, double* q_out,
                           size_t* bad_index) {
  return qtraj_sample(trajectory, times, count, q_out, bad_index);
}
inline qtraj_status sample(const qtraj_trajectory* trajectory, const double* times, size_t count, float* q_out,
                           size_t* bad_index) {
  return qtraj_sample_f32(trajectory, times, count, q_out, bad_index);
}
inline qtraj_status sample_uniform(const qtraj_trajectory* trajectory, double start, double step, size_t count,
                                   double* q_out, size_t* bad_index) {
  return qtraj_sample_uniform(trajectory, start, step, count, q_out, bad_index);
}
inline qtraj_status sample_uniform(const qtraj_trajectory* trajectory, double start, double step, size_t count,
                                   float* q_out, size_t* bad_index) {
  return qtraj_sample_uniform_f32(trajectory, start, step, count, q_out, bad_index);
}
inline qtraj_status sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor, double* q_out) {
  return qtraj_sample_at(trajectory, time, cursor, q_out);
}
inline qtraj_status sample_at(const qtraj_trajectory* trajectory, double time, size_t* cursor, float* q_out) {
  return qtraj_sample_at_f32(trajectory, time, cursor, q_out);
}
inline qtraj_status sample_rates(const qtraj_trajectory* trajectory, int32_t frame, const double* times, size_t count,
                                 double* q_out, double* omega_out, double* alpha_out, size_t* bad_index) {
  return qtraj_sample_rates(trajectory, frame, times, count, q_out, omega_out, alpha_out, bad_index);
}
inline qtraj_status sample_rates(const qtraj_trajectory* trajectory, int32_t frame, const double* times, size_t count,
                                 float* q_out, float* omega_out, float* alpha_out, size_t* bad_index) {
  return qtraj_sample_rates_f32(trajectory, frame, times, count, q_out, omega_out, alpha_out, bad_index);
}
inline qtraj_status sample_rates_at(const qtraj_trajectory* trajectory, int32_t frame, double time, size_t* cursor,
                                    double* q_out, double* omega_out, double* alpha_out) {
  return qtraj_sample_rates_at(trajectory, frame, time, cursor, q_out, omega_out, alpha_out);
}
inline qtraj_status sample_rates_at(const qtraj_trajectory* trajectory, int32_t frame, double time, size_t* cursor,
                                    float* q_out, float* omega_out, float* alpha_out) {
  return qtraj_sample_rates_at_f32(trajectory, frame, time, cursor, q_out, omega_out, alpha_out);
}

inline qtraj_status normalize(const double* q, size_t count, double* q_out, size_t* bad_index) {
  return qtraj_normalize(q, count, q_out, bad_index);
}
inline qtraj_status normalize(const float* q, size_t count, float* q_out, size_t* bad_index) {
  return qtraj_normalize_f32(q, count, q_out, bad_index);
}
inline qtraj_status make_continuous(const double* q, size_t series, size_t length, double* q_out, size_t* flips,
                                    size_t* bad_index) {
  return qtraj_make_continuous(q, series, length, q_out, flips, bad_index);
}
inline qtraj_status make_continuous(const float* q, size_t series, size_t length, float* q_out, size_t* flips,
                                    size_t* bad_index) {
  return qtraj_make_continuous_f32(q, series, length, q_out, flips, bad_index);
}
inline qtraj_status wxyz_from_xyzw(const double* q_xyzw, size_t count, double* q_out) {
  return qtraj_wxyz_from_xyzw(q_xyzw, count, q_out);
}
inline qtraj_status wxyz_from_xyzw(const float* q_xyzw, size_t count, float* q_out) {
  return qtraj_wxyz_from_xyzw_f32(q_xyzw, count, q_out);
}
inline qtraj_status xyzw_from_wxyz(const double* q, size_t count, double* q_xyzw_out) {
  return qtraj_xyzw_from_wxyz(q, count, q_xyzw_out);
}
inline qtraj_status xyzw_from_wxyz(const float* q, size_t count, float* q_xyzw_out) {
  return qtraj_xyzw_from_wxyz_f32(q, count, q_xyzw_out);
}

}  // namespace capi

#endif
