// Vector curves that free themselves, one name for the double and the float twin of their functions, and every method
// with all of its ends.
#ifndef QTRAJ_TESTS_VECTOR_HANDLES_HPP
#define QTRAJ_TESTS_VECTOR_HANDLES_HPP

#include <qtraj.h>

#include <memory>
#include <string>
#include <vector>

#include "support/capi_handles.hpp"

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

}  // namespace capi

#endif
