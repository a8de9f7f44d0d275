// Random trajectories: created and made in place, sampled by every function, asked.
#include "fuzz.hpp"
#include "support/capi_handles.hpp"

namespace fuzz {
namespace {

using capi::Trajectory;
using capi::Variant;

capi::Options make_options(Source& source, const Variant& variant) {
  qtraj_options* options = nullptr;
  check(qtraj_options_create(variant.method, &options) == QTRAJ_OK, "options_create", "no options");
  capi::Options owner(options);
  if (variant.end != QTRAJ_END_DEFAULT) qtraj_options_set_ends(options, variant.end, variant.end);
  if (variant.end == QTRAJ_END_GIVEN) {
    const double omega[] = {source.uniform(-1, 1), source.number<double>(Level::finite), 0};
    checked("set_end_rates", [&] { return qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, omega, omega); });
  }
  if (variant.tangents != QTRAJ_TANGENT_DEFAULT) qtraj_options_set_tangents(options, variant.tangents);
  const double q[] = {1, 0.2, 0.3, -0.1};
  if (variant.reference != QTRAJ_REFERENCE_DEFAULT)
    qtraj_options_set_reference(options, variant.reference, variant.reference == QTRAJ_REFERENCE_GIVEN ? q : nullptr);
  const int32_t rules[] = {QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE};
  const int32_t before = source.one_of(rules), after = source.one_of(rules);
  checked("set_extrapolation", [&] { return qtraj_options_set_extrapolation(options, before, after); });
  return owner;
}

// Every sampler gives the row that the batch has.
template <class Real>
void fuzz_sampling(Source& source, const qtraj_trajectory* curve, const Array<double>& times, Digests& digests) {
  const size_t count = times.count();
  const int32_t frame = source.one_in(2) ? QTRAJ_FRAME_BODY : QTRAJ_FRAME_WORLD;
  const Array<Real> q(source, 4 * count), same(source, 4 * count), omega(source, 3 * count), alpha(source, 3 * count),
      row(source, 4);
  size_t bad_index = 0, cursor = source.below(100);
  const qtraj_status status =
      checked("sample", [&] { return capi::sample(curve, times.data(), count, q.data(), &bad_index); });
  check_rows("sample", q, 4, status, bad_index);
  checked("sample_rates", [&] {
    return capi::sample_rates(curve, frame, times.data(), count, same.data(), omega.data(), alpha.data(), nullptr);
  });
  for (size_t i = 0; i < count; ++i) {
    checked("sample_at", [&] { return capi::sample_at(curve, times[i], &cursor, row.data()); });
    const bool nan = row.row_is_nan(0, 4) && q.row_is_nan(i, 4);
    check(nan || std::memcmp(row.data(), q.data() + 4 * i, 4 * sizeof(Real)) == 0, "sample_at", "differs from sample");
    check(same.row_is_nan(i, 4) || std::memcmp(same.data() + 4 * i, q.data() + 4 * i, 4 * sizeof(Real)) == 0,
          "sample_rates", "differs from sample");
    check(omega.row_is_finite(i, 3) || omega.row_is_nan(i, 3), "sample_rates", "omega neither finite nor NaN");
    check(alpha.row_is_finite(i, 3) || alpha.row_is_nan(i, 3), "sample_rates", "alpha neither finite nor NaN");
  }
  for (const Array<Real>* output : {&q, &omega, &alpha}) digests.of_kind.add_all(*output);
}

void ask(Source& source, const qtraj_trajectory* curve, size_t count) {
  const Array<double> times(source, count), q(source, 4 * count), omega(source, 3 * count), alpha(source, 3 * count);
  check(checked("keys", [&] { return qtraj_keys(curve, times.data(), q.data()); }) == QTRAJ_OK, "keys", "no keys");
  check(qtraj_key_count(curve) == count && qtraj_sign_flips(curve) < count, "getters", "counts");
  check(qtraj_least_dot(curve) >= -1e-6 && qtraj_least_dot(curve) <= 1 + 1e-15, "least_dot", "out of range");
  checked("curve_jumps", [&] { return qtraj_curve_jumps(curve, QTRAJ_FRAME_BODY, omega.data(), alpha.data()); });
  double numbers[3] = {0, 0, 0};
  if (count > 4 || !source.one_in(4)) return;
  if (checked("curve_energy", [&] { return qtraj_curve_energy(curve, numbers); }) == QTRAJ_OK)
    check(is_finite(numbers[0]) && numbers[0] >= 0, "curve_energy", "no energy");
  if (checked("curve_total_angle", [&] { return qtraj_curve_total_angle(curve, numbers); }) == QTRAJ_OK)
    check(is_finite(numbers[0]) && numbers[0] >= 0, "curve_total_angle", "no angle");
  if (checked("curve_peak_rates",
              [&] { return qtraj_curve_peak_rates(curve, numbers, nullptr, numbers + 1, nullptr); }) == QTRAJ_OK)
    check(is_finite(numbers[0]) && is_finite(numbers[1]), "curve_peak_rates", "no peaks");
}

template <class Real>
void fuzz_curve_of(Source& source, Digests& digests) {
  static const std::vector<Variant> variants = capi::variants();
  const Level levels[] = {Level::ordinary, Level::ordinary, Level::finite, Level::any};
  const Level level = source.one_of(levels), rate_level = source.one_in(3) ? level : Level::ordinary;
  const Variant& variant = variants[source.below(variants.size())];
  const size_t count = 2 + source.below(source.one_in(8) ? 300 : 12);
  const Array<double> times = knots(source, count, level);
  const Array<Real> q = quaternions<Real>(source, count, level), omega(source, 3 * count, rate_level),
                    alpha(source, 3 * count, rate_level);
  const size_t tangents = variant.needs_tangents() ? 4 * count : 0;
  const Array<Real> in_tangents(source, tangents, rate_level), out_tangents(source, tangents, rate_level);
  if (variant.end == QTRAJ_END_PERIODIC && !source.one_in(8))
    for (size_t k = 0; k < 4; ++k) q[4 * (count - 1) + k] = q[k];
  const Real* const omega_or_null = variant.needs_rates() ? omega.data() : nullptr;
  const Real* const alpha_or_null = variant.needs_alpha() ? alpha.data() : nullptr;
  const capi::Options options = make_options(source, variant);

  size_t bytes = 0, bad_index = 0, same_index = 0;
  check(qtraj_init_size(options.get(), count, &bytes) == QTRAJ_OK, "init_size", "no size");
  qtraj_trajectory *made = nullptr, *placed = nullptr;
  const int32_t frame = variant.needs_rates() ? QTRAJ_FRAME_BODY : 0;
  const qtraj_status status = checked("create", [&] {
    if (variant.needs_tangents())
      return capi::create_with_tangents(options.get(), times.data(), q.data(), in_tangents.data(), out_tangents.data(),
                                        count, &made, &bad_index);
    return omega_or_null ? capi::create_with_rates(options.get(), frame, times.data(), q.data(), omega_or_null,
                                                   alpha_or_null, count, &made, &bad_index)
                         : capi::create_with_options(options.get(), times.data(), q.data(), count, &made, &bad_index);
  });
  const Trajectory owner(made);
  digests.everywhere.add(static_cast<double>(status));
  digests.everywhere.add(static_cast<double>(bad_index));
  check((status == QTRAJ_OK) == (made != nullptr), "create", "status and handle");
  check(bad_index == SIZE_MAX || (status != QTRAJ_OK && bad_index < count), "create", "index");
  if (bytes <= Rooms::kBytes) {
    const Array<double> memory(source, bytes / sizeof(double));
    const qtraj_status in_place = checked("init", [&] {
      if (variant.needs_tangents())
        return capi::init_with_tangents(memory.data(), bytes, options.get(), times.data(), q.data(), in_tangents.data(),
                                        out_tangents.data(), count, &placed, &same_index);
      return capi::init(memory.data(), bytes, options.get(), frame, times.data(), q.data(), omega_or_null,
                        alpha_or_null, count, &placed, &same_index);
    });
    check(in_place == status && same_index == bad_index, "init", "differs from create");
  }
  if (status != QTRAJ_OK) return;

  ask(source, made, count);
  const Array<double> at = query_times(source, times, 1 + source.below(60), level);
  const qtraj_trajectory* const curve = placed && source.one_in(2) ? placed : made;
  fuzz_sampling<double>(source, curve, at, digests);
  fuzz_sampling<float>(source, curve, at, digests);
}

}  // namespace

void fuzz_curve(Source& source, Digests& digests) {
  source.one_in(3) ? fuzz_curve_of<float>(source, digests) : fuzz_curve_of<double>(source, digests);
}

}  // namespace fuzz
