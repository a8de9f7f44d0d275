// Both means with faulty arguments or samples: statuses, indices, NaN rows, untouched outputs, floating environment.
#include <algorithm>
#include <cfloat>
#include <string>

#include "support/capi_floating.hpp"
#include "support/capi_handles.hpp"
#include "support/capi_means.hpp"
#include "support/catch.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kCount = 5;

// A call of one of the means with everything it takes.
template <class Real>
struct Call {
  bool karcher;
  const Real *q, *weights;
  size_t count;
  Real* mean_out;
  double *eigengap, *residual;
  int32_t* iterations;
  double tolerance = 0;
  int32_t max_iterations = 100;

  qtraj_status operator()(size_t* bad_index) const {
    return karcher
               ? mean_karcher(q, weights, count, tolerance, max_iterations, mean_out, iterations, residual, bad_index)
               : mean_eigen(q, weights, count, mean_out, eigengap, bad_index);
  }
};

// Arrays of good samples and outputs, and the call that uses them.
template <class Real>
struct Arrays {
  Samples<Real> samples;
  std::vector<Real> mean = std::vector<Real>(4, Real(7));
  double eigengap = 7, residual = 7;
  int32_t iterations = 7;

  Arrays() {
    test::Random random(41);
    samples = cloud<Real>(random, kCount, 0.3);
    samples.weights = {1, 2, 0, 3, 1};
  }
  Call<Real> call(bool karcher) {
    return {karcher, samples.q.data(), samples.weights.data(), kCount, mean.data(), &eigengap, &residual, &iterations};
  }
  bool untouched() const {
    return mean == std::vector<Real>(4, Real(7)) && eigengap == 7 && residual == 7 && iterations == 7;
  }
};

template <class Real>
void check_argument_error(const Arrays<Real>& arrays, const Call<Real>& call, qtraj_status expected) {
  size_t bad_index = 12345;
  CHECK(call(&bad_index) == expected);
  CHECK(bad_index == SIZE_MAX);
  CHECK(call(nullptr) == expected);
  CHECK(arrays.untouched());
}

// Runs body(real zero, karcher) for the four functions.
template <class Body>
void for_every_mean(const Body& body) {
  for_double_and_float([&](auto zero) {
    for (const bool karcher : {false, true}) {
      CAPTURE(sizeof zero, karcher);
      body(zero, karcher);
    }
  });
}

}  // namespace

TEST_CASE("C API: means judge arguments in the order NULL, COUNT, SIZE, OPTION, OVERLAP and then leave outputs alone",
          "[capi][means][errors]") {
  for_every_mean([](auto zero, bool karcher) {
    using Real = decltype(zero);
    Arrays<Real> arrays;
    const Call<Real> good = arrays.call(karcher);
    const auto check = [&](qtraj_status expected, auto&& change) {
      Call<Real> call = good;
      change(call);
      check_argument_error(arrays, call, expected);
    };
    Real* const in_q = arrays.samples.q.data();
    check(QTRAJ_E_NULL, [](auto& call) { call.q = nullptr; });
    check(QTRAJ_E_NULL, [](auto& call) { call.mean_out = nullptr; });
    check(QTRAJ_E_NULL, [](auto& call) { call.q = nullptr, call.count = SIZE_MAX; });
    check(QTRAJ_E_TOO_FEW, [](auto& call) { call.count = 0; });
    check(QTRAJ_E_TOO_FEW, [](auto& call) { call.count = 0, call.q = nullptr, call.weights = nullptr; });
    check(QTRAJ_E_TOO_FEW, [](auto& call) { call.count = 0, call.q = nullptr, call.mean_out = nullptr; });
    check(QTRAJ_E_TOO_FEW, [](auto& call) { call.count = 0, call.tolerance = -1; });
    constexpr size_t kMost = PTRDIFF_MAX;
    for (const size_t count : {SIZE_MAX, SIZE_MAX / 4 + 2, kMost / (4 * sizeof(Real)) + 1}) {
      check(QTRAJ_E_SIZE, [&](auto& call) { call.count = count; });
      check(QTRAJ_E_SIZE, [&](auto& call) { call.count = count, call.weights = nullptr, call.max_iterations = 0; });
    }
    check(QTRAJ_E_OVERLAP, [&](auto& call) { call.mean_out = in_q; });
    check(QTRAJ_E_OVERLAP, [&](auto& call) { call.mean_out = in_q + 4 * kCount - 1; });
    if (!karcher) return;
    for (const double tolerance : {-1e-300, -1.0, kNaN, -kNaN, kInfinity, -kInfinity})
      check(QTRAJ_E_VALUE, [&](auto& call) { call.tolerance = tolerance; });
    for (const int32_t limit : {0, -1, INT32_MIN})
      check(QTRAJ_E_VALUE, [&](auto& call) { call.max_iterations = limit, call.mean_out = in_q; });
  });
}

TEST_CASE("C API: outputs of a mean may not overlap another array, but for the one sample of a mean of one",
          "[capi][means][errors]") {
  for_every_mean([](auto zero, bool karcher) {
    using Real = decltype(zero);
    // outputs move across the samples
    for (size_t offset = 0; offset + 4 * sizeof(Real) <= 256; offset += sizeof(Real)) {
      CAPTURE(offset);
      alignas(double) unsigned char block[256], before[256];
      std::fill(block, block + sizeof block, static_cast<unsigned char>(0x3f));
      std::memcpy(before, block, sizeof block);
      constexpr size_t kAt = 96, kBytes = 2 * 4 * sizeof(Real);
      const auto at = [&](size_t place) { return reinterpret_cast<Real*>(block + place); };
      Call<Real> call = {karcher, at(kAt), nullptr, 2, at(offset), nullptr, nullptr, nullptr};
      const bool apart = offset + 4 * sizeof(Real) <= kAt || offset >= kAt + kBytes;
      CHECK(call(nullptr) == (apart ? QTRAJ_OK : QTRAJ_E_OVERLAP));
      if (!apart) CHECK(std::memcmp(block, before, sizeof block) == 0);
      call.count = 1;
      const bool in_place = offset == kAt, apart_from_one = apart || offset >= kAt + kBytes / 2;
      CHECK(call(nullptr) == (in_place || apart_from_one ? QTRAJ_OK : QTRAJ_E_OVERLAP));
    }
    // scalar outputs
    Arrays<Real> arrays;
    const auto check = [&](auto&& change) {
      Call<Real> call = arrays.call(karcher);
      change(call);
      check_argument_error(arrays, call, QTRAJ_E_OVERLAP);
    };
    alignas(double) Real row[4] = {7, 7, 7, 7};
    double* const scalar = reinterpret_cast<double*>(row);
    check([&](auto& call) { call.mean_out = row, call.residual = call.eigengap = scalar; });
    check([&](auto& call) { call.q = row, call.count = 1, call.residual = call.eigengap = scalar; });
    if (!karcher) return;
    check([&](auto& call) { call.mean_out = row, call.iterations = reinterpret_cast<int32_t*>(row + 3); });
    check([&](auto& call) { call.residual = scalar, call.iterations = reinterpret_cast<int32_t*>(row); });
  });
}

TEST_CASE("C API: scalar outputs of a mean may be NULL and the others are the same", "[capi][means]") {
  for_every_mean([](auto zero, bool karcher) {
    using Real = decltype(zero);
    Arrays<Real> all, none;
    REQUIRE(all.call(karcher)(nullptr) == QTRAJ_OK);
    CHECK((karcher ? all.iterations > 0 && all.residual < 1e-6 && all.eigengap == 7
                   : all.eigengap > 0.5 && all.iterations == 7 && all.residual == 7));
    Call<Real> call = none.call(karcher);
    call.eigengap = call.residual = nullptr;
    call.iterations = nullptr;
    size_t bad_index = 12345;
    CHECK((call(&bad_index) == QTRAJ_OK && bad_index == SIZE_MAX));
    CHECK(none.mean == all.mean);
  });
}

TEST_CASE("C API: a mean with samples at fault is NaN, with status and index of the first", "[capi][means][errors]") {
  for_every_mean([](auto zero, bool karcher) {
    using Real = decltype(zero);
    struct Fault {
      qtraj_status status;
      Real w, z, weight;
    };
    const Real nan = static_cast<Real>(kNaN), infinity = static_cast<Real>(kInfinity), keep = 1;
    Real signalling;
    set_signalling_nan(signalling);
    const Fault faults[] = {
        {QTRAJ_E_NOT_FINITE, nan, 0, keep},
        {QTRAJ_E_NOT_FINITE, 0, -infinity, keep},
        {QTRAJ_E_NOT_FINITE, signalling, 0, keep},
        {QTRAJ_E_NOT_FINITE, keep, 0, infinity},
        {QTRAJ_E_NOT_FINITE, keep, 0, signalling},
        {QTRAJ_E_ZERO_NORM, 0, 0, keep},
        {QTRAJ_E_NEGATIVE_WEIGHT, keep, 0, -keep},
        {QTRAJ_E_NEGATIVE_WEIGHT, keep, 0, -std::numeric_limits<Real>::denorm_min()},
        // several faults of one sample
        {QTRAJ_E_NOT_FINITE, 0, 0, nan},
        {QTRAJ_E_NOT_FINITE, nan, 0, -keep},
        {QTRAJ_E_NOT_FINITE, keep, 0, -infinity},
        {QTRAJ_E_ZERO_NORM, 0, Real(-0.0), -keep},
        // at fault without weight too
        {QTRAJ_E_NOT_FINITE, 0, infinity, 0},
        {QTRAJ_E_ZERO_NORM, 0, 0, 0},
    };
    for (const Fault& first : faults)
      for (const Fault& second : faults)
        for (const size_t row : {size_t{0}, size_t{2}, size_t{3}}) {
          Arrays<Real> arrays;
          const auto spoil = [&](size_t i, const Fault& fault) {
            const Real values[] = {fault.w, 0, 0, fault.z};
            std::memcpy(&arrays.samples.q[4 * i], values, sizeof values);
            std::memcpy(&arrays.samples.weights[i], &fault.weight, sizeof(Real));
          };
          spoil(row, first);
          spoil(4, second);
          size_t bad_index = 12345;
          const qtraj_status status = arrays.call(karcher)(&bad_index);
          CAPTURE(first.status, row);
          CHECK((status == first.status && bad_index == row));
          CHECK(std::all_of(arrays.mean.begin(), arrays.mean.end(), [](Real x) { return std::isnan(x); }));
          CHECK((karcher ? std::isnan(arrays.residual) && arrays.iterations == 0 : std::isnan(arrays.eigengap)));
        }
  });
}

TEST_CASE("C API: weights that are all 0 are ZERO_NORM, without an index", "[capi][means][errors]") {
  for_every_mean([](auto zero, bool karcher) {
    using Real = decltype(zero);
    Arrays<Real> arrays;
    arrays.samples.weights = {0, Real(-0.0), 0, 0, 0};
    size_t bad_index = 12345;
    CHECK(arrays.call(karcher)(&bad_index) == QTRAJ_E_ZERO_NORM);
    CHECK(bad_index == SIZE_MAX);
    CHECK(std::isnan(arrays.mean[0]));
  });
}

TEST_CASE("C API: means leave the floating-point environment and errno alone, for every input",
          "[capi][means][errors]") {
  const std::string nothing = "nothing";
  for_every_mean([&](auto zero, bool karcher) {
    using Real = decltype(zero);
    const auto check = [&](const Samples<Real>& samples) {
      std::vector<Real> mean(4);
      double scalar = 0;
      int32_t iterations = 0;
      const Call<Real> call = {karcher,         samples.q.data(), samples.weights_or_null(),
                               samples.count(), mean.data(),      &scalar,
                               &scalar,         &iterations};
      CHECK(disturbance([&] { call(nullptr); }) == nothing);
    };
    test::Random random(42);
    for (int set = 0; set < 300; ++set) check(hard_samples<Real>(random, 3.0));
    // components and weights of every size, close to each other and far
    const Real extremes[] = {
        0,          std::numeric_limits<Real>::denorm_min(), std::numeric_limits<Real>::min(), Real(1e-30), 1,
        Real(1e30), std::numeric_limits<Real>::max()};
    for (int set = 0; set < 300; ++set) {
      const auto any = [&] { return extremes[static_cast<size_t>(random.uniform(0, 7))]; };
      Samples<Real> samples;
      for (size_t i = 0; i < 4; ++i) {
        for (size_t k = 0; k < 4; ++k) samples.q.push_back(random.uniform(0, 1) < 0.5 ? any() : -any());
        samples.weights.push_back(any());
      }
      check(samples);
    }
    // faults of every kind
    for (int set = 0; set < 16; ++set) {
      Samples<Real> samples = cloud<Real>(random, 4, 0.3);
      samples.weights.assign(4, 1);
      Real& element = set < 8 ? samples.q[static_cast<size_t>(set) + 4] : samples.weights[static_cast<size_t>(set) % 4];
      if (set % 2 == 0)
        set_signalling_nan(element);
      else
        element = static_cast<Real>(set % 4 == 1 ? -kInfinity : kNaN);
      check(samples);
    }
    // settings that are not numbers
    Arrays<Real> arrays;
    for (const double tolerance : {kNaN, kInfinity}) {
      Call<Real> call = arrays.call(karcher);
      call.tolerance = tolerance;
      CHECK(disturbance([&] { call(nullptr); }) == nothing);
    }
  });
}
