#include "methods/spline_curve.hpp"

#include <algorithm>
#include <limits>

#include "targets/sampling.hpp"

namespace qtraj {
namespace {

bool is_spline_end(End end) {
  return end == End::standard || end == End::natural || end == End::not_a_knot || end == End::periodic;
}

Options spline_options(End start, End end) {
  Options options;
  options.method = Method{QTRAJ_VECTOR_CUBIC};
  options.start.condition = start;
  options.end.condition = end;
  return options;
}

}  // namespace

bool are_spline_ends(End start, End end) {
  return is_spline_end(start) && is_spline_end(end) && (start == End::periodic) == (end == End::periodic);
}

bool spline_curve_size(size_t count, size_t dim, CurveSize& size) {
  return vector_curve_size(spline_options(End::natural, End::natural), count, dim, size);
}

Outcome sample_spline_curve(const VectorInput& input, End start, End end, const double* queries, size_t query_count,
                            double* y_out, void* memory, const CurveSize& size) {
  VectorCurve* curve = nullptr;
  const Outcome built =
      build_vector_curve(spline_options(start, end), input, memory, static_cast<char*>(memory) + size.handle, &curve);
  if (built.status != Status::ok) {
    std::fill_n(y_out, query_count * input.dim, std::numeric_limits<double>::quiet_NaN());
    return built;
  }
  size_t cursor = 0;
  const VectorOutputs<double> outputs = {y_out, nullptr, nullptr};
  // one by one where each value takes the place of its query
  const TimeSource times = {queries, 0, 0};
  const Outcome sampled = y_out == queries ? sample_vector_rows(*curve, times, query_count, cursor, outputs)
                                           : sample(*curve, times, query_count, cursor, outputs);
  return sampled.status == Status::ok ? Outcome{} : Outcome{sampled.status, input.count + sampled.index};
}

}  // namespace qtraj
