// Construction of vector curves: every error, its index, their order, and what is left alone.
#include <cfloat>
#include <cmath>
#include <cstring>

#include "support/capi_variants.hpp"
#include "support/guarded.hpp"
#include "support/vector_curve.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
const VectorVariant kHermite = {"HERMITE", QTRAJ_VECTOR_HERMITE}, kQuintic = {"QUINTIC", QTRAJ_VECTOR_QUINTIC},
                    kLinear = {"LINEAR", QTRAJ_VECTOR_LINEAR}, kCubic = {"CUBIC", QTRAJ_VECTOR_CUBIC};

// All arguments of a construction, good as they are: create, or init where memory is given.
template <class Real>
struct Arguments {
  Options options_of;
  VectorKeys<Real> keys;
  std::vector<double> memory;
  const qtraj_options* options;
  const double* times;
  const Real *values, *first, *second;
  size_t count, dim, bytes = 0, bad = 7;
  qtraj_vector_curve* curve = reinterpret_cast<qtraj_vector_curve*>(&bytes);
  qtraj_vector_curve** out = &curve;

  explicit Arguments(const VectorVariant& variant) : options_of(vector_options(variant)) {
    keys = vector_tour<Real>(variant, 6, 3);
    options = options_of.get(), times = keys.times.data(), values = keys.values.data();
    first = keys.first_or_null(), second = keys.second_or_null(), count = 6, dim = 3;
    REQUIRE(qtraj_vector_init_size(options, count, dim, &bytes) == QTRAJ_OK);
    memory.assign(bytes / 8, -7.0);
  }
  qtraj_status create() { return vector_create(options, times, values, first, second, count, dim, out, &bad); }
  qtraj_status init(void* at) {
    return vector_init(at, bytes, options, times, values, first, second, count, dim, out, &bad);
  }
  bool memory_is_untouched() const {
    return std::all_of(memory.begin(), memory.end(), [](double x) { return x == -7.0; });
  }
};

// Changes the arguments, and checks status and index of both ways to build, and that nothing is left of a curve.
template <class Change>
void check_refusal(const VectorVariant& variant, qtraj_status expected, Change&& change, size_t bad_index = SIZE_MAX) {
  for_double_and_float([&](auto zero) {
    for (const bool in_place : {false, true}) {
      CAPTURE(variant.name, in_place);
      Arguments<decltype(zero)> a(variant);
      change(a);
      CHECK((in_place ? a.init(a.memory.data()) : a.create()) == expected);
      CHECK(a.bad == bad_index);
      CHECK(a.curve == nullptr);
      if (bad_index == SIZE_MAX) CHECK(a.memory_is_untouched());
    }
  });
}

TEST_CASE("C API: vector construction without an array, or without keys", "[capi][vector][errors]") {
  for (const VectorVariant& variant : vector_variants()) {
    check_refusal(variant, QTRAJ_E_NULL, [](auto& a) { a.options = nullptr; });
    check_refusal(variant, QTRAJ_E_NULL, [](auto& a) { a.times = nullptr; });
    check_refusal(variant, QTRAJ_E_NULL, [](auto& a) { a.values = nullptr; });
    for (const size_t few : {0u, 1u}) check_refusal(variant, QTRAJ_E_TOO_FEW, [=](auto& a) { a.count = few; });
    check_refusal(variant, QTRAJ_E_TOO_FEW, [](auto& a) { a.dim = 0; });
    // arrays without elements may be NULL
    check_refusal(variant, QTRAJ_E_TOO_FEW, [](auto& a) { a.count = 0, a.times = nullptr, a.values = nullptr; });
    check_refusal(variant, QTRAJ_E_TOO_FEW, [](auto& a) { a.dim = 0, a.values = nullptr; });
    check_refusal(variant, QTRAJ_E_NULL, [](auto& a) { a.dim = 0, a.times = nullptr; });
    // a period makes no key of one
    check_refusal(variant, QTRAJ_E_TOO_FEW, [](auto& a) {
      REQUIRE(qtraj_options_set_period(a.options_of.get(), 100) == QTRAJ_OK);
      a.count = 1;
    });
  }
  for_double_and_float([](auto zero) {
    Arguments<decltype(zero)> a(kLinear);
    CHECK(a.init(nullptr) == QTRAJ_E_NULL);
    CHECK((a.curve == nullptr && a.bad == SIZE_MAX));
    a.out = nullptr, a.bad = 7;
    CHECK(a.create() == QTRAJ_E_NULL);
    CHECK(a.init(a.memory.data()) == QTRAJ_E_NULL);
    CHECK((a.bad == SIZE_MAX && a.memory_is_untouched()));
    // without a place for the index
    CHECK(vector_create(a.options, a.times, a.values, a.first, a.second, 1, 3, &a.curve, nullptr) == QTRAJ_E_TOO_FEW);
  });
}

TEST_CASE("C API: options of one kind are no options of the other", "[capi][vector][errors]") {
  const Options squad = make_options({"", QTRAJ_SQUAD}), cubic = vector_options(kCubic);
  alignas(8) const double nothing[64] = {};
  for (const qtraj_options* wrong :
       {static_cast<const qtraj_options*>(squad.get()), reinterpret_cast<const qtraj_options*>(nothing),
        reinterpret_cast<const qtraj_options*>(reinterpret_cast<const char*>(cubic.get()) + 4)}) {
    check_refusal(kCubic, QTRAJ_E_HANDLE, [=](auto& a) { a.options = wrong; });
    // before all else but NULL
    check_refusal(kCubic, QTRAJ_E_HANDLE, [=](auto& a) { a.options = wrong, a.count = 0; });
    check_refusal(kCubic, QTRAJ_E_NULL, [=](auto& a) { a.options = wrong, a.times = nullptr; });
    size_t bytes = 7;
    CHECK(qtraj_vector_init_size(wrong, 6, 3, &bytes) == QTRAJ_E_HANDLE);
    CHECK(qtraj_vector_init_size(wrong, 6, 3, nullptr) == QTRAJ_E_NULL);
    CHECK(bytes == 7);
  }
  const Keyframes<double> keys = closed_tour<double>(5);
  Built built = build(cubic.get(), keys);
  CHECK((built.status == QTRAJ_E_HANDLE && built.bad_index == SIZE_MAX && !built.trajectory));
  built = build(cubic.get(), keys, rates_for<double>({"", QTRAJ_HERMITE}, 5));
  CHECK(built.status == QTRAJ_E_HANDLE);
  size_t bytes = 7;
  CHECK(qtraj_init_size(cubic.get(), 5, &bytes) == QTRAJ_E_HANDLE);
  CHECK(bytes == 7);
  qtraj_trajectory* out = nullptr;
  double memory[400];
  CHECK(qtraj_init(memory, sizeof memory, cubic.get(), 0, keys.times.data(), keys.q.data(), nullptr, nullptr, nullptr,
                   5, &out, nullptr) == QTRAJ_E_HANDLE);
  CHECK(qtraj_create(QTRAJ_VECTOR_LINEAR, keys.times.data(), keys.q.data(), 5, &out, nullptr) == QTRAJ_E_VALUE);
  CHECK(out == nullptr);
  // destroyed
  Options gone = vector_options(kCubic);
  unsigned char place[QTRAJ_OPTIONS_BYTES + 8];
  auto* at = place + (8 - reinterpret_cast<uintptr_t>(place) % 8) % 8;
  qtraj_options* in_place = nullptr;
  REQUIRE(qtraj_options_init(at, QTRAJ_OPTIONS_BYTES, QTRAJ_VECTOR_LINEAR, &in_place) == QTRAJ_OK);
  qtraj_options_destroy(in_place);
  CHECK(qtraj_vector_init_size(in_place, 6, 3, &bytes) == QTRAJ_E_HANDLE);
  CHECK(qtraj_options_set_period(in_place, 3) == QTRAJ_E_HANDLE);
}

TEST_CASE("C API: settings that mean nothing to a vector curve are SETTING", "[capi][vector][errors]") {
  const double omega[3] = {0, 0, 0}, q[4] = {1, 0, 0, 0};
  for (const int32_t method :
       {QTRAJ_VECTOR_STEP, QTRAJ_VECTOR_LINEAR, QTRAJ_VECTOR_CUBIC, QTRAJ_VECTOR_HERMITE, QTRAJ_VECTOR_QUINTIC}) {
    CAPTURE(method);
    const bool has_ends = method == QTRAJ_VECTOR_CUBIC;
    const Options options = vector_options(method);
    qtraj_options* const o = options.get();
    CHECK(qtraj_options_set_tangents(o, QTRAJ_TANGENT_CATMULL_ROM) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_tangents(o, 17) == QTRAJ_E_VALUE);
    CHECK(qtraj_options_set_reference(o, QTRAJ_REFERENCE_GIVEN, q) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_reference(o, QTRAJ_REFERENCE_FIRST, nullptr) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_turns(o, QTRAJ_TURNS_AS_GIVEN) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_turns(o, QTRAJ_TURNS_GIVEN) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_end_rates(o, QTRAJ_FRAME_BODY, omega, omega) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_end_rates(o, 0, omega, omega) == QTRAJ_E_VALUE);
    CHECK(qtraj_options_set_ends(o, QTRAJ_END_PERIODIC, QTRAJ_END_NATURAL) == QTRAJ_E_VALUE);
    for (const int32_t end :
         {QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_GIVEN, QTRAJ_END_PERIODIC, QTRAJ_END_DEFAULT})
      CHECK(qtraj_options_set_ends(o, end, end) == (has_ends ? QTRAJ_OK : QTRAJ_E_SETTING));
    for (const int32_t end : {QTRAJ_END_CHORD, QTRAJ_END_ESTIMATED})
      CHECK(qtraj_options_set_ends(o, end, end) == QTRAJ_E_SETTING);
    if (has_ends) {
      CHECK(qtraj_options_set_ends(o, QTRAJ_END_GIVEN, QTRAJ_END_GIVEN) == QTRAJ_OK);
      CHECK(qtraj_options_set_end_rates(o, QTRAJ_FRAME_BODY, omega, omega) == QTRAJ_E_SETTING);
    }
    CHECK(qtraj_options_set_period(o, 9) == QTRAJ_OK);
    CHECK(qtraj_options_set_closure(o, 0.5) == QTRAJ_OK);
    CHECK(qtraj_options_set_longest_gap(o, 0.5) == QTRAJ_OK);
    CHECK(qtraj_options_set_extrapolation(o, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_ERROR) == QTRAJ_OK);
    // the family of methods is one of its own
    for (const int32_t unknown : {1000, 1006, 0, 10, -1}) {
      qtraj_options* none = o;
      CHECK(qtraj_options_create(unknown, &none) == QTRAJ_E_VALUE);
      CHECK(none == nullptr);
    }
  }
}

TEST_CASE("C API: sizes of vector curves that no memory can have are SIZE", "[capi][vector][errors]") {
  const size_t hostile[] = {SIZE_MAX,      SIZE_MAX - 1,     SIZE_MAX / 2,   SIZE_MAX / 2 + 1,
                            SIZE_MAX / 8,  SIZE_MAX / 8 + 1, SIZE_MAX / 16,  SIZE_MAX / 24,
                            SIZE_MAX / 64, SIZE_MAX / 128,   SIZE_MAX / 512, SIZE_MAX / 1024 + 1};
  for (const VectorVariant& variant : vector_variants()) {
    for (const size_t huge : hostile) {
      CAPTURE(huge);
      // the arrays are never looked at
      if (huge > SIZE_MAX / 100) {
        check_refusal(variant, QTRAJ_E_SIZE, [=](auto& a) { a.count = huge; });
        check_refusal(variant, QTRAJ_E_SIZE, [=](auto& a) { a.dim = huge; });
      }
      check_refusal(variant, QTRAJ_E_SIZE, [=](auto& a) { a.count = huge, a.dim = huge; });
      const Options options = vector_options(variant);
      REQUIRE(qtraj_options_set_period(options.get(), 1) == QTRAJ_OK);
      for (const size_t other : {size_t{2}, size_t{1000}, size_t{1} << 32, huge}) {
        size_t bytes = 7;
        for (const bool swapped : {false, true}) {
          const size_t count = swapped ? other : huge, dim = swapped ? huge : other;
          const qtraj_status status = qtraj_vector_init_size(options.get(), count, dim, &bytes);
          // keys and knots at least
          const long double least = 8.0L * static_cast<long double>(count) * static_cast<long double>(dim);
          if (status == QTRAJ_OK)
            CHECK((static_cast<long double>(bytes) >= least && bytes <= PTRDIFF_MAX));
          else
            CHECK((status == QTRAJ_E_SIZE && bytes == 7));
          bytes = 7;
        }
      }
    }
    // before the derivatives are judged
    check_refusal(variant, QTRAJ_E_SIZE, [](auto& a) { a.count = SIZE_MAX, a.first = a.second = a.values; });
  }
  size_t bytes = 7;
  const Options options = vector_options(kLinear);
  CHECK(qtraj_vector_init_size(options.get(), 1, 3, &bytes) == QTRAJ_E_TOO_FEW);
  CHECK(qtraj_vector_init_size(options.get(), 2, 0, &bytes) == QTRAJ_E_TOO_FEW);
  CHECK(qtraj_vector_init_size(nullptr, 2, 1, &bytes) == QTRAJ_E_NULL);
  CHECK(bytes == 7);
}

TEST_CASE("C API: derivatives are there where a vector method needs them, and only there", "[capi][vector][errors]") {
  for (const VectorVariant& variant : vector_variants()) {
    if (variant.needs_first())
      check_refusal(variant, QTRAJ_E_INPUT_MISSING, [](auto& a) { a.first = nullptr; });
    else
      check_refusal(variant, QTRAJ_E_INPUT_UNWANTED, [](auto& a) { a.first = a.values; });
    if (variant.needs_second()) {
      check_refusal(variant, QTRAJ_E_INPUT_MISSING, [](auto& a) { a.second = nullptr; });
      check_refusal(variant, QTRAJ_E_INPUT_MISSING, [](auto& a) { a.first = nullptr; });
    } else {
      check_refusal(variant, QTRAJ_E_INPUT_UNWANTED, [](auto& a) { a.second = a.values; });
    }
    // missing before unwanted
    if (variant.needs_first() && !variant.needs_second())
      check_refusal(variant, QTRAJ_E_INPUT_MISSING, [](auto& a) { a.first = nullptr, a.second = a.values; });
  }
}

TEST_CASE("C API: the key that is not finite is told, wherever the number is", "[capi][vector][errors]") {
  for (const VectorVariant& variant : vector_variants())
    for (const double bad : {kNaN, kInfinity, -kInfinity})
      for (size_t key = 0; key < 6; ++key) {
        check_refusal(
            variant, QTRAJ_E_NOT_FINITE, [=](auto& a) { a.keys.times[key] = bad; }, key);
        for (size_t c = 0; c < 3; ++c) {
          check_refusal(
              variant, QTRAJ_E_NOT_FINITE,
              [=](auto& a) { a.keys.values[3 * key + c] = static_cast<std::decay_t<decltype(*a.values)>>(bad); }, key);
          if (variant.method == QTRAJ_VECTOR_HERMITE || variant.method == QTRAJ_VECTOR_QUINTIC)
            check_refusal(
                variant, QTRAJ_E_NOT_FINITE,
                [=](auto& a) { a.keys.first[3 * key + c] = static_cast<std::decay_t<decltype(*a.values)>>(bad); }, key);
          if (variant.method == QTRAJ_VECTOR_QUINTIC)
            check_refusal(
                variant, QTRAJ_E_NOT_FINITE,
                [=](auto& a) { a.keys.second[3 * key + c] = static_cast<std::decay_t<decltype(*a.values)>>(bad); },
                key);
          // a given end is of the first or the last key
          if (variant.start == QTRAJ_END_GIVEN && key == 0)
            check_refusal(
                variant, QTRAJ_E_NOT_FINITE,
                [=](auto& a) { a.keys.first[c] = static_cast<std::decay_t<decltype(*a.values)>>(bad); }, 0);
          if (variant.end == QTRAJ_END_GIVEN && key == 0)
            check_refusal(
                variant, QTRAJ_E_NOT_FINITE,
                [=](auto& a) { a.keys.first[3 + c] = static_cast<std::decay_t<decltype(*a.values)>>(bad); }, 5);
        }
      }
}

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

TEST_CASE("C API: times of vector keys must increase, not too fast and not for too long", "[capi][vector][errors]") {
  for (const VectorVariant& variant : vector_variants()) {
    check_refusal(
        variant, QTRAJ_E_TIME_ORDER, [](auto& a) { a.keys.times[3] = a.keys.times[2]; }, 3);
    check_refusal(
        variant, QTRAJ_E_TIME_ORDER, [](auto& a) { a.keys.times[1] = -100; }, 1);
    check_refusal(
        variant, QTRAJ_E_TIME_ORDER,
        [](auto& a) {
          for (size_t i = 0; i < 6; ++i) a.keys.times[i] = static_cast<double>(i) * 1e-155;
        },
        1);
    check_refusal(
        variant, QTRAJ_E_TIME_SPAN, [](auto& a) { a.keys.times[0] = -1e308, a.keys.times[5] = 1e308; }, 5);
    // the first key at fault; at one key NOT_FINITE first
    check_refusal(
        variant, QTRAJ_E_TIME_ORDER, [](auto& a) { a.keys.times[2] = a.keys.times[1], a.keys.values[10] = NAN; }, 2);
    check_refusal(
        variant, QTRAJ_E_NOT_FINITE, [](auto& a) { a.keys.times[2] = a.keys.times[1], a.keys.values[7] = NAN; }, 2);
    // a period that ends before the last key
    check_refusal(
        variant, QTRAJ_E_TIME_ORDER,
        [](auto& a) {
          a.memory.assign(2 * a.memory.size(), -7.0), a.bytes *= 2;
          CHECK(qtraj_options_set_period(a.options_of.get(), 0.1) == QTRAJ_OK);
        },
        5);
  }
}

TEST_CASE("C API: derivatives that are too fast for their interval", "[capi][vector][errors]") {
  const auto set = [](auto& number) { number = std::numeric_limits<std::decay_t<decltype(number)>>::max(); };
  for (size_t key = 0; key < 6; ++key) {
    for (const VectorVariant& variant : {kHermite, kQuintic})
      for_double_and_float([&](auto zero) {
        using Real = decltype(zero);
        if (sizeof(Real) < sizeof(double)) return;  // no float is
        Arguments<Real> a(variant);
        set(a.keys.first[3 * key + 1]);
        CHECK(a.create() == QTRAJ_E_RATE_TOO_FAST);
        CHECK(a.bad == key);
      });
    Arguments<double> a(kQuintic);
    set(a.keys.second[3 * key + 2]);
    CHECK(a.create() == QTRAJ_E_RATE_TOO_FAST);
    CHECK(a.bad == key);
  }
  for (const bool at_end : {false, true})
    for (const bool loops : {false, true}) {
      Arguments<double> a({"", QTRAJ_VECTOR_CUBIC, QTRAJ_END_GIVEN, QTRAJ_END_GIVEN});
      if (loops) REQUIRE(qtraj_options_set_period(a.options_of.get(), 100) == QTRAJ_OK);
      set(a.keys.first[at_end ? 4 : 1]);
      CHECK(a.create() == QTRAJ_E_RATE_TOO_FAST);
      CHECK(a.bad == (at_end ? 5 : 0));
    }
  // a loop goes back to the first key, with its derivative
  Arguments<double> a(kHermite);
  REQUIRE(qtraj_options_set_period(a.options_of.get(), 1e300) == QTRAJ_OK);
  a.keys.first[0] = 1e-145, a.keys.first[1] = 0, a.keys.first[2] = 0;
  std::fill(a.keys.first.begin() + 3, a.keys.first.end(), 0.0);
  CHECK(a.create() == QTRAJ_E_RATE_TOO_FAST);
  CHECK(a.bad == 0);
}

TEST_CASE("C API: memory of a vector curve that is too small, not aligned or an input", "[capi][vector][memory]") {
  for (const VectorVariant& variant : vector_variants())
    for_double_and_float([&](auto zero) {
      using Real = decltype(zero);
      CAPTURE(variant.name);
      const auto is_refused = [&](Arguments<Real>& a, void* at, qtraj_status expected) {
        a.curve = reinterpret_cast<qtraj_vector_curve*>(&a.bytes);
        CHECK(a.init(at) == expected);
        CHECK((a.curve == nullptr && a.bad == SIZE_MAX));
      };
      Arguments<Real> a(variant);
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
      const auto check_overlap = [&](const auto& input, auto Arguments<Real>::*pointer) {
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
      check_overlap(a.keys.times, &Arguments<Real>::times);
      check_overlap(a.keys.values, &Arguments<Real>::values);
      check_overlap(a.keys.first, &Arguments<Real>::first);
      check_overlap(a.keys.second, &Arguments<Real>::second);
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

TEST_CASE("C API: getters of vector curves", "[capi][vector][errors]") {
  const Options options = vector_options(kCubic);
  const VectorKeys<double> keys = vector_tour<double>(kCubic, 6, 3);
  const VectorCurve curve = must_build_vector(options.get(), keys);
  double room[18 + 6];
  CHECK(qtraj_vector_keys(curve.get(), nullptr, nullptr) == QTRAJ_OK);
  CHECK(qtraj_vector_keys(curve.get(), room + 5, room) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_vector_keys(curve.get(), room, room + 5) == QTRAJ_E_OVERLAP);
  CHECK(qtraj_vector_keys(curve.get(), room, room + 6) == QTRAJ_OK);
  CHECK(std::vector<double>(room, room + 6) == keys.times);
  CHECK(std::vector<double>(room + 6, room + 24) == keys.values);
  // of any size, as they were given
  for (const double size : {1e308, 1e-310, 5e-324, 1e-200}) {
    VectorKeys<double> scaled = {{0, 1, 2}, {0.25 * size, size, -size, 7, -0.5 * size, 1e9}, {}, {}, 2};
    std::vector<double> values(6);
    const VectorCurve extreme = must_build_vector(options.get(), scaled);
    CHECK(qtraj_vector_keys(extreme.get(), nullptr, values.data()) == QTRAJ_OK);
    CHECK(values == scaled.values);
  }
}

}  // namespace
