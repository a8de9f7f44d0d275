// Samples of motions, and the diagnostics of samples as functions that must succeed.
#ifndef QTRAJ_TESTS_CAPI_SAMPLES_HPP
#define QTRAJ_TESTS_CAPI_SAMPLES_HPP

#include <qtraj.h>

#include <vector>

#include "support/catch.hpp"
#include "support/hard_inputs.hpp"

namespace capi {

constexpr int32_t kFrames[] = {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD};

struct EstimatedRates {
  std::vector<double> t_mid, omega;
  qtraj_status status;
};
inline EstimatedRates estimate(const test::Keys& samples, int32_t frame) {
  EstimatedRates rates = {std::vector<double>(samples.count() - 1), std::vector<double>(3 * samples.count() - 3),
                          QTRAJ_OK};
  rates.status = qtraj_estimate_omega(frame, samples.times.data(), samples.q.data(), samples.count(),
                                      rates.t_mid.data(), rates.omega.data(), nullptr);
  return rates;
}

inline double energy_of(const test::Keys& samples, int32_t frame) {
  double energy = 0;
  REQUIRE(qtraj_estimate_energy(frame, samples.times.data(), samples.q.data(), samples.count(), &energy, nullptr) ==
          QTRAJ_OK);
  return energy;
}

inline std::vector<double> jumps_of(const test::Keys& samples, const std::vector<double>& knots, int32_t frame) {
  std::vector<double> jumps(3 * knots.size());
  REQUIRE(qtraj_estimate_jumps(frame, samples.times.data(), samples.q.data(), samples.count(), knots.data(),
                               knots.size(), jumps.data(), nullptr) == QTRAJ_OK);
  return jumps;
}

// All arguments of the four functions, good as they are; the 8 samples are also the keys.
struct SampleArguments {
  std::vector<double> samples_times = {0, 1, 2, 3.5, 4, 5, 6, 7}, samples_q, knots = {2, 1, 3.7, 5, 6, 2.5};
  std::vector<double> t_mid = std::vector<double>(7, 9.0), omega = std::vector<double>(21, 9.0),
                      jumps = std::vector<double>(18, 9.0), errors = std::vector<double>(8, 9.0);
  std::vector<size_t> indices = std::vector<size_t>(8, 9);
  double energy_value = 9;
  size_t bad_index = 12345;

  const double *times, *q, *knot_times, *key_times, *key_q;
  size_t count = 8, knot_count = 6, key_count = 8;
  int32_t frame = QTRAJ_FRAME_WORLD;
  double *t_mid_out, *omega_out, *energy, *jump_out, *error_out;
  size_t* index_out;

  SampleArguments() {
    test::Random random(41);
    for (size_t k = 0; k < 8; ++k) {
      const test::Quaternion q_k = random.orientation();
      samples_q.insert(samples_q.end(), q_k.begin(), q_k.end());
    }
    key_times = times = samples_times.data();
    key_q = q = samples_q.data();
    knot_times = knots.data();
    t_mid_out = t_mid.data();
    omega_out = omega.data();
    energy = &energy_value;
    jump_out = jumps.data();
    error_out = errors.data();
    index_out = indices.data();
  }
  SampleArguments(const SampleArguments&) = delete;

  bool outputs_untouched() const {
    return t_mid == std::vector<double>(7, 9.0) && omega == std::vector<double>(21, 9.0) &&
           jumps == std::vector<double>(18, 9.0) && errors == std::vector<double>(8, 9.0) &&
           indices == std::vector<size_t>(8, 9) && energy_value == 9;
  }
};

enum SampleFunction { kOmega, kEnergy, kJumps, kErrors, kFunctions };

inline qtraj_status call(SampleFunction function, SampleArguments& a) {
  switch (function) {
    case kOmega:
      return qtraj_estimate_omega(a.frame, a.times, a.q, a.count, a.t_mid_out, a.omega_out, &a.bad_index);
    case kEnergy:
      return qtraj_estimate_energy(a.frame, a.times, a.q, a.count, a.energy, &a.bad_index);
    case kJumps:
      return qtraj_estimate_jumps(a.frame, a.times, a.q, a.count, a.knot_times, a.knot_count, a.jump_out, &a.bad_index);
    default:
      return qtraj_keyframe_errors(a.key_times, a.key_q, a.key_count, a.times, a.q, a.count, a.error_out, a.index_out,
                                   &a.bad_index);
  }
}

}  // namespace capi

#endif
