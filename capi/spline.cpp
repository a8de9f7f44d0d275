#include "arguments.hpp"
#include "methods/spline_curve.hpp"

using namespace qtraj;

namespace {

// Rows of `dim` numbers: none to point at where dim is 0, too many where one row is larger than memory.
capi::Argument rows_of_dim(const double* data, size_t rows, size_t dim, bool is_output) {
  constexpr size_t kMost = PTRDIFF_MAX / sizeof(double);
  if (dim > 0 && dim <= kMost) return {data, rows, dim, sizeof(double), is_output};
  return {data, rows == 0 || dim == 0 ? 0 : SIZE_MAX, 1, sizeof(double), is_output};
}

}  // namespace

extern "C" {

qtraj_status qtraj_cubic_spline(const double* x, const double* y, size_t count, size_t dim, int32_t start, int32_t end,
                                const double* queries, size_t query_count, double* y_out, size_t* bad_index) {
  const End start_end = static_cast<End>(start), end_end = static_cast<End>(end);
  CurveSize size = {};
  const bool fits = spline_curve_size(count, dim, size);
  const size_t bytes = fits ? size.all() : SIZE_MAX;
  return capi::call({input<1>(x, count), rows_of_dim(y, count, dim, false), input<1>(queries, query_count),
                     rows_of_dim(y_out, query_count, dim, true),
                     // no array of the caller, but its size is judged with theirs
                     optional(capi::Argument(nullptr, bytes, 1, 1, false))},
                    capi::at_least(2, count, are_spline_ends(start_end, end_end)), bad_index, [&]() -> Outcome {
                      void* memory = capi::allocate(bytes);
                      if (!memory) return {Status::no_memory, kNoIndex};
                      const VectorInput points = {x, {y, false}, {}, {}, count, dim};
                      const Outcome outcome =
                          sample_spline_curve(points, start_end, end_end, queries, query_count, y_out, memory, size);
                      capi::release(memory);
                      return outcome;
                    });
}

}  // extern "C"
