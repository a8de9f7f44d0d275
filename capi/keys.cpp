#include "functions/keys.hpp"

#include "arguments.hpp"

using namespace qtraj;

namespace {

template <class Real>
qtraj_status normalize_rows(const Real* q, size_t count, Real* q_out, size_t* bad_index) {
  const NormalizeRows rows = {input<4>(q, count), output<4>(q_out, count)};
  return capi::call({rows.q, rows.q_out}, {}, bad_index, [&] { return normalize_keys(rows, count); });
}

template <class Real>
qtraj_status continue_rows(const Real* q, size_t series, size_t length, Real* q_out, size_t* flips, size_t* bad_index) {
  // a product that overflows is SIZE
  const size_t count = length > 0 && series > SIZE_MAX / length ? SIZE_MAX : series * length;
  size_t flipped = 0;
  const ContinuousRows rows = {input<4>(q, count), output<4>(q_out, count), &flipped};
  return capi::call({rows.q, rows.q_out, optional(capi::result(flips, 1))}, {}, bad_index, [&] {
    const Outcome outcome = make_continuous(rows, series, length);
    if (flips) *flips = flipped;
    return outcome;
  });
}

template <class Real>
qtraj_status reorder(const Real* q, size_t count, Real* q_out, void (*move)(const void*, size_t, size_t, void*)) {
  return capi::call({input<4>(q, count), output<4>(q_out, count)}, {}, nullptr, [&] {
    move(q, sizeof(Real), count, q_out);
    return Outcome{};
  });
}

}  // namespace

extern "C" {

qtraj_status qtraj_normalize(const double* q, size_t count, double* q_out, size_t* bad_index) {
  return normalize_rows(q, count, q_out, bad_index);
}

qtraj_status qtraj_normalize_f32(const float* q, size_t count, float* q_out, size_t* bad_index) {
  return normalize_rows(q, count, q_out, bad_index);
}

qtraj_status qtraj_make_continuous(const double* q, size_t series, size_t length, double* q_out, size_t* flips,
                                   size_t* bad_index) {
  return continue_rows(q, series, length, q_out, flips, bad_index);
}

qtraj_status qtraj_make_continuous_f32(const float* q, size_t series, size_t length, float* q_out, size_t* flips,
                                       size_t* bad_index) {
  return continue_rows(q, series, length, q_out, flips, bad_index);
}

qtraj_status qtraj_wxyz_from_xyzw(const double* q_xyzw, size_t count, double* q_out) {
  return reorder(q_xyzw, count, q_out, wxyz_from_xyzw);
}

qtraj_status qtraj_wxyz_from_xyzw_f32(const float* q_xyzw, size_t count, float* q_out) {
  return reorder(q_xyzw, count, q_out, wxyz_from_xyzw);
}

qtraj_status qtraj_xyzw_from_wxyz(const double* q, size_t count, double* q_xyzw_out) {
  return reorder(q, count, q_xyzw_out, xyzw_from_wxyz);
}

qtraj_status qtraj_xyzw_from_wxyz_f32(const float* q, size_t count, float* q_xyzw_out) {
  return reorder(q, count, q_xyzw_out, xyzw_from_wxyz);
}

}  // extern "C"
