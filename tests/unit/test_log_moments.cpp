#include <cfloat>

#include "math/so3.hpp"
#include "math/trigonometry.hpp"
#include "means/log_moments.hpp"
#include "support/capi_means.hpp"
#include "support/catch.hpp"
#include "support/kernel_curves.hpp"
#include "support/long_double_means.hpp"

namespace {

using qtraj::Quaternion;
using qtraj::Vector3;

Quaternion quaternion(const test::Quaternion& q) { return {q[0], q[1], q[2], q[3]}; }

qtraj::WeightedOrientations orientations(const capi::Samples<double>& samples) {
  qtraj::WeightedOrientations result = {qtraj::input<4>(samples.q.data(), samples.count()),
                                        qtraj::input<1>(samples.weights_or_null(), samples.count()), samples.count()};
  REQUIRE((result.scale_weights() && result.first_fault().status == qtraj::Status::ok));
  return result;
}

// Largest errors of sums over the sum of their terms, where an error of 1e-15 rad of each r does not explain them; the
// Hessian's over W, and that of the largest d.
struct MomentErrors {
  double weight = 0, squares = 0, farthest = 0, logs = 0, hessian = 0;

  void raise(const qtraj::LogMoments& at, const wide::Moments& expected) {
    const wide::Real of_r = 1e-15L, of_squares = of_r * (2 * expected.distances + of_r * expected.weight),
                     of_logs = of_r * expected.weight + 2 * wide::kPi * expected.undecided;
    const auto raise_to = [](double& largest, wide::Real error) {
      if (!(error <= largest)) largest = std::isnan(error) ? HUGE_VAL : static_cast<double>(error);
    };
    raise_to(weight, std::abs(at.weight - expected.weight) / expected.weight);
    raise_to(squares, (std::abs(at.squares - expected.squares) - of_squares) / expected.squares);
    raise_to(farthest, std::abs(at.farthest - expected.farthest));
    raise_to(logs, (wide::error(at.logs.data(), expected.logs) - of_logs) / expected.distances);
    for (size_t row = 0; row < 3; ++row)
      raise_to(hessian, wide::error(at.hessian.col(int(row)).data(), expected.hessian[row]) / expected.weight);
  }
};

}  // namespace

TEST_CASE("quaternions of any norm are made unit within 2 eps a component", "[means]") {
  test::Random random(1);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const Quaternion q = quaternion(test::scaled(test::hard_norm(random, 300), test::hard_orientation(random)));
    const Quaternion unit = qtraj::unit(q);
    const wide::Quaternion expected = wide::normalized(wide::quaternion(q.data()));
    for (size_t k = 0; k < 4; ++k) {
      const double size = std::max(static_cast<double>(std::abs(expected[k])), DBL_MIN);
      worst = std::max(worst, static_cast<double>(std::abs(unit[int(k)] - expected[k])) / size);
    }
  }
  CHECK(worst <= 2 * DBL_EPSILON);
}

TEST_CASE("the log to the nearest of q and -q keeps its bound and does not see the sign of q", "[means]") {
  test::Random random(2);
  double worst = 0;
  bool same = true;
  for (int i = 0; i < 100000; ++i) {
    const test::Quaternion base = random.orientation();
    const Quaternion m = quaternion(base), q = quaternion(test::hard_neighbour(random, base));
    const qtraj::NearestLog at = qtraj::nearest_log(m, q), opposite = qtraj::nearest_log(m, -q);
    same = same && at.log == opposite.log && at.angle == opposite.angle;
    wide::Quaternion relative = wide::multiply(wide::conjugate(wide::quaternion(m.data())), wide::quaternion(q.data()));
    if (relative[0] < 0) relative = wide::scaled(-1, relative);
    const wide::Vector r = wide::log(relative);
    // at pi/2 either of two logs
    const double error = wide::error(at.log.data(), r), other = wide::error(at.log.data(), wide::scaled(-1, r));
    worst = std::max(worst, relative[0] > 1e-15L ? error : std::min(error, other));
  }
  CHECK(worst <= 1e-15);
  CHECK(same);

  const Quaternion one(1, 0, 0, 0);
  for (int k = 1; k < 4; ++k)
    for (const double sign : {1.0, -1.0}) {
      const Vector3 log = qtraj::nearest_log(one, sign * Quaternion::Unit(k)).log;
      CHECK((log - 0.5 * qtraj::kPi * Vector3::Unit(k - 1)).norm() <= 1e-15);
    }
  CHECK(qtraj::nearest_log(one, -one).log == Vector3::Zero());
}

TEST_CASE("the moments' logs and Hessian are the derivatives of f/2", "[means]") {
  test::Random random(3);
  for (int set = 0; set < 20; ++set) {
    capi::Samples<double> samples = capi::cloud<double>(random, 10, 0.6);
    for (size_t i = 0; i < 10; ++i) samples.weights.push_back(i == 3 ? 0.0 : random.uniform(0, 1));
    const qtraj::WeightedOrientations all = orientations(samples);
    const Quaternion m = all.unit(3);
    const qtraj::LogMoments at = qtraj::log_moments(all, m);
    for (int trial = 0; trial < 5; ++trial) {
      const test::Vector v = random.direction();
      const Vector3 direction(v[0], v[1], v[2]);
      constexpr double kStep = 1e-3;
      const double before = qtraj::log_moments(all, qtraj::multiply(m, qtraj::exp_map(-kStep * direction))).squares;
      const double after = qtraj::log_moments(all, qtraj::multiply(m, qtraj::exp_map(kStep * direction))).squares;
      CHECK(std::abs((after - before) / (4 * kStep) + at.logs.dot(direction)) <= 1e-5);
      CHECK(std::abs((after - 2 * at.squares + before) / (2 * kStep * kStep) - direction.dot(at.hessian * direction)) <=
            1e-5);
    }
    CHECK(std::abs(at.root_mean_square() - std::sqrt(at.squares / at.weight)) <= 1e-15);
  }
}

TEST_CASE("moments keep their bounds in every kernel, from equal samples to half a turn", "[means]") {
  test::for_every_kernel([](const char*) {
    test::Random random(4);
    MomentErrors worst;
    for (int set = 0; set < 400; ++set) {
      const test::Quaternion base = random.orientation();
      const auto count = static_cast<size_t>(random.uniform(1, set % 2 == 0 ? 10 : 400));
      const double norm = set % 4 < 2 ? 1.0 : std::pow(10.0, random.uniform(-5, 5));
      capi::Samples<double> samples;
      for (size_t i = 0; i < count; ++i) {
        test::Quaternion q = test::hard_neighbour(random, base);
        while (set % 4 > 0 && std::abs(wide::dot(base, q)) < 1e-15L) q = test::hard_neighbour(random, base);
        samples.add(test::scaled(norm, q), random.uniform(0, 1));
      }
      const qtraj::WeightedOrientations all = orientations(samples);
      const Quaternion m = quaternion(base);
      const qtraj::LogMoments at = qtraj::log_moments(all, m);
      for (double& weight : samples.weights) weight *= all.weight_scale;
      worst.raise(at, wide::moments(samples, wide::quaternion(m.data())));
    }
    const double bound = 8 * DBL_EPSILON;
    CHECK((worst.weight <= bound && worst.squares <= bound && worst.logs <= bound && worst.hessian <= bound));
    CHECK(worst.farthest <= 1e-15);
  });
}
