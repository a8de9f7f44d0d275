// Random vector curves: created and made in place, sampled by every function; and poses with them.
#include <algorithm>

#include "fuzz.hpp"
#include "support/vector_handles.hpp"

namespace fuzz {
namespace {

using capi::VectorVariant;

// Options of a variant with rules at both ends, and now and then a longest gap or a period.
capi::Options make_options(Source& source, const VectorVariant& variant) {
  qtraj_options* options = nullptr;
  check(qtraj_options_create(variant.method, &options) == QTRAJ_OK, "options_create", "no options");
  capi::Options owner(options);
  if (variant.method == QTRAJ_VECTOR_CUBIC) qtraj_options_set_ends(options, variant.start, variant.end);
  const int32_t rules[] = {QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE};
  const bool wraps = source.one_in(8);
  const int32_t before = wraps ? QTRAJ_EXTRAPOLATE_PERIODIC : source.one_of(rules),
                after = wraps ? QTRAJ_EXTRAPOLATE_PERIODIC : source.one_of(rules);
  checked("set_extrapolation", [&] { return qtraj_options_set_extrapolation(options, before, after); });
  if (source.one_in(8)) qtraj_options_set_longest_gap(options, source.power(-3, 1));
  if (source.one_in(8)) qtraj_options_set_period(options, source.power(-3, 3));
  return owner;
}

// Outputs, some of them none.
template <class Real>
struct Outputs {
  Array<Real> value, first, second;
  bool asked[3];

  Outputs(Source& source, size_t numbers) : value(source, numbers), first(source, numbers), second(source, numbers) {
    for (bool& one : asked) one = !source.one_in(4);
    if (!asked[1] && !asked[2]) asked[0] = true;
  }
  Real* at(size_t which, size_t number = 0) const {
    const Array<Real>& array = which == 0 ? value : which == 1 ? first : second;
    return asked[which] ? array.data() + number : nullptr;
  }
};

// Every sampler gives the row that the batch has.
template <class Real>
void fuzz_sampling(Source& source, const qtraj_vector_curve* curve, const Array<double>& times, Digests& digests) {
  const size_t count = times.count(), dim = qtraj_vector_dim(curve);
  const Outputs<Real> all(source, dim * count);
  const Array<Real> value(source, dim), first(source, dim), second(source, dim);
  const Real* const one[] = {value.data(), first.data(), second.data()};
  size_t bad_index = 0, cursor = source.below(100);
  const qtraj_status status = checked("vector_sample", [&] {
    return capi::vector_sample(curve, times.data(), count, all.at(0), all.at(1), all.at(2), &bad_index);
  });
  check(bad_index == SIZE_MAX || bad_index < count, "vector_sample", "index");
  const Array<Real>* const arrays[] = {&all.value, &all.first, &all.second};
  for (size_t k = 0; k < 3; ++k) {
    if (!all.asked[k]) continue;
    check_rows("vector_sample", *arrays[k], dim, status, bad_index);
    digests.everywhere.add_all(*arrays[k]);
  }
  for (size_t i = 0; i < count; ++i) {
    checked("vector_sample_at", [&] {
      return capi::vector_sample_at(curve, times[i], &cursor, all.asked[0] ? value.data() : nullptr,
                                    all.asked[1] ? first.data() : nullptr, all.asked[2] ? second.data() : nullptr);
    });
    for (size_t k = 0; k < 3; ++k) {
      if (!all.asked[k]) continue;
      const Array<Real>& row = k == 0 ? value : k == 1 ? first : second;
      const bool nan = row.row_is_nan(0, dim) && arrays[k]->row_is_nan(i, dim);
      check(nan || std::memcmp(one[k], all.at(k, dim * i), dim * sizeof(Real)) == 0, "vector_sample_at",
            "differs from vector_sample");
    }
  }
}

// A pose is whole or missing, and what there is equals the samples of the curves.
template <class Real>
void fuzz_poses(Source& source, const qtraj_vector_curve* positions, const Array<double>& times) {
  const double key_times[] = {-3, 0.5, 1, 7}, q[] = {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0, 1, 0, 0, 0, 0.6, 0.8, 0};
  qtraj_trajectory* made = nullptr;
  qtraj_create(QTRAJ_SLERP, key_times, q, 4, &made, nullptr);
  const capi::Trajectory trajectory(made);
  const size_t count = times.count(), dim = qtraj_vector_dim(positions);
  const Array<Real> q_out(source, 4 * count), p_out(source, dim * count), q_alone(source, 4), p_alone(source, dim);
  const auto sample = [&](size_t row, size_t rows, const Array<Real>& to_q, const Array<Real>& to_p, size_t* bad) {
    Real* const none = nullptr;
    if constexpr (sizeof(Real) == 8)
      return qtraj_sample_poses(made, positions, QTRAJ_FRAME_BODY, times.data() + row, rows, to_q.data(), none, none,
                                to_p.data(), none, none, bad);
    else
      return qtraj_sample_poses_f32(made, positions, QTRAJ_FRAME_BODY, times.data() + row, rows, to_q.data(), none,
                                    none, to_p.data(), none, none, bad);
  };
  size_t bad_index = 0;
  const qtraj_status status = checked("sample_poses", [&] { return sample(0, count, q_out, p_out, &bad_index); });
  check_rows("sample_poses", q_out, 4, status, bad_index);
  check_rows("sample_poses", p_out, dim, status, bad_index);
  for (size_t i = 0; i < count; ++i) {
    const bool missing = q_out.row_is_nan(i, 4);
    check(missing == p_out.row_is_nan(i, dim), "sample_poses", "half a pose");
    const bool alone = checked("sample_poses", [&] { return sample(i, 1, q_alone, p_alone, nullptr); }) == QTRAJ_OK;
    check(alone != missing, "sample_poses", "a pose alone differs");
    check(missing || (std::memcmp(q_alone.data(), q_out.data() + 4 * i, 4 * sizeof(Real)) == 0 &&
                      std::memcmp(p_alone.data(), p_out.data() + dim * i, dim * sizeof(Real)) == 0),
          "sample_poses", "a pose alone differs");
  }
}

template <class Real>
void fuzz_vectors_of(Source& source, Digests& digests) {
  const Level levels[] = {Level::ordinary, Level::ordinary, Level::finite, Level::any};
  const Level level = source.one_of(levels), rate_level = source.one_in(3) ? level : Level::ordinary;
  const std::vector<VectorVariant>& variants = capi::vector_variants();
  const VectorVariant& variant = variants[source.below(variants.size())];
  const size_t count = 2 + source.below(source.one_in(8) ? 150 : 12), dim = 1 + source.below(6);
  const Array<double> times = knots(source, count, level);
  const Array<Real> values(source, dim * count, Level::ordinary),
      first(source, dim * variant.first_rows(count), rate_level), second(source, dim * count, rate_level);
  for (size_t i = 0; level != Level::ordinary && i < values.count(); ++i)
    if (source.one_in(30)) values[i] = source.number<Real>(level);
  if (!source.one_in(8))
    for (size_t c = 0; c < dim; ++c) values[dim * (count - 1) + c] = values[c];
  const Real* const first_or_null = variant.needs_first() ? first.data() : nullptr;
  const Real* const second_or_null = variant.needs_second() ? second.data() : nullptr;
  const capi::Options options = make_options(source, variant);

  size_t bytes = 0, bad_index = 0, same_index = 0;
  check(qtraj_vector_init_size(options.get(), count, dim, &bytes) == QTRAJ_OK, "vector_init_size", "no size");
  qtraj_vector_curve *made = nullptr, *placed = nullptr;
  const qtraj_status status = checked("vector_create", [&] {
    return capi::vector_create(options.get(), times.data(), values.data(), first_or_null, second_or_null, count, dim,
                               &made, &bad_index);
  });
  const capi::VectorCurve owner(made);
  digests.everywhere.add(static_cast<double>(status));
  digests.everywhere.add(static_cast<double>(bad_index));
  check((status == QTRAJ_OK) == (made != nullptr), "vector_create", "status and handle");
  check(bad_index == SIZE_MAX || (status != QTRAJ_OK && bad_index < count), "vector_create", "index");
  if (bytes <= Rooms::kBytes) {
    const Array<double> memory(source, bytes / sizeof(double));
    const qtraj_status in_place = checked("vector_init", [&] {
      return capi::vector_init(memory.data(), bytes, options.get(), times.data(), values.data(), first_or_null,
                               second_or_null, count, dim, &placed, &same_index);
    });
    check(in_place == status && same_index == bad_index, "vector_init", "differs from vector_create");
  }
  if (status != QTRAJ_OK) return;

  const Array<double> at = query_times(source, times, 1 + source.below(60), level);
  const qtraj_vector_curve* const curve = placed && source.one_in(2) ? placed : made;
  const Array<double> key_times(source, qtraj_vector_key_count(curve)),
      keys(source, dim * qtraj_vector_key_count(curve));
  check(checked("vector_keys", [&] { return qtraj_vector_keys(curve, key_times.data(), keys.data()); }) == QTRAJ_OK,
        "vector_keys", "no keys");
  double largest = 0;
  for (size_t i = 0; i < dim * count; ++i) largest = std::max(largest, std::abs(static_cast<double>(values[i])));
  for (size_t i = 0; i < dim * (count - 1); ++i)  // the last may have been closed
    check(std::abs(keys[i] - static_cast<double>(values[i])) <= 1e-300 * largest, "vector_keys", "not the key");
  fuzz_sampling<double>(source, curve, at, digests);
  fuzz_sampling<float>(source, curve, at, digests);
  if (source.one_in(2))
    fuzz_poses<double>(source, curve, at);
  else
    fuzz_poses<float>(source, curve, at);
}

}  // namespace

void fuzz_vectors(Source& source, Digests& digests) {
  source.one_in(3) ? fuzz_vectors_of<float>(source, digests) : fuzz_vectors_of<double>(source, digests);
}

}  // namespace fuzz
