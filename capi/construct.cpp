#include "build_on_heap.hpp"
#include "methods/build.hpp"
#include "methods/method.hpp"

using namespace qtraj;

namespace {

// Arguments of a constructor, float or double alike.
struct Request {
  KeyframeInput input;
  int32_t frame;
  qtraj_trajectory** out;
  size_t* bad_index;

  size_t element_bytes() const { return input.q_wb.is_float ? sizeof(float) : sizeof(double); }
};

template <class Real>
Request request(const double* times, const Real* q_wb, int32_t frame, const Real* omega, const Real* alpha,
                const int32_t* turns, size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return {
      {times, qtraj::input<4>(q_wb, count), qtraj::input<3>(omega, count), qtraj::input<3>(alpha, count), turns, count},
      frame,
      out,
      bad_index};
}

template <class Real>
Request request_with_tangents(const double* times, const Real* q_wb, const Real* in_tangents, const Real* out_tangents,
                              size_t count, qtraj_trajectory** out, size_t* bad_index) {
  Request with_tangents = request<Real>(times, q_wb, 0, nullptr, nullptr, nullptr, count, out, bad_index);
  with_tangents.input.in_tangents = qtraj::input<4>(in_tangents, count);
  with_tangents.input.out_tangents = qtraj::input<4>(out_tangents ? out_tangents : in_tangents, count);
  return with_tangents;
}

// NULL, HANDLE, TOO_FEW and SIZE; *out and *bad_index get their values for an error.
Status begin(const Request& request, Status handle = Status::ok) {
  if (request.bad_index) *request.bad_index = kNoIndex;
  if (!request.out) return Status::null;
  *request.out = nullptr;
  const KeyframeInput& input = request.input;
  if (input.count > 0 && (!input.times || !input.q_wb.data)) return Status::null;
  if (handle != Status::ok) return handle;
  if (input.count < 2) return Status::too_few;
  size_t bytes;
  return capi::array_bytes(input.count, 4 * sizeof(double), bytes) ? Status::ok : Status::size;
}

qtraj_status finish(const Request& request, const Outcome& outcome, Trajectory* built) {
  if (outcome.status == Status::ok) *request.out = reinterpret_cast<qtraj_trajectory*>(built);
  return capi::report(outcome, request.bad_index);
}

qtraj_status create_on_heap(const Options& options, const Request& request) {
  CurveSize size;
  if (!trajectory_size(options, request.input.count, size)) return QTRAJ_E_SIZE;
  const Frame frame = static_cast<Frame>(request.frame);
  const Status settings = check_settings(options, request.input, frame);
  if (settings != Status::ok) return capi::to_c(settings);

  Trajectory* built = nullptr;
  const Outcome outcome = capi::build_on_heap(size, built, [&](void* handle, void* workspace) {
    return build_trajectory(options, request.input, frame, handle, workspace, &built);
  });
  return finish(request, outcome, built);
}

qtraj_status create_with_method(int32_t method, const Request& request) {
  const Status status = begin(request);
  if (status != Status::ok) return capi::to_c(status);
  Options options;
  const Method core_method = static_cast<Method>(method);
  if (!find_method(core_method) || Options::make(core_method, options) != Status::ok) return QTRAJ_E_VALUE;
  return create_on_heap(options, request);
}

// `is_missing`: an array that the function is named for is NULL.
qtraj_status create_with_options(const qtraj_options* options, const Request& request, bool is_missing = false) {
  const Status status = begin(request, is_missing ? Status::null : capi::check_handle(options));
  return status != Status::ok ? capi::to_c(status) : create_on_heap(options->core, request);
}

bool overlaps_input(const capi::Bytes& memory, const qtraj_options* options, const Request& request) {
  const KeyframeInput& input = request.input;
  const size_t row_of_3 = 3 * input.count * request.element_bytes(),
               row_of_4 = 4 * input.count * request.element_bytes();
  return capi::overlap(memory, {input.times, input.count * sizeof(double)}) ||
         capi::overlap(memory, {input.q_wb.data, row_of_4}) ||
         capi::overlap(memory, {input.in_tangents.data, row_of_4}) ||
         capi::overlap(memory, {input.out_tangents.data, row_of_4}) ||
         capi::overlap(memory, {input.omega.data, row_of_3}) || capi::overlap(memory, {input.alpha.data, row_of_3}) ||
         capi::overlap(memory, {input.turns, (options->core.key_count(input.count) - 1) * sizeof(int32_t)}) ||
         capi::overlap(memory, {options, sizeof *options});
}

qtraj_status init_in_place(void* memory, size_t bytes, const qtraj_options* options, const Request& request,
                           bool is_missing = false) {
  const bool has_arrays = memory && !is_missing;
  const Status status = begin(request, has_arrays ? capi::check_handle(options) : Status::null);
  if (status != Status::ok) return capi::to_c(status);
  CurveSize size;
  if (!trajectory_size(options->core, request.input.count, size)) return QTRAJ_E_SIZE;
  const Frame frame = static_cast<Frame>(request.frame);
  const Status settings = check_settings(options->core, request.input, frame);
  if (settings != Status::ok) return capi::to_c(settings);
  const size_t needed = size.all();
  if (bytes < needed || !capi::is_aligned(memory)) return QTRAJ_E_BUFFER;
  if (overlaps_input({memory, needed}, options, request)) return QTRAJ_E_OVERLAP;

  Trajectory* built = nullptr;
  const Outcome outcome =
      build_trajectory(options->core, request.input, frame, memory, static_cast<char*>(memory) + size.handle, &built);
  return finish(request, outcome, built);
}

}  // namespace

extern "C" {

qtraj_status qtraj_create(int32_t method, const double* times, const double* q_wb, size_t count, qtraj_trajectory** out,
                          size_t* bad_index) {
  return create_with_method(method, request<double>(times, q_wb, 0, nullptr, nullptr, nullptr, count, out, bad_index));
}

qtraj_status qtraj_create_f32(int32_t method, const double* times, const float* q_wb, size_t count,
                              qtraj_trajectory** out, size_t* bad_index) {
  return create_with_method(method, request<float>(times, q_wb, 0, nullptr, nullptr, nullptr, count, out, bad_index));
}

qtraj_status qtraj_create_with_options(const qtraj_options* options, const double* times, const double* q_wb,
                                       size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return create_with_options(options,
                             request<double>(times, q_wb, 0, nullptr, nullptr, nullptr, count, out, bad_index));
}

qtraj_status qtraj_create_with_options_f32(const qtraj_options* options, const double* times, const float* q_wb,
                                           size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return create_with_options(options, request<float>(times, q_wb, 0, nullptr, nullptr, nullptr, count, out, bad_index));
}

qtraj_status qtraj_create_with_rates(const qtraj_options* options, int32_t frame, const double* times,
                                     const double* q_wb, const double* omega, const double* alpha, size_t count,
                                     qtraj_trajectory** out, size_t* bad_index) {
  return create_with_options(options, request(times, q_wb, frame, omega, alpha, nullptr, count, out, bad_index),
                             count > 0 && !omega);
}

qtraj_status qtraj_create_with_rates_f32(const qtraj_options* options, int32_t frame, const double* times,
                                         const float* q_wb, const float* omega, const float* alpha, size_t count,
                                         qtraj_trajectory** out, size_t* bad_index) {
  return create_with_options(options, request(times, q_wb, frame, omega, alpha, nullptr, count, out, bad_index),
                             count > 0 && !omega);
}

qtraj_status qtraj_create_with_turns(const qtraj_options* options, int32_t frame, const double* times,
                                     const double* q_wb, const double* omega, const double* alpha, const int32_t* turns,
                                     size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return create_with_options(options, request(times, q_wb, frame, omega, alpha, turns, count, out, bad_index),
                             count > 0 && !turns);
}

qtraj_status qtraj_create_with_turns_f32(const qtraj_options* options, int32_t frame, const double* times,
                                         const float* q_wb, const float* omega, const float* alpha,
                                         const int32_t* turns, size_t count, qtraj_trajectory** out,
                                         size_t* bad_index) {
  return create_with_options(options, request(times, q_wb, frame, omega, alpha, turns, count, out, bad_index),
                             count > 0 && !turns);
}

qtraj_status qtraj_init_size(const qtraj_options* options, size_t count, size_t* bytes) {
  const Status handle = bytes ? capi::check_handle(options) : Status::null;
  if (handle != Status::ok) return capi::to_c(handle);
  if (count < 2) return QTRAJ_E_TOO_FEW;
  CurveSize size;
  if (!trajectory_size(options->core, count, size)) return QTRAJ_E_SIZE;
  *bytes = size.all();
  return QTRAJ_OK;
}

qtraj_status qtraj_init(void* memory, size_t bytes, const qtraj_options* options, int32_t frame, const double* times,
                        const double* q_wb, const double* omega, const double* alpha, const int32_t* turns,
                        size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return init_in_place(memory, bytes, options, request(times, q_wb, frame, omega, alpha, turns, count, out, bad_index));
}

qtraj_status qtraj_init_f32(void* memory, size_t bytes, const qtraj_options* options, int32_t frame,
                            const double* times, const float* q_wb, const float* omega, const float* alpha,
                            const int32_t* turns, size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return init_in_place(memory, bytes, options, request(times, q_wb, frame, omega, alpha, turns, count, out, bad_index));
}

qtraj_status qtraj_create_with_tangents(const qtraj_options* options, const double* times, const double* q_wb,
                                        const double* in_tangents, const double* out_tangents, size_t count,
                                        qtraj_trajectory** out, size_t* bad_index) {
  return create_with_options(options,
                             request_with_tangents(times, q_wb, in_tangents, out_tangents, count, out, bad_index),
                             count > 0 && !in_tangents);
}

qtraj_status qtraj_create_with_tangents_f32(const qtraj_options* options, const double* times, const float* q_wb,
                                            const float* in_tangents, const float* out_tangents, size_t count,
                                            qtraj_trajectory** out, size_t* bad_index) {
  return create_with_options(options,
                             request_with_tangents(times, q_wb, in_tangents, out_tangents, count, out, bad_index),
                             count > 0 && !in_tangents);
}

qtraj_status qtraj_init_with_tangents(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                                      const double* q_wb, const double* in_tangents, const double* out_tangents,
                                      size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return init_in_place(memory, bytes, options,
                       request_with_tangents(times, q_wb, in_tangents, out_tangents, count, out, bad_index),
                       count > 0 && !in_tangents);
}

qtraj_status qtraj_init_with_tangents_f32(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                                          const float* q_wb, const float* in_tangents, const float* out_tangents,
                                          size_t count, qtraj_trajectory** out, size_t* bad_index) {
  return init_in_place(memory, bytes, options,
                       request_with_tangents(times, q_wb, in_tangents, out_tangents, count, out, bad_index),
                       count > 0 && !in_tangents);
}

void qtraj_destroy(qtraj_trajectory* trajectory) {
  if (capi::check_handle(trajectory) != Status::ok) return;
  const bool on_heap = trajectory->core.on_heap;
  capi::clear_tag(trajectory);
  if (on_heap) capi::release(trajectory);
}

}  // extern "C"
