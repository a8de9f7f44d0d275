#include "arguments.hpp"
#include "qtraj/pair.hpp"
#include "qtraj/squad_controls.hpp"
#include "qtraj/squad_segment.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

using Interpolation = Outcome (*)(const PairRows&, size_t, const OutputRows<4>&);

// pair_count, fraction_count: 1 or count.
template <class Real>
qtraj_status interpolate(Interpolation interpolation, const Real* a, const Real* b, size_t pair_count,
                         const Real* fraction, size_t fraction_count, size_t count, int32_t path, Real* q_out,
                         size_t* bad_index) {
  const size_t pair_rows = rows_of(pair_count, count);
  return call({input(a, pair_rows, 4), input(b, pair_rows, 4), input(fraction, rows_of(fraction_count, count), 1),
               output(q_out, count, 4)},
              {serves(fraction_count, count), is_known(static_cast<Path>(path))}, bad_index, [&] {
                const PairRows pairs = {rows<4>(a, pair_count), rows<4>(b, pair_count),
                                        rows<1>(fraction, fraction_count), static_cast<Path>(path)};
                return interpolation(pairs, count, output_rows<4>(q_out));
              });
}

}  // namespace

extern "C" {

qtraj_status qtraj_slerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                         double* q_out, size_t* bad_index) {
  return interpolate(slerp, a, b, 1, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_f32(const float* a, const float* b, const float* fraction, size_t count, int32_t path,
                             float* q_out, size_t* bad_index) {
  return interpolate(slerp, a, b, 1, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_pairs(const double* a, const double* b, const double* fraction, size_t fraction_count,
                               size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return interpolate(slerp, a, b, count, fraction, fraction_count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_pairs_f32(const float* a, const float* b, const float* fraction, size_t fraction_count,
                                   size_t count, int32_t path, float* q_out, size_t* bad_index) {
  return interpolate(slerp, a, b, count, fraction, fraction_count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                         double* q_out, size_t* bad_index) {
  return interpolate(nlerp, a, b, 1, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_f32(const float* a, const float* b, const float* fraction, size_t count, int32_t path,
                             float* q_out, size_t* bad_index) {
  return interpolate(nlerp, a, b, 1, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_pairs(const double* a, const double* b, const double* fraction, size_t fraction_count,
                               size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return interpolate(nlerp, a, b, count, fraction, fraction_count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_pairs_f32(const float* a, const float* b, const float* fraction, size_t fraction_count,
                                   size_t count, int32_t path, float* q_out, size_t* bad_index) {
  return interpolate(nlerp, a, b, count, fraction, fraction_count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_between(const double* a, double time_a, const double* b, double time_b, const double* times,
                                 size_t count, int32_t path, double* q_out, size_t* bad_index) {
  const size_t pair_rows = rows_of(1, count);
  return call({input(a, pair_rows, 4), input(b, pair_rows, 4), input(times, count, 1), output(q_out, count, 4)},
              {true, is_known(static_cast<Path>(path))}, bad_index, [&] {
                const TimedPair pair = {rows<4>(a), rows<4>(b),     time_a,
                                        time_b,     rows<1>(times), static_cast<Path>(path)};
                return slerp_between(pair, count, output_rows<4>(q_out));
              });
}

qtraj_status qtraj_squad_controls(const double* times, const double* q_wb, size_t count, double* a_out, double* b_out,
                                  size_t* bad_index) {
  return call(
      {optional(input(times, count, 1)), input(q_wb, count, 4), output(a_out, count, 4), output(b_out, count, 4)}, {},
      bad_index, [&] {
        return squad_controls({rows<1>(times), rows<4>(q_wb)}, count, output_rows<4>(a_out), output_rows<4>(b_out));
      });
}

qtraj_status qtraj_squad_segment(const double* q0, const double* q1, const double* a, const double* b,
                                 const double* fraction, size_t count, double* q_out, size_t* bad_index) {
  const size_t point_rows = rows_of(1, count);
  return call({input(q0, point_rows, 4), input(q1, point_rows, 4), input(a, point_rows, 4), input(b, point_rows, 4),
               input(fraction, count, 1), output(q_out, count, 4)},
              {}, bad_index, [&] {
                return squad_segment({rows<4>(q0), rows<4>(q1), rows<4>(a), rows<4>(b), rows<1>(fraction)}, count,
                                     output_rows<4>(q_out));
              });
}

}  // extern "C"
