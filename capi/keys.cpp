#include "arguments.hpp"
#include "qtraj/key_rows.hpp"

using namespace qtraj;
using capi::input, capi::optional, capi::output;

namespace {

template <class Real>
qtraj_status normalize_keys(const Real* q, size_t count, Real* q_out, size_t* bad_index) {
  return capi::call({input(q, count, 4), output(q_out, count, 4)}, {}, bad_index,
                    [&] { return normalize_rows(capi::rows<4>(q), count, capi::output_rows<4>(q_out)); });
}

template <class Real>
qtraj_status make_keys_continuous(const Real* q, size_t series, size_t length, Real* q_out, size_t* flips,
                                  size_t* bad_index) {
  // a product that overflows is SIZE
  const size_t rows = length > 0 && series > SIZE_MAX / length ? SIZE_MAX : series * length;
  return capi::call({input(q, rows, 4), output(q_out, rows, 4), optional(output(flips, 1, 1))}, {}, bad_index, [&] {
    size_t flipped;
    const Outcome outcome =
        make_continuous_rows(capi::rows<4>(q), series, length, capi::output_rows<4>(q_out), flipped);
    if (flips) *flips = flipped;
    return outcome;
  });
}

template <class Real>
qtraj_status reorder(const Real* q, size_t count, Real* q_out, void (*move)(const void*, size_t, size_t, void*)) {
  return capi::call({input(q, count, 4), output(q_out, count, 4)}, {}, nullptr, [&] {
    move(q, sizeof(Real), count, q_out);
    return Outcome{};
  });
}

}  // namespace

extern "C" {

qtraj_status qtraj_normalize(const double* q, size_t count, double* q_out, size_t* bad_index) {
  return normalize_keys(q, count, q_out, bad_index);
}

qtraj_status qtraj_normalize_f32(const float* q, size_t count, float* q_out, size_t* bad_index) {
  return normalize_keys(q, count, q_out, bad_index);
}

qtraj_status qtraj_make_continuous(const double* q, size_t series, size_t length, double* q_out, size_t* flips,
                                   size_t* bad_index) {
  return make_keys_continuous(q, series, length, q_out, flips, bad_index);
}

qtraj_status qtraj_make_continuous_f32(const float* q, size_t series, size_t length, float* q_out, size_t* flips,
                                       size_t* bad_index) {
  return make_keys_continuous(q, series, length, q_out, flips, bad_index);
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
