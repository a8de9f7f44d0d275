// exp, log, rotation vectors and distances in float: error bounds on a million rows, and their singular cases.
#include <qtraj.h>

#include "support/catch.hpp"
#include "support/hard_rows.hpp"

namespace {

using namespace test;

constexpr double kFloatEps = FLT_EPSILON, kLeastFloat = 1.5e-45;

std::vector<float> in_float(const std::vector<double>& numbers) {
  return std::vector<float>(numbers.begin(), numbers.end());
}

// Norms so large and so small that rows are done in float and in double, and none is 0 or infinite.
const std::vector<double>& quaternions() {
  static const std::vector<double> rows = HardRows(41, 30).quaternions();
  return rows;
}

TEST_CASE("C API: exponentials in float are within 1.5 eps of float", "[capi][exponential]") {
  Random random(42);
  std::vector<double> rows;
  for (size_t row = 0; row < kHardRows; ++row) {
    const Vector direction = hard_direction(random);
    const double length = row % 3 == 0   ? std::pow(10.0, random.uniform(-44, 0))
                          : row % 3 == 1 ? hard_angle(random)
                                         : random.uniform(0, 20);
    append(rows, Vector{length * direction[0], length * direction[1], length * direction[2]});
  }
  const std::vector<float> v = in_float(rows);
  std::vector<float> q(4 * kHardRows), q_of_half(4 * kHardRows);
  REQUIRE(qtraj_exp_f32(v.data(), kHardRows, q.data(), nullptr) == QTRAJ_OK);
  REQUIRE(qtraj_q_from_rotation_vector_f32(v.data(), kHardRows, q_of_half.data(), nullptr) == QTRAJ_OK);
  Worst worst, worst_of_half;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Vector vector = wide::vector(&v[3 * row]);
    worst.add(row, wide::error(&q[4 * row], wide::exp(vector)), 1.5 * kFloatEps);
    worst_of_half.add(row, wide::error(&q_of_half[4 * row], wide::exp(wide::scaled(0.5L, vector))), 1.5 * kFloatEps);
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_of_half.ratio <= 1);
}

TEST_CASE("C API: logs and rotation vectors in float are good to 4 eps of float", "[capi][exponential]") {
  const std::vector<float> q = in_float(quaternions());
  std::vector<float> v(3 * kHardRows), r(3 * kHardRows);
  CHECK(qtraj_log_f32(q.data(), kHardRows, v.data(), nullptr) == QTRAJ_E_AMBIGUOUS);
  REQUIRE(qtraj_rotation_vector_from_q_f32(q.data(), kHardRows, r.data(), nullptr) == QTRAJ_OK);
  Worst worst, worst_rotation;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Quaternion wide_q = wide::quaternion(&q[4 * row]);
    const bool ambiguous = q[4 * row] < 0 && wide::norm(wide::vector_part(wide_q)) == 0;
    const wide::Vector log = ambiguous ? wide::Vector{wide::kPi, 0, 0} : wide::log(wide_q);
    // the shorter way
    const wide::Vector rotation = wide::scaled(2, wide::log(q[4 * row] < 0 ? wide::scaled(-1, wide_q) : wide_q));
    for (size_t k = 0; k < 3; ++k) {
      worst.add(row, static_cast<double>(std::abs(v[3 * row + k] - log[k])),
                static_cast<double>(4 * kFloatEps * std::abs(log[k])) + kLeastFloat);
      worst_rotation.add(row, static_cast<double>(std::abs(r[3 * row + k] - rotation[k])),
                         static_cast<double>(4 * kFloatEps * std::abs(rotation[k])) + kLeastFloat);
    }
  }
  CHECK(worst.ratio <= 1);
  CHECK(worst_rotation.ratio <= 1);
}

TEST_CASE("C API: distances in float are good to 0.51 eps of float, exact at 0 and pi", "[capi][algebra]") {
  const std::vector<float> a = in_float(quaternions()), b = in_float(HardRows(43, 30).neighbours(quaternions()));
  std::vector<float> opposite(a), distance(kHardRows);
  for (float& component : opposite) component = -component;
  REQUIRE(qtraj_distance_f32(a.data(), kHardRows, b.data(), kHardRows, kHardRows, distance.data(), nullptr) ==
          QTRAJ_OK);
  Worst worst;
  for (size_t row = 0; row < kHardRows; ++row) {
    const wide::Real reference = wide::angle(wide::quaternion(&a[4 * row]), wide::quaternion(&b[4 * row]));
    worst.add(row, static_cast<double>(std::abs(distance[row] - reference)),
              static_cast<double>(0.51 * kFloatEps * reference) + 1e-15);
  }
  CHECK(worst.ratio <= 1);
  const auto count_unlike = [&](const std::vector<float>& from, float angle) {
    REQUIRE(qtraj_distance_f32(a.data(), kHardRows, from.data(), kHardRows, kHardRows, distance.data(), nullptr) ==
            QTRAJ_OK);
    size_t unlike = 0;
    for (const float value : distance) unlike += value != angle;
    return unlike;
  };
  CHECK(count_unlike(a, 0.0f) == 0);
  CHECK(count_unlike(opposite, static_cast<float>(wide::kPi)) == 0);
}

TEST_CASE("C API: in float too the log of 1 is 0, that of -1 is pi about x and ambiguous, and tiny vectors stay",
          "[capi][exponential][singular]") {
  for (const float norm : {1.0f, 1e-30f, 1e30f}) {
    const float one[4] = {norm, 0, 0, 0}, minus_one[4] = {-norm, 0, 0, 0};
    float v[3] = {7, 7, 7};
    CHECK(qtraj_log_f32(one, 1, v, nullptr) == QTRAJ_OK);
    CHECK((v[0] == 0 && v[1] == 0 && v[2] == 0));
    CHECK(qtraj_log_f32(minus_one, 1, v, nullptr) == QTRAJ_E_AMBIGUOUS);
    CHECK((v[0] == static_cast<float>(wide::kPi) && v[1] == 0 && v[2] == 0));
    CHECK(qtraj_rotation_vector_from_q_f32(minus_one, 1, v, nullptr) == QTRAJ_OK);
    CHECK((v[0] == 0 && v[1] == 0 && v[2] == 0));
  }
  for (const float size : {1e-5f, 1e-20f, 1e-38f, 1e-44f}) {
    const float v[3] = {size, -2 * size, 0};
    float q[4], back[3];
    CHECK(qtraj_exp_f32(v, 1, q, nullptr) == QTRAJ_OK);
    CHECK((q[0] == 1 && q[1] == v[0] && q[2] == v[1] && q[3] == 0));
    CHECK(qtraj_log_f32(q, 1, back, nullptr) == QTRAJ_OK);
    CHECK((back[0] == v[0] && back[1] == v[1] && back[2] == 0));
  }
}

}  // namespace
