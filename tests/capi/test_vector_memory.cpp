// What a vector curve in the caller's memory needs, refuses and leaves alone.
#include <cstring>

#include "support/capi_variants.hpp"
#include "support/guarded.hpp"
#include "support/vector_arguments.hpp"

using namespace capi;

namespace {

TEST_CASE("C API: of a given end only its own row is read", "[capi][vector][errors][memory]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const bool at_end : {false, true}) {
      const VectorVariant variant = at_end ? VectorVariant{"", QTRAJ_VECTOR_CUBIC, QTRAJ_END_NATURAL, QTRAJ_END_GIVEN}
                                           : VectorVariant{"", QTRAJ_VECTOR_CUBIC, QTRAJ_END_GIVEN, QTRAJ_END_NATURAL};
      VectorKeys<Real> keys = vector_tour<Real>(variant, 6, 3);
      const Options options = vector_options(variant);
      const VectorCurve expected = must_build_vector(options.get(), keys);
      // the other row lies where nothing may be read
      test::Guarded<Real> room(3);
      Real* const row = room.array(3, !at_end);
      std::copy_n(&keys.first[at_end ? 3 : 0], 3, row);
      qtraj_vector_curve* out = nullptr;
      REQUIRE(vector_create(options.get(), keys.times.data(), keys.values.data(), at_end ? row - 3 : row,
                            static_cast<Real*>(nullptr), 6, 3, &out, nullptr) == QTRAJ_OK);
      const VectorCurve curve(out);
      const std::vector<double> times = times_in(keys.times, 9);
      CHECK(same_bits(must_sample_vectors<double>(curve.get(), times),
                      must_sample_vectors<double>(expected.get(), times)));
    }
  });
}

TEST_CASE("C API: memory of a vector curve that is too small, not aligned or an input", "[capi][vector][memory]") {
  for (const VectorVariant& variant : vector_variants())
    for_double_and_float([&](auto zero) {
      using Real = decltype(zero);
      CAPTURE(variant.name);
      const auto is_refused = [&](VectorArguments<Real>& a, void* at, qtraj_status expected) {
        a.curve = reinterpret_cast<qtraj_vector_curve*>(&a.bytes);
        CHECK(a.init(at) == expected);
        CHECK((a.curve == nullptr && a.bad == SIZE_MAX));
      };
      VectorArguments<Real> a(variant);
      const size_t needed = a.bytes;
      for (const size_t few : {size_t{0}, size_t{8}, needed - 1}) {
        a.bytes = few;
        is_refused(a, a.memory.data(), QTRAJ_E_BUFFER);
      }
      a.bytes = needed + 100;
      std::vector<char> shifted(needed + 200);
      for (size_t by = 1; by < 8; ++by) {
        const size_t offset = 8 - reinterpret_cast<uintptr_t>(shifted.data()) % 8 + by;
        is_refused(a, shifted.data() + offset, QTRAJ_E_BUFFER);
      }
      CHECK(std::all_of(shifted.begin(), shifted.end(), [](char c) { return c == 0; }));
      CHECK(a.memory_is_untouched());
      a.bytes = needed;

      // each input at the start, and its last number at the end, of the memory
      const auto check_overlap = [&](const auto& input, auto VectorArguments<Real>::*pointer) {
        if (input.empty()) return;
        using Number = typename std::decay_t<decltype(input)>::value_type;
        const auto kept = a.*pointer;
        const size_t bytes = input.size() * sizeof(Number);
        std::vector<double> room(needed / 8 + 2 * bytes / 8 + 4);
        auto* const begin = reinterpret_cast<char*>(room.data()) + (bytes + 7) / 8 * 8;
        for (char* const at : {begin, begin - bytes + sizeof(Number), begin + needed - sizeof(Number)}) {
          std::memcpy(at, input.data(), bytes);
          a.*pointer = reinterpret_cast<const Number*>(at);
          is_refused(a, begin, QTRAJ_E_OVERLAP);
          CHECK(std::memcmp(at, input.data(), bytes) == 0);
        }
        for (char* const at : {begin - bytes, begin + needed}) {  // beside it
          std::memcpy(at, input.data(), bytes);
          a.*pointer = reinterpret_cast<const Number*>(at);
          CHECK(a.init(begin) == QTRAJ_OK);
        }
        a.*pointer = kept;
      };
      check_overlap(a.keys.times, &VectorArguments<Real>::times);
      check_overlap(a.keys.values, &VectorArguments<Real>::values);
      check_overlap(a.keys.first, &VectorArguments<Real>::first);
      check_overlap(a.keys.second, &VectorArguments<Real>::second);
      is_refused(a, const_cast<qtraj_options*>(a.options), a.bytes > 0 ? QTRAJ_E_OVERLAP : QTRAJ_OK);
    });
}

TEST_CASE("C API: a vector curve in the caller's memory is that of the heap, and stays within it",
          "[capi][vector][memory]") {
  for (const VectorVariant& variant : vector_variants())
    for (const size_t count : {2u, 3u, 4u, 33u})
      for (const size_t dim : {1u, 3u, 8u})
        for_double_and_float([&](auto zero) {
          using Real = decltype(zero);
          CAPTURE(variant.name, count, dim);
          const Options options = vector_options(variant);
          const VectorKeys<Real> keys = vector_tour<Real>(variant, count, dim);
          const VectorCurve heap = must_build_vector(options.get(), keys);
          size_t bytes = 0;
          REQUIRE(qtraj_vector_init_size(options.get(), count, dim, &bytes) == QTRAJ_OK);
          test::Guarded<double> room((bytes + 7) / 8);
          for (const bool at_end : {false, true}) {
            room.fill(0x5a);
            double* const memory = room.array((bytes + 7) / 8, at_end);
            qtraj_vector_curve* curve = nullptr;
            REQUIRE(vector_init(memory, bytes, options.get(), keys.times.data(), keys.values.data(),
                                keys.first_or_null(), keys.second_or_null(), count, dim, &curve, nullptr) == QTRAJ_OK);
            CHECK(room.holds_around(memory, (bytes + 7) / 8, 0x5a));
            const std::vector<double> times = times_in(keys.times, 7);
            room.protect(PROT_READ);  // sampling writes nothing there
            CHECK(same_bits(must_sample_vectors<double>(curve, times), must_sample_vectors<double>(heap.get(), times)));
            room.protect(PROT_READ | PROT_WRITE);
            qtraj_vector_destroy(curve);
            CHECK(qtraj_vector_dim(curve) == 0);
          }
        });
}

}  // namespace
