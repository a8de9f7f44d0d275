#include "arguments.hpp"
#include "qtraj/karcher_mean.hpp"
#include "qtraj/mean.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// A scalar result that the caller may not want; there is none without samples.
template <class Element>
Argument scalar_output(Element* data, size_t count) {
  return optional(output(data, rows_of(1, count), 1));
}

template <class Real>
qtraj_status mean_eigen(const Real* q, const Real* weights, size_t count, Real* mean_out, double* eigengap,
                        size_t* bad_index) {
  return call({input(q, count, 4), optional(input(weights, count, 1)), output(mean_out, rows_of(1, count), 4),
               scalar_output(eigengap, count)},
              {count >= 1}, bad_index, [&] {
                const EigenMean mean = qtraj::mean_eigen({rows<4>(q), rows<1>(weights), count});
                output_rows<4>(mean_out).write(0, mean.q);
                if (eigengap) *eigengap = mean.eigengap;
                return mean.outcome;
              });
}

template <class Real>
qtraj_status mean_karcher(const Real* q, const Real* weights, size_t count, const KarcherSettings& settings,
                          Real* mean_out, int32_t* iterations, double* residual, size_t* bad_index) {
  return call({input(q, count, 4), optional(input(weights, count, 1)), output(mean_out, rows_of(1, count), 4),
               apart(scalar_output(iterations, count)), scalar_output(residual, count)},
              {count >= 1, settings.is_valid()}, bad_index, [&] {
                const KarcherMean mean = qtraj::mean_karcher({rows<4>(q), rows<1>(weights), count}, settings);
                output_rows<4>(mean_out).write(0, mean.q);
                if (iterations) *iterations = mean.iterations;
                if (residual) *residual = mean.residual;
                return mean.outcome;
              });
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

}  // extern "C"
