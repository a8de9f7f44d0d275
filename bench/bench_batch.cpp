// Many short curves in one call. Peers: a loop over qtraj_init and qtraj_sample in memory that is used again, and
// sampling alone, of curves that are built already.
#include "support.hpp"

namespace bench {
namespace {

// Series of keys, and of samples in order, all within the keys.
struct Table {
  std::vector<int64_t> key_offsets = {0}, sample_offsets = {0};
  std::vector<double> times, q, sample_times;
  size_t longest = 0;

  size_t count() const { return key_offsets.size() - 1; }
  size_t key(size_t k) const { return static_cast<size_t>(key_offsets[k]); }
  size_t keys(size_t k) const { return key(k + 1) - key(k); }
  size_t row(size_t k) const { return static_cast<size_t>(sample_offsets[k]); }
  size_t rows(size_t k) const { return row(k + 1) - row(k); }

  void add(const Keys& series, size_t samples) {
    times.insert(times.end(), series.times.begin(), series.times.end());
    q.insert(q.end(), series.q.begin(), series.q.end());
    key_offsets.push_back(static_cast<int64_t>(times.size()));
    sample_times.resize(sample_times.size() + samples);
    must_be_ok(qtraj_even_times(series.times.front(), series.times.back(), samples,
                                sample_times.data() + sample_times.size() - samples));
    sample_offsets.push_back(static_cast<int64_t>(sample_times.size()));
    longest = std::max(longest, series.count());
  }
};

// `samples` in all, `per_series` of them each, of least to most keys.
const Table& table_of(size_t least, size_t most, size_t per_series, size_t samples) {
  static std::map<std::tuple<size_t, size_t, size_t, size_t>, std::unique_ptr<Table>> all;
  const auto make = [=] {
    Random random(samples);
    Table table;
    for (size_t row = 0; row < samples; row += per_series) {
      const auto keys = static_cast<size_t>(random.uniform(double(least), double(most) + 0.999));
      table.add(test::random_walk(random, keys, 1.0, 0.05, 0.5), per_series);
    }
    return table;
  };
  return kept(all, make, least, most, per_series, samples);
}

struct Curves {
  std::unique_ptr<qtraj_options, void (*)(qtraj_options*)> options = {nullptr, qtraj_options_destroy};
  size_t bytes = 0;  // of the longest

  Curves(int32_t method, const Table& table) {
    qtraj_options* made = nullptr;
    must_be_ok(qtraj_options_create(method, &made));
    options.reset(made);
    must_be_ok(qtraj_init_size(made, table.longest, &bytes));
  }
  qtraj_trajectory* build(const Table& table, size_t k, void* memory) const {
    qtraj_trajectory* curve = nullptr;
    must_be_ok(qtraj_init(memory, bytes, options.get(), 0, &table.times[table.key(k)], &table.q[4 * table.key(k)],
                          nullptr, nullptr, nullptr, table.keys(k), &curve, nullptr));
    return curve;
  }
};

void sample_series(const qtraj_trajectory* curve, const Table& table, size_t k, double* out) {
  must_be_ok(qtraj_sample(curve, &table.sample_times[table.row(k)], table.rows(k), out + 4 * table.row(k), nullptr));
}

void add_batch(const Case& batch, int32_t method, const Table& (*make)(size_t samples)) {
  add<double>(batch, "ours", [=] {
    const Table& table = make(batch.samples);
    const auto curves = std::make_shared<Curves>(method, table);
    return [=, &table](double* out) {
      must_be_ok(qtraj_batch_sample(curves->options.get(), table.count(), table.key_offsets.data(), table.times.data(),
                                    table.q.data(), table.sample_offsets.data(), table.sample_times.data(), nullptr, 0,
                                    out, nullptr, nullptr));
    };
  });
  add<double>(batch, "loop", [=] {
    const Table& table = make(batch.samples);
    const auto curves = std::make_shared<Curves>(method, table);
    const auto memory = std::make_shared<std::vector<double>>(curves->bytes / sizeof(double));
    return [=, &table](double* out) {
      for (size_t k = 0; k < table.count(); ++k) sample_series(curves->build(table, k, memory->data()), table, k, out);
    };
  });
  add<double>(batch, "sampling", [=] {
    const Table& table = make(batch.samples);
    const Curves curves(method, table);
    const size_t each = curves.bytes / sizeof(double);
    const auto memory = std::make_shared<std::vector<double>>(each * table.count());
    for (size_t k = 0; k < table.count(); ++k) curves.build(table, k, memory->data() + k * each);
    return [=, &table](double* out) {
      for (size_t k = 0; k < table.count(); ++k)
        sample_series(reinterpret_cast<const qtraj_trajectory*>(memory->data() + k * each), table, k, out);
    };
  });
}

const Table& ragged(size_t samples) { return table_of(4, 12, 20, samples); }
const Table& longer(size_t samples) { return table_of(16, 16, 200, samples); }

}  // namespace

void add_batches() {
  constexpr size_t kSamples = 2000000;  // of 1e5 and of 1e4 series
  add_batch({"batch_ragged_slerp_f64", 12, kSamples}, QTRAJ_SLERP, ragged);
  add_batch({"batch_ragged_rotation_spline_f64", 12, kSamples}, QTRAJ_ROTATION_SPLINE, ragged);
  add_batch({"batch_slerp_f64", 16, kSamples}, QTRAJ_SLERP, longer);
  add_batch({"batch_rotation_spline_f64", 16, kSamples}, QTRAJ_ROTATION_SPLINE, longer);
}

}  // namespace bench
