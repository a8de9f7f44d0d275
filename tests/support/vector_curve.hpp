// Vector curves of every method and of all ends, and one name for the double and the float twin of their functions.
#ifndef QTRAJ_TESTS_VECTOR_CURVE_HPP
#define QTRAJ_TESTS_VECTOR_CURVE_HPP

#include <qtraj.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace capi {

struct DestroyVector {
  void operator()(qtraj_vector_curve* curve) const { qtraj_vector_destroy(curve); }
};
using VectorCurve = std::unique_ptr<qtraj_vector_curve, DestroyVector>;

// ---- Twins ----

inline qtraj_status vector_create(const qtraj_options* options, const double* times, const double* values,
                                  const double* first, const double* second, size_t count, size_t dim,
                                  qtraj_vector_curve** out, size_t* bad_index) {
  return qtraj_vector_create(options, times, values, first, second, count, dim, out, bad_index);
}
inline qtraj_status vector_create(const qtraj_options* options, const double* times, const float* values,
                                  const float* first, const float* second, size_t count, size_t dim,
                                  qtraj_vector_curve** out, size_t* bad_index) {
  return qtraj_vector_create_f32(options, times, values, first, second, count, dim, out, bad_index);
}
inline qtraj_status vector_init(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                                const double* values, const double* first, const double* second, size_t count,
                                size_t dim, qtraj_vector_curve** out, size_t* bad_index) {
  return qtraj_vector_init(memory, bytes, options, times, values, first, second, count, dim, out, bad_index);
}
inline qtraj_status vector_init(void* memory, size_t bytes, const qtraj_options* options, const double* times,
                                const float* values, const float* first, const float* second, size_t count, size_t dim,
                                qtraj_vector_curve** out, size_t* bad_index) {
  return qtraj_vector_init_f32(memory, bytes, options, times, values, first, second, count, dim, out, bad_index);
}
inline qtraj_status vector_sample(const qtraj_vector_curve* curve, const double* times, size_t count, double* value,
                                  double* first, double* second, size_t* bad_index) {
  return qtraj_vector_sample(curve, times, count, value, first, second, bad_index);
}
inline qtraj_status vector_sample(const qtraj_vector_curve* curve, const double* times, size_t count, float* value,
                                  float* first, float* second, size_t* bad_index) {
  return qtraj_vector_sample_f32(curve, times, count, value, first, second, bad_index);
}
inline qtraj_status vector_sample_uniform(const qtraj_vector_curve* curve, double start, double step, size_t count,
                                          double* value, double* first, double* second, size_t* bad_index) {
  return qtraj_vector_sample_uniform(curve, start, step, count, value, first, second, bad_index);
}
inline qtraj_status vector_sample_uniform(const qtraj_vector_curve* curve, double start, double step, size_t count,
                                          float* value, float* first, float* second, size_t* bad_index) {
  return qtraj_vector_sample_uniform_f32(curve, start, step, count, value, first, second, bad_index);
}
inline qtraj_status vector_sample_at(const qtraj_vector_curve* curve, double time, size_t* cursor, double* value,
                                     double* first, double* second) {
  return qtraj_vector_sample_at(curve, time, cursor, value, first, second);
}
inline qtraj_status vector_sample_at(const qtraj_vector_curve* curve, double time, size_t* cursor, float* value,
                                     float* first, float* second) {
  return qtraj_vector_sample_at_f32(curve, time, cursor, value, first, second);
}

// ---- Variants: a method with its ends ----

struct VectorVariant {
  std::string name;
  int32_t method, start = QTRAJ_END_DEFAULT, end = QTRAJ_END_DEFAULT;

  bool gives_end() const { return start == QTRAJ_END_GIVEN || end == QTRAJ_END_GIVEN; }
  bool needs_first() const { return method >= QTRAJ_VECTOR_HERMITE || gives_end(); }
  bool needs_second() const { return method == QTRAJ_VECTOR_QUINTIC; }
  size_t first_rows(size_t count) const { return method == QTRAJ_VECTOR_CUBIC ? 2 : count; }
};

inline const std::vector<VectorVariant>& vector_variants() {
  static const std::vector<VectorVariant> all = [] {
    std::vector<VectorVariant> list = {{"STEP", QTRAJ_VECTOR_STEP},
                                       {"LINEAR", QTRAJ_VECTOR_LINEAR},
                                       {"HERMITE", QTRAJ_VECTOR_HERMITE},
                                       {"QUINTIC", QTRAJ_VECTOR_QUINTIC},
                                       {"CUBIC", QTRAJ_VECTOR_CUBIC}};
    const Constant open[] = {
        {" NATURAL", QTRAJ_END_NATURAL}, {" NOT_A_KNOT", QTRAJ_END_NOT_A_KNOT}, {" GIVEN", QTRAJ_END_GIVEN}};
    for (const Constant& start : open)
      for (const Constant& end : open)
        list.push_back({std::string("CUBIC") + start.name + end.name, QTRAJ_VECTOR_CUBIC, start.value, end.value});
    list.push_back({"CUBIC PERIODIC", QTRAJ_VECTOR_CUBIC, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC});
    return list;
  }();
  return all;
}

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
