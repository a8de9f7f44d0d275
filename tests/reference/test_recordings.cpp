// Recorded attitudes as they come: norms off, signs flipped, poses repeated, steps from 0.1 ms to 12 s.
#include <cmath>
#include <map>

#include "support/recording.hpp"
#include "support/trajectory.hpp"

namespace {

using test::Keys;
using test::Quaternion;
using test::Trajectory;

constexpr double kEps = 0x1p-52;

// |norm - 1| of a row, the norm taken in extended precision.
double norm_error(const double* q) {
  long double sum = 0;
  for (int k = 0; k < 4; ++k) sum += static_cast<long double>(q[k]) * q[k];
  return static_cast<double>(std::fabs(std::sqrt(sum) - 1.0L));
}

Quaternion normalized(const Quaternion& q) {
  long double sum = 0;
  for (const double component : q) sum += static_cast<long double>(component) * component;
  Quaternion unit;
  for (size_t k = 0; k < 4; ++k) unit[k] = static_cast<double>(q[k] / std::sqrt(sum));
  return unit;
}

double dot(const Keys& keys, size_t a, size_t b) {
  double sum = 0;
  for (size_t k = 0; k < 4; ++k) sum += keys.orientation(a)[k] * keys.orientation(b)[k];
  return sum;
}

// Half-angle from the first key along the shorter way at every step: at least |p| of a LOG_SPLINE at the key.
std::vector<double> turned(const Keys& keys) {
  std::vector<double> angles = {0.0};
  for (size_t key = 1; key < keys.count(); ++key)
    angles.push_back(angles.back() + std::acos(std::min(1.0, std::abs(dot(keys, key - 1, key)))));
  return angles;
}

double worst_norm_error(const Trajectory& trajectory, const Keys& keys) {
  constexpr size_t kPerSegment = 1000;
  double worst = 0;
  std::vector<double> q(4 * kPerSegment);
  for (size_t segment = 0; segment + 1 < keys.count(); ++segment) {
    const double start = keys.times[segment], step = (keys.times[segment + 1] - start) / kPerSegment;
    REQUIRE(qtraj_sample_uniform(trajectory.get(), start, step, kPerSegment, q.data(), nullptr) == QTRAJ_OK);
    for (size_t i = 0; i < kPerSegment; ++i) worst = std::max(worst, norm_error(&q[4 * i]));
  }
  return worst;
}

double worst_key_error(const Trajectory& trajectory, const Keys& recorded, bool grows_with_angle) {
  const std::vector<double> q = trajectory.sample(recorded.times), angles = turned(recorded);
  double worst = 0;
  for (size_t key = 0; key < recorded.count(); ++key) {
    const Quaternion unit = normalized(recorded.orientation(key));
    const Quaternion sample = {q[4 * key], q[4 * key + 1], q[4 * key + 2], q[4 * key + 3]};
    const Quaternion opposite = {-unit[0], -unit[1], -unit[2], -unit[3]};
    const double error = std::min(test::largest_difference(sample, unit), test::largest_difference(sample, opposite));
    worst = std::max(worst, grows_with_angle ? error / (1.0 + angles[key]) : error);
  }
  return worst;
}

}  // namespace

TEST_CASE("every recording goes through every method, its keys met and all samples unit", "[recordings]") {
  for (const test::Recording& recording : test::all_recordings()) {
    for (const int32_t method : {QTRAJ_SLERP, QTRAJ_NLERP, QTRAJ_SQUAD, QTRAJ_LOG_SPLINE}) {
      CAPTURE(recording.name, method);
      const Trajectory trajectory({method}, recording.keys);
      CHECK(worst_key_error(trajectory, recording.keys, method == QTRAJ_LOG_SPLINE) <= 1e-15);
      CHECK(worst_norm_error(trajectory, recording.keys) <= 4 * kEps);
    }
  }
}

TEST_CASE("the getters report what was cleaned in a recording", "[recordings]") {
  struct Facts {
    size_t keys, sign_changes;
    double norm_error;
  };
  // from examples/data/README.md
  const std::map<std::string, Facts> expected = {{"cassini_turn", {2428, 1, 2.3e-5}},
                                                 {"juno_spinner", {96, 3, 1e-6}},
                                                 {"newhorizons_signflip", {425, 2, 1e-6}},
                                                 {"tum_fr2_desk_head", {8000, 20, 8.6e-5}}};
  size_t found = 0;
  for (const test::Recording& recording : test::all_recordings()) {
    const auto facts = expected.find(recording.name);
    if (facts == expected.end()) continue;
    ++found;
    CAPTURE(recording.name);
    // after an odd number of sign changes every key has the other sign
    size_t sign_changes = 0, keys_changed = 0;
    for (size_t key = 1; key < recording.keys.count(); ++key) {
      if (dot(recording.keys, key - 1, key) < 0) ++sign_changes;
      keys_changed += sign_changes % 2;
    }
    CHECK(sign_changes == facts->second.sign_changes);
    const Trajectory trajectory({QTRAJ_SLERP}, recording.keys);
    CHECK(qtraj_sign_flips(trajectory.get()) == keys_changed);
    CHECK(qtraj_key_count(trajectory.get()) == facts->second.keys);
    CHECK(qtraj_worst_norm_error(trajectory.get()) <= 1.05 * facts->second.norm_error);
    CHECK(qtraj_least_dot(trajectory.get()) > 0.9);
  }
  CHECK(found == expected.size());
}
