// Random batches: series of keys and samples of any length, offsets that are none, and what a loop gives of them.
#include <algorithm>

#include "fuzz.hpp"
#include "support/capi_batch_call.hpp"
#include "support/capi_handles.hpp"

namespace fuzz {
namespace {

constexpr size_t kMostSeries = 6, kMostKeys = 12, kMostSamples = 40;

// Of `count` series, from any row on.
struct Offsets {
  std::vector<int64_t> at;

  Offsets(Source& source, size_t count, size_t most_rows) : at{static_cast<int64_t>(source.below(5))} {
    while (at.size() <= count) at.push_back(at.back() + static_cast<int64_t>(source.below(most_rows + 1)));
  }
  size_t row(size_t k) const { return static_cast<size_t>(at[k]); }
  size_t rows(size_t k) const { return row(k + 1) - row(k); }
  // Makes one of them negative, or less than the one before; false where that would be none.
  bool spoil(Source& source) {
    const size_t k = source.below(at.size());
    const int64_t bad[] = {-1, INT64_MIN, k > 0 ? at[k - 1] - 1 : -2};
    at[k] = source.one_of(bad);
    return at[k] < (k > 0 ? at[k - 1] : 0);
  }
};

// Series k on its own, to arrays of a row.
template <class Real>
qtraj_status alone(const capi::BatchCall<Real>& call, const Offsets& keys, const Offsets& rows, size_t k, void* memory,
                   size_t bytes, Real* q_out) {
  qtraj_trajectory* curve = nullptr;
  const size_t key = keys.row(k);
  if (keys.rows(k) < 2) return QTRAJ_E_TOO_FEW;
  const qtraj_status status =
      capi::init(memory, bytes, call.options, call.frame, call.key_times + key, call.key_q + 4 * key,
                 call.key_omega ? call.key_omega + 3 * key : nullptr,
                 call.key_alpha ? call.key_alpha + 3 * key : nullptr, keys.rows(k), &curve, nullptr);
  if (status != QTRAJ_OK) return status;
  const double* const times = call.sample_times + rows.row(k);
  return call.with_rates ? capi::sample_rates(curve, call.frame, times, rows.rows(k), q_out,
                                              static_cast<Real*>(nullptr), static_cast<Real*>(nullptr), nullptr)
                         : capi::sample(curve, times, rows.rows(k), q_out, nullptr);
}

template <class Real>
void fuzz_batch_of(Source& source, Digests& digests) {
  // batches have no tangents
  static const std::vector<int32_t> methods = [] {
    std::vector<int32_t> all = capi::all_methods();
    all.erase(std::remove_if(all.begin(), all.end(), capi::needs_tangents), all.end());
    return all;
  }();
  const Level levels[] = {Level::ordinary, Level::finite, Level::any};
  const Level level = source.one_of(levels);
  const capi::Method& method = capi::method_of(methods[source.below(methods.size())]);
  qtraj_options* made = nullptr;
  check(qtraj_options_create(method.value, &made) == QTRAJ_OK, "options_create", "no options");
  const capi::Options options(made);
  const size_t count = 1 + source.below(kMostSeries);
  Offsets key_rows(source, count, kMostKeys), rows(source, count, kMostSamples);
  const size_t keys = key_rows.row(count) + 1, samples = rows.row(count);
  const Array<double> key_times = knots(source, keys, level), times = query_times(source, key_times, samples, level);
  const Array<Real> q = quaternions<Real>(source, keys, level), omega(source, 3 * keys, Level::ordinary),
                    alpha(source, 3 * keys, Level::ordinary), q_out(source, 4 * samples),
                    expected(source, 4 * kMostSamples);
  const Array<int32_t> statuses(source, count);
  capi::BatchCall<Real> call;
  call.options = made, call.count = count;
  call.key_offsets = key_rows.at.data(), call.sample_offsets = rows.at.data();
  call.key_times = key_times.data(), call.key_q = q.data(), call.sample_times = times.data();
  call.key_omega = method.needs == capi::Needs::nothing ? nullptr : omega.data();
  call.key_alpha = method.needs == capi::Needs::omega_and_alpha ? alpha.data() : nullptr;
  call.with_rates = call.key_omega || source.one_in(2);
  call.q_out = q_out.data(), call.status_out = statuses.data();
  size_t bad_index = 0, bytes = 0;
  const bool is_hostile = source.one_in(8) && (source.one_in(2) ? key_rows : rows).spoil(source);
  const qtraj_status status = checked("batch_sample", [&] { return call(&bad_index); });
  digests.everywhere.add(static_cast<double>(status));
  digests.everywhere.add(static_cast<double>(bad_index));
  if (is_hostile) {
    check(status == QTRAJ_E_COUNT && bad_index < count, "batch_sample", "hostile offsets");
    check(q_out.is_untouched() && statuses.is_untouched(), "batch_sample", "written though refused");
    return;
  }
  size_t first = SIZE_MAX;
  check(qtraj_init_size(made, kMostKeys, &bytes) == QTRAJ_OK, "init_size", "no size");
  const Array<double> memory(source, bytes / sizeof(double));
  for (size_t k = 0; k < count; ++k) {
    const qtraj_status own = alone(call, key_rows, rows, k, memory.data(), bytes, expected.data());
    check(statuses[k] == own, "batch_sample", "a status differs from that of a loop");
    if (own != QTRAJ_OK && first == SIZE_MAX) first = k;
    for (size_t i = 0; i < rows.rows(k); ++i) {
      const Real* const row = q_out.data() + 4 * (rows.row(k) + i);
      const bool nan = q_out.row_is_nan(rows.row(k) + i, 4);
      check((nan && own != QTRAJ_OK) || std::memcmp(row, expected.data() + 4 * i, 4 * sizeof(Real)) == 0,
            "batch_sample", "a row differs from that of a loop");
    }
  }
  check(bad_index == first && status == (first == SIZE_MAX ? QTRAJ_OK : statuses[first]), "batch_sample", "status");
  digests.of_kind.add_all(q_out);
}

}  // namespace

void fuzz_batch(Source& source, Digests& digests) {
  source.one_in(2) ? fuzz_batch_of<float>(source, digests) : fuzz_batch_of<double>(source, digests);
}

}  // namespace fuzz
