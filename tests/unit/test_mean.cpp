#include <Eigen/Eigenvalues>
#include <cfloat>

#include "means/eigen_mean.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using qtraj::Quaternion;
using qtraj::Status;

double difference_of_orientations(const Quaternion& a, const Quaternion& b) {
  return std::min((a - b).cwiseAbs().maxCoeff(), (a + b).cwiseAbs().maxCoeff());
}

}  // namespace

TEST_CASE("the scatter's top eigenvector satisfies its equation to rounding", "[mean]") {
  test::Random random(1);
  for (int set = 0; set < 200; ++set) {
    qtraj::OrientationScatter scatter;
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    const test::Quaternion center = random.orientation();
    for (int i = 0; i < 12; ++i) {
      const test::Quaternion q = test::multiply(center, test::turn_within(random, 1.5));
      const Quaternion sample = (i % 2 == 0 ? 1.0 : -1.0) * Quaternion(q[0], q[1], q[2], q[3]);
      const double weight = random.uniform(0, 2);
      scatter.add(sample, weight);
      sum += weight * sample * sample.transpose();
    }
    Quaternion mean;
    REQUIRE(scatter.top_eigenvector(DBL_EPSILON, mean) == Status::ok);
    const double value = mean.dot(sum * mean);
    CHECK((sum * mean - value * mean).norm() <= 4e-15 * sum.trace());
    CHECK(std::abs(mean.norm() - 1) <= 1e-15);
    CHECK(value >= Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(sum).eigenvalues()[3] - 1e-12);
  }
}

TEST_CASE("one sample is its own mean, and opposite signs do not matter", "[mean]") {
  test::Random random(2);
  const test::Quaternion q = random.orientation();
  const Quaternion sample(q[0], q[1], q[2], q[3]);
  for (const double sign : {1.0, -1.0}) {
    qtraj::OrientationScatter scatter;
    scatter.add(sample, 1.0);
    scatter.add(sign * sample, 3.0);
    Quaternion mean;
    REQUIRE(scatter.top_eigenvector(DBL_EPSILON, mean) == Status::ok);
    CHECK(difference_of_orientations(mean, sample) <= 4e-16);
  }
}

TEST_CASE("orientations that differ by less than a square can hold have a mean", "[mean][singular]") {
  for (const double e : {1e-82, 1e-90, 1e-160, 1e-300}) {
    qtraj::OrientationScatter scatter;
    for (int i = 0; i < 3; ++i) scatter.add(Quaternion(1, i * e, e, 0), 1.0);
    Quaternion mean;
    REQUIRE(scatter.top_eigenvector(DBL_EPSILON, mean) == Status::ok);
    CHECK(difference_of_orientations(mean, Quaternion(1, 0, 0, 0)) <= 1e-15);
  }
}

TEST_CASE("evenly spread orientations have no mean", "[mean][singular]") {
  qtraj::OrientationScatter four, two;
  for (int k = 0; k < 4; ++k) four.add(Quaternion::Unit(k), 1.0);
  for (int k = 0; k < 2; ++k) two.add(Quaternion::Unit(k), 1.0);  // a half turn apart
  Quaternion mean;
  CHECK(four.top_eigenvector(DBL_EPSILON, mean) == Status::ambiguous);
  CHECK(two.top_eigenvector(DBL_EPSILON, mean) == Status::ambiguous);
  two.add(Quaternion::Unit(0), 1e-6);
  CHECK(two.top_eigenvector(DBL_EPSILON, mean) == Status::ok);
  CHECK(two.top_eigenvector(FLT_EPSILON, mean) == Status::ambiguous);  // within the rounding of float samples
}
