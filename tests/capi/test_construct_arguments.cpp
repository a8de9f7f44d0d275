// Constructors and faulty arguments: what is judged before any keyframe is read, and in which order.
#include <cerrno>
#include <functional>

#include "support/capi_variants.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define QTRAJ_TESTS_ASAN
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define QTRAJ_TESTS_ASAN
#endif
#endif

#ifdef QTRAJ_TESTS_ASAN
// malloc that cannot serve shall return NULL here too, as it does for users.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1"; }
#endif

using namespace capi;

namespace {

constexpr size_t kMost = PTRDIFF_MAX;
// Sizes that overflow: as they are, times 4, 8, 16 or 32 (to 0 and to small numbers), and just past PTRDIFF_MAX.
const size_t kHuge[] = {SIZE_MAX,          SIZE_MAX / 2,      SIZE_MAX / 4 + 2, SIZE_MAX / 8 + 2, SIZE_MAX / 16 + 2,
                        SIZE_MAX / 32 + 1, SIZE_MAX / 32 + 3, kMost / 32 + 1,   kMost / 32};

// All arguments of all constructors.
template <class Real>
struct Arguments {
  int32_t method = QTRAJ_SQUAD;
  const qtraj_options* options;
  const double* times;
  const Real* q;
  int32_t frame = QTRAJ_FRAME_BODY;
  const Real* omega;
  const Real* alpha = nullptr;
  size_t count = 4;
  qtraj_trajectory** out;
  size_t* bad_index;
  void* memory;
  size_t bytes;
};

enum Door { kCreate, kCreateWith, kCreateWithRates, kInit, kDoors };

template <class Real>
qtraj_status open(Door door, const Arguments<Real>& a) {
  switch (door) {
    case kCreate:
      return create(a.method, a.times, a.q, a.count, a.out, a.bad_index);
    case kCreateWith:
      return create_with_options(a.options, a.times, a.q, a.count, a.out, a.bad_index);
    case kCreateWithRates:
      return create_with_rates(a.options, a.frame, a.times, a.q, a.omega, a.alpha, a.count, a.out, a.bad_index);
    default:
      return init(a.memory, a.bytes, a.options, a.frame, a.times, a.q, a.omega, a.alpha, a.count, a.out, a.bad_index);
  }
}

// Good arguments for SQUAD with (rates: TANGENT_GIVEN) that a row of a table then spoils.
template <class Real>
struct Case {
  Keyframes<Real> keys = closed_tour<Real>(4);
  std::vector<Real> omega = std::vector<Real>(12);
  std::vector<double> memory = std::vector<double>(1024);
  Options plain = make_options({"", QTRAJ_SQUAD});
  Options with_rates = make_options({"", QTRAJ_SQUAD, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_GIVEN});
  int stale = 0;
  qtraj_trajectory* out = reinterpret_cast<qtraj_trajectory*>(&stale);
  size_t bad_index = 12345;
  Arguments<Real> arguments;

  explicit Case(bool rates)
      : arguments{QTRAJ_SQUAD,
                  rates ? with_rates.get() : plain.get(),
                  keys.times.data(),
                  keys.q.data(),
                  QTRAJ_FRAME_BODY,
                  rates ? omega.data() : nullptr,
                  nullptr,
                  4,
                  &out,
                  &bad_index,
                  memory.data(),
                  memory.size() * sizeof(double)} {}
};

template <class Real>
struct Row {
  const char* name;
  unsigned doors;  // a bit for each that has the argument
  std::function<void(Arguments<Real>&)> spoil;
  qtraj_status status;
};

constexpr unsigned bit(Door door) { return 1u << door; }
constexpr unsigned kAll = bit(kCreate) | bit(kCreateWith) | bit(kCreateWithRates) | bit(kInit);
constexpr unsigned kWithOptions = bit(kCreateWith) | bit(kCreateWithRates) | bit(kInit);
constexpr unsigned kWithRates = bit(kCreateWithRates) | bit(kInit);

template <class Real>
std::vector<Row<Real>> rows() {
  using A = Arguments<Real>;
  static const Real number = 1;
  return {
      {"times NULL", kAll, [](A& a) { a.times = nullptr; }, QTRAJ_E_NULL},
      {"q NULL", kAll, [](A& a) { a.q = nullptr; }, QTRAJ_E_NULL},
      {"options NULL", kWithOptions, [](A& a) { a.options = nullptr; }, QTRAJ_E_NULL},
      {"omega NULL", bit(kCreateWithRates), [](A& a) { a.omega = nullptr; }, QTRAJ_E_NULL},
      {"memory NULL", bit(kInit), [](A& a) { a.memory = nullptr; }, QTRAJ_E_NULL},
      {"count 0", kAll, [](A& a) { a.count = 0; }, QTRAJ_E_TOO_FEW},
      {"count 1", kAll, [](A& a) { a.count = 1; }, QTRAJ_E_TOO_FEW},
      {"count 0, arrays NULL", kAll, [](A& a) { a.count = 0, a.times = nullptr, a.q = nullptr, a.omega = nullptr; },
       QTRAJ_E_TOO_FEW},
      {"method 0", bit(kCreate), [](A& a) { a.method = 0; }, QTRAJ_E_VALUE},
      {"method unknown", bit(kCreate), [](A& a) { a.method = INT32_MIN; }, QTRAJ_E_VALUE},
      {"frame 0", kWithRates, [](A& a) { a.frame = 0; }, QTRAJ_E_VALUE},
      {"frame unknown", kWithRates, [](A& a) { a.frame = INT32_MAX; }, QTRAJ_E_VALUE},
      {"alpha for a method without", kWithRates, [](A& a) { a.alpha = &number; }, QTRAJ_E_INPUT_UNWANTED},
      {"rates missing in plain create", bit(kCreate), [](A& a) { a.method = QTRAJ_HERMITE; }, QTRAJ_E_INPUT_MISSING},
      {"rates missing", bit(kInit), [](A& a) { a.omega = nullptr; }, QTRAJ_E_INPUT_MISSING},
      {"bytes 0", bit(kInit), [](A& a) { a.bytes = 0; }, QTRAJ_E_BUFFER},
      {"memory misaligned", bit(kInit), [](A& a) { a.memory = static_cast<char*>(a.memory) + 4; }, QTRAJ_E_BUFFER},
      // two faults: NULL, HANDLE, TOO_FEW, SIZE, VALUE, INPUT_MISSING, INPUT_UNWANTED, BUFFER, OVERLAP
      {"NULL before COUNT", kAll, [](A& a) { a.q = nullptr, a.count = 1; }, QTRAJ_E_NULL},
      {"NULL options before COUNT", kWithOptions, [](A& a) { a.options = nullptr, a.count = 1; }, QTRAJ_E_NULL},
      {"NULL options before COUNT 0", kWithOptions, [](A& a) { a.options = nullptr, a.count = 0; }, QTRAJ_E_NULL},
      {"NULL omega before COUNT", bit(kCreateWithRates), [](A& a) { a.omega = nullptr, a.count = 1; }, QTRAJ_E_NULL},
      {"NULL memory before COUNT", bit(kInit), [](A& a) { a.memory = nullptr, a.count = 0; }, QTRAJ_E_NULL},
      {"NULL before SIZE", kAll, [](A& a) { a.times = nullptr, a.count = SIZE_MAX; }, QTRAJ_E_NULL},
      {"NULL options before SIZE", kWithOptions, [](A& a) { a.options = nullptr, a.count = SIZE_MAX; }, QTRAJ_E_NULL},
      {"NULL before VALUE", bit(kCreate), [](A& a) { a.q = nullptr, a.method = 0; }, QTRAJ_E_NULL},
      {"NULL before frame", bit(kCreateWithRates), [](A& a) { a.omega = nullptr, a.frame = 0; }, QTRAJ_E_NULL},
      {"TOO_FEW before VALUE", bit(kCreate), [](A& a) { a.count = 1, a.method = 0; }, QTRAJ_E_TOO_FEW},
      {"TOO_FEW before frame", kWithRates, [](A& a) { a.count = 1, a.frame = 0; }, QTRAJ_E_TOO_FEW},
      {"TOO_FEW before BUFFER", bit(kInit), [](A& a) { a.count = 1, a.bytes = 0; }, QTRAJ_E_TOO_FEW},
      {"SIZE before VALUE", bit(kCreate), [](A& a) { a.count = SIZE_MAX, a.method = 0; }, QTRAJ_E_SIZE},
      {"SIZE before frame", kWithRates, [](A& a) { a.count = SIZE_MAX, a.frame = 0; }, QTRAJ_E_SIZE},
      {"SIZE before BUFFER", bit(kInit), [](A& a) { a.count = SIZE_MAX, a.bytes = 0; }, QTRAJ_E_SIZE},
      {"VALUE before BUFFER", bit(kInit), [](A& a) { a.frame = 0, a.bytes = 0; }, QTRAJ_E_VALUE},
      {"BUFFER before OVERLAP", bit(kInit), [](A& a) { a.memory = const_cast<double*>(a.times), a.bytes = 8; },
       QTRAJ_E_BUFFER},
  };
}

TEST_CASE("C API: constructors judge arguments in the order NULL, HANDLE, TOO_FEW, SIZE, VALUE, RATES, BUFFER",
          "[capi][construct][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Row<Real>& row : rows<Real>())
      for (int door = kCreate; door < kDoors; ++door) {
        if (!(row.doors & bit(static_cast<Door>(door)))) continue;
        INFO(row.name << ", constructor " << door << (sizeof(Real) == 4 ? " (float)" : ""));
        const bool rates = (kWithRates & bit(static_cast<Door>(door))) != 0;
        Case<Real> good(rates);
        row.spoil(good.arguments);
        // keyframes full of faults: arguments come first
        for (Real& component : good.keys.q) component = 0;
        good.keys.times[1] = good.keys.times[0];
        CHECK(open(static_cast<Door>(door), good.arguments) == row.status);
        CHECK(good.out == nullptr);
        CHECK(good.bad_index == SIZE_MAX);
        good.arguments.bad_index = nullptr;
        CHECK(open(static_cast<Door>(door), good.arguments) == row.status);
        // without a place for the result, whatever else is wrong
        good.arguments.out = nullptr;
        good.arguments.bad_index = &good.bad_index;
        good.bad_index = 12345;
        CHECK(open(static_cast<Door>(door), good.arguments) == QTRAJ_E_NULL);
        CHECK(good.bad_index == SIZE_MAX);
      }
  });
}

TEST_CASE("C API: counts whose arrays would pass PTRDIFF_MAX bytes are SIZE", "[capi][construct][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const size_t count : kHuge)
      for (int door = kCreate; door < kDoors; ++door) {
        CAPTURE(count, door);
        Case<Real> good((kWithRates & bit(static_cast<Door>(door))) != 0);
        good.arguments.count = count;
        good.arguments.bytes = SIZE_MAX;
        CHECK(open(static_cast<Door>(door), good.arguments) == QTRAJ_E_SIZE);
        CHECK(good.out == nullptr);
        CHECK(good.bad_index == SIZE_MAX);
      }
  });
}

TEST_CASE("C API: rates that the method or its tangent rule does not use are INPUT_UNWANTED",
          "[capi][construct][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const Variant& variant : variants()) {
      if (variant.needs_rates() || variant.needs_tangents()) continue;
      CAPTURE(variant.name);
      Case<Real> good(true);
      const Options options = make_options(variant);
      good.arguments.options = options.get();
      CHECK(open(kCreateWithRates, good.arguments) == QTRAJ_E_INPUT_UNWANTED);
      CHECK(open(kInit, good.arguments) == QTRAJ_E_INPUT_UNWANTED);
      CHECK(good.bad_index == SIZE_MAX);
      CHECK(good.out == nullptr);
    }
  });
}

TEST_CASE("C API: rates that are needed and missing are INPUT_MISSING", "[capi][construct][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    Case<Real> good(false);
    good.arguments.options = good.with_rates.get();
    CHECK(open(kCreateWith, good.arguments) == QTRAJ_E_INPUT_MISSING);
    CHECK(open(kInit, good.arguments) == QTRAJ_E_INPUT_MISSING);
    // END_GIVEN at either end, and its rate never set
    for (const bool at_start : {false, true}) {
      const Options options = make_options({"", QTRAJ_SQUAD});
      REQUIRE(qtraj_options_set_ends(options.get(), at_start ? QTRAJ_END_GIVEN : QTRAJ_END_CHORD,
                                     at_start ? QTRAJ_END_CHORD : QTRAJ_END_GIVEN) == QTRAJ_OK);
      good.arguments.options = options.get();
      CHECK(open(kCreateWith, good.arguments) == QTRAJ_E_INPUT_MISSING);
      CHECK(open(kInit, good.arguments) == QTRAJ_E_INPUT_MISSING);
      CHECK(good.out == nullptr);
      CHECK(good.bad_index == SIZE_MAX);
    }
  });
}

TEST_CASE("C API: init without rates ignores the frame", "[capi][construct]") {
  for (const int32_t frame : kUnknown) {
    Case<double> good(false);
    good.arguments.frame = frame;
    CHECK(open(kInit, good.arguments) == QTRAJ_OK);
  }
}

TEST_CASE("C API: memory that malloc cannot give is NO_MEMORY", "[capi][construct][errors][memory]") {
  if (sizeof(void*) < 8) return;  // every size that passes the check of SIZE may be there
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const size_t count = size_t{1} << 47;  // more than an address space holds, less than PTRDIFF_MAX bytes
    for (const Door door : {kCreate, kCreateWith, kCreateWithRates}) {
      CAPTURE(door);
      Case<Real> good(door == kCreateWithRates);
      good.arguments.count = count;
      errno = 0x5a5a;
      const qtraj_status status = open(door, good.arguments);
      const int errno_after = errno;
      CHECK(status == QTRAJ_E_NO_MEMORY);
      CHECK(errno_after == 0x5a5a);
      CHECK(good.out == nullptr);
      CHECK(good.bad_index == SIZE_MAX);
    }
  });
}

}  // namespace
