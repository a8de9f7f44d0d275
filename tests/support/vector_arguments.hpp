// The arguments of a vector construction, and what holds after it was refused.
#ifndef QTRAJ_TESTS_VECTOR_ARGUMENTS_HPP
#define QTRAJ_TESTS_VECTOR_ARGUMENTS_HPP

#include "support/vector_curve.hpp"

namespace capi {

// All arguments of a construction, good as they are: create, or init where memory is given.
template <class Real>
struct VectorArguments {
  Options options_of;
  VectorKeys<Real> keys;
  std::vector<double> memory;
  const qtraj_options* options;
  const double* times;
  const Real *values, *first, *second;
  size_t count, dim, bytes = 0, bad = 7;
  qtraj_vector_curve* curve = reinterpret_cast<qtraj_vector_curve*>(&bytes);
  qtraj_vector_curve** out = &curve;

  explicit VectorArguments(const VectorVariant& variant) : options_of(vector_options(variant)) {
    keys = vector_tour<Real>(variant, 6, 3);
    options = options_of.get(), times = keys.times.data(), values = keys.values.data();
    first = keys.first_or_null(), second = keys.second_or_null(), count = 6, dim = 3;
    REQUIRE(qtraj_vector_init_size(options, count, dim, &bytes) == QTRAJ_OK);
    memory.assign(bytes / 8, -7.0);
  }
  qtraj_status create() { return vector_create(options, times, values, first, second, count, dim, out, &bad); }
  qtraj_status init(void* at) {
    return vector_init(at, bytes, options, times, values, first, second, count, dim, out, &bad);
  }
  bool memory_is_untouched() const {
    return std::all_of(memory.begin(), memory.end(), [](double x) { return x == -7.0; });
  }
};

// Changes the arguments, and checks status and index of both ways to build, and that nothing is left of a curve.
template <class Change>
void check_refusal(const VectorVariant& variant, qtraj_status expected, Change&& change, size_t bad_index = SIZE_MAX) {
  for_double_and_float([&](auto zero) {
    for (const bool in_place : {false, true}) {
      CAPTURE(variant.name, in_place);
      VectorArguments<decltype(zero)> a(variant);
      change(a);
      CHECK((in_place ? a.init(a.memory.data()) : a.create()) == expected);
      CHECK(a.bad == bad_index);
      CHECK(a.curve == nullptr);
      if (bad_index == SIZE_MAX) CHECK(a.memory_is_untouched());
    }
  });
}

}  // namespace capi

#endif
