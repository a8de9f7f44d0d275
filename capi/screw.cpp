#include "functions/screw.hpp"

#include "arguments.hpp"

using namespace qtraj;
using namespace qtraj::capi;

namespace {

// A pose a row, or one that serves all.
template <class Real>
struct Poses {
  const Real *q, *p;
  size_t count;
};

template <class Real>
qtraj_status between_poses(const Poses<Real>& a, const Poses<Real>& b, const Real* fraction, size_t fraction_count,
                           size_t count, Real* q_out, Real* p_out, size_t* bad_index) {
  const size_t a_rows = rows_of(a.count, count), b_rows = rows_of(b.count, count);
  const ScrewRows rows = {input<4>(a.q, a_rows),
                          input<3>(a.p, a_rows),
                          input<4>(b.q, b_rows),
                          input<3>(b.p, b_rows),
                          input<1>(fraction, rows_of(fraction_count, count)),
                          output<4>(q_out, count),
                          output<3>(p_out, count)};
  const bool counts_fit = is_one_or(count, a.count) && is_one_or(count, b.count) && is_one_or(count, fraction_count);
  return call({rows.q_a, rows.p_a, rows.q_b, rows.p_b, rows.fraction, rows.q, rows.p}, {counts_fit}, bad_index,
              [&] { return screw_pairs(rows, count); });
}

}  // namespace

extern "C" {

qtraj_status qtraj_screw_pairs(const double* q_a, const double* p_a, size_t a_count, const double* q_b,
                               const double* p_b, size_t b_count, const double* fraction, size_t fraction_count,
                               size_t count, double* q_out, double* p_out, size_t* bad_index) {
  return between_poses<double>({q_a, p_a, a_count}, {q_b, p_b, b_count}, fraction, fraction_count, count, q_out, p_out,
                               bad_index);
}

qtraj_status qtraj_screw_pairs_f32(const float* q_a, const float* p_a, size_t a_count, const float* q_b,
                                   const float* p_b, size_t b_count, const float* fraction, size_t fraction_count,
                                   size_t count, float* q_out, float* p_out, size_t* bad_index) {
  return between_poses<float>({q_a, p_a, a_count}, {q_b, p_b, b_count}, fraction, fraction_count, count, q_out, p_out,
                              bad_index);
}

}  // extern "C"
