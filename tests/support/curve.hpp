// All that decides a curve, rates at the keys included, and its trajectory.
#ifndef QTRAJ_TESTS_CURVE_HPP
#define QTRAJ_TESTS_CURVE_HPP

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/trajectory.hpp"
#include "support/worst.hpp"

namespace test {

// A method with its settings, under a name for messages.
struct Variant {
  std::string name;
  Settings settings;

  bool is(int32_t method) const { return settings.method == method; }
  bool needs_omega() const { return settings.method >= QTRAJ_HERMITE || settings.tangents == QTRAJ_TANGENT_GIVEN; }
  bool needs_alpha() const { return is(QTRAJ_ROTATION_QUINTIC) || is(QTRAJ_QUATERNION_QUINTIC); }
  bool needs_end_rates() const { return settings.end == QTRAJ_END_GIVEN; }
  bool is_closed() const { return settings.end == QTRAJ_END_PERIODIC; }
};

// Every method with every setting that changes its curve. REFERENCE_GIVEN has its quaternion still to be set.
inline std::vector<Variant> all_variants() {
  const struct {
    int32_t value;
    const char* name;
  } ends[] = {{QTRAJ_END_CHORD, "CHORD"},         {QTRAJ_END_NATURAL, "NATURAL"}, {QTRAJ_END_NOT_A_KNOT, "NOT_A_KNOT"},
              {QTRAJ_END_ESTIMATED, "ESTIMATED"}, {QTRAJ_END_GIVEN, "GIVEN"},     {QTRAJ_END_PERIODIC, "PERIODIC"}};
  std::vector<Variant> variants = {{"SLERP", {QTRAJ_SLERP}},
                                   {"NLERP", {QTRAJ_NLERP}},
                                   {"SQUAD with rates", {QTRAJ_SQUAD, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_GIVEN}},
                                   {"HERMITE", {QTRAJ_HERMITE}},
                                   {"ROTATION_QUINTIC", {QTRAJ_ROTATION_QUINTIC}},
                                   {"QUATERNION_QUINTIC", {QTRAJ_QUATERNION_QUINTIC}}};
  for (const auto& end : ends) {
    const bool log_only = end.value == QTRAJ_END_NOT_A_KNOT, natural = end.value == QTRAJ_END_NATURAL;
    const bool periodic = end.value == QTRAJ_END_PERIODIC;
    const std::string suffix = std::string(" ") + end.name;
    if (!log_only && !natural) {
      variants.push_back({"SQUAD CATMULL_ROM" + suffix, {QTRAJ_SQUAD, end.value, QTRAJ_TANGENT_CATMULL_ROM}});
      variants.push_back({"SQUAD MEAN_VELOCITY" + suffix, {QTRAJ_SQUAD, end.value, QTRAJ_TANGENT_MEAN_VELOCITY}});
    }
    if (!log_only) variants.push_back({"ROTATION_SPLINE" + suffix, {QTRAJ_ROTATION_SPLINE, end.value}});
    if (log_only || natural || periodic) {
      variants.push_back({"LOG_SPLINE FIRST" + suffix, {QTRAJ_LOG_SPLINE, end.value, 0, QTRAJ_REFERENCE_FIRST}});
      variants.push_back({"LOG_SPLINE MEAN" + suffix, {QTRAJ_LOG_SPLINE, end.value, 0, QTRAJ_REFERENCE_MEAN}});
      variants.push_back({"LOG_SPLINE GIVEN" + suffix, {QTRAJ_LOG_SPLINE, end.value, 0, QTRAJ_REFERENCE_GIVEN}});
    }
  }
  return variants;
}

struct Curve {
  Variant variant;
  Keys keys;
  int32_t frame;                     // of the rates
  std::vector<Vector> omega, alpha;  // at the keys, of which build takes what the method needs
};

inline std::vector<double> flat(const std::vector<Vector>& vectors) {
  std::vector<double> components;
  for (const Vector& v : vectors) components.insert(components.end(), v.begin(), v.end());
  return components;
}

// Handle of a curve; owned by the caller.
inline qtraj_trajectory* build_handle(const Curve& curve) {
  qtraj_options* options = make_options(curve.variant.settings);
  if (curve.variant.needs_end_rates())
    REQUIRE(qtraj_options_set_end_rates(options, curve.frame, curve.omega.front().data(), curve.omega.back().data()) ==
            QTRAJ_OK);
  const std::vector<double> omega = flat(curve.omega), alpha = flat(curve.alpha);
  const Keys& keys = curve.keys;
  qtraj_trajectory* handle = nullptr;
  const qtraj_status status =
      curve.variant.needs_omega()
          ? qtraj_create_with_rates(options, curve.frame, keys.times.data(), keys.q.data(), omega.data(),
                                    curve.variant.needs_alpha() ? alpha.data() : nullptr, keys.count(), &handle,
                                    nullptr)
          : qtraj_create_with_options(options, keys.times.data(), keys.q.data(), keys.count(), &handle, nullptr);
  qtraj_options_destroy(options);
  REQUIRE(status == QTRAJ_OK);
  return handle;
}

inline Trajectory build(const Curve& curve) { return Trajectory(build_handle(curve)); }

}  // namespace test

#endif
