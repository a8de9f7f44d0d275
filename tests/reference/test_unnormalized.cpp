// The curve in R^4 and its derivatives against values computed at 60 digits (tests/reference/unnormalized.py).
#include <cfloat>
#include <fstream>
#include <sstream>

#include "support/trajectory.hpp"
#include "support/worst.hpp"

namespace {

struct Row {
  double time, expected[3][4], h, size;
};
struct ReferenceCurve {
  std::string method;
  std::vector<double> times, q, omega, alpha;
  std::vector<Row> rows;
};

std::vector<ReferenceCurve> read_curves() {
  std::ifstream stream(QTRAJ_REFERENCE_DIR "/unnormalized.txt");
  REQUIRE(stream.is_open());
  std::vector<ReferenceCurve> curves;
  std::string line, word;
  while (std::getline(stream, line)) {
    if (line[0] == '#') continue;
    ReferenceCurve curve;
    size_t keys = 0, samples = 0;
    REQUIRE(std::istringstream(line) >> word >> curve.method >> keys >> samples);
    const bool has_rates = curve.method == "quintic";
    for (size_t key = 0; key < keys; ++key) {
      std::vector<double> numbers(has_rates ? 11 : 5);
      for (double& number : numbers) REQUIRE(stream >> number);
      curve.times.push_back(numbers[0]);
      curve.q.insert(curve.q.end(), &numbers[1], &numbers[1] + 4);
      if (!has_rates) continue;
      curve.omega.insert(curve.omega.end(), &numbers[5], &numbers[5] + 3);
      curve.alpha.insert(curve.alpha.end(), &numbers[8], &numbers[8] + 3);
    }
    for (size_t sample = 0; sample < samples; ++sample) {
      Row row;
      REQUIRE(stream >> row.time);
      for (auto& array : row.expected)
        for (double& number : array) REQUIRE(stream >> number);
      REQUIRE(stream >> row.h >> row.size);
      curve.rows.push_back(row);
    }
    std::getline(stream, line);
    curves.push_back(curve);
  }
  return curves;
}

qtraj_trajectory* build(const ReferenceCurve& curve) {
  qtraj_trajectory* handle = nullptr;
  qtraj_options* options = nullptr;
  const bool has_rates = curve.method == "quintic";
  REQUIRE(qtraj_options_create(has_rates ? QTRAJ_QUATERNION_QUINTIC : QTRAJ_NLERP, &options) == QTRAJ_OK);
  const size_t count = curve.times.size();
  if (has_rates)
    REQUIRE(qtraj_create_with_rates(options, QTRAJ_FRAME_WORLD, curve.times.data(), curve.q.data(), curve.omega.data(),
                                    curve.alpha.data(), count, &handle, nullptr) == QTRAJ_OK);
  else
    REQUIRE(qtraj_create_with_options(options, curve.times.data(), curve.q.data(), count, &handle, nullptr) ==
            QTRAJ_OK);
  qtraj_options_destroy(options);
  return handle;
}

double error(const double* found, const double (&expected)[4]) {
  double sum = 0;
  for (size_t k = 0; k < 4; ++k) sum += (found[k] - expected[k]) * (found[k] - expected[k]);
  return std::sqrt(sum);
}

TEST_CASE("the curve in R^4 and its derivatives agree with 60-digit values", "[unnormalized]") {
  double worst[3] = {0, 0, 0};
  const std::vector<ReferenceCurve> curves = read_curves();
  REQUIRE(curves.size() == 12);
  for (const ReferenceCurve& curve : curves) {
    qtraj_trajectory* const trajectory = build(curve);
    const size_t count = curve.rows.size();
    std::vector<double> times, p(4 * count), dp(4 * count), ddp(4 * count);
    for (const Row& row : curve.rows) times.push_back(row.time);
    CHECK(qtraj_sample_unnormalized(trajectory, times.data(), count, p.data(), dp.data(), ddp.data(), nullptr) ==
          QTRAJ_OK);
    for (size_t i = 0; i < count; ++i) {
      const Row& row = curve.rows[i];
      // the bounds of curve/unnormalized.hpp
      test::raise_to(worst[0], error(&p[4 * i], row.expected[0]) / (2 * DBL_EPSILON * (1 + row.size)));
      test::raise_to(worst[1], error(&dp[4 * i], row.expected[1]) / (12 * DBL_EPSILON * row.size / row.h));
      test::raise_to(worst[2], error(&ddp[4 * i], row.expected[2]) / (120 * DBL_EPSILON * row.size / (row.h * row.h)));
    }
    qtraj_destroy(trajectory);
  }
  CAPTURE(worst[0], worst[1], worst[2]);
  for (const double ratio : worst) CHECK(ratio <= 1);
}

}  // namespace
