// Options: what each method's setters take and refuse, and that a refusal leaves no trace.
#include <algorithm>
#include <array>
#include <limits>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

Options options_of(int32_t method) {
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(method, &options) == QTRAJ_OK);
  return Options(options);
}

// What options do: samples of a curve built with them, or the status where there is none.
std::vector<double> effect_of(const qtraj_options* options) {
  const Keyframes<double> keys = closed_tour<double>(7);
  const std::vector<double> rate(21, 0.1);
  Built built = build(options, keys);
  if (built.status == QTRAJ_E_INPUT_MISSING) built = build(options, keys, Rates<double>{rate, {}});
  if (built.status == QTRAJ_E_INPUT_MISSING) built = build(options, keys, Rates<double>{rate, rate});
  const std::vector<double> tangents(28, 0.1);
  if (built.status == QTRAJ_E_INPUT_MISSING) built = build(options, keys, Rates<double>{{}, {}, tangents, tangents});
  if (built.status != QTRAJ_OK) return {static_cast<double>(built.status)};
  std::vector<double> times = times_in(keys.times, 3), q(4 * times.size() + 8);
  times.insert(times.end(), {-100.25, 100.25});
  sample(built.trajectory.get(), times.data(), times.size(), q.data(), nullptr);
  return q;
}

bool is_one_of(int32_t value, const std::vector<int32_t>& values) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

struct MethodSettings {
  int32_t method;
  std::vector<int32_t> ends, tangents, references;
};
const std::vector<MethodSettings>& table() {
  static const std::vector<MethodSettings> rows = {
      {QTRAJ_SLERP, {}, {}, {}},
      {QTRAJ_NLERP, {}, {}, {}},
      {QTRAJ_SQUAD,
       {QTRAJ_END_DEFAULT, QTRAJ_END_CHORD, QTRAJ_END_ESTIMATED, QTRAJ_END_GIVEN, QTRAJ_END_PERIODIC},
       {QTRAJ_TANGENT_DEFAULT, QTRAJ_TANGENT_CATMULL_ROM, QTRAJ_TANGENT_MEAN_VELOCITY, QTRAJ_TANGENT_GIVEN,
        QTRAJ_TANGENT_REST},
       {}},
      {QTRAJ_LOG_SPLINE,
       {QTRAJ_END_DEFAULT, QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_PERIODIC},
       {},
       {QTRAJ_REFERENCE_DEFAULT, QTRAJ_REFERENCE_FIRST, QTRAJ_REFERENCE_MEAN, QTRAJ_REFERENCE_GIVEN}},
      {QTRAJ_ROTATION_SPLINE,
       {QTRAJ_END_DEFAULT, QTRAJ_END_CHORD, QTRAJ_END_NATURAL, QTRAJ_END_ESTIMATED, QTRAJ_END_GIVEN,
        QTRAJ_END_PERIODIC},
       {},
       {}},
      {QTRAJ_HERMITE, {}, {}, {}},
      {QTRAJ_ROTATION_QUINTIC, {}, {}, {}},
      {QTRAJ_QUATERNION_QUINTIC, {}, {}, {}},
      {QTRAJ_QUATERNION_HERMITE, {}, {}, {}},
  };
  return rows;
}

// Every constant of a family, and numbers that are none.
std::vector<int32_t> candidates(int32_t first, int32_t last) {
  std::vector<int32_t> values(std::begin(kUnknown), std::end(kUnknown));
  values.push_back(0);
  for (int32_t value = first; value <= last; ++value) values.push_back(value);
  return values;
}

bool is_constant(int32_t value, int32_t first, int32_t last) { return value == 0 || (value >= first && value <= last); }

TEST_CASE("C API: every method takes its own end conditions, periodic on both ends or none", "[capi][options]") {
  for (const MethodSettings& row : table())
    for (const int32_t start : candidates(QTRAJ_END_CHORD, QTRAJ_END_PERIODIC))
      for (const int32_t end : candidates(QTRAJ_END_CHORD, QTRAJ_END_PERIODIC)) {
        CAPTURE(row.method, start, end);
        const bool one_periodic = (start == QTRAJ_END_PERIODIC) != (end == QTRAJ_END_PERIODIC);
        const bool has_both = is_one_of(start, row.ends) && is_one_of(end, row.ends);
        const auto known = [](int32_t value) { return is_constant(value, QTRAJ_END_CHORD, QTRAJ_END_PERIODIC); };
        const bool valid = known(start) && known(end) && !one_periodic;
        const Options options = options_of(row.method);
        CHECK(qtraj_options_set_ends(options.get(), start, end) == (!valid      ? QTRAJ_E_VALUE
                                                                    : !has_both ? QTRAJ_E_SETTING
                                                                                : QTRAJ_OK));
      }
}

TEST_CASE("C API: tangents and reference are settings of the methods that have them", "[capi][options]") {
  const double q_wb[4] = {1, 2, 3, 4};
  for (const MethodSettings& row : table()) {
    const Options options = options_of(row.method);
    for (const int32_t rule : candidates(QTRAJ_TANGENT_CATMULL_ROM, QTRAJ_TANGENT_REST)) {
      CAPTURE(row.method, rule);
      const bool known = is_constant(rule, QTRAJ_TANGENT_CATMULL_ROM, QTRAJ_TANGENT_REST);
      const qtraj_status expected = !known ? QTRAJ_E_VALUE : is_one_of(rule, row.tangents) ? QTRAJ_OK : QTRAJ_E_SETTING;
      CHECK(qtraj_options_set_tangents(options.get(), rule) == expected);
    }
    for (const int32_t rule : candidates(QTRAJ_REFERENCE_FIRST, QTRAJ_REFERENCE_GIVEN)) {
      CAPTURE(row.method, rule);
      const bool known = is_constant(rule, QTRAJ_REFERENCE_FIRST, QTRAJ_REFERENCE_GIVEN);
      const qtraj_status expected = !known                            ? QTRAJ_E_VALUE
                                    : is_one_of(rule, row.references) ? QTRAJ_OK
                                                                      : QTRAJ_E_SETTING;
      CHECK(qtraj_options_set_reference(options.get(), rule, rule == QTRAJ_REFERENCE_GIVEN ? q_wb : nullptr) ==
            expected);
      // and an orientation that the rule does not use, or lacks
      CHECK(qtraj_options_set_reference(options.get(), rule, rule == QTRAJ_REFERENCE_GIVEN ? nullptr : q_wb) ==
            (rule == QTRAJ_REFERENCE_GIVEN ? QTRAJ_E_NULL : QTRAJ_E_VALUE));
    }
  }
}

TEST_CASE("C API: every method extrapolates by every rule, periodic on both sides or none", "[capi][options]") {
  for (const int32_t method : all_methods())
    for (const int32_t before : candidates(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_PERIODIC))
      for (const int32_t after : candidates(QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_PERIODIC)) {
        CAPTURE(method, before, after);
        const auto known = [](int32_t rule) {
          return is_constant(rule, QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_PERIODIC);
        };
        const bool one_wraps = (before == QTRAJ_EXTRAPOLATE_PERIODIC) != (after == QTRAJ_EXTRAPOLATE_PERIODIC);
        const bool fine = known(before) && known(after) && !one_wraps;
        const Options options = options_of(method);
        CHECK(qtraj_options_set_extrapolation(options.get(), before, after) == (fine ? QTRAJ_OK : QTRAJ_E_VALUE));
      }
}

TEST_CASE("C API: end rates go to the ends that are GIVEN, and only there", "[capi][options]") {
  const double omega[3] = {0.1, 0.2, 0.3};
  for (const int32_t method : {QTRAJ_SQUAD, QTRAJ_ROTATION_SPLINE})
    for (const int32_t start : {QTRAJ_END_DEFAULT, QTRAJ_END_CHORD, QTRAJ_END_GIVEN})
      for (const int32_t end : {QTRAJ_END_DEFAULT, QTRAJ_END_ESTIMATED, QTRAJ_END_GIVEN})
        for (const bool at_start : {false, true})
          for (const bool at_end : {false, true}) {
            CAPTURE(method, start, end, at_start, at_end);
            const bool missing = (start == QTRAJ_END_GIVEN && !at_start) || (end == QTRAJ_END_GIVEN && !at_end);
            const bool superfluous = (start != QTRAJ_END_GIVEN && at_start) || (end != QTRAJ_END_GIVEN && at_end);
            const qtraj_status expected = missing       ? QTRAJ_E_INPUT_MISSING
                                          : superfluous ? QTRAJ_E_INPUT_UNWANTED
                                                        : QTRAJ_OK;
            const Options options = options_of(method);
            REQUIRE(qtraj_options_set_ends(options.get(), start, end) == QTRAJ_OK);
            CHECK(qtraj_options_set_end_rates(options.get(), QTRAJ_FRAME_WORLD, at_start ? omega : nullptr,
                                              at_end ? omega : nullptr) == expected);
          }
}

TEST_CASE("C API: methods without given ends refuse end rates", "[capi][options]") {
  const double omega[3] = {0.1, 0.2, 0.3};
  for (const int32_t method :
       {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_LOG_SPLINE, QTRAJ_HERMITE, QTRAJ_ROTATION_QUINTIC, QTRAJ_QUATERNION_QUINTIC}) {
    const Options options = options_of(method);
    CHECK(qtraj_options_set_end_rates(options.get(), QTRAJ_FRAME_BODY, omega, omega) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_end_rates(options.get(), QTRAJ_FRAME_BODY, nullptr, nullptr) == QTRAJ_E_SETTING);
  }
}

TEST_CASE("C API: a setter that fails has no effect", "[capi][options]") {
  const double omega[3] = {0.3, -0.2, 0.1}, other[3] = {9, 9, 9}, q_wb[4] = {1, 0.5, 0, 0.25};
  const double not_finite[][4] = {{kNaN, 0, 0, 0}, {0, -kInfinity, 0, 1}, {1, 0, kInfinity, 0}};
  const double zero[4] = {0, -0.0, 0, 0};

  SECTION("of SQUAD") {
    const Options squad = options_of(QTRAJ_SQUAD);
    qtraj_options* options = squad.get();
    REQUIRE(qtraj_options_set_ends(options, QTRAJ_END_GIVEN, QTRAJ_END_GIVEN) == QTRAJ_OK);
    REQUIRE(qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, omega, omega) == QTRAJ_OK);
    REQUIRE(qtraj_options_set_tangents(options, QTRAJ_TANGENT_MEAN_VELOCITY) == QTRAJ_OK);
    REQUIRE(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
            QTRAJ_OK);
    const std::vector<double> before = effect_of(options);

    CHECK(qtraj_options_set_ends(options, QTRAJ_END_CHORD, QTRAJ_END_NATURAL) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_ends(options, QTRAJ_END_CHORD, QTRAJ_END_PERIODIC) == QTRAJ_E_VALUE);
    CHECK(qtraj_options_set_end_rates(options, QTRAJ_FRAME_WORLD, other, nullptr) == QTRAJ_E_INPUT_MISSING);
    CHECK(qtraj_options_set_end_rates(options, 0, other, other) == QTRAJ_E_VALUE);
    for (const double(&bad)[4] : not_finite) {
      CHECK(qtraj_options_set_end_rates(options, QTRAJ_FRAME_WORLD, other, bad) == QTRAJ_E_NOT_FINITE);
      CHECK(qtraj_options_set_end_rates(options, QTRAJ_FRAME_WORLD, bad, other) == QTRAJ_E_NOT_FINITE);
    }
    CHECK(qtraj_options_set_tangents(options, 1000) == QTRAJ_E_VALUE);
    CHECK(qtraj_options_set_reference(options, QTRAJ_REFERENCE_MEAN, nullptr) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_ERROR, -1) == QTRAJ_E_VALUE);
    CHECK(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_HOLD) ==
          QTRAJ_E_VALUE);
    CHECK(same_bits(effect_of(options), before));
  }
  SECTION("of LOG_SPLINE") {
    const Options spline = options_of(QTRAJ_LOG_SPLINE);
    qtraj_options* options = spline.get();
    REQUIRE(qtraj_options_set_reference(options, QTRAJ_REFERENCE_GIVEN, q_wb) == QTRAJ_OK);
    const std::vector<double> before = effect_of(options);

    for (const double(&bad)[4] : not_finite)
      CHECK(qtraj_options_set_reference(options, QTRAJ_REFERENCE_GIVEN, bad) == QTRAJ_E_NOT_FINITE);
    CHECK(qtraj_options_set_reference(options, QTRAJ_REFERENCE_GIVEN, zero) == QTRAJ_E_ZERO_NORM);
    CHECK(qtraj_options_set_reference(options, QTRAJ_REFERENCE_FIRST, q_wb) == QTRAJ_E_VALUE);
    CHECK(qtraj_options_set_reference(options, INT32_MIN, nullptr) == QTRAJ_E_VALUE);
    CHECK(qtraj_options_set_tangents(options, QTRAJ_TANGENT_DEFAULT) == QTRAJ_E_SETTING);
    CHECK(qtraj_options_set_ends(options, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_ESTIMATED) == QTRAJ_E_SETTING);
    CHECK(same_bits(effect_of(options), before));
  }
}

TEST_CASE("C API: a NULL pointer comes before an unknown constant", "[capi][options][errors]") {
  const double omega[3] = {0, 0, 0};
  const Options squad = options_of(QTRAJ_SQUAD), slerp = options_of(QTRAJ_SLERP);
  REQUIRE(qtraj_options_set_ends(squad.get(), QTRAJ_END_GIVEN, QTRAJ_END_GIVEN) == QTRAJ_OK);
  CHECK(qtraj_options_set_reference(slerp.get(), QTRAJ_REFERENCE_GIVEN, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_options_set_ends(nullptr, 1000, 1000) == QTRAJ_E_NULL);
  CHECK(qtraj_options_set_end_rates(nullptr, 1000, omega, omega) == QTRAJ_E_NULL);
  CHECK(qtraj_options_set_tangents(nullptr, 1000) == QTRAJ_E_NULL);
  CHECK(qtraj_options_set_reference(nullptr, 1000, nullptr) == QTRAJ_E_NULL);
  CHECK(qtraj_options_set_extrapolation(nullptr, 1000, 1000) == QTRAJ_E_NULL);
}

TEST_CASE("C API: another end condition drops the rate that was stored for the end", "[capi][options]") {
  const double omega[3] = {0.1, 0.2, 0.3};
  const Options options = options_of(QTRAJ_SQUAD);
  const Keyframes<double> keys = closed_tour<double>(5);
  REQUIRE(qtraj_options_set_ends(options.get(), QTRAJ_END_GIVEN, QTRAJ_END_CHORD) == QTRAJ_OK);
  CHECK(build(options.get(), keys).status == QTRAJ_E_INPUT_MISSING);  // no rate yet
  REQUIRE(qtraj_options_set_end_rates(options.get(), QTRAJ_FRAME_BODY, omega, nullptr) == QTRAJ_OK);
  CHECK(build(options.get(), keys).status == QTRAJ_OK);
  // setting the other end keeps it
  REQUIRE(qtraj_options_set_ends(options.get(), QTRAJ_END_GIVEN, QTRAJ_END_ESTIMATED) == QTRAJ_OK);
  CHECK(build(options.get(), keys).status == QTRAJ_OK);
  REQUIRE(qtraj_options_set_ends(options.get(), QTRAJ_END_CHORD, QTRAJ_END_ESTIMATED) == QTRAJ_OK);
  REQUIRE(qtraj_options_set_ends(options.get(), QTRAJ_END_GIVEN, QTRAJ_END_ESTIMATED) == QTRAJ_OK);
  CHECK(build(options.get(), keys).status == QTRAJ_E_INPUT_MISSING);
}

TEST_CASE("C API: DEFAULT stands for the documented constant", "[capi][options]") {
  const auto same = [](int32_t method, auto&& set_default, auto&& set_named) {
    const Options plain = options_of(method), first = options_of(method), second = options_of(method);
    CHECK(set_default(first.get()) == QTRAJ_OK);
    CHECK(set_named(second.get()) == QTRAJ_OK);
    CHECK(same_bits(effect_of(first.get()), effect_of(second.get())));
    CHECK(same_bits(effect_of(first.get()), effect_of(plain.get())));
  };
  const auto ends = [](int32_t value) {
    return [value](qtraj_options* options) { return qtraj_options_set_ends(options, value, value); };
  };
  same(QTRAJ_SQUAD, ends(QTRAJ_END_DEFAULT), ends(QTRAJ_END_CHORD));
  same(QTRAJ_LOG_SPLINE, ends(QTRAJ_END_DEFAULT), ends(QTRAJ_END_NATURAL));
  same(QTRAJ_ROTATION_SPLINE, ends(QTRAJ_END_DEFAULT), ends(QTRAJ_END_ESTIMATED));
  const auto tangents = [](int32_t value) {
    return [value](qtraj_options* options) { return qtraj_options_set_tangents(options, value); };
  };
  same(QTRAJ_SQUAD, tangents(QTRAJ_TANGENT_DEFAULT), tangents(QTRAJ_TANGENT_CATMULL_ROM));
  const auto reference = [](int32_t value) {
    return [value](qtraj_options* options) { return qtraj_options_set_reference(options, value, nullptr); };
  };
  same(QTRAJ_LOG_SPLINE, reference(QTRAJ_REFERENCE_DEFAULT), reference(QTRAJ_REFERENCE_FIRST));
}

TEST_CASE("C API: a given reference counts up to sign and norm", "[capi][options]") {
  const double q_wb[][4] = {{1, 0.5, 0, 0.25}, {-1, -0.5, 0, -0.25}, {4, 2, 0, 1}, {-0x1p600, -0x1p599, 0, -0x1p598}};
  std::vector<std::vector<double>> effects;
  for (const double(&q)[4] : q_wb) {
    const Options options = options_of(QTRAJ_LOG_SPLINE);
    REQUIRE(qtraj_options_set_reference(options.get(), QTRAJ_REFERENCE_GIVEN, q) == QTRAJ_OK);
    effects.push_back(effect_of(options.get()));
    CHECK(same_bits(effects.back(), effects.front()));
  }
}

TEST_CASE("C API: options copy rates and reference, and are reusable for any number of curves", "[capi][options]") {
  std::array<double, 3> omega = {0.1, 0.2, 0.3};
  const Options options = options_of(QTRAJ_SQUAD);
  REQUIRE(qtraj_options_set_ends(options.get(), QTRAJ_END_GIVEN, QTRAJ_END_GIVEN) == QTRAJ_OK);
  REQUIRE(qtraj_options_set_end_rates(options.get(), QTRAJ_FRAME_BODY, omega.data(), omega.data()) == QTRAJ_OK);
  const std::vector<double> before = effect_of(options.get());
  omega = {9, 9, 9};
  CHECK(same_bits(effect_of(options.get()), before));
  CHECK(same_bits(effect_of(options.get()), before));
}

}  // namespace
