// Vector curves outside their knots, in gaps, and loops.
#include <cfloat>
#include <cmath>

#include "support/capi_variants.hpp"
#include "support/ends.hpp"
#include "support/vector_curve.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct OneVector {
  double value[3], first[3], second[3];
  qtraj_status status;
};
OneVector vector_at(const qtraj_vector_curve* curve, double time) {
  OneVector at;
  at.status = qtraj_vector_sample_at(curve, time, nullptr, at.value, at.first, at.second);
  return at;
}

VectorCurve curve_by(const VectorVariant& variant, int32_t rule, size_t count = 9) {
  const Options options = vector_options(variant);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), rule, rule) == QTRAJ_OK);
  return must_build_vector(options.get(), vector_tour<double>(variant, count, 3));
}

TEST_CASE("C API: a vector curve holds, goes straight on or ends outside its knots", "[capi][vector][extrapolation]") {
  for (const VectorVariant& variant : vector_variants()) {
    CAPTURE(variant.name);
    const VectorCurve error = curve_by(variant, QTRAJ_EXTRAPOLATE_ERROR),
                      hold = curve_by(variant, QTRAJ_EXTRAPOLATE_HOLD),
                      rate = curve_by(variant, QTRAJ_EXTRAPOLATE_CONSTANT_RATE);
    const double first = qtraj_vector_start_time(error.get()), last = qtraj_vector_end_time(error.get());
    for (const bool is_after : {false, true}) {
      const double knot = is_after ? last : first, sign = is_after ? 1 : -1;
      const OneVector end = vector_at(error.get(), knot);
      for (const double distance : {0.001, 1.0, 1e3, 1e9}) {
        const double time = knot + sign * distance;
        CAPTURE(is_after, distance);
        const OneVector none = vector_at(error.get(), time), held = vector_at(hold.get(), time),
                        moved = vector_at(rate.get(), time);
        CHECK(none.status == QTRAJ_E_TIME_RANGE);
        CHECK(held.status == QTRAJ_OK);
        CHECK(moved.status == QTRAJ_OK);
        for (size_t c = 0; c < 3; ++c) {
          CHECK((std::isnan(none.value[c]) && std::isnan(none.first[c]) && std::isnan(none.second[c])));
          CHECK(held.value[c] == end.value[c]);
          CHECK((held.first[c] == 0 && held.second[c] == 0 && moved.second[c] == 0));
          CHECK(std::abs(moved.first[c] - end.first[c]) <= 4 * DBL_EPSILON * std::abs(end.first[c]));
          const double way = end.first[c] * (time - knot);
          CHECK(std::abs(moved.value[c] - (end.value[c] + way)) <=
                8 * DBL_EPSILON * (std::abs(end.value[c]) + std::abs(way)));
        }
      }
      // times 4 ulps outside count as the knot, by any rule
      const double reach = test::reach_of(first, last);
      for (const qtraj_vector_curve* curve : {error.get(), hold.get(), rate.get()}) {
        const OneVector near = vector_at(curve, knot + sign * reach);
        CHECK(near.status == QTRAJ_OK);
        for (size_t c = 0; c < 3; ++c) {
          CHECK(near.value[c] == end.value[c]);
          CHECK(near.first[c] == end.first[c]);
          CHECK(near.second[c] == end.second[c]);
        }
      }
      const double outside = is_after ? test::after_all(first, last) : test::before_all(first, last);
      CHECK(vector_at(error.get(), outside).status == QTRAJ_E_TIME_RANGE);
    }
  }
}

TEST_CASE("C API: the first and the last knot may have rules of their own", "[capi][vector][extrapolation]") {
  const Options options = vector_options(QTRAJ_VECTOR_LINEAR);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE) ==
          QTRAJ_OK);
  const VectorCurve curve = must_build_vector(options.get(), VectorKeys<double>{{1, 2, 4}, {3, 5, -1}, {}, {}, 1});
  CHECK(must_sample_vectors<double>(curve.get(), {-9, 1, 3, 4, 6}).value == std::vector<double>{3, 3, 2, -1, -7});
  CHECK(must_sample_vectors<double>(curve.get(), {-9, 1, 3, 4, 6}).first == std::vector<double>{0, 2, -3, -3, -3});
}

TEST_CASE("C API: far away a vector is a number or NOT_FINITE, and nothing in between",
          "[capi][vector][extrapolation]") {
  const Options options = vector_options(QTRAJ_VECTOR_LINEAR);
  REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
                                          QTRAJ_EXTRAPOLATE_CONSTANT_RATE) == QTRAJ_OK);
  // slopes 8, 0.25 and 0
  const VectorCurve curve =
      must_build_vector(options.get(), VectorKeys<double>{{0, 1}, {0, 0, 3, 8, 0.25, 3}, {}, {}, 3});
  const double far = 2e307;
  OneVector at = vector_at(curve.get(), far);
  CHECK(at.status == QTRAJ_OK);
  CHECK((at.value[0] == 8 * far && at.value[1] == 0.25 * far && at.value[2] == 3));
  at = vector_at(curve.get(), -far);
  CHECK((at.status == QTRAJ_OK && at.value[0] == -8 * far));
  for (const double time : {2.5e307, -2.5e307, DBL_MAX, -DBL_MAX}) {
    at = vector_at(curve.get(), time);
    CHECK(at.status == QTRAJ_E_NOT_FINITE);
    for (size_t c = 0; c < 3; ++c)
      CHECK((std::isnan(at.value[c]) && std::isnan(at.first[c]) && std::isnan(at.second[c])));
    double first[3];  // what does not overflow is there when it alone is asked for
    CHECK(qtraj_vector_sample_at(curve.get(), time, nullptr, nullptr, first, nullptr) == QTRAJ_OK);
    CHECK((first[0] == 8 && first[2] == 0));
    float single[3];
    CHECK(qtraj_vector_sample_at_f32(curve.get(), 1e38, nullptr, single, nullptr, nullptr) == QTRAJ_E_NOT_FINITE);
    CHECK(qtraj_vector_sample_at_f32(curve.get(), 1e37, nullptr, single, nullptr, nullptr) == QTRAJ_OK);
    CHECK(single[0] == static_cast<float>(8e37));
  }
}

TEST_CASE("C API: a vector curve that repeats is the same a period later", "[capi][vector][extrapolation]") {
  for (const VectorVariant& variant : vector_variants()) {
    CAPTURE(variant.name);
    const Options options = vector_options(variant);
    REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
            QTRAJ_OK);
    VectorKeys<double> keys = vector_tour<double>(variant, 9, 3);
    keys.times = {0, 0.5, 0.75, 1.25, 2, 2.25, 3, 3.5, 4};  // times and their sums with periods are exact
    const VectorCurve curve = must_build_vector(options.get(), keys);
    std::vector<double> times, later, earlier;
    for (int i = 0; i < 256; ++i) {
      times.push_back(i / 64.0);
      later.push_back(times.back() + 12), earlier.push_back(times.back() - 4096);
    }
    const VectorMotion<double> expected = must_sample_vectors<double>(curve.get(), times);
    CHECK(same_bits(must_sample_vectors<double>(curve.get(), later), expected));
    CHECK(same_bits(must_sample_vectors<double>(curve.get(), earlier), expected));
    // at the last knot the next round has begun
    const VectorMotion<double> last = must_sample_vectors<double>(curve.get(), {4.0, std::nextafter(4.0, 5.0)}),
                               first = must_sample_vectors<double>(curve.get(), {0.0, 0.0});
    CHECK(same_bits(last, first));
  }
}

TEST_CASE("C API: a curve that is to close must return to its first vector", "[capi][vector][closure]") {
  const auto status_of = [](double last, double closure, double scale) {
    const Options options = vector_options({"", QTRAJ_VECTOR_CUBIC, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC});
    if (closure >= 0) REQUIRE(qtraj_options_set_closure(options.get(), closure) == QTRAJ_OK);
    const VectorKeys<double> keys = {
        {0, 1, 2, 3}, {0, 1 * scale, 0, 4 * scale, 0, -2 * scale, 0, last * scale}, {}, {}, 2};
    const BuiltVector built = build_vector(options.get(), keys);
    CHECK(built.bad_index == (built.status == QTRAJ_OK ? SIZE_MAX : 3));
    if (built.status != QTRAJ_OK) return built.status;
    double p[4];
    const double ends[2] = {0, 3};
    CHECK(qtraj_vector_sample(built.curve.get(), ends, 2, p, nullptr, nullptr, nullptr) == QTRAJ_OK);
    CHECK((p[1] == scale && p[3] == scale));  // the first key, twice
    return built.status;
  };
  for (const double scale : {1.0, 1e-200, 1e200, 1e-308, 4e307}) {
    CAPTURE(scale);
    CHECK(status_of(1, -1, scale) == QTRAJ_OK);
    CHECK(status_of(1 + 3.9e-6, -1, scale) == QTRAJ_OK);  // 1e-6 of the largest, which is 4
    CHECK(status_of(1 + 4.1e-6, -1, scale) == QTRAJ_E_NOT_CLOSED);
    CHECK(status_of(1, 0, scale) == QTRAJ_OK);
    CHECK(status_of(1 + DBL_EPSILON, 0, scale) == (scale == 1e-308 ? QTRAJ_OK : QTRAJ_E_NOT_CLOSED));
    CHECK(status_of(1.39, 0.1, scale) == QTRAJ_OK);
    CHECK(status_of(1.41, 0.1, scale) == QTRAJ_E_NOT_CLOSED);
  }
  // by extrapolation as well
  for (const int32_t method : {QTRAJ_VECTOR_STEP, QTRAJ_VECTOR_LINEAR}) {
    const Options options = vector_options(method);
    REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
            QTRAJ_OK);
    const BuiltVector built = build_vector(options.get(), VectorKeys<double>{{0, 1, 2}, {1, 2, 1.1}, {}, {}, 1});
    CHECK((built.status == QTRAJ_E_NOT_CLOSED && built.bad_index == 2 && !built.curve));
  }
}

TEST_CASE("C API: a period closes a vector curve with its first key", "[capi][vector][period]") {
  for (const VectorVariant& variant : vector_variants()) {
    if (variant.gives_end()) continue;
    CAPTURE(variant.name);
    VectorKeys<double> keys = vector_tour<double>(variant, 6, 2);
    const double period = keys.times.back() - keys.times.front();
    const Options options = vector_options(variant);
    const VectorCurve closed = must_build_vector(options.get(), keys);
    // the same without the last key
    keys.times.pop_back();
    keys.values.resize(10);
    if (!keys.first.empty()) {
      keys.first.resize(10);
      if (variant.needs_second()) keys.second.resize(10);
    }
    REQUIRE(qtraj_options_set_period(options.get(), period) == QTRAJ_OK);
    const VectorCurve loop = must_build_vector(options.get(), keys);
    CHECK(qtraj_vector_key_count(loop.get()) == 6);
    std::vector<double> times(6), values(12);
    CHECK(qtraj_vector_keys(loop.get(), times.data(), values.data()) == QTRAJ_OK);
    CHECK(times.back() == keys.times.front() + period);
    CHECK((values[10] == keys.values[0] && values[11] == keys.values[1]));
    if (variant.needs_first()) {  // the derivatives of the first key as well
      const VectorMotion<double> ends = must_sample_vectors<double>(loop.get(), {times.front(), times.back()});
      CHECK(std::abs(ends.first[0] - ends.first[2]) < 1e-13);
      CHECK(std::abs(ends.first[0] - keys.first[0]) < 1e-13);
    } else {
      std::vector<double> at = times_in(keys.times, 10);
      CHECK(same_bits(must_sample_vectors<double>(loop.get(), at), must_sample_vectors<double>(closed.get(), at)));
    }
  }
}

TEST_CASE("C API: a time in a gap has no vector, its knots have", "[capi][vector][gap]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const VectorVariant& variant : vector_variants())
      for (const size_t dim : {1u, 3u, 5u}) {
        CAPTURE(variant.name, dim);
        VectorKeys<Real> keys = vector_tour<Real>(variant, 9, dim);
        for (size_t i = 4; i < 9; ++i) keys.times[i] += 12.0;  // between keys 3 and 4
        const Options options = vector_options(variant);
        const VectorCurve whole = must_build_vector(options.get(), keys);
        REQUIRE(qtraj_options_set_longest_gap(options.get(), 3.0) == QTRAJ_OK);
        const VectorCurve curve = must_build_vector(options.get(), keys);
        const double from = keys.times[3], to = keys.times[4];
        std::vector<double> times = times_in(keys.times, 40);
        for (const double time : {from, std::nextafter(from, to), 0.5 * (from + to), std::nextafter(to, from), to})
          times.push_back(time);
        for (const bool sorted : {false, true}) {
          if (sorted) std::sort(times.begin(), times.end());
          const VectorMotion<Real> expected = must_sample_vectors<Real>(whole.get(), times);
          VectorMotion<Real> motion(times.size() * dim);
          size_t bad = 0, first = times.size(), wrong = 0;
          CHECK(vector_sample(curve.get(), times.data(), times.size(), motion.value.data(), motion.first.data(),
                              motion.second.data(), &bad) == QTRAJ_E_GAP);
          for (size_t i = times.size(); i-- > 0;) {
            const bool in_gap = times[i] > from && times[i] < to;
            if (in_gap) first = i;
            for (size_t k = dim * i; k < dim * (i + 1); ++k)
              wrong +=
                  in_gap ? !std::isnan(motion.value[k]) || !std::isnan(motion.first[k]) || !std::isnan(motion.second[k])
                         : motion.value[k] != expected.value[k] || motion.first[k] != expected.first[k] ||
                               motion.second[k] != expected.second[k];
            std::vector<Real> one(dim);
            wrong += vector_sample_at(curve.get(), times[i], nullptr, one.data(), static_cast<Real*>(nullptr),
                                      static_cast<Real*>(nullptr)) != (in_gap ? QTRAJ_E_GAP : QTRAJ_OK);
          }
          CHECK(wrong == 0);
          CHECK(bad == first);
        }
      }
  });
}

TEST_CASE("C API: counts of an even grid of vectors are those of trajectories", "[capi][vector][grid]") {
  const Options options = vector_options(QTRAJ_VECTOR_LINEAR);
  const VectorCurve curve = must_build_vector(options.get(), VectorKeys<double>{{0, 0.35, 0.6}, {1, 2, 4}, {}, {}, 1});
  const Trajectory same = must_build(make_options({"", QTRAJ_SLERP}).get(),
                                     Keyframes<double>{{0, 0.35, 0.6}, {1, 0, 0, 0, 0.8, 0.6, 0, 0, 0, 1, 0, 0}});
  for (const double start : {0.0, 0.1, 0.6, 0.7, -0.1, kNaN})
    for (const double step : {0.1, 0.07, -0.1, 0.0, 5.0, 1e-300, kNaN}) {
      CAPTURE(start, step);
      size_t count = 7, expected = 7;
      CHECK(qtraj_vector_uniform_count(curve.get(), start, step, &count) ==
            qtraj_uniform_count(same.get(), start, step, &expected));
      CHECK(count == expected);
    }
  double p[7];
  CHECK(qtraj_vector_sample_uniform(curve.get(), 0, 0.1, 7, p, nullptr, nullptr, nullptr) == QTRAJ_OK);
  CHECK(p[6] == 4);
}

}  // namespace
