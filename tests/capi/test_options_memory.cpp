// Options on the heap and in the caller's memory.
#include <cstdlib>
#include <memory>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};

TEST_CASE("C API: options_create makes options of known methods and else writes NULL", "[capi][options][errors]") {
  qtraj_options* const stale = reinterpret_cast<qtraj_options*>(&std::free);
  for (const int32_t method : all_methods()) {
    qtraj_options* options = stale;
    CHECK(qtraj_options_create(method, &options) == QTRAJ_OK);
    CHECK((options != nullptr && options != stale));
    qtraj_options_destroy(options);
    CHECK(qtraj_options_create(method, nullptr) == QTRAJ_E_NULL);
  }
  for (const int32_t method : {0, -1, 1000, INT32_MAX, INT32_MIN}) {
    CAPTURE(method);
    qtraj_options* options = stale;
    CHECK(qtraj_options_create(method, &options) == QTRAJ_E_VALUE);
    CHECK(options == nullptr);
    CHECK(qtraj_options_create(method, nullptr) == QTRAJ_E_NULL);
  }
}

TEST_CASE("C API: QTRAJ_OPTIONS_BYTES of memory hold options of every method", "[capi][options][memory]") {
  const Keyframes<double> keys = closed_tour<double>(6);
  for (const int32_t method : all_methods()) {
    CAPTURE(method);
    // exactly as long as asked for: a sanitizer sees any access past it
    const std::unique_ptr<void, Free> memory(std::malloc(QTRAJ_OPTIONS_BYTES));
    qtraj_options* options = nullptr;
    REQUIRE(qtraj_options_init(memory.get(), QTRAJ_OPTIONS_BYTES, method, &options) == QTRAJ_OK);
    CHECK(static_cast<void*>(options) == memory.get());
    CHECK(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD) == QTRAJ_OK);
    const Rates<double> rates = rates_for<double>({"", method}, keys.count());
    const Trajectory here = must_build(options, keys, rates);

    qtraj_options* on_heap = nullptr;
    REQUIRE(qtraj_options_create(method, &on_heap) == QTRAJ_OK);
    REQUIRE(qtraj_options_set_extrapolation(on_heap, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_HOLD) == QTRAJ_OK);
    const Trajectory there = must_build(on_heap, keys, rates);
    qtraj_options_destroy(on_heap);
    const std::vector<double> times = times_in(keys.times, 4);
    CHECK(same_bits(must_sample<double>(here.get(), times), must_sample<double>(there.get(), times)));

    // no-op: the memory is still ours to use again
    qtraj_options_destroy(options);
    CHECK(qtraj_options_init(memory.get(), QTRAJ_OPTIONS_BYTES, QTRAJ_SQUAD, &options) == QTRAJ_OK);
    CHECK(must_build(options, keys) != nullptr);
  }
}

TEST_CASE("C API: options_init refuses memory that is too small or misaligned and leaves it alone",
          "[capi][options][memory][errors]") {
  alignas(16) unsigned char memory[QTRAJ_OPTIONS_BYTES + 32];
  std::memset(memory, 0xa5, sizeof memory);
  const auto untouched = [&] {
    return std::all_of(std::begin(memory), std::end(memory), [](unsigned char byte) { return byte == 0xa5; });
  };
  const auto status_of = [](void* at, size_t bytes, int32_t method) {
    int stale = 0;
    qtraj_options* options = reinterpret_cast<qtraj_options*>(&stale);
    const qtraj_status status = qtraj_options_init(at, bytes, method, &options);
    CHECK((options == nullptr) == (status != QTRAJ_OK));
    return status;
  };
  for (const size_t bytes : {size_t{0}, size_t{1}, size_t{QTRAJ_OPTIONS_BYTES - 1}})
    CHECK(status_of(memory, bytes, QTRAJ_SLERP) == QTRAJ_E_BUFFER);
  for (size_t offset = 1; offset < 8; ++offset)
    CHECK(status_of(memory + offset, QTRAJ_OPTIONS_BYTES, QTRAJ_SLERP) == QTRAJ_E_BUFFER);
  // NULL, then OPTION, then BUFFER
  CHECK(status_of(nullptr, 0, 0) == QTRAJ_E_NULL);
  CHECK(status_of(memory + 1, 0, 0) == QTRAJ_E_VALUE);
  CHECK(status_of(memory + 1, 0, 1000) == QTRAJ_E_VALUE);
  CHECK(qtraj_options_init(memory, sizeof memory, QTRAJ_SLERP, nullptr) == QTRAJ_E_NULL);
  CHECK(untouched());
  CHECK(status_of(memory + 8, SIZE_MAX, QTRAJ_SLERP) == QTRAJ_OK);
}

TEST_CASE("C API: options_init writes nothing outside QTRAJ_OPTIONS_BYTES", "[capi][options][memory]") {
  alignas(8) unsigned char memory[QTRAJ_OPTIONS_BYTES + 128];
  for (const int32_t method : all_methods()) {
    std::memset(memory, 0x5a, sizeof memory);
    qtraj_options* options = nullptr;
    REQUIRE(qtraj_options_init(memory + 64, QTRAJ_OPTIONS_BYTES, method, &options) == QTRAJ_OK);
    qtraj_options_set_ends(options, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC);
    qtraj_options_set_tangents(options, QTRAJ_TANGENT_GIVEN);
    const double q_wb[4] = {1, 2, 3, 4};
    qtraj_options_set_reference(options, QTRAJ_REFERENCE_GIVEN, q_wb);
    for (size_t i = 0; i < 64; ++i) {
      CHECK(memory[i] == 0x5a);
      CHECK(memory[64 + QTRAJ_OPTIONS_BYTES + i] == 0x5a);
    }
  }
}

}  // namespace
