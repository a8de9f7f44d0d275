// Vector curves of extreme numbers: results are right or, where they overflow, NOT_FINITE; floating-point flags and
// errno stay as they were.
#include <cfloat>
#include <cmath>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"
#include "support/vector_curve.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

// The ordinary tour with values times `size` and intervals times `slowness`, both powers of two.
VectorKeys<double> stretched(const VectorVariant& variant, double size, double slowness) {
  VectorKeys<double> keys = vector_tour<double>(variant, 8, 3);
  for (double& time : keys.times) time = (time + 3.0) * slowness;
  for (double& value : keys.values) value *= size;
  const auto times = [](double number, long double factor) {
    return static_cast<double>(static_cast<long double>(number) * factor);  // in one step: halves of it may underflow
  };
  const long double per_second = static_cast<long double>(size) / static_cast<long double>(slowness);
  for (double& first : keys.first) first = times(first, per_second);
  for (double& second : keys.second) second = times(second, per_second / static_cast<long double>(slowness));
  return keys;
}

TEST_CASE("C API: sizes and durations that are powers of two scale a vector curve exactly",
          "[capi][vector][extremes]") {
  const struct {
    double size, slowness;
  } cases[] = {{0x1p900, 1},        {0x1p-900, 1},       {0x1p1019, 0x1p10},   {0x1p-1000, 0x1p-20},
               {0x1p1019, 0x1p400}, {0x1p900, 0x1p600},  {0x1p-10, 0x1p480},   {0x1p-900, 0x1p-450},
               {1, 0x1p-500},       {1, 0x1p400},        {0x1p290, 0x1p-300},  {0x1p305, 0x1p-200},
               {0x1p-310, 0x1p340}, {0x1p1019, 0x1p900}, {0x1p-1000, 0x1p-500}};
  for (const VectorVariant& variant : vector_variants()) {
    const Options options = vector_options(variant);
    const VectorKeys<double> plain = stretched(variant, 1, 1);
    const VectorCurve expected_curve = must_build_vector(options.get(), plain);
    std::vector<double> times = times_in(plain.times, 9);
    const VectorMotion<double> expected = must_sample_vectors<double>(expected_curve.get(), times);
    for (const auto& c : cases) {
      CAPTURE(variant.name, std::log2(c.size), std::log2(c.slowness));
      const VectorKeys<double> keys = stretched(variant, c.size, c.slowness);
      const BuiltVector built = build_vector(options.get(), keys);
      REQUIRE(built.status == QTRAJ_OK);
      double worst = 0;
      for (size_t i = 0; i < times.size(); ++i) {
        double rows[3][3];
        const double time = times[i] * c.slowness;
        for (int asked = 0; asked < 3; ++asked) {
          double* const out = rows[asked];
          const qtraj_status status =
              qtraj_vector_sample_at(built.curve.get(), time, nullptr, asked == 0 ? out : nullptr,
                                     asked == 1 ? out : nullptr, asked == 2 ? out : nullptr);
          const std::vector<double>& all = asked == 0 ? expected.value : asked == 1 ? expected.first : expected.second;
          bool overflows = false;
          for (size_t k = 0; k < 3; ++k) {
            // exponents of long double are wide enough
            const long double exact = static_cast<long double>(all[3 * i + k]) * static_cast<long double>(c.size) /
                                      std::pow(static_cast<long double>(c.slowness), asked);
            overflows = overflows || std::abs(exact) > static_cast<long double>(DBL_MAX);
            if (status == QTRAJ_OK && std::abs(exact) > static_cast<long double>(DBL_MIN))
              test::raise_to(worst, std::abs(static_cast<long double>(out[k]) / exact - 1));
          }
          if (overflows != (status == QTRAJ_E_NOT_FINITE)) FAIL_CHECK("derivative " << asked << " at " << time);
          if (overflows) CHECK((std::isnan(out[0]) && std::isnan(out[1]) && std::isnan(out[2])));
        }
      }
      CHECK(worst <= 1e-12);
    }
  }
}

TEST_CASE("C API: small keys do not make a given derivative too fast", "[capi][vector][extremes]") {
  for (const double tiny : {0.0, 1e-100, 1e-310}) {
    CAPTURE(tiny);
    const Options hermite = vector_options(QTRAJ_VECTOR_HERMITE);
    VectorCurve curve = must_build_vector(hermite.get(), VectorKeys<double>{{0, 1}, {tiny, -tiny}, {1, 1}, {}, 1});
    VectorMotion<double> at = must_sample_vectors<double>(curve.get(), {0, 0.25, 1});
    CHECK((at.value[0] == tiny && at.value[2] == -tiny));
    CHECK(at.value[1] == Approx(0.25 * 0.75 * 0.5));
    CHECK((at.first[0] == 1 && at.first[2] == 1));
    const Options quintic = vector_options(QTRAJ_VECTOR_QUINTIC);
    curve = must_build_vector(quintic.get(), VectorKeys<double>{{0, 1}, {tiny, -tiny}, {0, 0}, {1, -1}, 1});
    at = must_sample_vectors<double>(curve.get(), {0, 1});
    CHECK((at.second[0] == 1 && at.second[1] == -1));
    const Options cubic = vector_options({"", QTRAJ_VECTOR_CUBIC, QTRAJ_END_NATURAL, QTRAJ_END_GIVEN});
    curve = must_build_vector(cubic.get(), VectorKeys<double>{{0, 1, 2}, {tiny, tiny, -tiny}, {NAN, 3}, {}, 1});
    CHECK(must_sample_vectors<double>(curve.get(), {2}).first[0] == Approx(3));
  }
}

TEST_CASE("C API: a row whose numbers overflow is NOT_FINITE, all others are right", "[capi][vector][extremes]") {
  // the spline through these swings beyond the largest number within the middle interval
  const VectorKeys<double> keys = {{0, 1, 2, 3}, {-1.5e308, 1.7e308, 1.7e308, -1.5e308}, {}, {}, 1};
  const Options options = vector_options(QTRAJ_VECTOR_CUBIC);
  const VectorCurve curve = must_build_vector(options.get(), keys);
  std::vector<double> times;
  for (int i = 0; i <= 300; ++i) times.push_back(i * 0.01);
  std::vector<double> p(times.size()), v(times.size());
  size_t bad = 0, first = SIZE_MAX;
  CHECK(qtraj_vector_sample(curve.get(), times.data(), times.size(), p.data(), nullptr, nullptr, &bad) ==
        QTRAJ_E_NOT_FINITE);
  for (size_t i = times.size(); i-- > 0;)
    if (std::isnan(p[i])) first = i;
  CHECK(bad == first);
  CHECK((first > 100 && first < 200 && !std::isnan(p[0]) && !std::isnan(p[100]) && !std::isnan(p[200])));
  CHECK(std::count_if(p.begin(), p.end(), [](double x) { return std::isnan(x); }) > 50);
  // in a row that is at fault nothing is left
  CHECK(qtraj_vector_sample(curve.get(), times.data(), times.size(), p.data(), v.data(), nullptr, &bad) ==
        QTRAJ_E_NOT_FINITE);
  for (size_t i = 0; i < times.size(); ++i) CHECK(std::isnan(p[i]) == std::isnan(v[i]));
  // float, of numbers that double holds
  const VectorKeys<double> large = {{0, 1, 2}, {0, 1e39, 0}, {}, {}, 1};
  const Options linear = vector_options(QTRAJ_VECTOR_LINEAR);
  const VectorCurve lines = must_build_vector(linear.get(), large);
  const double at[] = {0.1, 0.3, 0.5, 1.9, 1.0};
  for (size_t count = 1; count < 5; ++count) {
    std::vector<double> many;
    while (many.size() < 200) many.insert(many.end(), at, at + count);
    std::vector<float> out(many.size());
    const bool overflows = count > 2;
    CHECK(qtraj_vector_sample_f32(lines.get(), many.data(), many.size(), out.data(), nullptr, nullptr, &bad) ==
          (overflows ? QTRAJ_E_NOT_FINITE : QTRAJ_OK));
    CHECK(bad == (overflows ? 2 : SIZE_MAX));
    for (size_t i = 0; i < many.size(); ++i)
      CHECK((many[i] == 0.5 ? std::isnan(out[i]) : std::abs(out[i] / 1e38 - (many[i] > 1 ? 1 : 10 * many[i])) < 1e-6));
  }
}

TEST_CASE("C API: vectors of any size leave errno and the floating-point environment alone",
          "[capi][vector][extremes][floating]") {
  const double sizes[] = {1, 1e308, 1e-310, 5e-324, 1e100, 1e-100}, hours[] = {1, 1e300, 1e-150};
  for (const VectorVariant& variant : vector_variants())
    for (const double size : sizes)
      for (const double slowness : hours) {
        CAPTURE(variant.name, size, slowness);
        VectorKeys<double> keys = vector_tour<double>(variant, 8, 3);
        double time = slowness;
        for (double& t : keys.times) t = time, time += slowness * (1 + (t > 0 ? 0.5 : 0));
        for (double& value : keys.values) value *= 0.5 * size;
        const Options options = vector_options(variant);
        REQUIRE(qtraj_options_set_extrapolation(options.get(), QTRAJ_EXTRAPOLATE_CONSTANT_RATE,
                                                QTRAJ_EXTRAPOLATE_CONSTANT_RATE) == QTRAJ_OK);
        CHECK(std::string("nothing") == disturbance([&] { build_vector(options.get(), keys); }));
        const BuiltVector built = build_vector(options.get(), keys);
        if (built.status != QTRAJ_OK) continue;
        std::vector<double> times = times_in(keys.times, 9);
        for (const double t : {0.0, -slowness, 100 * slowness, 1e300, -1e308, DBL_MAX, 5e-324}) times.push_back(t);
        VectorMotion<double> motion(3 * times.size());
        VectorMotion<float> single(3 * times.size());
        const auto sample_all = [&] {
          qtraj_vector_sample(built.curve.get(), times.data(), times.size(), motion.value.data(), motion.first.data(),
                              motion.second.data(), nullptr);
          qtraj_vector_sample_f32(built.curve.get(), times.data(), times.size(), single.value.data(),
                                  single.first.data(), single.second.data(), nullptr);
          for (const double t : times)
            qtraj_vector_sample_at(built.curve.get(), t, nullptr, motion.value.data(), motion.first.data(),
                                   motion.second.data());
        };
        CHECK(std::string("nothing") == disturbance(sample_all));
        for (size_t i = 0; i < times.size(); ++i) {
          const bool nan = std::isnan(single.value[3 * i]);
          for (size_t k = 3 * i; k < 3 * i + 3; ++k)
            CHECK((std::isnan(single.value[k]) == nan && std::isnan(single.first[k]) == nan &&
                   std::isnan(single.second[k]) == nan && !std::isinf(single.value[k]) &&
                   !std::isinf(single.first[k])));
        }
      }
  // signalling NaN among times and keys
  VectorKeys<double> keys = vector_tour<double>({"", QTRAJ_VECTOR_HERMITE}, 8, 3);
  keys.first.assign(24, 0.0);
  const Options options = vector_options(QTRAJ_VECTOR_HERMITE);
  const VectorCurve curve = must_build_vector(options.get(), keys);
  std::vector<double> times(40, 0.5), out(120);
  set_signalling_nan(times[7]), set_signalling_nan(times[39]);
  CHECK(std::string("nothing") == disturbance([&] {
          qtraj_vector_sample(curve.get(), times.data(), 40, out.data(), nullptr, nullptr, nullptr);
        }));
  for (std::vector<double>* numbers : {&keys.times, &keys.values, &keys.first}) {
    const std::vector<double> kept = *numbers;
    set_signalling_nan((*numbers)[5]);
    CHECK(std::string("nothing") == disturbance([&] { build_vector(options.get(), keys); }));
    CHECK(build_vector(options.get(), keys).status == QTRAJ_E_NOT_FINITE);
    *numbers = kept;
  }
  VectorKeys<float> single = vector_tour<float>({"", QTRAJ_VECTOR_HERMITE}, 8, 3);
  for (std::vector<float>* numbers : {&single.values, &single.first}) {
    const std::vector<float> kept = *numbers;
    set_signalling_nan((*numbers)[5]);
    CHECK(std::string("nothing") == disturbance([&] { build_vector(options.get(), single); }));
    *numbers = kept;
  }
}

}  // namespace
