// Random calls of the functions over arrays.
#include "fuzz.hpp"
#include "support/row_functions.hpp"

namespace fuzz {
namespace {

// ---- Functions from rows to rows ----

template <class Real>
void fuzz_row_function(Source& source, Level level, Digests& digests) {
  static const std::vector<test::RowFunction<Real>> functions = test::row_functions(Real());
  const test::RowFunction<Real>& function = functions[source.below(functions.size())];
  const size_t count = source.below(70);
  std::vector<Array<Real>> in, out, alone;
  std::vector<const Real*> inputs, row_inputs;
  std::vector<Real*> outputs, row_outputs;
  for (const test::RowInput& input : function.inputs) {
    in.push_back(input.width == 4 ? quaternions<Real>(source, count, level)
                                  : Array<Real>(source, input.width * count, level));
    inputs.push_back(in.back().data());
  }
  for (const size_t width : function.outputs) {
    out.emplace_back(source, width * count);
    alone.emplace_back(source, width);
    outputs.push_back(out.back().data());
    row_outputs.push_back(alone.back().data());
  }
  size_t bad_index = 0;
  const qtraj_status status =
      checked(function.name, [&] { return function.call(inputs.data(), count, outputs.data(), &bad_index); });
  digests.everywhere.add(static_cast<double>(status));
  digests.everywhere.add(static_cast<double>(bad_index));
  for (size_t k = 0; k < out.size(); ++k) {
    check_rows(function.name, out[k], function.outputs[k], status, bad_index);
    (function.is_same_everywhere() ? digests.everywhere : digests.of_kind).add_all(out[k]);
  }
  // a row alone
  if (count == 0) return;
  const size_t row = source.below(count);
  for (size_t k = 0; k < in.size(); ++k) row_inputs.push_back(inputs[k] + row * function.inputs[k].width);
  checked(function.name, [&] { return function.call(row_inputs.data(), 1, row_outputs.data(), nullptr); });
  for (size_t k = 0; k < out.size(); ++k) {
    const size_t width = function.outputs[k];
    const bool nan = alone[k].row_is_nan(0, width) && out[k].row_is_nan(row, width);
    check(nan || std::memcmp(alone[k].data(), out[k].data() + row * width, width * sizeof(Real)) == 0, function.name,
          "a row alone differs");
  }
}

// ---- Pairs ----

void fuzz_pairs(Source& source, Level level, Digests& digests) {
  const size_t pairs = source.one_in(3) ? 1 : source.below(40), count = pairs;
  const int32_t path = source.constant({QTRAJ_PATH_SHORTEST, QTRAJ_PATH_AS_GIVEN});
  const Array<double> a = quaternions<double>(source, pairs, level), b = quaternions<double>(source, pairs, level),
                      fractions(source, count, level);
  const Array<double> slerp(source, 4 * count), nlerp(source, 4 * count), one(source, 4 * count);
  size_t bad_index = 0;
  qtraj_status status = checked("slerp_pairs", [&] {
    return qtraj_slerp_pairs(a.data(), pairs, b.data(), pairs, fractions.data(), pairs, count, path, slerp.data(),
                             &bad_index);
  });
  const bool refused = path != QTRAJ_PATH_SHORTEST && path != QTRAJ_PATH_AS_GIVEN;
  if (refused) {
    check(status != QTRAJ_OK && slerp.is_untouched() && bad_index == SIZE_MAX, "slerp_pairs", "an unknown path");
    return;
  }
  check_rows("slerp_pairs", slerp, 4, status, bad_index);
  status = checked("nlerp_pairs", [&] {
    return qtraj_nlerp_pairs(a.data(), pairs, b.data(), pairs, fractions.data(), pairs, count, path, nlerp.data(),
                             &bad_index);
  });
  check_rows("nlerp_pairs", nlerp, 4, status, bad_index);
  digests.of_kind.add_all(slerp);
  digests.of_kind.add_all(nlerp);
  if (count == 0) return;
  status = checked(
      "slerp", [&] { return qtraj_slerp(a.data(), b.data(), fractions.data(), count, path, one.data(), &bad_index); });
  check_rows("slerp", one, 4, status, bad_index);
  digests.of_kind.add_all(one);
}

// ---- Keys ----

template <class Real>
qtraj_status make_continuous(const Real* q, size_t series, size_t length, Real* q_out, size_t* flips, size_t* bad) {
  if constexpr (sizeof(Real) == 8)
    return qtraj_make_continuous(q, series, length, q_out, flips, bad);
  else
    return qtraj_make_continuous_f32(q, series, length, q_out, flips, bad);
}

template <class Real>
void fuzz_keys(Source& source, Level level, Digests& digests) {
  const size_t series = source.below(4), length = source.below(50), count = series * length;
  const Array<Real> q = quaternions<Real>(source, count, level), out(source, 4 * count), again(source, 4 * count);
  size_t flips = 0, bad_index = 0;
  qtraj_status status = checked(
      "make_continuous", [&] { return make_continuous(q.data(), series, length, out.data(), &flips, &bad_index); });
  check_rows("make_continuous", out, 4, status, bad_index);
  check(flips <= count, "make_continuous", "too many flips");
  digests.everywhere.add_all(out);
  if (status != QTRAJ_OK) return;
  status = checked("make_continuous",
                   [&] { return make_continuous(out.data(), series, length, again.data(), &flips, &bad_index); });
  check(status == QTRAJ_OK && flips == 0, "make_continuous", "what is continuous is changed");
}

// ---- Means ----

void fuzz_means(Source& source, Level level, Digests& digests) {
  const size_t count = source.below(60);
  const Array<double> q = quaternions<double>(source, count, level), weights(source, count, level), eigen(source, 4),
                      karcher(source, 4);
  for (size_t i = 0; i < count; ++i)
    if (level != Level::any && !std::signbit(weights[i])) weights[i] = std::abs(weights[i]);
  const double* const weights_or_null = source.one_in(2) ? weights.data() : nullptr;
  double eigengap = 0, residual = 0;
  size_t bad_index = 0;
  int32_t iterations = 0;
  const int32_t most = source.one_in(3) ? static_cast<int32_t>(source.below(4)) : 100;
  const auto judge = [&](const char* name, const Array<double>& mean, qtraj_status status) {
    const bool valid = status == QTRAJ_OK || status == QTRAJ_E_AMBIGUOUS || status == QTRAJ_E_NO_CONVERGENCE;
    check(mean.is_untouched() || mean.row_is_nan(0, 4) || mean.row_is_finite(0, 4), name, "a mean half written");
    check(!valid || (mean.row_is_finite(0, 4) && bad_index == SIZE_MAX), name, "a mean that is none");
  };
  qtraj_status status = checked("mean_eigen", [&] {
    return qtraj_mean_eigen(q.data(), weights_or_null, count, eigen.data(), &eigengap, &bad_index);
  });
  judge("mean_eigen", eigen, status);
  digests.everywhere.add_all(eigen);
  digests.everywhere.add(static_cast<double>(status));
  status = checked("mean_karcher", [&] {
    return qtraj_mean_karcher(q.data(), weights_or_null, count, 0, most, karcher.data(), &iterations, &residual,
                              &bad_index);
  });
  judge("mean_karcher", karcher, status);
  check(iterations >= 0 && iterations <= most, "mean_karcher", "too many iterations");
  digests.of_kind.add_all(karcher);
}

// ---- Samples, SQUAD's controls, the spline, even times ----

void fuzz_samples(Source& source, Level level, Digests& digests) {
  const size_t count = 3 + source.below(50);
  const int32_t frame = source.one_in(2) ? QTRAJ_FRAME_BODY : QTRAJ_FRAME_WORLD;
  const Array<double> times = knots(source, count, level), q = quaternions<double>(source, count, level),
                      key_times = query_times(source, times, 20, level), key_q = quaternions<double>(source, 20, level);
  const Array<double> middles(source, count - 1), omega(source, 3 * (count - 1)), jumps(source, 60), errors(source, 20),
      a(source, 4 * count), b(source, 4 * count);
  double energy = 0;
  size_t bad_index = 0;
  qtraj_status status = checked("estimate_omega", [&] {
    return qtraj_estimate_omega(frame, times.data(), q.data(), count, middles.data(), omega.data(), &bad_index);
  });
  for (size_t row = 0; row + 1 < count; ++row)
    check(omega.row_is_finite(row, 3) || (status != QTRAJ_OK && omega.row_is_nan(row, 3)), "estimate_omega", "a row");
  status = checked("estimate_energy",
                   [&] { return qtraj_estimate_energy(frame, times.data(), q.data(), count, &energy, &bad_index); });
  check((status == QTRAJ_OK || status == QTRAJ_E_AMBIGUOUS) == is_finite(energy), "estimate_energy", "no energy");
  status = checked("estimate_jumps", [&] {
    return qtraj_estimate_jumps(frame, times.data(), q.data(), count, key_times.data(), 20, jumps.data(), &bad_index);
  });
  for (size_t row = 0; row < 20; ++row)
    check(jumps.row_is_finite(row, 3) || (status != QTRAJ_OK && jumps.row_is_nan(row, 3)), "estimate_jumps", "a row");
  status = checked("keyframe_errors", [&] {
    return qtraj_keyframe_errors(key_times.data(), key_q.data(), 20, times.data(), q.data(), count, errors.data(),
                                 nullptr, &bad_index);
  });
  // a fault among the samples, whose indices come after those of the keys, may make any row NaN
  check_rows("keyframe_errors", errors, 1, status, SIZE_MAX);
  checked("squad_controls",
          [&] { return qtraj_squad_controls(times.data(), q.data(), count, a.data(), b.data(), &bad_index); });
  for (const Array<double>* output : {&omega, &jumps, &a, &b}) digests.everywhere.add_all(*output);
  digests.of_kind.add_all(errors);
}

void fuzz_spline(Source& source, Level level, Digests& digests) {
  const size_t count = source.below(20), width = source.below(4), queries = 1 + source.below(30);
  const int32_t end = source.constant({QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_PERIODIC});
  const Array<double> x = knots(source, count, level), y(source, count * width, level);
  const Array<double> at = count > 0 ? query_times(source, x, queries, level) : Array<double>(source, queries, level);
  const Array<double> out(source, queries * width);
  size_t bad_index = 0;
  const qtraj_status status = checked("cubic_spline", [&] {
    return qtraj_cubic_spline(x.data(), y.data(), count, width, end, end, at.data(), queries, out.data(), &bad_index);
  });
  if (count < 2) check(status != QTRAJ_OK && out.is_untouched(), "cubic_spline", "too few points");
  // a point at fault makes all rows NaN; queries are counted after the points
  const size_t bad_row = bad_index == SIZE_MAX ? SIZE_MAX : bad_index < count ? 0 : bad_index - count;
  if (width > 0 && !out.is_untouched()) check_rows("cubic_spline", out, width, status, bad_row);
  digests.everywhere.add_all(out);
}

void fuzz_even_times(Source& source, Level level, Digests& digests) {
  const size_t count = source.below(60);
  const double first = source.number<double>(level), last = source.number<double>(level);
  const Array<double> times(source, count);
  const qtraj_status status = checked("even_times", [&] { return qtraj_even_times(first, last, count, times.data()); });
  check_rows("even_times", times, 1, status, SIZE_MAX);
  for (size_t i = 1; i < count && status == QTRAJ_OK; ++i)
    check(times[i - 1] <= times[i] && times[i] <= last, "even_times", "out of order");
  digests.everywhere.add_all(times);
}

}  // namespace

void fuzz_arrays(Source& source, Digests& digests) {
  const Level levels[] = {Level::ordinary, Level::finite, Level::any};
  const Level level = source.one_of(levels);
  switch (source.below(9)) {
    case 0:
    case 1:
      return fuzz_row_function<double>(source, level, digests);
    case 2:
      return fuzz_row_function<float>(source, level, digests);
    case 3:
      return fuzz_pairs(source, level, digests);
    case 4:
      return source.one_in(2) ? fuzz_keys<double>(source, level, digests) : fuzz_keys<float>(source, level, digests);
    case 5:
      return fuzz_means(source, level, digests);
    case 6:
      return fuzz_samples(source, level, digests);
    case 7:
      return fuzz_spline(source, level, digests);
    default:
      return fuzz_even_times(source, level, digests);
  }
}

}  // namespace fuzz
