// Vector curves through keys that every method accepts, and their samples, as functions that must succeed.
#ifndef QTRAJ_TESTS_VECTOR_CURVE_HPP
#define QTRAJ_TESTS_VECTOR_CURVE_HPP

#include <qtraj.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/vector_handles.hpp"

namespace capi {

inline Options vector_options(const VectorVariant& variant) {
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(variant.method, &options) == QTRAJ_OK);
  if (variant.start != QTRAJ_END_DEFAULT || variant.end != QTRAJ_END_DEFAULT)
    REQUIRE(qtraj_options_set_ends(options, variant.start, variant.end) == QTRAJ_OK);
  return Options(options);
}
inline Options vector_options(int32_t method) { return vector_options(VectorVariant{"", method}); }

// ---- Keys and curves ----

template <class Real>
struct VectorKeys {
  std::vector<double> times;
  std::vector<Real> values, first, second;  // derivatives are empty where there are none
  size_t dim;

  size_t count() const { return times.size(); }
  const Real* first_or_null() const { return first.empty() ? nullptr : first.data(); }
  const Real* second_or_null() const { return second.empty() ? nullptr : second.data(); }
};

// Keys within 2 of 0 on uneven knots, the last of them the first, with the derivatives that the variant needs.
template <class Real>
VectorKeys<Real> vector_tour(const VectorVariant& variant, size_t count, size_t dim, uint64_t seed = 17) {
  test::Random random(seed + 100 * count + dim);
  VectorKeys<Real> keys = {{}, {}, {}, {}, dim};
  double time = -2.0;
  for (size_t i = 0; i < count; ++i, time += random.uniform(0.2, 1.5)) keys.times.push_back(time);
  while (keys.values.size() < count * dim) keys.values.push_back(Real(random.uniform(-2, 2)));
  std::copy_n(keys.values.begin(), dim, keys.values.end() - static_cast<ptrdiff_t>(dim));
  while (variant.needs_first() && keys.first.size() < variant.first_rows(count) * dim)
    keys.first.push_back(Real(random.uniform(-3, 3)));
  while (variant.needs_second() && keys.second.size() < count * dim) keys.second.push_back(Real(random.uniform(-9, 9)));
  return keys;
}

struct BuiltVector {
  qtraj_status status;
  size_t bad_index;
  VectorCurve curve;
};
template <class Real>
BuiltVector build_vector(const qtraj_options* options, const VectorKeys<Real>& keys) {
  qtraj_vector_curve* out = nullptr;
  size_t bad_index = 0;
  const qtraj_status status = vector_create(options, keys.times.data(), keys.values.data(), keys.first_or_null(),
                                            keys.second_or_null(), keys.count(), keys.dim, &out, &bad_index);
  return {status, bad_index, VectorCurve(out)};
}
template <class Real>
VectorCurve must_build_vector(const qtraj_options* options, const VectorKeys<Real>& keys) {
  BuiltVector built = build_vector(options, keys);
  REQUIRE(built.status == QTRAJ_OK);
  REQUIRE(built.bad_index == SIZE_MAX);
  return std::move(built.curve);
}

// ---- Samples ----

template <class Real>
struct VectorMotion {
  std::vector<Real> value, first, second;

  explicit VectorMotion(size_t numbers) : value(numbers), first(numbers), second(numbers) {}
};
template <class Real>
bool same_bits(const VectorMotion<Real>& a, const VectorMotion<Real>& b) {
  const auto same = [](const std::vector<Real>& x, const std::vector<Real>& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(Real)) == 0;
  };
  return same(a.value, b.value) && same(a.first, b.first) && same(a.second, b.second);
}

template <class Real>
VectorMotion<Real> must_sample_vectors(const qtraj_vector_curve* curve, const std::vector<double>& times) {
  VectorMotion<Real> motion(times.size() * qtraj_vector_dim(curve));
  size_t bad_index = 0;
  REQUIRE(vector_sample(curve, times.data(), times.size(), motion.value.data(), motion.first.data(),
                        motion.second.data(), &bad_index) == QTRAJ_OK);
  REQUIRE(bad_index == SIZE_MAX);
  return motion;
}

}  // namespace capi

#endif
