// Time per key of constructing curves through few keys in the same memory, again and again: what short recordings are
// made of. The peer is a loop that prepares slerp alone.
#include "peers.hpp"
#include "support.hpp"

namespace bench {
namespace {

template <class Prepare>
void add_row(const Case& built, const char* who, const Prepare& prepare) {
  benchmark::RegisterBenchmark(built.row(who).c_str(), [=](benchmark::State& state) {
    const auto construct = prepare();
    for (auto iteration : state) {
      construct();
      benchmark::ClobberMemory();
    }
    state.counters["samples"] = static_cast<double>(built.keys);
  });
}

// `rates`: one for each key, for methods that want them.
void add_method(const char* name, int32_t method, bool has_rates, size_t key_count) {
  const Case built = {std::string("init_") + name + "_f64", key_count, 0};
  const Keys& keys = keys_of(key_count);
  add_row(built, "ours", [=, &keys] {
    qtraj_options* options = nullptr;
    must_be_ok(qtraj_options_create(method, &options));  // lives until the program ends
    size_t bytes = 0;
    must_be_ok(qtraj_init_size(options, key_count, &bytes));
    void* const memory = warm_memory(bytes);
    return [=, &keys, rates = std::vector<double>(3 * key_count, 0.1)] {
      qtraj_trajectory* made = nullptr;
      must_be_ok(qtraj_init(memory, bytes, options, QTRAJ_FRAME_BODY, keys.times.data(), keys.q.data(),
                            has_rates ? rates.data() : nullptr, nullptr, nullptr, key_count, &made, nullptr));
    };
  });
  add_row(built, "eigen", [=, &keys] {
    return [=, &keys, segments = std::make_shared<std::vector<peers::EigenSegment>>(key_count)] {
      peers::eigen_prepare_slerp(keys.times.data(), keys.q.data(), key_count, segments->data());
    };
  });
}

}  // namespace

void add_few_keys() {
  for (const size_t key_count : {2, 4, 8, 16, 32, 64}) {
    add_method("slerp", QTRAJ_SLERP, false, key_count);
    add_method("nlerp", QTRAJ_NLERP, false, key_count);
    add_method("squad", QTRAJ_SQUAD, false, key_count);
    add_method("hermite", QTRAJ_HERMITE, true, key_count);
  }
}

}  // namespace bench
