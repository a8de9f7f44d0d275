// Time per key. The peer, SciPy, is in scipy_peers.py.
#include "support.hpp"

namespace bench {
namespace {

void add_creation(const char* name, int32_t method, size_t key_count) {
  const std::string row = Case{std::string("create_") + name + "_f64", key_count, 0}.row("ours");
  benchmark::RegisterBenchmark(row.c_str(), [=](benchmark::State& state) {
    const Keys& keys = keys_of(key_count);
    for (auto iteration : state) {
      qtraj_trajectory* made = nullptr;
      must_be_ok(qtraj_create(method, keys.times.data(), keys.q.data(), key_count, &made, nullptr));
      qtraj_destroy(made);
    }
    state.counters["samples"] = static_cast<double>(key_count);
  });
}

}  // namespace

void add_construction() {
  for (const size_t key_count : {100, 1000, 10000, 100000, 1000000})
    add_creation("rotation_spline", QTRAJ_ROTATION_SPLINE, key_count);
  for (const size_t key_count : {1000, 100000}) {
    add_creation("slerp", QTRAJ_SLERP, key_count);
    add_creation("squad", QTRAJ_SQUAD, key_count);
    add_creation("log_spline", QTRAJ_LOG_SPLINE, key_count);
  }
}

}  // namespace bench
