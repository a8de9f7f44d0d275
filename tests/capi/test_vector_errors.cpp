// Construction of vector curves: every error, its index, their order, and what is left alone.
#include <cfloat>
#include <cmath>

#include "support/capi_variants.hpp"
#include "support/vector_arguments.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
const VectorVariant kHermite = {"HERMITE", QTRAJ_VECTOR_HERMITE}, kQuintic = {"QUINTIC", QTRAJ_VECTOR_QUINTIC},
                    kLinear = {"LINEAR", QTRAJ_VECTOR_LINEAR}, kCubic = {"CUBIC", QTRAJ_VECTOR_CUBIC};

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
    VectorArguments<decltype(zero)> a(kLinear);
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
    for (const int32_t unknown : {1000, 1006, 0, 11, -1}) {
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
        VectorArguments<Real> a(variant);
        set(a.keys.first[3 * key + 1]);
        CHECK(a.create() == QTRAJ_E_RATE_TOO_FAST);
        CHECK(a.bad == key);
      });
    VectorArguments<double> a(kQuintic);
    set(a.keys.second[3 * key + 2]);
    CHECK(a.create() == QTRAJ_E_RATE_TOO_FAST);
    CHECK(a.bad == key);
  }
  for (const bool at_end : {false, true})
    for (const bool loops : {false, true}) {
      VectorArguments<double> a({"", QTRAJ_VECTOR_CUBIC, QTRAJ_END_GIVEN, QTRAJ_END_GIVEN});
      if (loops) REQUIRE(qtraj_options_set_period(a.options_of.get(), 100) == QTRAJ_OK);
      set(a.keys.first[at_end ? 4 : 1]);
      CHECK(a.create() == QTRAJ_E_RATE_TOO_FAST);
      CHECK(a.bad == (at_end ? 5 : 0));
    }
  // a loop goes back to the first key, with its derivative
  VectorArguments<double> a(kHermite);
  REQUIRE(qtraj_options_set_period(a.options_of.get(), 1e300) == QTRAJ_OK);
  a.keys.first[0] = 1e-145, a.keys.first[1] = 0, a.keys.first[2] = 0;
  std::fill(a.keys.first.begin() + 3, a.keys.first.end(), 0.0);
  CHECK(a.create() == QTRAJ_E_RATE_TOO_FAST);
  CHECK(a.bad == 0);
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
