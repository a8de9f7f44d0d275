#include "functions/keys.hpp"

#include "arguments.hpp"
#include "diagnostics/recording.hpp"
#include "functions/nanoseconds.hpp"

using namespace qtraj;

namespace {

template <class Real>
qtraj_status check_rows(const double* times, const Real* q_wb, size_t count, int32_t* status_out,
                        qtraj_key_report* report, size_t* bad_index) {
  const Samples keys = {input<1>(times, count), input<4>(q_wb, count)};
  return capi::call(
      {keys.times, keys.q_wb, optional(capi::result(status_out, count)), optional(capi::result(report, 1))}, {},
      bad_index, [&]() -> Outcome {
        qtraj_key_report ignored;
        qtraj_key_report& found = report ? *report : ignored;
        if (times_are_in_order(keys)) return check_keys(keys, {}, status_out, found);
        // together no more than the times and the keys, whose size was checked
        auto* chain = static_cast<size_t*>(capi::allocate(count * sizeof(size_t)));
        auto* latest = static_cast<double*>(capi::allocate(count * sizeof(double)));
        const Outcome outcome = chain && latest ? check_keys(keys, {chain, latest}, status_out, found)
                                                : Outcome{Status::no_memory, kNoIndex};
        capi::release(latest);
        capi::release(chain);
        return outcome;
      });
}

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
qtraj_status continue_strided(const Real* q, const SeriesLayout& layout, Real* q_out, size_t* flips,
                              size_t* bad_index) {
  const size_t extent = layout.extent();
  size_t flipped = 0;
  const ContinuousRows rows = {input<4>(q, extent), output<4>(q_out, extent), &flipped};
  return capi::call({rows.q, rows.q_out, optional(capi::result(flips, 1))}, {true, layout.is_apart()}, bad_index, [&] {
    const Outcome outcome = make_continuous(rows, layout);
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

qtraj_status qtraj_check_keys(const double* times, const double* q_wb, size_t count, int32_t* status_out,
                              qtraj_key_report* report, size_t* bad_index) {
  return check_rows(times, q_wb, count, status_out, report, bad_index);
}

qtraj_status qtraj_check_keys_f32(const double* times, const float* q_wb, size_t count, int32_t* status_out,
                                  qtraj_key_report* report, size_t* bad_index) {
  return check_rows(times, q_wb, count, status_out, report, bad_index);
}

qtraj_status qtraj_seconds_from_ns(const int64_t* ns, size_t count, int64_t origin, double* seconds_out) {
  const capi::Argument stamps = {ns, count, 1, sizeof *ns, false};
  return capi::call({distinct(stamps), output<1>(seconds_out, count)}, {}, nullptr, [&] {
    seconds_from_ns(ns, count, origin, seconds_out);
    return Outcome{};
  });
}

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

qtraj_status qtraj_make_continuous_strided(const double* q, size_t series, size_t series_stride, size_t length,
                                           size_t key_stride, double* q_out, size_t* flips, size_t* bad_index) {
  return continue_strided(q, {series, series_stride, length, key_stride}, q_out, flips, bad_index);
}

qtraj_status qtraj_make_continuous_strided_f32(const float* q, size_t series, size_t series_stride, size_t length,
                                               size_t key_stride, float* q_out, size_t* flips, size_t* bad_index) {
  return continue_strided(q, {series, series_stride, length, key_stride}, q_out, flips, bad_index);
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
