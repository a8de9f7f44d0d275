// All of one sample of a curve, and how far numbers are apart.
#ifndef QTRAJ_TESTS_CAPI_ONE_SAMPLE_HPP
#define QTRAJ_TESTS_CAPI_ONE_SAMPLE_HPP

#include <qtraj.h>

#include <algorithm>
#include <cmath>

namespace capi {

// In double, rates in the body frame.
struct Sample {
  double q[4], omega[3], alpha[3];
  qtraj_status status;
};
inline Sample sample_of(const qtraj_trajectory* curve, double time) {
  Sample s;
  s.status = qtraj_sample_rates_at(curve, QTRAJ_FRAME_BODY, time, nullptr, s.q, s.omega, s.alpha);
  return s;
}
inline double difference(const double* a, const double* b, size_t count, double sign = 1) {
  double worst = 0;
  for (size_t k = 0; k < count; ++k) worst = std::max(worst, std::abs(a[k] - sign * b[k]));
  return worst;
}

}  // namespace capi

#endif
