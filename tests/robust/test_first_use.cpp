// The first calls of a process come from many threads at once: which kernel runs is found out once for all, and they
// all get the results that one thread gets later.
#include <atomic>
#include <string>
#include <thread>

#include "support/capi_means.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr size_t kThreads = 12, kKeys = 64;

// What a thread gets from a constructor, samplers, a mean and a function over pairs.
struct Results {
  std::string target;
  std::vector<double> numbers;

  bool operator==(const Results& other) const { return target == other.target && same_bits(numbers, other.numbers); }
};

Results use_library(const Keyframes<double>& keys, const std::vector<double>& times, size_t thread) {
  Results results;
  if (thread % 2 == 1) results.target = qtraj_target();
  qtraj_trajectory* curve = nullptr;
  qtraj_create(QTRAJ_ROTATION_SPLINE, keys.times.data(), keys.q.data(), kKeys, &curve, nullptr);
  std::vector<double>& numbers = results.numbers;
  numbers.resize(10 * times.size() + 4 * kKeys + 4);
  double *const q = numbers.data(), *const omega = q + 4 * times.size(), *const alpha = omega + 3 * times.size(),
                *const pairs = alpha + 3 * times.size(), *const mean = pairs + 4 * kKeys;
  qtraj_sample_rates(curve, QTRAJ_FRAME_BODY, times.data(), times.size(), q, omega, alpha, nullptr);
  qtraj_destroy(curve);
  qtraj_normalize(keys.q.data(), kKeys, pairs, nullptr);
  qtraj_mean_karcher(keys.q.data(), nullptr, kKeys, 0, 50, mean, nullptr, nullptr, nullptr);
  if (thread % 2 == 0) results.target = qtraj_target();
  return results;
}

TEST_CASE("C API: the first calls may come from many threads at once", "[robust][threads]") {
  const Keyframes<double> keys = closed_tour<double>(kKeys);
  const std::vector<double> times = times_in(keys.times, 5);
  std::vector<Results> results(kThreads);
  std::atomic<size_t> waiting{0};
  std::vector<std::thread> threads;
  for (size_t thread = 0; thread < kThreads; ++thread)
    threads.emplace_back([&, thread] {
      ++waiting;
      while (waiting < kThreads) std::this_thread::yield();
      results[thread] = use_library(keys, times, thread);
    });
  for (std::thread& thread : threads) thread.join();
  const Results alone = use_library(keys, times, 0);
  for (const Results& result : results) CHECK(result == alone);
}

}  // namespace
