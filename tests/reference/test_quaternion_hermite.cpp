// QUATERNION_HERMITE against values computed at 60 digits (quaternion_hermite.py).
#include <cfloat>
#include <fstream>
#include <sstream>

#include "support/trajectory.hpp"
#include "support/worst.hpp"

namespace {

struct TangentCurve {
  int32_t turns;
  std::vector<double> times, q, in_tangents, out_tangents;
  std::vector<double> sample_times, expected, size;  // [10] a sample: q, omega, alpha, body frame; S/|p|
};

std::vector<double> numbers_of(std::ifstream& stream, size_t count) {
  std::vector<double> numbers(count);
  for (double& number : numbers) REQUIRE(stream >> number);
  return numbers;
}

std::vector<TangentCurve> read_curves() {
  std::ifstream stream(QTRAJ_REFERENCE_DIR "/quaternion_hermite.txt");
  REQUIRE(stream.is_open());
  std::vector<TangentCurve> curves;
  for (std::string line, word, rule; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    size_t count = 0;
    REQUIRE(std::istringstream(line) >> word >> rule >> count);
    TangentCurve curve;
    curve.turns = rule == "shortest" ? QTRAJ_TURNS_SHORTEST : QTRAJ_TURNS_AS_GIVEN;
    for (size_t key = 0; key < count; ++key) {
      const std::vector<double> row = numbers_of(stream, 13);
      curve.times.push_back(row[0]);
      curve.q.insert(curve.q.end(), &row[1], &row[5]);
      curve.in_tangents.insert(curve.in_tangents.end(), &row[5], &row[9]);
      curve.out_tangents.insert(curve.out_tangents.end(), &row[9], row.data() + 13);
    }
    REQUIRE(stream >> word >> count);
    for (size_t i = 0; i < count; ++i) {
      const std::vector<double> row = numbers_of(stream, 12);
      curve.sample_times.push_back(row[0]);
      curve.expected.insert(curve.expected.end(), &row[1], &row[11]);
      curve.size.push_back(row[11]);
    }
    curves.push_back(curve);
  }
  return curves;
}

test::Trajectory build(const TangentCurve& curve) {
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(QTRAJ_QUATERNION_HERMITE, &options) == QTRAJ_OK);
  REQUIRE(qtraj_options_set_turns(options, curve.turns) == QTRAJ_OK);
  qtraj_trajectory* handle = nullptr;
  const qtraj_status status =
      qtraj_create_with_tangents(options, curve.times.data(), curve.q.data(), curve.in_tangents.data(),
                                 curve.out_tangents.data(), curve.times.size(), &handle, nullptr);
  qtraj_options_destroy(options);
  REQUIRE(status == QTRAJ_OK);
  return test::Trajectory(handle);
}

template <class Real>
double largest(const Real* a, const double* b, size_t count) {
  double worst = 0;
  for (size_t k = 0; k < count; ++k) test::raise_to(worst, std::abs(static_cast<double>(a[k]) - b[k]));
  return worst;
}
double length(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

}  // namespace

TEST_CASE("QUATERNION_HERMITE meets values of 60 digits, with its rates", "[reference][quaternion_hermite]") {
  const std::vector<TangentCurve> curves = read_curves();
  REQUIRE(curves.size() == 12);
  // of the bounds of docs/accuracy.md
  double worst_q = 0, worst_float = 0, worst_omega = 0, worst_alpha = 0, worst_float_rate = 0;
  for (const TangentCurve& curve : curves) {
    CAPTURE(curve.times[0], curve.q[0]);
    const test::Trajectory trajectory = build(curve);
    const auto motion = trajectory.sample_rates(QTRAJ_FRAME_BODY, curve.sample_times);
    const std::vector<float> single = trajectory.sample_f32(curve.sample_times);
    const size_t count = curve.sample_times.size();
    std::vector<float> omega(3 * count), alpha(3 * count);
    REQUIRE(qtraj_sample_rates_f32(trajectory.get(), QTRAJ_FRAME_BODY, curve.sample_times.data(), count, nullptr,
                                   omega.data(), alpha.data(), nullptr) == QTRAJ_OK);
    double fastest = 0, hardest = 0;
    for (size_t i = 0; i < count; ++i) {
      test::raise_to(fastest, length(&curve.expected[10 * i + 4]));
      test::raise_to(hardest, length(&curve.expected[10 * i + 7]));
    }
    for (size_t i = 1; i < curve.times.size(); ++i)
      test::raise_to(hardest, fastest / (curve.times[i] - curve.times[i - 1]));
    for (size_t i = 0; i < count; ++i) {
      const double* expected = &curve.expected[10 * i];
      const double share = 1 + curve.size[i];
      test::raise_to(worst_q, largest(&motion.q[4 * i], expected, 4) / (2e-16 * share));
      test::raise_to(worst_float, largest(&single[4 * i], expected, 4) / (1.1e-7 * share));
      test::raise_to(worst_omega, largest(&motion.omega[3 * i], expected + 4, 3) / (1e-13 * fastest));
      test::raise_to(worst_alpha, largest(&motion.alpha[3 * i], expected + 7, 3) / (1e-13 * hardest));
      test::raise_to(worst_float_rate, largest(&omega[3 * i], expected + 4, 3) / (1e-5 * fastest));
      test::raise_to(worst_float_rate, largest(&alpha[3 * i], expected + 7, 3) / (1e-5 * hardest));
    }
  }
  CAPTURE(worst_q, worst_float, worst_omega, worst_alpha, worst_float_rate);
  CHECK(worst_q <= 1);
  CHECK(worst_float <= 1);
  CHECK(worst_omega <= 1);
  CHECK(worst_alpha <= 1);
  CHECK(worst_float_rate <= 1);
}
