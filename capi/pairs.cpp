#include "functions/pairs.hpp"

#include "arguments.hpp"
#include "functions/squad.hpp"
#include "functions/timed_pairs.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// A quaternion a row, or one that serves all.
template <class Real>
struct End {
  const Real* q;
  size_t count;
};
template <class Real>
struct TimedEnd {
  const Real* q;
  const double* time;
  size_t count;
};

template <class Real>
qtraj_status between_pairs(Outcome (*core)(const PairRows&, size_t), const End<Real>& a, const End<Real>& b,
                           const Real* fraction, size_t fraction_count, size_t count, int32_t path, Real* q_out,
                           size_t* bad_index) {
  const PairRows pairs = {input<4>(a.q, rows_of(a.count, count)), input<4>(b.q, rows_of(b.count, count)),
                          input<1>(fraction, rows_of(fraction_count, count)), static_cast<Path>(path),
                          output<4>(q_out, count)};
  const bool counts_fit = is_one_or(count, a.count) && is_one_or(count, b.count) && is_one_or(count, fraction_count);
  return call({pairs.a, pairs.b, pairs.fraction, pairs.q}, {counts_fit, is_known(pairs.path)}, bad_index,
              [&] { return core(pairs, count); });
}

template <class Real>
qtraj_status between_times(Outcome (*core)(const TimedPairRows&, size_t), const TimedEnd<Real>& a,
                           const TimedEnd<Real>& b, const double* times, size_t times_count, size_t count, int32_t path,
                           Real* q_out, size_t* bad_index) {
  const size_t a_rows = rows_of(a.count, count), b_rows = rows_of(b.count, count);
  const TimedPairRows pairs = {input<4>(a.q, a_rows),
                               input<1>(a.time, a_rows),
                               input<4>(b.q, b_rows),
                               input<1>(b.time, b_rows),
                               input<1>(times, rows_of(times_count, count)),
                               static_cast<Path>(path),
                               output<4>(q_out, count)};
  const bool counts_fit = is_one_or(count, a.count) && is_one_or(count, b.count) && is_one_or(count, times_count);
  return call({pairs.a, pairs.time_a, pairs.b, pairs.time_b, pairs.times, pairs.q}, {counts_fit, is_known(pairs.path)},
              bad_index, [&] { return core(pairs, count); });
}

}  // namespace

extern "C" {

qtraj_status qtraj_slerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                         double* q_out, size_t* bad_index) {
  return between_pairs<double>(slerp, {a, 1}, {b, 1}, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_f32(const float* a, const float* b, const float* fraction, size_t count, int32_t path,
                             float* q_out, size_t* bad_index) {
  return between_pairs<float>(slerp, {a, 1}, {b, 1}, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_pairs(const double* a, size_t a_count, const double* b, size_t b_count, const double* fraction,
                               size_t fraction_count, size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return between_pairs<double>(slerp, {a, a_count}, {b, b_count}, fraction, fraction_count, count, path, q_out,
                               bad_index);
}

qtraj_status qtraj_slerp_pairs_f32(const float* a, size_t a_count, const float* b, size_t b_count,
                                   const float* fraction, size_t fraction_count, size_t count, int32_t path,
                                   float* q_out, size_t* bad_index) {
  return between_pairs<float>(slerp, {a, a_count}, {b, b_count}, fraction, fraction_count, count, path, q_out,
                              bad_index);
}

qtraj_status qtraj_nlerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                         double* q_out, size_t* bad_index) {
  return between_pairs<double>(nlerp, {a, 1}, {b, 1}, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_f32(const float* a, const float* b, const float* fraction, size_t count, int32_t path,
                             float* q_out, size_t* bad_index) {
  return between_pairs<float>(nlerp, {a, 1}, {b, 1}, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_pairs(const double* a, size_t a_count, const double* b, size_t b_count, const double* fraction,
                               size_t fraction_count, size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return between_pairs<double>(nlerp, {a, a_count}, {b, b_count}, fraction, fraction_count, count, path, q_out,
                               bad_index);
}

qtraj_status qtraj_nlerp_pairs_f32(const float* a, size_t a_count, const float* b, size_t b_count,
                                   const float* fraction, size_t fraction_count, size_t count, int32_t path,
                                   float* q_out, size_t* bad_index) {
  return between_pairs<float>(nlerp, {a, a_count}, {b, b_count}, fraction, fraction_count, count, path, q_out,
                              bad_index);
}

qtraj_status qtraj_slerp_between(const double* a, double time_a, const double* b, double time_b, const double* times,
                                 size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return between_times<double>(slerp_between, {a, &time_a, 1}, {b, &time_b, 1}, times, count, count, path, q_out,
                               bad_index);
}

qtraj_status qtraj_slerp_pairs_between(const double* a, const double* time_a, size_t a_count, const double* b,
                                       const double* time_b, size_t b_count, const double* times, size_t times_count,
                                       size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return between_times<double>(slerp_between, {a, time_a, a_count}, {b, time_b, b_count}, times, times_count, count,
                               path, q_out, bad_index);
}

qtraj_status qtraj_slerp_pairs_between_f32(const float* a, const double* time_a, size_t a_count, const float* b,
                                           const double* time_b, size_t b_count, const double* times,
                                           size_t times_count, size_t count, int32_t path, float* q_out,
                                           size_t* bad_index) {
  return between_times<float>(slerp_between, {a, time_a, a_count}, {b, time_b, b_count}, times, times_count, count,
                              path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_pairs_between(const double* a, const double* time_a, size_t a_count, const double* b,
                                       const double* time_b, size_t b_count, const double* times, size_t times_count,
                                       size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return between_times<double>(nlerp_between, {a, time_a, a_count}, {b, time_b, b_count}, times, times_count, count,
                               path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_pairs_between_f32(const float* a, const double* time_a, size_t a_count, const float* b,
                                           const double* time_b, size_t b_count, const double* times,
                                           size_t times_count, size_t count, int32_t path, float* q_out,
                                           size_t* bad_index) {
  return between_times<float>(nlerp_between, {a, time_a, a_count}, {b, time_b, b_count}, times, times_count, count,
                              path, q_out, bad_index);
}

qtraj_status qtraj_squad_controls(const double* times, const double* q_wb, size_t count, double* a_out, double* b_out,
                                  size_t* bad_index) {
  const SquadKeyRows keys = {input<1>(times, count), input<4>(q_wb, count), output<4>(a_out, count),
                             output<4>(b_out, count)};
  return call({optional(keys.times), keys.q_wb, keys.a, keys.b}, {}, bad_index,
              [&] { return squad_controls(keys, count); });
}

qtraj_status qtraj_squad_segment(const double* q0, const double* q1, const double* a, const double* b,
                                 const double* fraction, size_t count, double* q_out, size_t* bad_index) {
  const size_t point_rows = rows_of(1, count);
  const SquadSegmentRows segment = {input<4>(q0, point_rows), input<4>(q1, point_rows),  input<4>(a, point_rows),
                                    input<4>(b, point_rows),  input<1>(fraction, count), output<4>(q_out, count)};
  return call({segment.q0, segment.q1, segment.a, segment.b, segment.fraction, segment.q}, {}, bad_index,
              [&] { return squad_segment(segment, count); });
}

}  // extern "C"
