// Spacecraft that recorded their angular velocity beside their attitude: the curve through the attitudes has the rates
// that the gyroscopes measured.
#include <algorithm>
#include <vector>

#include "support/derivative.hpp"
#include "support/recording.hpp"

namespace {

using test::Keys;
using test::Quaternion;
using test::Trajectory;
using test::Vector;

// Attitudes, body to inertial axes, with the measured angular velocities in inertial axes.
struct Telemetry {
  Keys keys;
  std::vector<Vector> omega_world;
};

// examples/data/README.md: the files hold SPICE's quaternion, v_body = q v_ref q*, so ours is its conjugate.
Telemetry read_telemetry(const std::string& file) {
  Telemetry telemetry;
  std::ifstream stream = test::open_data(file);
  std::string line;
  while (std::getline(stream, line)) {
    const std::vector<double> row = test::numbers(line);
    if (row.size() != 8) continue;
    telemetry.keys.add(row[0], {row[1], -row[2], -row[3], -row[4]});
    telemetry.omega_world.push_back({row[5], row[6], row[7]});
  }
  return telemetry;
}

double median(std::vector<double> values) {
  REQUIRE(!values.empty());
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// Median of |omega - measured| over the keys, rad/s.
double median_difference(const Telemetry& telemetry, const std::vector<Vector>& measured, int32_t end, int32_t frame) {
  const Trajectory trajectory({QTRAJ_ROTATION_SPLINE, end}, telemetry.keys);
  const std::vector<double> omega = trajectory.sample_rates(frame, telemetry.keys.times).omega;
  std::vector<double> differences;
  for (size_t key = 0; key < telemetry.keys.count(); ++key)
    differences.push_back(test::distance({omega[3 * key], omega[3 * key + 1], omega[3 * key + 2]}, measured[key]));
  return median(differences);
}

Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }

}  // namespace

TEST_CASE("rates of ROTATION_SPLINE through recorded attitudes are the measured ones", "[telemetry][rotation_spline]") {
  const struct {
    const char* file;
    size_t keys;
    double agreement;  // rad/s
  } recordings[] = {
      {"juno_spinner.csv", 96, 2e-6}, {"cassini_turn.csv", 2428, 4e-5}, {"newhorizons_signflip.csv", 425, 1e-5}};
  for (const auto& recording : recordings) {
    const Telemetry telemetry = read_telemetry(recording.file);
    CAPTURE(recording.file);
    REQUIRE(telemetry.keys.count() == recording.keys);

    // the same in body axes: world rates turned into them by each attitude
    std::vector<Vector> omega_body;
    for (size_t key = 0; key < telemetry.keys.count(); ++key)
      omega_body.push_back(test::rotate(conjugate(telemetry.keys.orientation(key)), telemetry.omega_world[key]));

    for (const int32_t end : {QTRAJ_END_ESTIMATED, QTRAJ_END_CHORD, QTRAJ_END_NATURAL}) {
      CAPTURE(end);
      const double world = median_difference(telemetry, telemetry.omega_world, end, QTRAJ_FRAME_WORLD);
      const double body = median_difference(telemetry, omega_body, end, QTRAJ_FRAME_BODY);
      CAPTURE(world, body);
      CHECK(world <= recording.agreement);
      CHECK(body <= recording.agreement);
    }
  }
}

TEST_CASE("measured rates tell the frames apart", "[telemetry][rotation_spline]") {
  for (const char* file : {"juno_spinner.csv", "cassini_turn.csv", "newhorizons_signflip.csv"}) {
    const Telemetry telemetry = read_telemetry(file);
    const int32_t end = QTRAJ_END_ESTIMATED;
    CAPTURE(file);
    CHECK(median_difference(telemetry, telemetry.omega_world, end, QTRAJ_FRAME_BODY) >
          3 * median_difference(telemetry, telemetry.omega_world, end, QTRAJ_FRAME_WORLD));
  }
}
