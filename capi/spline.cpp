#include "arguments.hpp"
#include "qtraj/spline_curve.hpp"

using namespace qtraj;
using capi::input, capi::optional, capi::output;

namespace {

// Rows of `dim` numbers: none to point at where dim is 0, too many where one row is larger than memory.
capi::Argument with_rows(capi::Argument argument) {
  constexpr size_t kMost = PTRDIFF_MAX / sizeof(double);
  if (argument.width > 0 && argument.width <= kMost) return argument;
  if (argument.rows > 0) argument.rows = argument.width == 0 ? 0 : SIZE_MAX;
  argument.width = 1;
  return argument;
}

}  // namespace

extern "C" {

qtraj_status qtraj_cubic_spline(const double* x, const double* y, size_t count, size_t dim, int32_t start, int32_t end,
                                const double* queries, size_t query_count, double* y_out, size_t* bad_index) {
  const End start_end = static_cast<End>(start), end_end = static_cast<End>(end);
  const size_t doubles = spline_curve_workspace(count, dim);
  return capi::call({input(x, count, 1), with_rows(input(y, count, dim)), input(queries, query_count, 1),
                     with_rows(output(y_out, query_count, dim)),
                     // no array of the caller, but its size is judged with theirs
                     optional(input<double>(nullptr, doubles, 1))},
                    {count >= 2, are_spline_ends(start_end, end_end)}, bad_index, [&]() -> Outcome {
                      auto* memory = static_cast<double*>(capi::allocate(doubles * sizeof(double)));
                      if (!memory) return {Status::no_memory, kNoIndex};
                      const Outcome outcome = sample_spline_curve({x, y, count, dim}, start_end, end_end, queries,
                                                                  query_count, y_out, memory);
                      capi::release(memory);
                      return outcome;
                    });
}

}  // extern "C"
