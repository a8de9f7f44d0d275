// The one list of methods from which the tests over all methods and the golden program are made: what each takes and
// needs, and every setting that changes its curve. The gate `methods` compares it with qtraj.h. New methods are
// appended: the golden hashes depend on the order.
#ifndef QTRAJ_TESTS_METHOD_SETTINGS_HPP
#define QTRAJ_TESTS_METHOD_SETTINGS_HPP

#include <qtraj.h>

#include <string>
#include <vector>

namespace capi {

// A constant of qtraj.h with its name for messages; without one, the default.
struct Constant {
  const char* name;
  int32_t value;
};

enum class Needs { nothing, omega, omega_and_alpha, tangents };  // at all keys

struct Method {
  const char* name;
  int32_t value;
  Needs needs = Needs::nothing;
  bool takes_rates = false;  // QTRAJ_TANGENT_GIVEN
  std::vector<Constant> tangents = {{"", QTRAJ_TANGENT_DEFAULT}};
  std::vector<Constant> references = {{"", QTRAJ_REFERENCE_DEFAULT}};
  std::vector<Constant> ends = {{"", QTRAJ_END_DEFAULT}};
};

inline const std::vector<Method>& methods() {
  const Constant chord = {" CHORD", QTRAJ_END_CHORD}, natural = {" NATURAL", QTRAJ_END_NATURAL},
                 not_a_knot = {" NOT_A_KNOT", QTRAJ_END_NOT_A_KNOT}, estimated = {" ESTIMATED", QTRAJ_END_ESTIMATED},
                 given = {" GIVEN", QTRAJ_END_GIVEN}, periodic = {" PERIODIC", QTRAJ_END_PERIODIC};
  static const std::vector<Method> all = [&] {
    std::vector<Method> list = {{"SLERP", QTRAJ_SLERP},
                                {"NLERP", QTRAJ_NLERP},
                                {"HERMITE", QTRAJ_HERMITE, Needs::omega},
                                {"ROTATION_QUINTIC", QTRAJ_ROTATION_QUINTIC, Needs::omega_and_alpha},
                                {"QUATERNION_QUINTIC", QTRAJ_QUATERNION_QUINTIC, Needs::omega_and_alpha}};
    Method squad = {"SQUAD", QTRAJ_SQUAD};
    squad.takes_rates = true;
    squad.tangents = {{" CATMULL_ROM", QTRAJ_TANGENT_CATMULL_ROM},
                      {" MEAN_VELOCITY", QTRAJ_TANGENT_MEAN_VELOCITY},
                      {" REST", QTRAJ_TANGENT_REST}};
    squad.ends = {chord, estimated, given, periodic};
    list.push_back(squad);
    Method log_spline = {"LOG_SPLINE", QTRAJ_LOG_SPLINE};
    log_spline.references = {
        {" FIRST", QTRAJ_REFERENCE_FIRST}, {" MEAN", QTRAJ_REFERENCE_MEAN}, {" GIVEN", QTRAJ_REFERENCE_GIVEN}};
    log_spline.ends = {natural, not_a_knot, periodic};
    list.push_back(log_spline);
    Method rotation_spline = {"ROTATION_SPLINE", QTRAJ_ROTATION_SPLINE};
    rotation_spline.ends = {estimated, chord, natural, given, periodic};
    list.push_back(rotation_spline);
    list.push_back({"QUATERNION_HERMITE", QTRAJ_QUATERNION_HERMITE, Needs::tangents});
    list.push_back({"STEP", QTRAJ_STEP});
    return list;
  }();
  return all;
}

inline std::vector<int32_t> all_methods() {
  std::vector<int32_t> values;
  for (const Method& method : methods()) values.push_back(method.value);
  return values;
}

inline const Method& method_of(int32_t value) {
  size_t row = 0;
  while (methods()[row].value != value) ++row;
  return methods()[row];
}

// Rates at the keys are arguments of some methods; of the others they may be with a setting.
inline bool always_needs_rates(int32_t method) {
  return method_of(method).needs == Needs::omega || method_of(method).needs == Needs::omega_and_alpha;
}
inline bool needs_tangents(int32_t method) { return method_of(method).needs == Needs::tangents; }

struct Variant {
  std::string name;
  int32_t method;
  int32_t end = QTRAJ_END_DEFAULT;
  int32_t tangents = QTRAJ_TANGENT_DEFAULT;
  int32_t reference = QTRAJ_REFERENCE_DEFAULT;

  bool needs_rates() const { return tangents == QTRAJ_TANGENT_GIVEN || always_needs_rates(method); }
  // Whether it moves from key to key; tests/capi/test_step.cpp has what becomes of the one that does not.
  bool is_continuous() const { return method != QTRAJ_STEP; }
  bool needs_alpha() const { return method_of(method).needs == Needs::omega_and_alpha; }
  bool needs_tangents() const { return capi::needs_tangents(method); }
};

// Every method with every setting that changes its curve: "SQUAD CATMULL_ROM CHORD", ...
inline std::vector<Variant> variants() {
  std::vector<Variant> all;
  for (const Method& method : methods()) {
    const std::string name = method.name;
    if (method.takes_rates) all.push_back({name + " with rates", method.value, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_GIVEN});
    for (const Constant& end : method.ends)
      for (const Constant& tangents : method.tangents)
        for (const Constant& reference : method.references)
          all.push_back({name + tangents.name + reference.name + end.name, method.value, end.value, tangents.value,
                         reference.value});
  }
  return all;
}

}  // namespace capi

#endif
