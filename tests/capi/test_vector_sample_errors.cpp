// Sampling vector curves: every error, its index, their order, and what is left alone; handles of other kinds.
#include <cfloat>
#include <cmath>
#include <cstring>

#include "support/capi_variants.hpp"
#include "support/guarded.hpp"
#include "support/vector_curve.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

VectorCurve make_curve(size_t dim = 3, int32_t method = QTRAJ_VECTOR_CUBIC) {
  const VectorVariant variant = {"", method};
  const Options options = vector_options(variant);
  VectorKeys<double> keys = vector_tour<double>(variant, 5, dim);
  keys.times = {0, 1, 2, 3, 4};
  return must_build_vector(options.get(), keys);
}

// All arguments of the sampling functions, good as they are.
template <class Real>
struct Arguments {
  VectorCurve owner = make_curve();
  std::vector<double> room = std::vector<double>(60, 0.5);  // times first
  const qtraj_vector_curve* curve = owner.get();
  const double* times = room.data();
  size_t count = 4, bad = 7, cursor = 7;
  Real *value = at(1), *first = at(2), *second = at(3);

  Real* at(size_t array) { return reinterpret_cast<Real*>(room.data() + 12 * array); }
  qtraj_status sample() { return vector_sample(curve, times, count, value, first, second, &bad); }
  qtraj_status uniform() { return vector_sample_uniform(curve, 0.5, 0.1, count, value, first, second, &bad); }
  qtraj_status one() { return vector_sample_at(curve, 0.5, &cursor, value, first, second); }
  bool is_untouched() const {
    return std::all_of(room.begin(), room.end(), [](double x) { return x == 0.5; }) && cursor == 7;
  }
};

enum Function { kSample = 1, kUniform = 2, kOne = 4, kAll = 7, kMany = 3 };

template <class Change>
void check_refusal(qtraj_status expected, Change&& change, int functions = kAll) {
  for_double_and_float([&](auto zero) {
    Arguments<decltype(zero)> a;
    change(a);
    if (functions & kSample) CHECK((a.sample() == expected && a.bad == SIZE_MAX));
    a.bad = 7;
    if (functions & kUniform) CHECK((a.uniform() == expected && a.bad == SIZE_MAX));
    if (functions & kOne) CHECK(a.one() == expected);
    CHECK(a.is_untouched());
  });
}

TEST_CASE("C API: sampling vectors judges NULL, HANDLE, SIZE, OVERLAP, in this order", "[capi][vector][errors]") {
  alignas(8) static const double nothing[64] = {};
  const auto* const wrong = reinterpret_cast<const qtraj_vector_curve*>(nothing);
  const auto no_outputs = [](auto& a) { a.value = a.first = a.second = nullptr; };
  check_refusal(QTRAJ_E_NULL, [](auto& a) { a.curve = nullptr; });
  check_refusal(QTRAJ_E_NULL, no_outputs);
  check_refusal(
      QTRAJ_E_NULL, [](auto& a) { a.times = nullptr; }, kSample);
  check_refusal(
      QTRAJ_E_NULL, [](auto& a) { a.curve = nullptr, a.count = 0, a.times = nullptr; }, kMany);
  check_refusal(
      QTRAJ_E_NULL, [=](auto& a) { a.curve = wrong, a.times = nullptr; }, kSample);
  check_refusal(QTRAJ_E_NULL, [=](auto& a) { a.curve = wrong, no_outputs(a); });
  check_refusal(QTRAJ_E_HANDLE, [=](auto& a) { a.curve = wrong, a.count = SIZE_MAX; });
  check_refusal(
      QTRAJ_E_HANDLE, [=](auto& a) { a.curve = wrong, a.count = 0, a.times = nullptr; }, kMany);
  check_refusal(QTRAJ_E_HANDLE, [=](auto& a) {
    a.curve = reinterpret_cast<const qtraj_vector_curve*>(reinterpret_cast<const char*>(a.owner.get()) + 4);
  });
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 8, SIZE_MAX / 16 + 1})
    check_refusal(
        QTRAJ_E_SIZE, [=](auto& a) { a.count = count, a.first = a.value; }, kMany);
  // rows of 3 may be too large where the times are not
  check_refusal(
      QTRAJ_E_SIZE, [](auto& a) { a.count = PTRDIFF_MAX / (3 * sizeof(*a.value)) + 1; }, kMany);
}

TEST_CASE("C API: arrays of vectors may not overlap, any two of them", "[capi][vector][overlap]") {
  check_refusal(QTRAJ_E_OVERLAP, [](auto& a) { a.first = a.value; });
  check_refusal(QTRAJ_E_OVERLAP, [](auto& a) { a.second = a.value + 2; });
  check_refusal(QTRAJ_E_OVERLAP, [](auto& a) { a.second = a.first - 2; });
  check_refusal(QTRAJ_E_OVERLAP, [](auto& a) { a.value = nullptr, a.second = a.first; });
  check_refusal(
      QTRAJ_E_OVERLAP, [](auto& a) { a.second = a.first - 11; }, kMany);
  check_refusal(
      QTRAJ_E_OVERLAP, [](auto& a) { a.value = a.at(0); }, kSample);
  check_refusal(
      QTRAJ_E_OVERLAP, [](auto& a) { a.first = reinterpret_cast<decltype(a.first)>(a.room.data() + 3); }, kSample);
  check_refusal(
      QTRAJ_E_OVERLAP, [](auto& a) { a.times = reinterpret_cast<double*>(a.second); }, kSample);
  for_double_and_float([](auto zero) {  // side by side
    Arguments<decltype(zero)> a;
    a.value = a.at(1), a.first = a.value + 12, a.second = a.value - 12;
    CHECK(a.sample() == (sizeof zero == 8 ? QTRAJ_E_OVERLAP : QTRAJ_OK));
    a.times = a.room.data() + 48;
    CHECK(a.sample() == QTRAJ_OK);
    a.first = a.value + 3, a.second = a.value + 6;
    CHECK(a.one() == QTRAJ_OK);
  });
}

TEST_CASE("C API: sampling no vectors is OK with NULL arrays", "[capi][vector]") {
  for_double_and_float([](auto zero) {
    Arguments<decltype(zero)> a;
    a.count = 0, a.times = nullptr, a.value = a.first = a.second = nullptr;
    CHECK((a.sample() == QTRAJ_OK && a.bad == SIZE_MAX));
    CHECK((a.uniform() == QTRAJ_OK && a.bad == SIZE_MAX && a.is_untouched()));
    CHECK(vector_sample(a.curve, a.times, 0, a.value, a.first, a.second, nullptr) == QTRAJ_OK);
  });
}

TEST_CASE("C API: vector rows at fault are NaN, all others right, the status that of the first",
          "[capi][vector][errors]") {
  struct Fault {
    double time;
    qtraj_status status;
  };
  const Fault faults[] = {{kNaN, QTRAJ_E_NOT_FINITE},
                          {-kInfinity, QTRAJ_E_NOT_FINITE},
                          {-0.1, QTRAJ_E_TIME_RANGE},
                          {4.1, QTRAJ_E_TIME_RANGE},
                          {1e308, QTRAJ_E_TIME_RANGE}};
  for_double_and_float([&](auto zero) {
    using Real = decltype(zero);
    for (const int32_t method : {QTRAJ_VECTOR_STEP, QTRAJ_VECTOR_LINEAR, QTRAJ_VECTOR_CUBIC})
      for (const size_t dim : {1u, 3u, 4u, 6u})
        for (const bool sorted : {false, true})
          for (const Fault& fault : faults)
            for (const size_t at : {0u, 1u, 255u, 256u, 300u, 399u}) {
              const VectorCurve curve = make_curve(dim, method);
              std::vector<double> times;
              test::Random random(at);
              for (size_t i = 0; i < 400; ++i) times.push_back(sorted ? 0.01 * double(i) : random.uniform(0, 4));
              const VectorMotion<Real> expected = must_sample_vectors<Real>(curve.get(), times);
              times[at] = fault.time;
              times[399] = at == 399 ? fault.time : 5;  // and another
              // guarded: a vector reaches not beyond the arrays
              VectorMotion<Real> motion(400 * dim);
              size_t bad = 7, wrong = 0;
              CHECK(vector_sample(curve.get(), times.data(), 400, motion.value.data(), motion.first.data(),
                                  motion.second.data(), &bad) == fault.status);
              CHECK(bad == at);
              for (size_t i = 0; i < 400 * dim; ++i)
                wrong +=
                    i / dim == at || i / dim == 399
                        ? !std::isnan(motion.value[i]) || !std::isnan(motion.first[i]) || !std::isnan(motion.second[i])
                        : motion.value[i] != expected.value[i] || motion.first[i] != expected.first[i] ||
                              motion.second[i] != expected.second[i];
              CHECK(wrong == 0);
              Real one[6], first[6], second[6];
              size_t cursor = 3;
              CHECK(vector_sample_at(curve.get(), fault.time, &cursor, one, first, second) == fault.status);
              CHECK((cursor == 3 && std::isnan(one[dim - 1]) && std::isnan(first[0]) && std::isnan(second[dim - 1])));
            }
  });
}

TEST_CASE("C API: sampling vectors touches nothing but its arrays", "[capi][vector][memory]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    constexpr size_t kMost = 70;
    for (const size_t dim : {1u, 2u, 3u, 4u, 5u, 7u, 8u}) {
      const VectorCurve curve = make_curve(dim);
      test::Guarded<double> times(kMost);
      test::Guarded<Real> rooms[3] = {test::Guarded<Real>(kMost * dim), test::Guarded<Real>(kMost * dim),
                                      test::Guarded<Real>(kMost * dim)};
      for (size_t count = 1; count <= kMost; count += count < 20 ? 1 : 7)
        for (const bool at_end : {false, true})
          for (const bool sorted : {false, true})
            for (const int asked : {1, 2, 7}) {
              double* const at = times.array(count, at_end);
              for (size_t i = 0; i < count; ++i)
                at[i] = 4 * (sorted ? double(i) / kMost : double(i * 37 % count) / double(count));
              Real* out[3];
              for (size_t k = 0; k < 3; ++k) {
                rooms[k].fill(0x5a);
                out[k] = asked >> k & 1 ? rooms[k].array(count * dim, at_end) : nullptr;
              }
              REQUIRE(vector_sample(curve.get(), at, count, out[0], out[1], out[2], nullptr) == QTRAJ_OK);
              for (size_t k = 0; k < 3; ++k)
                if (out[k] && !rooms[k].holds_around(out[k], count * dim, 0x5a))
                  FAIL_CHECK("dim " << dim << ", " << count << " rows, output " << k);
            }
    }
  });
}

// Calls every function that takes a vector curve; each must give `expected`.
void check_all_calls(const qtraj_vector_curve* handle, qtraj_status expected) {
  const double times[2] = {0.5, 1};
  double p[8], v[8], a[8];
  float pf[8];
  size_t bad = 7, cursor = 7, count = 7;
  CHECK(qtraj_vector_sample(handle, times, 2, p, v, a, &bad) == expected);
  CHECK(bad == SIZE_MAX);
  CHECK(qtraj_vector_sample_f32(handle, times, 2, pf, nullptr, nullptr, nullptr) == expected);
  CHECK(qtraj_vector_sample_uniform(handle, 0, 0.5, 2, p, nullptr, nullptr, nullptr) == expected);
  CHECK(qtraj_vector_sample_uniform_f32(handle, 0, 0.5, 2, pf, nullptr, nullptr, nullptr) == expected);
  CHECK(qtraj_vector_sample_at(handle, 0.5, &cursor, p, v, a) == expected);
  CHECK(qtraj_vector_sample_at_f32(handle, 0.5, &cursor, pf, nullptr, nullptr) == expected);
  CHECK(cursor == 7);
  CHECK(qtraj_vector_uniform_count(handle, 0, 0.5, &count) == expected);
  CHECK(count == 0);
  CHECK(qtraj_vector_keys(handle, v, p) == expected);
  CHECK(qtraj_vector_method(handle) == 0);
  CHECK(qtraj_vector_key_count(handle) == 0);
  CHECK(qtraj_vector_dim(handle) == 0);
  CHECK(std::isnan(qtraj_vector_start_time(handle)));
  CHECK(std::isnan(qtraj_vector_end_time(handle)));
}

TEST_CASE("C API: a handle that is no vector curve is HANDLE, and left alone", "[capi][vector][misuse]") {
  check_all_calls(nullptr, QTRAJ_E_NULL);
  const VectorCurve curve = make_curve();
  const Options options = vector_options(QTRAJ_VECTOR_LINEAR);
  const Trajectory trajectory = must_build(make_options({"", QTRAJ_SLERP}).get(), closed_tour<double>(5));
  alignas(8) double memory[64] = {};
  const auto as_vector = [](const void* p) {
    return const_cast<qtraj_vector_curve*>(static_cast<const qtraj_vector_curve*>(p));
  };
  for (const void* wrong :
       {static_cast<const void*>(options.get()), static_cast<const void*>(trajectory.get()),
        static_cast<const void*>(memory), static_cast<const void*>(reinterpret_cast<const char*>(curve.get()) + 4)}) {
    check_all_calls(as_vector(wrong), QTRAJ_E_HANDLE);
    qtraj_vector_destroy(as_vector(wrong));
  }
  qtraj_vector_destroy(nullptr);
  CHECK(qtraj_method(trajectory.get()) == QTRAJ_SLERP);
  // nor is it a trajectory, or options
  const auto* as_trajectory = reinterpret_cast<const qtraj_trajectory*>(curve.get());
  double q[4], times[5];
  CHECK(qtraj_sample_at(as_trajectory, 1, nullptr, q) == QTRAJ_E_HANDLE);
  CHECK(qtraj_keys(as_trajectory, times, nullptr) == QTRAJ_E_HANDLE);
  CHECK(qtraj_key_count(as_trajectory) == 0);
  CHECK(qtraj_options_set_period(reinterpret_cast<qtraj_options*>(curve.get()), 1) == QTRAJ_E_HANDLE);
  qtraj_destroy(reinterpret_cast<qtraj_trajectory*>(curve.get()));
  qtraj_options_destroy(reinterpret_cast<qtraj_options*>(curve.get()));
  CHECK(qtraj_vector_dim(curve.get()) == 3);
  size_t count = 7;
  CHECK(qtraj_vector_uniform_count(curve.get(), 0, 1, nullptr) == QTRAJ_E_NULL);
  CHECK((qtraj_vector_uniform_count(curve.get(), 0, 1, &count) == QTRAJ_OK && count == 5));
}

TEST_CASE("C API: a vector curve in the caller's memory is void once destroyed", "[capi][vector][misuse]") {
  const Options options = vector_options(QTRAJ_VECTOR_LINEAR);
  const double times[] = {0, 1}, values[] = {3, 4};
  size_t bytes = 0;
  REQUIRE(qtraj_vector_init_size(options.get(), 2, 1, &bytes) == QTRAJ_OK);
  std::vector<double> memory(bytes / 8 + 1);
  qtraj_vector_curve* curve = nullptr;
  for (int round = 0; round < 2; ++round) {  // one block serves one curve after another
    REQUIRE(qtraj_vector_init(memory.data(), bytes, options.get(), times, values, nullptr, nullptr, 2, 1, &curve,
                              nullptr) == QTRAJ_OK);
    CHECK(qtraj_vector_key_count(curve) == 2);
    qtraj_vector_destroy(curve);
    check_all_calls(curve, QTRAJ_E_HANDLE);
    qtraj_vector_destroy(curve);  // twice does no harm
  }
}

}  // namespace
