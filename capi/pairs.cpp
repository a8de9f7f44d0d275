#include "functions/pairs.hpp"

#include "arguments.hpp"
#include "functions/squad.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// pair_count, fraction_count: 1 or count.
template <class Real>
qtraj_status between_pairs(Outcome (*core)(const PairRows&, size_t), const Real* a, const Real* b, size_t pair_count,
                           const Real* fraction, size_t fraction_count, size_t count, int32_t path, Real* q_out,
                           size_t* bad_index) {
  const size_t pair_rows = rows_of(pair_count, count);
  const PairRows pairs = {input<4>(a, pair_rows), input<4>(b, pair_rows),
                          input<1>(fraction, rows_of(fraction_count, count)), static_cast<Path>(path),
                          output<4>(q_out, count)};
  return call({pairs.a, pairs.b, pairs.fraction, pairs.q}, {is_one_or(count, fraction_count), is_known(pairs.path)},
              bad_index, [&] { return core(pairs, count); });
}

}  // namespace

extern "C" {

qtraj_status qtraj_slerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                         double* q_out, size_t* bad_index) {
  return between_pairs(slerp, a, b, 1, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_f32(const float* a, const float* b, const float* fraction, size_t count, int32_t path,
                             float* q_out, size_t* bad_index) {
  return between_pairs(slerp, a, b, 1, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_pairs(const double* a, const double* b, const double* fraction, size_t fraction_count,
                               size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return between_pairs(slerp, a, b, count, fraction, fraction_count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_pairs_f32(const float* a, const float* b, const float* fraction, size_t fraction_count,
                                   size_t count, int32_t path, float* q_out, size_t* bad_index) {
  return between_pairs(slerp, a, b, count, fraction, fraction_count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp(const double* a, const double* b, const double* fraction, size_t count, int32_t path,
                         double* q_out, size_t* bad_index) {
  return between_pairs(nlerp, a, b, 1, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_f32(const float* a, const float* b, const float* fraction, size_t count, int32_t path,
                             float* q_out, size_t* bad_index) {
  return between_pairs(nlerp, a, b, 1, fraction, count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_pairs(const double* a, const double* b, const double* fraction, size_t fraction_count,
                               size_t count, int32_t path, double* q_out, size_t* bad_index) {
  return between_pairs(nlerp, a, b, count, fraction, fraction_count, count, path, q_out, bad_index);
}

qtraj_status qtraj_nlerp_pairs_f32(const float* a, const float* b, const float* fraction, size_t fraction_count,
                                   size_t count, int32_t path, float* q_out, size_t* bad_index) {
  return between_pairs(nlerp, a, b, count, fraction, fraction_count, count, path, q_out, bad_index);
}

qtraj_status qtraj_slerp_between(const double* a, double time_a, const double* b, double time_b, const double* times,
                                 size_t count, int32_t path, double* q_out, size_t* bad_index) {
  const size_t pair_rows = rows_of(1, count);
  const TimedPair pair = {input<4>(a, pair_rows),  input<4>(b, pair_rows), time_a, time_b, input<1>(times, count),
                          static_cast<Path>(path), output<4>(q_out, count)};
  return call({pair.a, pair.b, pair.times, pair.q}, {true, is_known(pair.path)}, bad_index,
              [&] { return slerp_between(pair, count); });
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
