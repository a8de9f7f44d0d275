// Curves whose steps turn by more than half a turn against values computed at 60 digits (turns.py).
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/trajectory.hpp"

namespace {

struct TurnCurve {
  std::string method, rule;
  std::vector<double> times, q, omega, alpha;  // the keys
  std::vector<int32_t> turns;
  std::vector<double> sample_times, expected;  // [10] a sample: q, omega, alpha
};

std::vector<TurnCurve> read_curves() {
  std::ifstream stream(QTRAJ_REFERENCE_DIR "/turns.txt");
  REQUIRE(stream.is_open());
  std::vector<TurnCurve> curves;
  std::string line;
  const auto row = [&] {
    REQUIRE(std::getline(stream, line));
    return std::istringstream(line);
  };
  const auto read = [](std::istringstream& fields, size_t count, std::vector<double>& to) {
    for (size_t k = 0; k < count; ++k) {
      double value = 0;
      REQUIRE(fields >> value);
      to.push_back(value);
    }
  };
  while (std::getline(stream, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream head(line);
    std::string word;
    size_t count = 0;
    TurnCurve curve;
    REQUIRE(head >> word >> curve.method >> curve.rule >> count);
    REQUIRE(word == "curve");
    for (size_t key = 0; key < count; ++key) {
      auto fields = row();
      read(fields, 1, curve.times), read(fields, 4, curve.q);
      read(fields, 3, curve.omega), read(fields, 3, curve.alpha);
    }
    auto turns = row();
    turns >> word;
    for (int32_t number; turns >> number;) curve.turns.push_back(number);
    REQUIRE(curve.turns.size() == count - 1);
    auto samples = row();
    REQUIRE(samples >> word >> count);
    for (size_t i = 0; i < count; ++i) {
      auto fields = row();
      read(fields, 1, curve.sample_times), read(fields, 10, curve.expected);
    }
    curves.push_back(curve);
  }
  return curves;
}

test::Trajectory build(const TurnCurve& curve) {
  const std::map<std::string, int32_t> methods = {{"slerp", QTRAJ_SLERP},
                                                  {"rotation_spline", QTRAJ_ROTATION_SPLINE},
                                                  {"hermite", QTRAJ_HERMITE},
                                                  {"rotation_quintic", QTRAJ_ROTATION_QUINTIC}};
  const std::map<std::string, int32_t> rules = {
      {"as_given", QTRAJ_TURNS_AS_GIVEN}, {"given", QTRAJ_TURNS_GIVEN}, {"from_rates", QTRAJ_TURNS_FROM_RATES}};
  const int32_t method = methods.at(curve.method), rule = rules.at(curve.rule);
  const bool has_omega = method >= QTRAJ_HERMITE, has_alpha = method == QTRAJ_ROTATION_QUINTIC;
  qtraj_options* options =
      test::make_options({method, method == QTRAJ_ROTATION_SPLINE ? QTRAJ_END_CHORD : QTRAJ_END_DEFAULT});
  REQUIRE(qtraj_options_set_turns(options, rule) == QTRAJ_OK);
  const double *omega = has_omega ? curve.omega.data() : nullptr, *alpha = has_alpha ? curve.alpha.data() : nullptr;
  qtraj_trajectory* handle = nullptr;
  size_t bytes = 0;
  qtraj_status status = QTRAJ_OK;
  if (rule == QTRAJ_TURNS_GIVEN)
    status = qtraj_create_with_turns(options, QTRAJ_FRAME_BODY, curve.times.data(), curve.q.data(), omega, alpha,
                                     curve.turns.data(), curve.times.size(), &handle, &bytes);
  else if (has_omega)
    status = qtraj_create_with_rates(options, QTRAJ_FRAME_BODY, curve.times.data(), curve.q.data(), omega, alpha,
                                     curve.times.size(), &handle, &bytes);
  else
    status =
        qtraj_create_with_options(options, curve.times.data(), curve.q.data(), curve.times.size(), &handle, &bytes);
  qtraj_options_destroy(options);
  REQUIRE(status == QTRAJ_OK);
  return test::Trajectory(handle);
}

double largest(const double* a, const double* b, size_t count) {
  double worst = 0;
  for (size_t k = 0; k < count; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  return worst;
}
double length(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

}  // namespace

TEST_CASE("curves with turns meet values of 60 digits, by every rule", "[reference][turns]") {
  const std::vector<TurnCurve> curves = read_curves();
  CHECK(curves.size() == 14);
  double worst_q = 0, worst_float = 0, worst_omega = 0, worst_alpha = 0;
  bool turned = false;
  for (const TurnCurve& curve : curves) {
    CAPTURE(curve.method, curve.rule, curve.times[0]);
    const test::Trajectory trajectory = build(curve);
    const size_t count = curve.sample_times.size();
    const auto motion = trajectory.sample_rates(QTRAJ_FRAME_BODY, curve.sample_times);
    const std::vector<float> single = trajectory.sample_f32(curve.sample_times);
    // the rotation vector of a segment is known to an eps of it: the longest, with what the rates bulge it
    double exponent = 0, fastest = 0, hardest = 0;
    for (size_t i = 0; i + 1 < curve.times.size(); ++i) {
      const double h = curve.times[i + 1] - curve.times[i];
      exponent = std::max(exponent, 6.3 * (std::abs(curve.turns[i]) + 1) +
                                        h * (length(&curve.omega[3 * i]) + length(&curve.omega[3 * i + 3])));
      turned = turned || curve.turns[i] != 0;
    }
    for (size_t i = 0; i < count; ++i) {
      fastest = std::max(fastest, length(&curve.expected[10 * i + 4]));
      hardest = std::max(hardest, length(&curve.expected[10 * i + 7]));
    }
    for (size_t i = 0; i < count; ++i) {
      const double* expected = &curve.expected[10 * i];
      worst_q = std::max(worst_q, largest(&motion.q[4 * i], expected, 4) / (1 + exponent));
      for (size_t k = 0; k < 4; ++k)
        worst_float = std::max(worst_float, std::abs(double(single[4 * i + k]) - expected[k]) / (1 + exponent));
      worst_omega = std::max(worst_omega, largest(&motion.omega[3 * i], expected + 4, 3) / fastest);
      worst_alpha = std::max(worst_alpha, largest(&motion.alpha[3 * i], expected + 7, 3) / (hardest + fastest));
    }
  }
  CHECK(turned);
  CAPTURE(worst_q, worst_float, worst_omega, worst_alpha);
  CHECK(worst_q <= 6e-16);
  CHECK(worst_float <= 3e-7);
  CHECK(worst_omega <= 1e-13);
  CHECK(worst_alpha <= 1e-13);
}
