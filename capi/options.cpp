#include <new>

#include "arguments.hpp"
#include "methods/method.hpp"

using namespace qtraj;
using capi::to_c;

static_assert(sizeof(qtraj_options) <= QTRAJ_OPTIONS_BYTES);
static_assert(alignof(qtraj_options) <= 8);

namespace {

// By their tag constructors tell the two kinds of options apart.
uint64_t tag_of(const Options& options) {
  return find_method(options.method) ? capi::kOptionsTag : capi::kVectorOptionsTag;
}

// Changes options that are some.
template <class Setter>
qtraj_status set(qtraj_options* options, const Setter& setter) {
  const Status handle = capi::check_any_options(options);
  return to_c(handle != Status::ok ? handle : setter(options->core));
}

}  // namespace

extern "C" {

qtraj_status qtraj_options_create(int32_t method, qtraj_options** out) {
  if (!out) return QTRAJ_E_NULL;
  *out = nullptr;
  Options core;
  const Status status = Options::make(static_cast<Method>(method), core);
  if (status != Status::ok) return to_c(status);
  void* memory = capi::allocate(sizeof(qtraj_options));
  if (!memory) return QTRAJ_E_NO_MEMORY;
  *out = new (memory) qtraj_options{tag_of(core), core, true};
  return QTRAJ_OK;
}

qtraj_status qtraj_options_init(void* memory, size_t bytes, int32_t method, qtraj_options** out) {
  if (!out) return QTRAJ_E_NULL;
  *out = nullptr;
  if (!memory) return QTRAJ_E_NULL;
  Options core;
  const Status status = Options::make(static_cast<Method>(method), core);
  if (status != Status::ok) return to_c(status);
  if (bytes < QTRAJ_OPTIONS_BYTES || !capi::is_aligned(memory)) return QTRAJ_E_BUFFER;
  *out = new (memory) qtraj_options{tag_of(core), core, false};
  return QTRAJ_OK;
}

void qtraj_options_destroy(qtraj_options* options) {
  if (capi::check_any_options(options) != Status::ok) return;
  const bool on_heap = options->on_heap;
  capi::clear_tag(options);
  if (on_heap) capi::release(options);
}

qtraj_status qtraj_options_set_ends(qtraj_options* options, int32_t start, int32_t end) {
  return set(options, [&](Options& core) { return core.set_ends(static_cast<End>(start), static_cast<End>(end)); });
}

qtraj_status qtraj_options_set_end_rates(qtraj_options* options, int32_t frame, const double* omega_start,
                                         const double* omega_end) {
  return set(options,
             [&](Options& core) { return core.set_end_rates(static_cast<Frame>(frame), omega_start, omega_end); });
}

qtraj_status qtraj_options_set_tangents(qtraj_options* options, int32_t rule) {
  return set(options, [&](Options& core) { return core.set_tangents(static_cast<Tangent>(rule)); });
}

qtraj_status qtraj_options_set_reference(qtraj_options* options, int32_t rule, const double* q_wb) {
  if (static_cast<Reference>(rule) == Reference::given && !q_wb) return QTRAJ_E_NULL;
  return set(options, [&](Options& core) { return core.set_reference(static_cast<Reference>(rule), q_wb); });
}

qtraj_status qtraj_options_set_extrapolation(qtraj_options* options, int32_t before, int32_t after) {
  return set(options, [&](Options& core) {
    return core.set_extrapolation(static_cast<Extrapolate>(before), static_cast<Extrapolate>(after));
  });
}

qtraj_status qtraj_options_set_turns(qtraj_options* options, int32_t rule) {
  return set(options, [&](Options& core) { return core.set_turns(static_cast<Turns>(rule)); });
}

qtraj_status qtraj_options_set_period(qtraj_options* options, double period) {
  return set(options, [&](Options& core) { return core.set_period(period); });
}

qtraj_status qtraj_options_set_closure(qtraj_options* options, double angle) {
  return set(options, [&](Options& core) { return core.set_closure(angle); });
}

qtraj_status qtraj_options_set_longest_gap(qtraj_options* options, double seconds) {
  return set(options, [&](Options& core) { return core.set_longest_gap(seconds); });
}

}  // extern "C"
