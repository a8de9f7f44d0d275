// All that decides a curve, rates at the keys included, and its trajectory.
#ifndef QTRAJ_TESTS_CURVE_HPP
#define QTRAJ_TESTS_CURVE_HPP

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/method_settings.hpp"
#include "support/trajectory.hpp"
#include "support/worst.hpp"

namespace test {

// A method with its settings, under a name for messages.
struct Variant {
  std::string name;
  Settings settings;

  bool is(int32_t method) const { return settings.method == method; }
  bool needs_omega() const {
    return capi::always_needs_rates(settings.method) || settings.tangents == QTRAJ_TANGENT_GIVEN;
  }
  bool needs_alpha() const { return capi::method_of(settings.method).needs == capi::Needs::omega_and_alpha; }
  bool needs_tangents() const { return capi::needs_tangents(settings.method); }
  bool needs_end_rates() const { return settings.end == QTRAJ_END_GIVEN; }
  bool is_closed() const { return settings.end == QTRAJ_END_PERIODIC; }
};

// Those of method_settings.hpp. REFERENCE_GIVEN has its quaternion still to be set.
inline std::vector<Variant> all_variants() {
  std::vector<Variant> all;
  for (const capi::Variant& v : capi::variants()) all.push_back({v.name, {v.method, v.end, v.tangents, v.reference}});
  return all;
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

// The tangents of a quaternion that turns with the rates of a curve.
inline std::vector<double> tangents_of(const Curve& curve) {
  std::vector<double> tangents;
  for (size_t key = 0; key < curve.keys.count(); ++key) {
    const Vector& w = curve.omega[key];
    const Quaternion half = {0, 0.5 * w[0], 0.5 * w[1], 0.5 * w[2]}, q = curve.keys.orientation(key);
    const Quaternion tangent = curve.frame == QTRAJ_FRAME_BODY ? multiply(q, half) : multiply(half, q);
    tangents.insert(tangents.end(), tangent.begin(), tangent.end());
  }
  return tangents;
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
  const std::vector<double> tangents = tangents_of(curve);
  const qtraj_status status =
      curve.variant.needs_tangents()
          ? qtraj_create_with_tangents(options, keys.times.data(), keys.q.data(), tangents.data(), nullptr,
                                       keys.count(), &handle, nullptr)
      : curve.variant.needs_omega()
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
