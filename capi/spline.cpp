#include "arguments.hpp"
#include "functions/spline_curve.hpp"

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
  const size_t doubles = spline_curve_workspace(count, dim);
  return capi::call({input<1>(x, count), rows_of_dim(y, count, dim, false), input<1>(queries, query_count),
                     rows_of_dim(y_out, query_count, dim, true),
                     // no array of the caller, but its size is judged with theirs
                     optional(capi::Argument(nullptr, doubles, 1, sizeof(double), false))},
                    capi::at_least(2, count, are_spline_ends(start_end, end_end)), bad_index, [&]() -> Outcome {
                      auto* memory = static_cast<double*>(capi::allocate(doubles * sizeof(double)));
                      if (!memory) return {Status::no_memory, kNoIndex};
                      const Outcome outcome = sample_spline_curve({x, y, count, dim}, start_end, end_end, queries,
                                                                  query_count, y_out, memory);
                      capi::release(memory);
                      return outcome;
                    });
}

}  // extern "C"
