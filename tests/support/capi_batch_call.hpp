// The arguments of a batch, and one name for its four functions.
#ifndef QTRAJ_TESTS_CAPI_BATCH_CALL_HPP
#define QTRAJ_TESTS_CAPI_BATCH_CALL_HPP

#include <qtraj.h>

#include <cstddef>
#include <cstdint>

namespace capi {

// Everything a call takes. Without rates q_out alone is asked for, and qtraj_batch_sample is called.
template <class Real>
struct BatchCall {
  const qtraj_options* options = nullptr;
  int32_t frame = QTRAJ_FRAME_WORLD;
  size_t count = 0;
  const int64_t* key_offsets = nullptr;
  const double* key_times = nullptr;
  const Real *key_q = nullptr, *key_omega = nullptr, *key_alpha = nullptr;
  const int64_t* sample_offsets = nullptr;
  const double* sample_times = nullptr;
  void* memory = nullptr;
  size_t bytes = 0;
  Real *q_out = nullptr, *omega_out = nullptr, *alpha_out = nullptr;
  int32_t* status_out = nullptr;
  bool with_rates = false;

  qtraj_status operator()(size_t* bad_index) const;
};

template <>
inline qtraj_status BatchCall<double>::operator()(size_t* bad_index) const {
  return with_rates ? qtraj_batch_sample_rates(options, frame, count, key_offsets, key_times, key_q, key_omega,
                                               key_alpha, sample_offsets, sample_times, memory, bytes, q_out, omega_out,
                                               alpha_out, status_out, bad_index)
                    : qtraj_batch_sample(options, count, key_offsets, key_times, key_q, sample_offsets, sample_times,
                                         memory, bytes, q_out, status_out, bad_index);
}
template <>
inline qtraj_status BatchCall<float>::operator()(size_t* bad_index) const {
  return with_rates ? qtraj_batch_sample_rates_f32(options, frame, count, key_offsets, key_times, key_q, key_omega,
                                                   key_alpha, sample_offsets, sample_times, memory, bytes, q_out,
                                                   omega_out, alpha_out, status_out, bad_index)
                    : qtraj_batch_sample_f32(options, count, key_offsets, key_times, key_q, sample_offsets,
                                             sample_times, memory, bytes, q_out, status_out, bad_index);
}

}  // namespace capi

#endif
