#include "build_on_heap.hpp"
#include "methods/vector_builder.hpp"

using namespace qtraj;

namespace {

struct Request {
  const qtraj_options* options;
  VectorInput input;
  qtraj_vector_curve** out;
  size_t* bad_index;

  // Bytes of `rows` rows of numbers.
  size_t bytes(size_t rows) const {
    return rows * input.dim * (input.values.is_float ? sizeof(float) : sizeof(double));
  }
};

template <class Real>
Numbers numbers(const Real* data) {
  return {data, sizeof(Real) == sizeof(float)};
}
template <class Real>
Request request(const qtraj_options* options, const double* times, const Real* values, const Real* first,
                const Real* second, size_t count, size_t dim, qtraj_vector_curve** out, size_t* bad_index) {
  return {options, {times, numbers(values), numbers(first), numbers(second), count, dim}, out, bad_index};
}

// NULL, HANDLE, TOO_FEW, SIZE, INPUT_MISSING and INPUT_UNWANTED; *out and *bad_index get their values for an error.
// `is_missing`: memory that must be there is NULL.
Status begin(const Request& request, CurveSize& size, bool is_missing = false) {
  if (request.bad_index) *request.bad_index = kNoIndex;
  if (!request.out) return Status::null;
  *request.out = nullptr;
  const VectorInput& input = request.input;
  const bool has_rows = input.count > 0 && input.dim > 0;
  if ((input.count > 0 && !input.times) || (has_rows && !input.values.data) || is_missing) return Status::null;
  const Status handle = capi::check_vector_options(request.options);
  if (handle != Status::ok) return handle;
  if (input.count < 2 || input.dim < 1) return Status::too_few;
  if (!vector_curve_size(request.options->core, input.count, input.dim, size)) return Status::size;
  return check_vector_settings(request.options->core, input);
}

qtraj_status finish(const Request& request, const Outcome& outcome, VectorCurve* built) {
  if (outcome.status == Status::ok) *request.out = reinterpret_cast<qtraj_vector_curve*>(built);
  return capi::report(outcome, request.bad_index);
}

qtraj_status create(const Request& request) {
  CurveSize size;
  const Status status = begin(request, size);
  if (status != Status::ok) return capi::to_c(status);
  VectorCurve* built = nullptr;
  const Outcome outcome = capi::build_on_heap(size, built, [&](void* handle, void* workspace) {
    return build_vector_curve(request.options->core, request.input, handle, workspace, &built);
  });
  return finish(request, outcome, built);
}

bool overlaps_input(const capi::Bytes& memory, const Request& request) {
  const VectorInput& input = request.input;
  const size_t rows = input.count;
  const bool two_rows = request.options->core.method == Method{QTRAJ_VECTOR_CUBIC};
  return capi::overlap(memory, {input.times, rows * sizeof(double)}) ||
         capi::overlap(memory, {input.values.data, request.bytes(rows)}) ||
         capi::overlap(memory, {input.first.data, request.bytes(two_rows ? 2 : rows)}) ||
         capi::overlap(memory, {input.second.data, request.bytes(rows)}) ||
         capi::overlap(memory, {request.options, sizeof *request.options});
}

qtraj_status init(void* memory, size_t bytes, const Request& request) {
  CurveSize size;
  const Status status = begin(request, size, !memory);
  if (status != Status::ok) return capi::to_c(status);
  const size_t needed = size.all();
  if (bytes < needed || !capi::is_aligned(memory)) return QTRAJ_E_BUFFER;
  if (overlaps_input({memory, needed}, request)) return QTRAJ_E_OVERLAP;
  VectorCurve* built = nullptr;
  const Outcome outcome = build_vector_curve(request.options->core, request.input, memory,
                                             static_cast<char*>(memory) + size.handle, &built);
  return finish(request, outcome, built);
}

}  // namespace

extern "C" {

qtraj_status qtraj_vector_create(const qtraj_options* options, const double* times, const double* values,
                                 const double* first, const double* second, size_t count, size_t dim,
                                 qtraj_vector_curve** out, size_t* bad_index) {
  return create(request(options, times, values, first, second, count, dim, out, bad_index));
}

qtraj_status qtraj_vector_create_f32(const qtraj_options* options, const double* times, const float* values,
                                     const float* first, const float* second, size_t count, size_t dim,
                                     qtraj_vector_curve** out, size_t* bad_index) {
  return create(request(options, times, values, first, second, count, dim, out, bad_index));
}

qtraj_status qtraj_vector_init_size(const qtraj_options* options, size_t count, size_t dim, size_t* bytes) {
  const Status handle = bytes ? capi::check_vector_options(options) : Status::null;
  if (handle != Status::ok) return capi::to_c(handle);
  if (count < 2 || dim < 1) return QTRAJ_E_TOO_FEW;
  CurveSize size;
  if (!vector_curve_size(options->core, count, dim, size)) return QTRAJ_E_SIZE;
  *bytes = size.all();
  return QTRAJ_OK;
}

qtraj_status qtraj_vector_init(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                               const double* values, const double* first, const double* second, size_t count,
                               size_t dim, qtraj_vector_curve** out, size_t* bad_index) {
  return init(memory, bytes, request(options, times, values, first, second, count, dim, out, bad_index));
}

qtraj_status qtraj_vector_init_f32(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                                   const float* values, const float* first, const float* second, size_t count,
                                   size_t dim, qtraj_vector_curve** out, size_t* bad_index) {
  return init(memory, bytes, request(options, times, values, first, second, count, dim, out, bad_index));
}

void qtraj_vector_destroy(qtraj_vector_curve* curve) {
  if (capi::check_handle(curve) != Status::ok) return;
  const bool on_heap = curve->core.on_heap;
  capi::clear_tag(curve);
  if (on_heap) capi::release(curve);
}

}  // extern "C"
