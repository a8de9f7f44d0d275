// What constructors with tangents say to faulty arguments and data.
#include <cfloat>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kCount = 5;

// Good arguments of a constructor, which a test then spoils.
template <class Real>
struct Arguments {
  std::vector<double> times = {0, 1, 2, 3, 4};
  std::vector<Real> q = closed_tour<Real>(kCount).q;
  std::vector<Real> in = std::vector<Real>(4 * kCount), out = std::vector<Real>(4 * kCount);
  Options options = make_options({"", QTRAJ_QUATERNION_HERMITE});
  size_t count = kCount;
};

struct Answer {
  qtraj_status status;
  size_t bad_index;
  bool built;
};

bool operator==(const Answer& a, const Answer& b) {
  return a.status == b.status && a.bad_index == b.bad_index && a.built == b.built;
}
Answer refused(qtraj_status status, size_t index = SIZE_MAX) { return {status, index, false}; }

// Both constructors must say the same.
template <class Real>
Answer open(const Arguments<Real>& a) {
  int stale = 0;
  size_t bad_index = 77, same_index = 77;
  auto *made = reinterpret_cast<qtraj_trajectory*>(&stale), *placed = made;
  const qtraj_status status = create_with_tangents(a.options.get(), a.times.data(), a.q.data(), a.in.data(),
                                                   a.out.data(), a.count, &made, &bad_index);
  const Trajectory owner(made);
  std::vector<double> memory(1024);
  const qtraj_status in_place =
      init_with_tangents(memory.data(), memory.size() * sizeof(double), a.options.get(), a.times.data(), a.q.data(),
                         a.in.data(), a.out.data(), a.count, &placed, &same_index);
  CHECK(status == in_place);
  CHECK(bad_index == same_index);
  CHECK((made != nullptr) == (placed != nullptr));
  return {status, bad_index, made != nullptr};
}

TEST_CASE("C API: with tangents, mistakes of the call are judged in their order",
          "[capi][quaternion_hermite][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Arguments<Real> good;
    CHECK((open(good) == Answer{QTRAJ_OK, SIZE_MAX, true}));
    const auto call = [&](const qtraj_options* options, const double* times, const Real* q, const Real* in,
                          size_t count) {
      int stale = 0;
      size_t bad_index = 77, same_index = 77;
      auto *made = reinterpret_cast<qtraj_trajectory*>(&stale), *placed = made;
      const qtraj_status status = create_with_tangents(options, times, q, in, in, count, &made, &bad_index);
      std::vector<double> memory(1024);
      const qtraj_status in_place = init_with_tangents(memory.data(), memory.size() * sizeof(double), options, times, q,
                                                       in, in, count, &placed, &same_index);
      CHECK(status == in_place);
      CHECK((bad_index == SIZE_MAX && same_index == SIZE_MAX));
      CHECK((made == nullptr && placed == nullptr));
      return status;
    };
    const qtraj_options* const options = good.options.get();
    const double* const times = good.times.data();
    const Real *const q = good.q.data(), *const in = good.in.data();
    std::vector<double> junk(64);
    const auto* wrong = reinterpret_cast<const qtraj_options*>(junk.data());
    CHECK(call(nullptr, times, q, in, kCount) == QTRAJ_E_NULL);
    CHECK(call(options, nullptr, q, in, kCount) == QTRAJ_E_NULL);
    CHECK(call(options, times, nullptr, in, kCount) == QTRAJ_E_NULL);
    CHECK(call(options, times, q, nullptr, kCount) == QTRAJ_E_NULL);
    CHECK(call(wrong, times, q, nullptr, kCount) == QTRAJ_E_NULL);
    CHECK(call(wrong, times, q, in, 1) == QTRAJ_E_HANDLE);
    CHECK(call(options, nullptr, nullptr, nullptr, 0) == QTRAJ_E_TOO_FEW);
    CHECK(call(options, times, q, in, 1) == QTRAJ_E_TOO_FEW);
    CHECK(call(options, times, q, in, SIZE_MAX) == QTRAJ_E_SIZE);
    CHECK(call(options, times, q, in, SIZE_MAX / 32 + 1) == QTRAJ_E_SIZE);
    // rates that HERMITE needs come first; all others have no use for tangents
    for (const int32_t method : all_methods()) {
      if (needs_tangents(method)) continue;
      CAPTURE(method);
      CHECK(call(make_options({"", method}).get(), times, q, in, kCount) ==
            (always_needs_rates(method) ? QTRAJ_E_INPUT_MISSING : QTRAJ_E_INPUT_UNWANTED));
    }
    size_t bad_index = 77;
    CHECK(create_with_tangents(options, times, q, in, in, kCount, nullptr, &bad_index) == QTRAJ_E_NULL);
    CHECK(bad_index == SIZE_MAX);
  });
}

TEST_CASE("C API: without tangents QUATERNION_HERMITE is INPUT_MISSING", "[capi][quaternion_hermite][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Arguments<Real> good;
    qtraj_trajectory* out = nullptr;
    const double* const times = good.times.data();
    const Real *const q = good.q.data(), *const omega = good.in.data();
    const qtraj_options* const options = good.options.get();
    std::vector<double> memory(1024);
    const size_t bytes = memory.size() * sizeof(double);
    CHECK(create(QTRAJ_QUATERNION_HERMITE, times, q, kCount, &out, nullptr) == QTRAJ_E_INPUT_MISSING);
    CHECK(create_with_options(options, times, q, kCount, &out, nullptr) == QTRAJ_E_INPUT_MISSING);
    CHECK(create_with_rates(options, QTRAJ_FRAME_BODY, times, q, omega, omega, kCount, &out, nullptr) ==
          QTRAJ_E_INPUT_MISSING);
    CHECK(init(memory.data(), bytes, options, QTRAJ_FRAME_BODY, times, q, omega, omega, kCount, &out, nullptr) ==
          QTRAJ_E_INPUT_MISSING);
    CHECK(out == nullptr);
  });
}

TEST_CASE("C API: memory for a curve with tangents may not be too small, misaligned or shared",
          "[capi][quaternion_hermite][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Arguments<Real> good;
    size_t bytes = 0;
    REQUIRE(qtraj_init_size(good.options.get(), kCount, &bytes) == QTRAJ_OK);
    std::vector<double> memory(2048);
    const std::vector<double> before = memory;
    const auto init_at = [&](void* at, size_t size, const Real* in, const Real* out_of) {
      qtraj_trajectory* out = nullptr;
      const qtraj_status status = init_with_tangents(at, size, good.options.get(), good.times.data(), good.q.data(), in,
                                                     out_of, kCount, &out, nullptr);
      CHECK((out != nullptr) == (status == QTRAJ_OK));
      return status;
    };
    const Real *const in = good.in.data(), *const out_of = good.out.data();
    CHECK(init_at(nullptr, bytes, in, out_of) == QTRAJ_E_NULL);
    CHECK(init_at(memory.data(), bytes - 1, in, out_of) == QTRAJ_E_BUFFER);
    CHECK(init_at(reinterpret_cast<char*>(memory.data()) + 4, bytes, in, out_of) == QTRAJ_E_BUFFER);
    const Real* const inside = reinterpret_cast<const Real*>(memory.data()) + 8;
    CHECK(init_at(memory.data(), bytes, inside, out_of) == QTRAJ_E_OVERLAP);
    CHECK(init_at(memory.data(), bytes, in, inside) == QTRAJ_E_OVERLAP);
    CHECK(init_at(memory.data(), bytes, inside, nullptr) == QTRAJ_E_OVERLAP);
    CHECK(memory == before);
    CHECK(init_at(memory.data(), bytes, in, nullptr) == QTRAJ_OK);
  });
}

TEST_CASE("C API: tangents that are not finite are those of their key, on either side",
          "[capi][quaternion_hermite][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const size_t key : {size_t{0}, size_t{2}, kCount - 1})
      for (const bool in : {false, true})
        for (const double bad : {kNaN, kInfinity, -kInfinity}) {
          CAPTURE(key, in, bad);
          Arguments<Real> arguments;
          (in ? arguments.in : arguments.out)[4 * key + 3] = Real(bad);
          CHECK((open(arguments) == refused(QTRAJ_E_NOT_FINITE, key)));
          arguments.times[1] = arguments.times[0];  // the first key at fault
          CHECK((open(arguments) == refused(key == 0 ? QTRAJ_E_NOT_FINITE : QTRAJ_E_TIME_ORDER, key == 0 ? 0 : 1)));
        }
  });
}

TEST_CASE("C API: tangents past 2^200 of their key over an interval are RATE_TOO_FAST",
          "[capi][quaternion_hermite][errors]") {
  for (const size_t key : {size_t{0}, size_t{2}, kCount - 1})
    for (const double size : {1.0, 0x1p-700, 0x1p300})
      for (const double interval : {0x1p-300, 1.0, 0x1p100})
        for (const double factor : {0.99, 1.01}) {
          CAPTURE(key, size, interval, factor);
          Arguments<double> arguments;
          for (double& number : arguments.q) number = 0;
          for (size_t k = 0; k < kCount; ++k) arguments.q[4 * k] = size;
          for (double& time : arguments.times) time *= interval;
          const double tangent = factor * 0x1p200 * size / interval;
          arguments.out[4 * key + 2] = tangent;
          // the last key's out-tangent is read by nobody, nor is the first one's in-tangent
          const bool out_counts = key + 1 < kCount, fine = factor < 1;
          const Answer good = {QTRAJ_OK, SIZE_MAX, true}, bad = refused(QTRAJ_E_RATE_TOO_FAST, key);
          CHECK((open(arguments) == (fine || !out_counts ? good : bad)));
          arguments.out[4 * key + 2] = 0;
          arguments.in[4 * key + 2] = -tangent;
          CHECK((open(arguments) == (fine || key == 0 ? good : bad)));
        }
  Arguments<double> largest;
  largest.out[5] = DBL_MAX;
  largest.times = {0, 1, 1e300, 2e300, 3e300};
  CHECK((open(largest) == refused(QTRAJ_E_RATE_TOO_FAST, 1)));
  // of the key that a period adds it is the first
  Arguments<double> added;
  REQUIRE(qtraj_options_set_period(added.options.get(), 5.0) == QTRAJ_OK);
  added.in[0] = 1e100;
  CHECK((open(added) == refused(QTRAJ_E_RATE_TOO_FAST, 0)));
}

TEST_CASE("C API: a key without a direction beside the largest is ZERO_NORM", "[capi][quaternion_hermite][errors]") {
  Arguments<double> arguments;
  for (size_t k = 4 * 3; k < 4 * 4; ++k) arguments.q[k] = 0;
  CHECK((open(arguments) == refused(QTRAJ_E_ZERO_NORM, 3)));
  const double largest = 1.5;
  for (size_t key = 0; key < kCount; ++key) arguments.q[4 * key] = largest;
  arguments.q[4 * 3] = 0x1p-100 * largest;
  CHECK((open(arguments) == Answer{QTRAJ_OK, SIZE_MAX, true}));
  arguments.q[4 * 3] = 0x1p-101 * largest;
  CHECK((open(arguments) == refused(QTRAJ_E_ZERO_NORM, 3)));
  for (size_t k = 4; k < 8; ++k) arguments.q[k] = 1e-200;
  CHECK((open(arguments) == refused(QTRAJ_E_ZERO_NORM, 1)));
}

TEST_CASE("C API: a QUATERNION_HERMITE that repeats must close", "[capi][quaternion_hermite][errors]") {
  Arguments<double> arguments;
  REQUIRE(qtraj_options_set_extrapolation(arguments.options.get(), QTRAJ_EXTRAPOLATE_PERIODIC,
                                          QTRAJ_EXTRAPOLATE_PERIODIC) == QTRAJ_OK);
  CHECK((open(arguments) == Answer{QTRAJ_OK, SIZE_MAX, true}));
  arguments.q[4 * kCount - 1] += 0.5;
  CHECK((open(arguments) == refused(QTRAJ_E_NOT_CLOSED, kCount - 1)));
}

}  // namespace
