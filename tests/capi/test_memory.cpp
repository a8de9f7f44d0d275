// Trajectories in the caller's memory: how much they need, and that they keep to it.
#include <cstdlib>
#include <memory>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

struct Free {
  void operator()(void* memory) const { std::free(memory); }
};
using Memory = std::unique_ptr<void, Free>;

// A variant with keyframes and rates it accepts, and the memory it needs.
template <class Real>
struct Case {
  Keyframes<Real> keys;
  Rates<Real> rates;
  Options options;
  size_t bytes = 0;

  Case(const Variant& variant, size_t count)
      : keys(closed_tour<Real>(count)), rates(rates_for<Real>(variant, count)), options(make_options(variant)) {
    REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
            QTRAJ_OK);
    REQUIRE(qtraj_init_size(options.get(), count, &bytes) == QTRAJ_OK);
  }

  qtraj_status init_at(void* memory, size_t size, qtraj_trajectory** out) const {
    return build_in(memory, size, options.get(), keys, rates, out);
  }
  std::vector<double> times() const {
    std::vector<double> times = times_in(keys.times, 5);
    times.insert(times.end(), {-50.0, 50.0, -1e300, 1e300});
    return times;
  }
};

TEST_CASE("C API: init with exactly qtraj_init_size bytes gives the bits of the heap, keys and options gone",
          "[capi][memory]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants())
      for (const size_t count : {3u, 4u, 17u}) {
        CAPTURE(variant.name, count);
        auto all = std::make_unique<Case<Real>>(variant, count);
        const std::vector<double> times = all->times();
        const Trajectory heap = must_build(all->options.get(), all->keys, all->rates);
        // a block of its own: a sanitizer sees any access outside
        const Memory memory(std::malloc(all->bytes));
        qtraj_trajectory* here = nullptr;
        REQUIRE(all->init_at(memory.get(), all->bytes, &here) == QTRAJ_OK);
        CHECK(reinterpret_cast<char*>(here) >= static_cast<char*>(memory.get()));
        CHECK(reinterpret_cast<char*>(here) < static_cast<char*>(memory.get()) + all->bytes);
        all.reset();

        CHECK(same_bits(must_sample<double>(here, times), must_sample<double>(heap.get(), times)));
        CHECK(same_bits(must_sample<float>(here, times), must_sample<float>(heap.get(), times)));
        CHECK(qtraj_method(here) == qtraj_method(heap.get()));
        CHECK(qtraj_key_count(here) == count);
        CHECK(qtraj_sign_flips(here) == qtraj_sign_flips(heap.get()));
        CHECK(qtraj_worst_norm_error(here) == qtraj_worst_norm_error(heap.get()));
        qtraj_destroy(here);  // the memory stays the caller's, the handle is void
        double q[4];
        CHECK(qtraj_sample_at(here, times[0], nullptr, q) == QTRAJ_E_HANDLE);
      }
  });
}

TEST_CASE("C API: init writes nothing outside its memory, whatever the outcome", "[capi][memory]") {
  static constexpr size_t kZone = 256;
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    Case<double> all(variant, 5);
    std::vector<double> block((all.bytes + 2 * kZone) / sizeof(double) + 1);
    auto* memory = reinterpret_cast<unsigned char*>(block.data()) + kZone;
    const auto zones_intact = [&] {
      const unsigned char *before = memory - kZone, *after = memory + all.bytes;
      const auto filled = [](const unsigned char* zone) {
        return std::all_of(zone, zone + kZone, [](unsigned char byte) { return byte == 0xc3; });
      };
      return filled(before) && filled(after);
    };
    for (const bool faulty : {false, true}) {
      if (faulty) all.keys.q[17] = std::numeric_limits<double>::quiet_NaN();
      std::memset(block.data(), 0xc3, block.size() * sizeof(double));
      qtraj_trajectory* out = nullptr;
      // more than needed is said to be there: only what is needed is used
      CHECK(all.init_at(memory, all.bytes + kZone, &out) == (faulty ? QTRAJ_E_NOT_FINITE : QTRAJ_OK));
      CHECK((out == nullptr) == faulty);
      CHECK(zones_intact());
    }
  }
}

TEST_CASE("C API: init refuses memory that is too small or misaligned and leaves it alone", "[capi][memory][errors]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Case<double> all(variant, 6);
    std::vector<double> block(all.bytes / sizeof(double) + 2);
    std::memset(block.data(), 0x3c, block.size() * sizeof(double));
    auto* memory = reinterpret_cast<unsigned char*>(block.data());
    const auto status_of = [&](void* at, size_t bytes) {
      qtraj_trajectory* out = reinterpret_cast<qtraj_trajectory*>(block.data());
      const qtraj_status status = all.init_at(at, bytes, &out);
      CHECK(out == nullptr);
      return status;
    };
    CHECK(status_of(memory, all.bytes - 1) == QTRAJ_E_BUFFER);
    CHECK(status_of(memory, 0) == QTRAJ_E_BUFFER);
    for (size_t offset = 1; offset < 8; ++offset) CHECK(status_of(memory + offset, all.bytes) == QTRAJ_E_BUFFER);
    CHECK(std::all_of(memory, memory + block.size() * sizeof(double), [](unsigned char byte) { return byte == 0x3c; }));
  }
}

// Arrays of the caller placed in the memory of the trajectory.
template <class Element>
Element* put(unsigned char* at, const std::vector<Element>& elements) {
  std::memcpy(at, elements.data(), elements.size() * sizeof(Element));
  return reinterpret_cast<Element*>(at);
}

TEST_CASE("C API: init refuses memory that any input shares, and takes inputs right beside it",
          "[capi][memory][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Case<Real> all({"", QTRAJ_ROTATION_QUINTIC}, 4);
    std::vector<double> block(all.bytes / sizeof(double) + 256);
    auto* memory = reinterpret_cast<unsigned char*>(block.data()) + 1024;
    enum Input { kTimes, kQ, kOmega, kAlpha, kOptions };
    const size_t sizes[] = {4 * sizeof(double), 16 * sizeof(Real), 12 * sizeof(Real), 12 * sizeof(Real),
                            QTRAJ_OPTIONS_BYTES};

    const auto init_with = [&](Input input, unsigned char* at) {
      const double* times = all.keys.times.data();
      const Real *q = all.keys.q.data(), *omega = all.rates.omega.data(), *alpha = all.rates.alpha.data();
      const qtraj_options* options = all.options.get();
      if (input == kTimes) times = put(at, all.keys.times);
      if (input == kQ) q = put(at, all.keys.q);
      if (input == kOmega) omega = put(at, all.rates.omega);
      if (input == kAlpha) alpha = put(at, all.rates.alpha);
      if (input == kOptions) {
        qtraj_options* moved = nullptr;
        REQUIRE(qtraj_options_init(at, QTRAJ_OPTIONS_BYTES, QTRAJ_ROTATION_QUINTIC, &moved) == QTRAJ_OK);
        options = moved;
      }
      const std::vector<double> before = block;
      size_t bad_index = 0;
      qtraj_trajectory* out = reinterpret_cast<qtraj_trajectory*>(block.data());
      const qtraj_status status =
          init(memory, all.bytes, options, QTRAJ_FRAME_BODY, times, q, omega, alpha, 4, &out, &bad_index);
      CHECK(bad_index == SIZE_MAX);
      CHECK((out == nullptr) == (status != QTRAJ_OK));
      if (status != QTRAJ_OK) CHECK(same_bits(block, before));
      return status;
    };
    for (const Input input : {kTimes, kQ, kOmega, kAlpha, kOptions}) {
      CAPTURE(input);
      unsigned char* const end = memory + all.bytes / 8 * 8;
      CHECK(init_with(input, memory) == QTRAJ_E_OVERLAP);
      CHECK(init_with(input, memory + 64) == QTRAJ_E_OVERLAP);
      CHECK(init_with(input, end - 8) == QTRAJ_E_OVERLAP);
      CHECK(init_with(input, memory - sizes[input] / 8 * 8) == QTRAJ_OK);
      CHECK(init_with(input, memory + (all.bytes + 7) / 8 * 8) == QTRAJ_OK);
      if (input != kOptions) CHECK(init_with(input, memory - sizes[input] + 8) == QTRAJ_E_OVERLAP);
    }
  });
}

TEST_CASE("C API: an input beyond the bytes that init needs is no overlap", "[capi][memory]") {
  const Case<double> all({"", QTRAJ_SLERP}, 4);
  std::vector<double> block(all.bytes / sizeof(double) + 64);
  auto* const after = reinterpret_cast<unsigned char*>(block.data()) + (all.bytes + 7) / 8 * 8;
  const double* q = put(after, all.keys.q);
  qtraj_trajectory* out = nullptr;
  CHECK(qtraj_init(block.data(), block.size() * sizeof(double), all.options.get(), 0, all.keys.times.data(), q, nullptr,
                   nullptr, nullptr, 4, &out, nullptr) == QTRAJ_OK);
  CHECK(std::equal(all.keys.q.begin(), all.keys.q.end(), q));
}

TEST_CASE("C API: one options object and one block serve one trajectory after another", "[capi][memory]") {
  const Case<double> all({"", QTRAJ_LOG_SPLINE}, 9);
  const Memory memory(std::malloc(all.bytes));
  const Trajectory heap = must_build(all.options.get(), all.keys);
  for (int round = 0; round < 3; ++round) {
    qtraj_trajectory* out = nullptr;
    REQUIRE(all.init_at(memory.get(), all.bytes, &out) == QTRAJ_OK);
    CHECK(same_bits(must_sample<double>(out, all.times()), must_sample<double>(heap.get(), all.times())));
  }
}

TEST_CASE("C API: qtraj_init_size grows with the count up to PTRDIFF_MAX and is SIZE beyond",
          "[capi][memory][errors]") {
  for (const Variant& variant : variants()) {
    CAPTURE(variant.name);
    const Options options = make_options(variant);
    size_t bytes = 12345;
    CHECK(qtraj_init_size(nullptr, 2, &bytes) == QTRAJ_E_NULL);
    CHECK(qtraj_init_size(nullptr, 0, &bytes) == QTRAJ_E_NULL);
    CHECK(qtraj_init_size(options.get(), 0, nullptr) == QTRAJ_E_NULL);
    CHECK(qtraj_init_size(options.get(), 0, &bytes) == QTRAJ_E_TOO_FEW);
    CHECK(qtraj_init_size(options.get(), 1, &bytes) == QTRAJ_E_TOO_FEW);
    CHECK(qtraj_init_size(options.get(), SIZE_MAX, &bytes) == QTRAJ_E_SIZE);
    CHECK(qtraj_init_size(options.get(), PTRDIFF_MAX, &bytes) == QTRAJ_E_SIZE);
    CHECK(bytes == 12345);  // untouched by errors

    size_t two = 0, three = 0;
    REQUIRE(qtraj_init_size(options.get(), 2, &two) == QTRAJ_OK);
    REQUIRE(qtraj_init_size(options.get(), 3, &three) == QTRAJ_OK);
    CHECK(three > two);

    size_t fits = 2, too_many = PTRDIFF_MAX;  // bisection
    while (too_many - fits > 1) {
      const size_t middle = fits + (too_many - fits) / 2;
      (qtraj_init_size(options.get(), middle, &bytes) == QTRAJ_OK ? fits : too_many) = middle;
    }
    REQUIRE(qtraj_init_size(options.get(), fits, &bytes) == QTRAJ_OK);
    CHECK(bytes <= static_cast<size_t>(PTRDIFF_MAX));
    CHECK(bytes > static_cast<size_t>(PTRDIFF_MAX) / 16 * 15);
    CHECK(bytes / fits >= 5 * sizeof(double));
  }
}

}  // namespace
