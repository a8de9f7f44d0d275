#include "arguments.hpp"
#include "means/eigen_mean.hpp"
#include "means/karcher_mean.hpp"
#include "means/moments.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// A scalar result that the caller may not want; there is none without samples.
template <class Element>
Argument scalar_result(Element* data, size_t count) {
  return optional(result(data, rows_of(1, count)));
}

template <class Real>
qtraj_status mean_eigen(const Real* q, const Real* weights, size_t count, Real* mean_out, double* eigengap,
                        size_t* bad_index) {
  const WeightedOrientations samples = {input<4>(q, count), input<1>(weights, count), count};
  const Output<4> out = output<4>(mean_out, rows_of(1, count));
  return call({samples.q, optional(samples.weights), out, scalar_result(eigengap, count)}, at_least(1, count),
              bad_index, [&] {
                const EigenMean mean = qtraj::mean_eigen(samples);
                write_row(out, 0, mean.q);
                if (eigengap) *eigengap = mean.eigengap;
                return mean.outcome;
              });
}

template <class Real>
qtraj_status mean_karcher(const Real* q, const Real* weights, size_t count, const KarcherSettings& settings,
                          Real* mean_out, int32_t* iterations, double* residual, size_t* bad_index) {
  const WeightedOrientations samples = {input<4>(q, count), input<1>(weights, count), count};
  const Output<4> out = output<4>(mean_out, rows_of(1, count));
  return call({samples.q, optional(samples.weights), out, distinct(scalar_result(iterations, count)),
               scalar_result(residual, count)},
              at_least(1, count, settings.is_valid()), bad_index, [&] {
                const KarcherMean mean = qtraj::mean_karcher(samples, settings);
                write_row(out, 0, mean.q);
                if (iterations) *iterations = mean.iterations;
                if (residual) *residual = mean.residual;
                return mean.outcome;
              });
}

template <class Real>
qtraj_status moments_add(const Real* q, const Real* weights, size_t count, double* moments, size_t* bad_index) {
  const WeightedOrientations samples = {input<4>(q, count), input<1>(weights, count), count};
  return call({samples.q, optional(samples.weights), distinct(result(moments, rows_of(kMomentCount, count)))}, {},
              bad_index, [&] { return count > 0 ? add_moments(samples, moments) : Outcome{}; });
}

}  // namespace

extern "C" {

qtraj_status qtraj_mean_eigen(const double* q, const double* weights, size_t count, double* mean_out, double* eigengap,
                              size_t* bad_index) {
  return mean_eigen(q, weights, count, mean_out, eigengap, bad_index);
}

qtraj_status qtraj_mean_eigen_f32(const float* q, const float* weights, size_t count, float* mean_out, double* eigengap,
                                  size_t* bad_index) {
  return mean_eigen(q, weights, count, mean_out, eigengap, bad_index);
}

qtraj_status qtraj_mean_karcher(const double* q, const double* weights, size_t count, double tolerance,
                                int32_t max_iterations, double* mean_out, int32_t* iterations, double* residual,
                                size_t* bad_index) {
  return mean_karcher(q, weights, count, {tolerance, max_iterations}, mean_out, iterations, residual, bad_index);
}

qtraj_status qtraj_mean_karcher_f32(const float* q, const float* weights, size_t count, double tolerance,
                                    int32_t max_iterations, float* mean_out, int32_t* iterations, double* residual,
                                    size_t* bad_index) {
  return mean_karcher(q, weights, count, {tolerance, max_iterations}, mean_out, iterations, residual, bad_index);
}

qtraj_status qtraj_moments_add(const double* q, const double* weights, size_t count, double* moments,
                               size_t* bad_index) {
  return moments_add(q, weights, count, moments, bad_index);
}

qtraj_status qtraj_moments_add_f32(const float* q, const float* weights, size_t count, double* moments,
                                   size_t* bad_index) {
  return moments_add(q, weights, count, moments, bad_index);
}

qtraj_status qtraj_mean_from_moments(const double* moments, double* mean_out, double* eigengap) {
  if (!moments || !mean_out) return QTRAJ_E_NULL;
  const EigenMean mean = mean_from_moments(moments);
  if (mean.outcome.status == Status::value) return QTRAJ_E_VALUE;
  const Argument sums = {moments, kMomentCount, 1, sizeof *moments, false};
  return call({sums, distinct(output<4>(mean_out, 1)), distinct(optional(result(eigengap, 1)))}, {}, nullptr, [&] {
    write_row(output<4>(mean_out, 1), 0, mean.q);
    if (eigengap) *eigengap = mean.eigengap;
    return mean.outcome;
  });
}

}  // extern "C"
