// A table of series for calls with offsets, and what is expected of them.
#ifndef QTRAJ_TESTS_CAPI_BATCHES_HPP
#define QTRAJ_TESTS_CAPI_BATCHES_HPP

#include <cstdint>
#include <cstring>
#include <vector>

#include "support/capi_batch_call.hpp"
#include "support/capi_variants.hpp"

namespace capi {

// Series of keys and of samples. Each is a closed tour of `least` keys and more, of several lengths, so that every
// setting takes it; samples lie all over it, in any order.
template <class Real>
struct Table {
  std::vector<int64_t> key_offsets = {0}, sample_offsets = {0};
  std::vector<double> key_times, sample_times;
  std::vector<Real> key_q, omega, alpha;

  explicit Table(size_t count, const Variant& variant = {"", QTRAJ_SLERP}, size_t least = 4) {
    test::Random random(count);
    for (size_t k = 0; k < count; ++k) {
      const size_t keys = least + (k * 5) % 9;
      add(closed_tour<Real>(keys), rates_for<Real>(variant, keys));
      const double first = key_times[key_times.size() - keys], last = key_times.back();
      add_samples(random, (k * 7) % 23, first, last);
    }
  }

  size_t count() const { return key_offsets.size() - 1; }
  size_t rows() const { return static_cast<size_t>(sample_offsets.back()); }
  size_t keys_of(size_t k) const { return static_cast<size_t>(key_offsets[k + 1] - key_offsets[k]); }
  size_t samples_of(size_t k) const { return static_cast<size_t>(sample_offsets[k + 1] - sample_offsets[k]); }
  size_t longest() const {
    size_t most = 0;
    for (size_t k = 0; k < count(); ++k) most = std::max(most, keys_of(k));
    return most;
  }

  BatchCall<Real> call(const qtraj_options* options, Motion<Real>& out, bool with_rates) const {
    BatchCall<Real> call;
    call.options = options;
    call.count = count();
    call.key_offsets = key_offsets.data(), call.key_times = key_times.data(), call.key_q = key_q.data();
    call.key_omega = omega.empty() ? nullptr : omega.data();
    call.key_alpha = alpha.empty() ? nullptr : alpha.data();
    call.sample_offsets = sample_offsets.data(), call.sample_times = sample_times.data();
    call.q_out = out.q.data();
    call.with_rates = with_rates;
    if (with_rates) call.omega_out = out.omega.data(), call.alpha_out = out.alpha.data();
    return call;
  }

 private:
  void add(const Keyframes<Real>& keys, const Rates<Real>& rates) {
    key_times.insert(key_times.end(), keys.times.begin(), keys.times.end());
    key_q.insert(key_q.end(), keys.q.begin(), keys.q.end());
    omega.insert(omega.end(), rates.omega.begin(), rates.omega.end());
    alpha.insert(alpha.end(), rates.alpha.begin(), rates.alpha.end());
    key_offsets.push_back(static_cast<int64_t>(key_times.size()));
  }
  void add_samples(test::Random& random, size_t samples, double first, double last) {
    for (size_t i = 0; i < samples; ++i) sample_times.push_back(random.uniform(first, last));
    sample_offsets.push_back(static_cast<int64_t>(sample_times.size()));
  }
};

// What is expected of a call: each series by init and sample of its own, NaN where there is no curve.
template <class Real>
struct Expected {
  Motion<Real> out;
  std::vector<int32_t> statuses;

  explicit Expected(const BatchCall<Real>& call)
      : out(static_cast<size_t>(call.sample_offsets[call.count])), statuses(call.count) {
    for (size_t k = 0; k < call.count; ++k) statuses[k] = one(call, k);
  }
  qtraj_status first(size_t& index) const {
    for (index = 0; index < statuses.size(); ++index)
      if (statuses[index] != QTRAJ_OK) return static_cast<qtraj_status>(statuses[index]);
    index = SIZE_MAX;
    return QTRAJ_OK;
  }

 private:
  qtraj_status one(const BatchCall<Real>& call, size_t k) {
    const auto key = static_cast<size_t>(call.key_offsets[k]),
               keys = static_cast<size_t>(call.key_offsets[k + 1]) - key;
    const auto row = static_cast<size_t>(call.sample_offsets[k]),
               rows = static_cast<size_t>(call.sample_offsets[k + 1]) - row;
    const auto nan = std::numeric_limits<Real>::quiet_NaN();
    Real *const q = out.q.data() + 4 * row, *const omega = out.omega.data() + 3 * row,
                *const alpha = out.alpha.data() + 3 * row;
    size_t bytes = 0;
    std::vector<double> memory;
    qtraj_trajectory* curve = nullptr;
    qtraj_status status = qtraj_init_size(call.options, keys, &bytes);
    memory.resize(bytes / sizeof(double) + 1);
    if (status == QTRAJ_OK)
      status = init(memory.data(), bytes, call.options, call.frame, call.key_times + key, call.key_q + 4 * key,
                    call.key_omega ? call.key_omega + 3 * key : nullptr,
                    call.key_alpha ? call.key_alpha + 3 * key : nullptr, keys, &curve, nullptr);
    if (status != QTRAJ_OK) {
      std::fill_n(q, 4 * rows, nan), std::fill_n(omega, 3 * rows, nan), std::fill_n(alpha, 3 * rows, nan);
      return status;
    }
    std::vector<double> even(rows);
    const double* times = even.data();
    if (call.sample_times)
      times = call.sample_times + row;
    else
      REQUIRE(qtraj_even_times(qtraj_start_time(curve), qtraj_end_time(curve), rows, even.data()) == QTRAJ_OK);
    return call.with_rates ? sample_rates(curve, call.frame, times, rows, q, omega, alpha, nullptr)
                           : sample(curve, times, rows, q, nullptr);
  }
};

template <class Real>
bool same_rows(const Motion<Real>& a, const Motion<Real>& b, bool with_rates) {
  return same_bits(a.q, b.q) && (!with_rates || (same_bits(a.omega, b.omega) && same_bits(a.alpha, b.alpha)));
}

inline qtraj_status batch_mean_eigen(size_t count, const int64_t* offsets, const double* q, const double* weights,
                                     double* mean_out, double* eigengap, int32_t* status_out, size_t* bad_index) {
  return qtraj_batch_mean_eigen(count, offsets, q, weights, mean_out, eigengap, status_out, bad_index);
}
inline qtraj_status batch_mean_eigen(size_t count, const int64_t* offsets, const float* q, const float* weights,
                                     float* mean_out, double* eigengap, int32_t* status_out, size_t* bad_index) {
  return qtraj_batch_mean_eigen_f32(count, offsets, q, weights, mean_out, eigengap, status_out, bad_index);
}
inline qtraj_status moments_add(const double* q, const double* weights, size_t count, double* moments,
                                size_t* bad_index) {
  return qtraj_moments_add(q, weights, count, moments, bad_index);
}
inline qtraj_status moments_add(const float* q, const float* weights, size_t count, double* moments,
                                size_t* bad_index) {
  return qtraj_moments_add_f32(q, weights, count, moments, bad_index);
}

}  // namespace capi

#endif
