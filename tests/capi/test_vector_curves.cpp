// What vector curves are: the key at every knot, constants, lines and cubics, continuous derivatives, components of
// their own.
#include <cfloat>
#include <cmath>

#include "support/capi_variants.hpp"
#include "support/vector_curve.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

// A polynomial, the highest power last, and its derivatives.
double polynomial(const std::vector<double>& powers, double t, int derivative = 0) {
  double sum = 0;
  for (size_t n = powers.size(); n-- > static_cast<size_t>(derivative);) {
    double factor = 1;
    for (int k = 0; k < derivative; ++k) factor *= static_cast<double>(n) - k;
    sum = sum * t + factor * powers[n];
  }
  return sum;
}

// Keys on a polynomial in each component, which are its powers times 1, 2, ...; derivatives as the variant needs.
VectorKeys<double> keys_on(const VectorVariant& variant, const std::vector<double>& powers,
                           const std::vector<double>& times, size_t dim) {
  VectorKeys<double> keys = {times, {}, {}, {}, dim};
  const auto at = [&](double t, int derivative, std::vector<double>& to) {
    for (size_t c = 0; c < dim; ++c) to.push_back(static_cast<double>(c + 1) * polynomial(powers, t, derivative));
  };
  for (const double t : times) {
    at(t, 0, keys.values);
    const bool is_end = t == times.front() || t == times.back();
    if (variant.needs_first() && (variant.method != QTRAJ_VECTOR_CUBIC || is_end)) at(t, 1, keys.first);
    if (variant.needs_second()) at(t, 2, keys.second);
  }
  return keys;
}

TEST_CASE("C API: at every knot a vector curve is the key, bit for bit", "[capi][vector]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const VectorVariant& variant : vector_variants())
      for (const size_t dim : {1u, 2u, 3u, 4u, 5u, 9u})
        for (const size_t count : {2u, 3u, 4u, 5u, 40u}) {
          CAPTURE(variant.name, dim, count);
          const VectorKeys<Real> keys = vector_tour<Real>(variant, count, dim);
          const Options options = vector_options(variant);
          const VectorCurve curve = must_build_vector(options.get(), keys);
          CHECK(must_sample_vectors<Real>(curve.get(), keys.times).value == keys.values);
          std::vector<double> times(count), values(count * dim);
          CHECK(qtraj_vector_keys(curve.get(), times.data(), values.data()) == QTRAJ_OK);
          CHECK(times == keys.times);
          CHECK(values == std::vector<double>(keys.values.begin(), keys.values.end()));
          CHECK(qtraj_vector_method(curve.get()) == variant.method);
          CHECK(qtraj_vector_key_count(curve.get()) == count);
          CHECK(qtraj_vector_dim(curve.get()) == dim);
          CHECK(qtraj_vector_start_time(curve.get()) == keys.times.front());
          CHECK(qtraj_vector_end_time(curve.get()) == keys.times.back());
        }
  });
}

TEST_CASE("C API: equal keys without slopes make a constant, bit for bit", "[capi][vector]") {
  for (const VectorVariant& variant : vector_variants()) {
    CAPTURE(variant.name);
    VectorKeys<double> keys = vector_tour<double>(variant, 6, 3);
    for (size_t i = 0; i < 6; ++i)
      for (size_t c = 0; c < 3; ++c) keys.values[3 * i + c] = 0.1 + 1e5 / (1 + static_cast<double>(c));
    std::fill(keys.first.begin(), keys.first.end(), 0.0);
    std::fill(keys.second.begin(), keys.second.end(), 0.0);
    const Options options = vector_options(variant);
    const VectorCurve curve = must_build_vector(options.get(), keys);
    const std::vector<double> times = times_in(keys.times, 100);
    const VectorMotion<double> motion = must_sample_vectors<double>(curve.get(), times);
    size_t wrong = 0;
    for (size_t i = 0; i < motion.value.size(); ++i)
      wrong += motion.value[i] != keys.values[i % 3] || motion.first[i] != 0 || motion.second[i] != 0;
    CHECK(wrong == 0);
  }
}

TEST_CASE("C API: equal neighbours of LINEAR and of HERMITE at rest make a constant between them", "[capi][vector]") {
  for (const int32_t method : {QTRAJ_VECTOR_LINEAR, QTRAJ_VECTOR_HERMITE}) {
    VectorKeys<double> keys = {{0, 0.3, 1.1, 2}, {1, 1 / 3.0, 1 / 3.0, -7}, {}, {}, 1};
    if (method == QTRAJ_VECTOR_HERMITE) keys.first = {5, 0, 0, -2};
    const Options options = vector_options(method);
    const VectorCurve curve = must_build_vector(options.get(), keys);
    std::vector<double> times;
    for (int i = 0; i < 801; ++i) times.push_back(0.3 + 0.001 * i);
    times.back() = 1.1;
    const VectorMotion<double> motion = must_sample_vectors<double>(curve.get(), times);
    CHECK(std::all_of(motion.value.begin(), motion.value.end(), [](double p) { return p == 1 / 3.0; }));
  }
}

TEST_CASE("C API: polynomials that a method can follow come back", "[capi][vector]") {
  const std::vector<double> powers = {0.7, -1.3, 0.9, 0.4, -0.2, 0.06};
  const std::vector<double> times = {-1, -0.4, -0.1, 0.7, 1.5, 1.8, 2.6};
  const auto follows = [&](const VectorVariant& variant, size_t terms) {
    CAPTURE(variant.name, terms);
    const std::vector<double> some(powers.begin(), powers.begin() + static_cast<ptrdiff_t>(terms));
    const Options options = vector_options(variant);
    const VectorCurve curve = must_build_vector(options.get(), keys_on(variant, some, times, 3));
    const std::vector<double> at = times_in(times, 25);
    const VectorMotion<double> motion = must_sample_vectors<double>(curve.get(), at);
    double worst[3] = {0, 0, 0};
    for (size_t i = 0; i < at.size(); ++i)
      for (size_t c = 0; c < 3; ++c) {
        const double times_c = static_cast<double>(c + 1);
        test::raise_to(worst[0], std::abs(motion.value[3 * i + c] - times_c * polynomial(some, at[i])));
        test::raise_to(worst[1], std::abs(motion.first[3 * i + c] - times_c * polynomial(some, at[i], 1)));
        test::raise_to(worst[2], std::abs(motion.second[3 * i + c] - times_c * polynomial(some, at[i], 2)));
      }
    CHECK(worst[0] <= 2e-13);
    CHECK(worst[1] <= 2e-12);
    CHECK(worst[2] <= 2e-11);
  };
  for (const VectorVariant& variant : vector_variants()) {
    if (variant.start == QTRAJ_END_PERIODIC) continue;
    follows(variant, 1);
    if (variant.method == QTRAJ_VECTOR_STEP) continue;
    follows(variant, 2);
    if (variant.method == QTRAJ_VECTOR_LINEAR) continue;
    const auto is_natural = [](int32_t end) { return end == QTRAJ_END_NATURAL || end == QTRAJ_END_DEFAULT; };
    if (variant.method == QTRAJ_VECTOR_CUBIC && (is_natural(variant.start) || is_natural(variant.end))) continue;
    follows(variant, 4);
    if (variant.method == QTRAJ_VECTOR_QUINTIC) follows(variant, 6);
  }
}

TEST_CASE("C API: ends of a cubic are what was asked for", "[capi][vector]") {
  for (const VectorVariant& variant : vector_variants()) {
    if (variant.method != QTRAJ_VECTOR_CUBIC) continue;
    CAPTURE(variant.name);
    const VectorKeys<double> keys = vector_tour<double>(variant, 7, 2);
    const Options options = vector_options(variant);
    const VectorCurve curve = must_build_vector(options.get(), keys);
    const VectorMotion<double> at = must_sample_vectors<double>(curve.get(), {keys.times.front(), keys.times.back()});
    for (size_t c = 0; c < 2; ++c) {
      for (const bool is_end : {false, true}) {
        const int32_t condition = is_end ? variant.end : variant.start;
        const size_t k = 2 * (is_end ? 1 : 0) + c;
        if (condition == QTRAJ_END_NATURAL || condition == QTRAJ_END_DEFAULT) CHECK(std::abs(at.second[k]) < 1e-12);
        if (condition == QTRAJ_END_GIVEN) CHECK(std::abs(at.first[k] - keys.first[k]) < 1e-13);
      }
      if (variant.start == QTRAJ_END_PERIODIC) {
        CHECK(std::abs(at.first[c] - at.first[2 + c]) < 1e-12);
        CHECK(std::abs(at.second[c] - at.second[2 + c]) < 1e-10);
      }
    }
  }
}

TEST_CASE("C API: derivatives are continuous where the method says so", "[capi][vector]") {
  for (const VectorVariant& variant : vector_variants()) {
    if (variant.method == QTRAJ_VECTOR_STEP || variant.method == QTRAJ_VECTOR_LINEAR) continue;
    CAPTURE(variant.name);
    const VectorKeys<double> keys = vector_tour<double>(variant, 12, 3);
    const Options options = vector_options(variant);
    const VectorCurve curve = must_build_vector(options.get(), keys);
    std::vector<double> before, after(keys.times.begin() + 1, keys.times.end() - 1);
    for (const double knot : after) before.push_back(std::nextafter(knot, -DBL_MAX));
    const VectorMotion<double> left = must_sample_vectors<double>(curve.get(), before),
                               right = must_sample_vectors<double>(curve.get(), after);
    double value = 0, first = 0, second = 0;
    for (size_t i = 0; i < left.value.size(); ++i) {
      test::raise_to(value, std::abs(left.value[i] - right.value[i]));
      test::raise_to(first, std::abs(left.first[i] - right.first[i]));
      test::raise_to(second, std::abs(left.second[i] - right.second[i]));
    }
    CHECK(value < 1e-13);
    CHECK(first < 1e-12);
    if (variant.method != QTRAJ_VECTOR_HERMITE) CHECK(second < 2e-11);
  }
}

TEST_CASE("C API: LINEAR never turns back", "[capi][vector]") {
  test::Random random(23);
  const Options options = vector_options(QTRAJ_VECTOR_LINEAR);
  for (int round = 0; round < 300; ++round) {
    const double left = random.uniform(-1, 1) * std::pow(10, random.uniform(-8, 8)),
                 right = round % 3 == 0 ? std::nextafter(-left, 1e9) : random.uniform(-1, 1);
    const VectorCurve curve = must_build_vector(options.get(), VectorKeys<double>{{0, 1}, {left, right}, {}, {}, 1});
    std::vector<double> times;
    for (int i = -40; i <= 40; ++i) times.push_back(0.5 + i * 0x1p-54);  // where the nearer end changes
    for (int i = 0; i < 50; ++i) times.push_back(random.uniform(0, 1)), times.push_back(i * 1e-17);
    std::sort(times.begin(), times.end());
    const std::vector<double> p = must_sample_vectors<double>(curve.get(), times).value;
    CHECK((std::is_sorted(p.begin(), p.end()) || std::is_sorted(p.rbegin(), p.rend())));
    CHECK(*std::min_element(p.begin(), p.end()) >= std::min(left, right));
    CHECK(*std::max_element(p.begin(), p.end()) <= std::max(left, right));
  }
}

TEST_CASE("C API: a component has the same bits in any dim and beside any other", "[capi][vector]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const VectorVariant& variant : vector_variants()) {
      CAPTURE(variant.name);
      constexpr size_t kDim = 7;
      const VectorKeys<Real> keys = vector_tour<Real>(variant, 20, kDim);
      const Options options = vector_options(variant);
      const VectorCurve whole = must_build_vector(options.get(), keys);
      const std::vector<double> times = times_in(keys.times, 13);
      const VectorMotion<Real> expected = must_sample_vectors<Real>(whole.get(), times);
      for (size_t dim = 1; dim < kDim; ++dim)
        for (size_t from = 0; from + dim <= kDim; ++from) {
          const auto columns = [&](const std::vector<Real>& rows) {
            std::vector<Real> some;
            for (size_t i = from; i < rows.size(); i += kDim)
              some.insert(some.end(), rows.begin() + static_cast<ptrdiff_t>(i),
                          rows.begin() + static_cast<ptrdiff_t>(i + dim));
            return some;
          };
          const VectorKeys<Real> some = {keys.times, columns(keys.values), columns(keys.first), columns(keys.second),
                                         dim};
          const VectorMotion<Real> motion =
              must_sample_vectors<Real>(must_build_vector(options.get(), some).get(), times);
          CHECK(capi::same_bits(motion.value, columns(expected.value)));
          CHECK(capi::same_bits(motion.first, columns(expected.first)));
          CHECK(capi::same_bits(motion.second, columns(expected.second)));
        }
    }
  });
}

TEST_CASE("C API: CUBIC is the spline function", "[capi][vector]") {
  for (const VectorVariant& variant : vector_variants()) {
    if (variant.method != QTRAJ_VECTOR_CUBIC || variant.gives_end()) continue;
    CAPTURE(variant.name);
    const VectorKeys<double> keys = vector_tour<double>(variant, 15, 3);
    const Options options = vector_options(variant);
    const VectorCurve curve = must_build_vector(options.get(), keys);
    const std::vector<double> times = times_in(keys.times, 11);
    std::vector<double> y(3 * times.size());
    REQUIRE(qtraj_cubic_spline(keys.times.data(), keys.values.data(), 15, 3, variant.start, variant.end, times.data(),
                               times.size(), y.data(), nullptr) == QTRAJ_OK);
    CHECK(capi::same_bits(must_sample_vectors<double>(curve.get(), times).value, y));
  }
}

}  // namespace
