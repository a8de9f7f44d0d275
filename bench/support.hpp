// What all benchmarks share: cases and their names, data made once and kept, output that is warm or fresh.
//
// A row is named work/order/memory/K:keys/M:samples/who, who being "ours" or a peer; report.py sets those that differ
// in nothing but who against each other. K:0 is no keys, M:0 no samples.
#pragma once

#include <benchmark/benchmark.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "qtraj.h"
#include "support/random.hpp"

namespace bench {

using test::Keys;
using test::Random;

struct Settings {
  bool large;  // M = 1e8 too
};

enum class Order { sorted, random };
enum class Memory { warm, fresh };

struct Case {
  std::string work;
  size_t keys, samples;
  Order order = Order::sorted;
  Memory memory = Memory::warm;

  std::string row(const char* who) const {
    return work + (order == Order::sorted ? "/sorted" : "/random") + (memory == Memory::warm ? "/warm" : "/fresh") +
           "/K:" + std::to_string(keys) + "/M:" + std::to_string(samples) + "/" + who;
  }
};

template <class Real>
std::string with_type(const char* work) {
  return std::string(work) + (sizeof(Real) == 4 ? "_f32" : "_f64");
}

inline void must_be_ok(qtraj_status status) {
  if (status == QTRAJ_OK) return;
  std::fprintf(stderr, "bench: %s\n", qtraj_status_text(status));
  std::exit(1);
}

// ---- Data ----

// The value that `make` gives for these arguments, made at the first use.
template <class Value, class... Arguments, class Make>
const Value& kept(std::map<std::tuple<Arguments...>, std::unique_ptr<Value>>& values, const Make& make,
                  Arguments... arguments) {
  std::unique_ptr<Value>& value = values[std::make_tuple(arguments...)];
  if (!value) value = std::make_unique<Value>(make());
  return *value;
}

// Steps of at most 1 rad, 0.2 to 2 s apart.
inline const Keys& keys_of(size_t count) {
  static std::map<std::tuple<size_t>, std::unique_ptr<Keys>> all;
  return kept(
      all,
      [=] {
        Random random(count);
        return test::random_walk(random, count, 1.0, 0.2, 2.0);
      },
      count);
}

inline const std::vector<double>& times_of(const Case& sampled) {
  static std::map<std::tuple<size_t, size_t, Order>, std::unique_ptr<std::vector<double>>> all;
  const auto make = [&] {
    const Keys& keys = keys_of(sampled.keys);
    const double first = keys.times.front(), last = keys.times.back();
    std::vector<double> times(sampled.samples);
    Random random(sampled.samples);
    if (sampled.order == Order::random)
      for (double& time : times) time = random.uniform(first, last);
    else
      must_be_ok(qtraj_even_times(first, last, times.size(), times.data()));
    return times;
  };
  return kept(all, make, sampled.keys, sampled.samples, sampled.order);
}

// Unrelated orientations, [count][4].
inline const std::vector<double>& orientations_of(size_t count, uint64_t seed) {
  static std::map<std::tuple<size_t, uint64_t>, std::unique_ptr<std::vector<double>>> all;
  const auto make = [=] {
    Random random(seed);
    std::vector<double> q;
    for (size_t i = 0; i < count; ++i)
      for (const double component : random.orientation()) q.push_back(component);
    return q;
  };
  return kept(all, make, count, seed);
}

template <class Real>
std::vector<Real> converted(const std::vector<double>& values) {
  return std::vector<Real>(values.begin(), values.end());
}

// Trajectories live until the program ends.
inline const qtraj_trajectory* trajectory_of(int32_t method, size_t key_count) {
  static std::map<std::tuple<int32_t, size_t>, std::unique_ptr<const qtraj_trajectory*>> all;
  const auto make = [=]() -> const qtraj_trajectory* {
    const Keys& keys = keys_of(key_count);
    qtraj_trajectory* made = nullptr;
    must_be_ok(qtraj_create(method, keys.times.data(), keys.q.data(), key_count, &made, nullptr));
    return made;
  };
  return kept(all, make, method, key_count);
}

// ---- Output ----

// Pages that no one has touched.
class FreshMemory {
 public:
  explicit FreshMemory(size_t bytes)
      : bytes_(bytes), data_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
    if (data_ == MAP_FAILED) {
      std::fprintf(stderr, "bench: no memory for %zu bytes\n", bytes);
      std::exit(1);
    }
  }
  ~FreshMemory() { munmap(data_, bytes_); }
  FreshMemory(const FreshMemory&) = delete;
  FreshMemory& operator=(const FreshMemory&) = delete;

  void* data() const { return data_; }

 private:
  size_t bytes_;
  void* data_;
};

// One array for all benchmarks, written to before.
inline void* warm_memory(size_t bytes) {
  static std::unique_ptr<FreshMemory> memory;
  static size_t size = 0;
  bytes = std::max(bytes, size_t{1});
  if (bytes > size) {
    memory.reset();
    memory = std::make_unique<FreshMemory>(bytes);
    std::memset(memory->data(), 1, bytes);
    size = bytes;
  }
  return memory->data();
}

// ---- Registration ----

// Adds a row. `prepare` is called before timing starts and returns what is timed: a function of the output array,
// [samples][components].
template <class Real, class Prepare>
void add(const Case& sampled, const char* who, const Prepare& prepare, size_t components = 4) {
  const size_t samples = sampled.samples, bytes = samples * components * sizeof(Real);
  const bool fresh = sampled.memory == Memory::fresh;
  benchmark::RegisterBenchmark(sampled.row(who).c_str(), [=](benchmark::State& state) {
    const auto batch = prepare();
    if (!fresh) {
      Real* const out = static_cast<Real*>(warm_memory(bytes));
      for (auto iteration : state) {
        batch(out);
        benchmark::ClobberMemory();
      }
    }
    while (fresh && state.KeepRunning()) {
      state.PauseTiming();
      {
        const FreshMemory memory(bytes);
        state.ResumeTiming();
        batch(static_cast<Real*>(memory.data()));
        benchmark::ClobberMemory();
        state.PauseTiming();
      }
      state.ResumeTiming();
    }
    state.counters["samples"] = static_cast<double>(samples);
  });
}

// ---- Sampling, f64 or f32 ----

inline void sample(const qtraj_trajectory* trajectory, const std::vector<double>& times, double* out) {
  must_be_ok(qtraj_sample(trajectory, times.data(), times.size(), out, nullptr));
}
inline void sample(const qtraj_trajectory* trajectory, const std::vector<double>& times, float* out) {
  must_be_ok(qtraj_sample_f32(trajectory, times.data(), times.size(), out, nullptr));
}

template <class Real>
void add_ours(const Case& sampled, int32_t method) {
  add<Real>(sampled, "ours", [=] {
    const qtraj_trajectory* const trajectory = trajectory_of(method, sampled.keys);
    const std::vector<double>& times = times_of(sampled);
    return [=, &times](Real* out) { sample(trajectory, times, out); };
  });
}

// ---- Topics ----

void add_slerp(const Settings& settings);
void add_squad();
void add_splines();
void add_pairs();
void add_means();
void add_single();
void add_rigs();
void add_tables();
void add_construction();
void add_vectors();
void add_batches();
void add_few_keys();
void add_functions();

}  // namespace bench
