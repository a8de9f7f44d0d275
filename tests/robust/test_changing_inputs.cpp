// Another thread changes the caller's arrays while a call reads them. What comes out is nobody's business, but nothing
// outside of arrays may be touched: a time that was checked may be another one when it is read again. Arrays end at
// guard pages, so that a release build sees it too; the sanitizers see the library's own arrays.
#include <qtraj.h>

#include <atomic>
#include <cfloat>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

#include "support/capi_variants.hpp"
#include "support/guarded.hpp"
#include "support/kernel_curves.hpp"

using namespace capi;

namespace {

constexpr size_t kKeys = 61, kTimes = 157;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

// An array against the guard page behind it.
struct Numbers {
  test::Guarded<double> memory;
  size_t count;
  double* data;

  explicit Numbers(size_t size) : memory(size), count(size), data(memory.array(size, true)) {
    for (size_t i = 0; i < size; ++i) data[i] = 0;
  }
};

constexpr size_t kSeries = 5;
constexpr int64_t kKeyOffsets[kSeries + 1] = {0, 10, 12, 13, 50, kKeys};
constexpr int64_t kSampleOffsets[kSeries + 1] = {0, 30, 30, 77, 150, kTimes};

struct Inputs {
  Numbers times{kKeys}, q{4 * kKeys}, queries{kTimes};
  int64_t key_offsets[kSeries + 1], sample_offsets[kSeries + 1];
  std::vector<double> good_times, good_q, good_queries;

  Inputs() {
    test::Random random(2);
    const test::Keys walk = test::random_walk(random, kKeys, 1.0, 0.2, 2.0);
    good_times = walk.times, good_q = walk.q;
    for (size_t i = 0; i < kTimes; ++i) {
      const double fraction = static_cast<double>(i) / (kTimes - 1);
      good_queries.push_back(walk.times.front() + fraction * (walk.times.back() - walk.times.front()));
    }
    std::copy(good_times.begin(), good_times.end(), times.data);
    std::copy(good_q.begin(), good_q.end(), q.data);
    std::copy(good_queries.begin(), good_queries.end(), queries.data);
    std::copy_n(kKeyOffsets, kSeries + 1, key_offsets);
    std::copy_n(kSampleOffsets, kSeries + 1, sample_offsets);
  }
};

// Any offset within the arrays, or one that is none; most of them as they belong.
void change_offset(int64_t* offset, int64_t good, int64_t last, test::Random& random) {
  const double kind = random.uniform(0, 1);
  const int64_t value = kind < 0.1 ? -1 : kind < 0.4 ? static_cast<int64_t>(random.uniform(0, double(last))) : good;
  __atomic_store(offset, &value, __ATOMIC_RELAXED);
}

// Writes single numbers, most of them those that belong there, until told to stop. Each store is whole.
void change(Inputs& inputs, const std::atomic<bool>& stop) {
  test::Random random(7);
  const double bad[] = {kNaN, kInfinity, -kInfinity, DBL_MAX, -DBL_MAX, 0.0, -3.0, 1e9, 5e-324};
  const auto index_below = [&](size_t limit) {
    return static_cast<size_t>(random.uniform(0, static_cast<double>(limit) - 0.001));
  };
  while (!stop) {
    const size_t at = index_below(kSeries + 1);
    change_offset(&inputs.key_offsets[at], kKeyOffsets[at], kKeys, random);
    change_offset(&inputs.sample_offsets[at], kSampleOffsets[at], kTimes, random);
    for (auto& [array, good] : {std::pair<Numbers*, std::vector<double>*>{&inputs.times, &inputs.good_times},
                                {&inputs.q, &inputs.good_q},
                                {&inputs.queries, &inputs.good_queries}}) {
      const size_t i = index_below(array->count), kind = index_below(8);
      double value = (*good)[i];
      if (kind == 0) value = bad[index_below(sizeof bad / sizeof bad[0])];
      if (kind == 1) value = (*good)[index_below(array->count)];
      __atomic_store(&array->data[i], &value, __ATOMIC_RELAXED);
      // the next turn mends another one; now and then all are good for a while
      if (kind == 2)
        for (size_t k = 0; k < array->count; ++k) __atomic_store(&array->data[k], &(*good)[k], __ATOMIC_RELAXED);
    }
  }
}

using Call = std::function<void()>;

struct Calls {
  Inputs inputs;
  Numbers q{4 * kTimes}, omega{3 * kTimes}, alpha{3 * kTimes}, errors{kKeys}, controls{8 * kKeys};
  std::vector<float> q_f32 = std::vector<float>(4 * kTimes);
  std::vector<size_t> index = std::vector<size_t>(kKeys);
  std::vector<int32_t> statuses = std::vector<int32_t>(kKeys);
  std::vector<test::KernelCurve> curves;
  std::vector<Call> list;

  Calls() {
    curves = test::kernel_curves(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_CONSTANT_RATE);
    for (const int32_t method : {QTRAJ_SLERP, QTRAJ_SQUAD}) {
      const Variant variant = {"periodic", method};
      const Options options = make_options(variant);
      REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
              QTRAJ_OK);
      const Keyframes<double> tour = closed_tour<double>(9);
      curves.push_back({variant.name, tour.times, must_build(options.get(), tour)});
    }
    for (const test::KernelCurve& curve : curves) add_samplers(curve.get());
    for (const Variant& variant : variants())
      if (!variant.needs_rates() && !variant.needs_tangents()) add_constructor(variant);
    add_batches();
    add_functions();
  }

  void add_samplers(const qtraj_trajectory* curve) {
    const double* at = inputs.queries.data;
    list.push_back([=] { qtraj_sample(curve, at, kTimes, q.data, nullptr); });
    list.push_back([=] { qtraj_sample_f32(curve, at, kTimes, q_f32.data(), nullptr); });
    list.push_back(
        [=] { qtraj_sample_rates(curve, QTRAJ_FRAME_WORLD, at, kTimes, q.data, omega.data, alpha.data, nullptr); });
    list.push_back([=] { qtraj_sample_unnormalized(curve, at, kTimes, q.data, nullptr, nullptr, nullptr); });
  }
  // Builds a curve, and samples it at times that change as well.
  void add_constructor(const Variant& variant) {
    const auto options = std::make_shared<Options>(make_options(variant));
    list.push_back([=] {
      qtraj_trajectory* curve = nullptr;
      qtraj_create_with_options(options->get(), inputs.times.data, inputs.q.data, kKeys, &curve, nullptr);
      if (curve) qtraj_sample(curve, inputs.queries.data, kTimes, q.data, nullptr);
      qtraj_destroy(curve);
    });
  }
  // Many curves, of series whose offsets change as well; rows are against the guard page.
  void add_batches() {
    const auto options = std::make_shared<Options>(make_options({"", QTRAJ_ROTATION_SPLINE}));
    for (const double* at : {static_cast<const double*>(inputs.queries.data), static_cast<const double*>(nullptr)})
      list.push_back([=] {
        qtraj_batch_sample(options->get(), kSeries, inputs.key_offsets, inputs.times.data, inputs.q.data,
                           inputs.sample_offsets, at, nullptr, 0, q.data, statuses.data(), nullptr);
      });
    list.push_back([=] {
      const double step = 0.1;
      qtraj_batch_times(kSeries, inputs.key_offsets, inputs.times.data, &step, 1, inputs.sample_offsets, q.data,
                        nullptr, nullptr);
    });
    list.push_back([=] {
      qtraj_batch_mean_eigen(kSeries, inputs.key_offsets, inputs.q.data, nullptr, omega.data, nullptr, nullptr,
                             nullptr);
    });
  }
  void add_functions() {
    const double *times = inputs.times.data, *keys = inputs.q.data, *queries = inputs.queries.data;
    for (const int32_t end : {QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_PERIODIC})
      list.push_back([=] { qtraj_cubic_spline(times, keys, kKeys, 4, end, end, queries, kTimes, q.data, nullptr); });
    list.push_back(
        [=] { qtraj_estimate_jumps(QTRAJ_FRAME_WORLD, times, keys, kKeys, queries, kTimes, omega.data, nullptr); });
    list.push_back(
        [=] { qtraj_keyframe_errors(times, keys, kKeys, times, keys, kKeys, errors.data, index.data(), nullptr); });
    list.push_back(
        [=] { qtraj_squad_controls(times, keys, kKeys, controls.data, controls.data + 4 * kKeys, nullptr); });
    list.push_back([=] {
      qtraj_slerp_between(keys, times[0], keys + 4, times[1], queries, kTimes, QTRAJ_PATH_SHORTEST, q.data, nullptr);
    });
    list.push_back([=] {
      qtraj_slerp_pairs_between(keys, times, kKeys, keys, times, kKeys, queries, kKeys, kKeys, QTRAJ_PATH_SHORTEST,
                                q.data, nullptr);
    });
    list.push_back([=] {
      qtraj_key_report report;
      qtraj_check_keys(times, keys, kKeys, statuses.data(), &report, nullptr);
    });
    list.push_back([=] { qtraj_estimate_omega(QTRAJ_FRAME_BODY, times, keys, kKeys, nullptr, omega.data, nullptr); });
    list.push_back([=] { qtraj_mean_karcher(keys, nullptr, kKeys, 0, 20, q.data, nullptr, nullptr, nullptr); });
  }
};

TEST_CASE("C API: inputs that change during a call make nothing outside of arrays be touched", "[robust][threads]") {
  using Clock = std::chrono::steady_clock;
  Calls calls;
  std::atomic<bool> stop{false};
  std::thread other([&] { change(calls.inputs, stop); });
  test::for_every_kernel([&](const char*) {
    const auto end = Clock::now() + std::chrono::milliseconds(300);
    do {
      for (const Call& call : calls.list) call();
    } while (Clock::now() < end);
  });
  stop = true;
  other.join();
  // indices that are told are those of samples
  for (const size_t index : calls.index) CHECK((index < kKeys || index == SIZE_MAX));
}

}  // namespace
