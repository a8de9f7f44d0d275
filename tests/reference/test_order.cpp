// Orders of accuracy on a smooth motion, as one table: how fast the errors of q, omega and alpha fall with the number
// of knots.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "support/curve.hpp"
#include "support/derivative.hpp"
#include "support/smooth_motion.hpp"

namespace {

using test::Curve;
using test::Keys;
using test::Quaternion;
using test::Random;
using test::SmoothMotion;
using test::Trajectory;
using test::Variant;
using test::Vector;

constexpr double kSpan = 8.0;  // s
constexpr size_t kSegmentCounts[] = {16, 32, 64, 128};
constexpr size_t kJitters = 12, kPerSegment = 8;

// A promise: the error of q falls as h^order; that of omega with one order less, of alpha with two. Order 0 of alpha
// says that it stays bounded and no more: of SLERP it is 0 whatever the motion does, and of curves of order 2 it is
// wrong in the end segments.
struct Promise {
  Variant variant;
  bool inside;  // in the middle half of the time, away from the end conditions
  double order;
};

std::vector<Promise> promises() {
  const auto variant = [](const std::string& name) {
    for (const Variant& v : test::all_variants())
      if (v.name == name) return v;
    FAIL("no variant " << name);
    return Variant{};
  };
  return {{variant("SLERP"), false, 2},
          {variant("NLERP"), false, 2},
          {variant("SQUAD CATMULL_ROM CHORD"), false, 2},
          {variant("SQUAD CATMULL_ROM CHORD"), true, 3},
          {variant("SQUAD CATMULL_ROM ESTIMATED"), false, 3},
          {variant("SQUAD MEAN_VELOCITY CHORD"), false, 2},
          {variant("SQUAD MEAN_VELOCITY ESTIMATED"), false, 2},
          {variant("SQUAD with rates"), false, 4},
          {variant("LOG_SPLINE FIRST NATURAL"), false, 2},
          {variant("LOG_SPLINE FIRST NATURAL"), true, 4},
          {variant("LOG_SPLINE FIRST NOT_A_KNOT"), false, 4},
          {variant("LOG_SPLINE MEAN NOT_A_KNOT"), false, 4},
          {variant("ROTATION_SPLINE ESTIMATED"), false, 4},
          {variant("ROTATION_SPLINE GIVEN"), false, 4},
          {variant("ROTATION_SPLINE CHORD"), false, 2},
          {variant("ROTATION_SPLINE NATURAL"), false, 2},
          {variant("HERMITE"), false, 4},
          {variant("ROTATION_QUINTIC"), false, 6},
          {variant("QUATERNION_QUINTIC"), false, 6},
          {variant("QUATERNION_HERMITE"), false, 4}};
}

// The motion at a set of knots and at times in between.
struct Task {
  Curve curve;         // variant still to be set
  double longest = 0;  // interval between knots
  std::vector<double> times;
  std::vector<SmoothMotion> motion;
};

Task make_task(Random& random, size_t segments) {
  Task task;
  task.curve.frame = QTRAJ_FRAME_WORLD;
  const double spacing = kSpan / static_cast<double>(segments);
  for (size_t key = 0; key <= segments; ++key) {
    const bool end = key == 0 || key == segments;
    const double time = spacing * (static_cast<double>(key) + (end ? 0.0 : random.uniform(-0.3, 0.3)));
    const SmoothMotion motion = test::smooth_motion(time);
    task.curve.keys.add(time, motion.q);
    task.curve.omega.push_back(motion.omega_world);
    task.curve.alpha.push_back(motion.alpha_world);
  }
  const std::vector<double>& knots = task.curve.keys.times;
  for (size_t i = 0; i < segments; ++i) task.longest = std::max(task.longest, knots[i + 1] - knots[i]);
  for (size_t i = 0; i < segments; ++i)
    for (size_t k = 0; k < kPerSegment; ++k)
      task.times.push_back(knots[i] + (knots[i + 1] - knots[i]) * (static_cast<double>(k) / kPerSegment));
  for (const double time : task.times) task.motion.push_back(test::smooth_motion(time));
  return task;
}

struct Errors {
  double q = 0, omega = 0, alpha = 0;
};

// Rotation angle between orientations.
double angle_between(const Quaternion& a, const Quaternion& b) {
  const double apart = test::distance(a, b), together = test::distance(a, {-b[0], -b[1], -b[2], -b[3]});
  return 4.0 * std::atan2(std::min(apart, together), std::max(apart, together));
}

Errors largest_errors(const Promise& promise, Task& task) {
  task.curve.variant = promise.variant;
  const auto sampled = test::build(task.curve).sample_rates(QTRAJ_FRAME_WORLD, task.times);
  const auto row = [](const std::vector<double>& v, size_t i) { return Vector{v[3 * i], v[3 * i + 1], v[3 * i + 2]}; };
  Errors errors;
  for (size_t i = 0; i < task.times.size(); ++i) {
    if (promise.inside && std::abs(task.times[i] - 0.5 * kSpan) > 0.25 * kSpan) continue;
    const double* q = &sampled.q[4 * i];
    test::raise_to(errors.q, angle_between({q[0], q[1], q[2], q[3]}, task.motion[i].q));
    test::raise_to(errors.omega, test::distance(row(sampled.omega, i), task.motion[i].omega_world));
    test::raise_to(errors.alpha, test::distance(row(sampled.alpha, i), task.motion[i].alpha_world));
  }
  return errors;
}

// Slope of the straight line through (log h, log error), by least squares over all knot counts and jitters. h is the
// longest interval: in units of the mean it grows with the number of knots, as more of them are drawn, and so hides
// up to 0.4 of an order where it is left out.
class Slope {
 public:
  void add(double h, double error) {
    const double x = std::log(h), y = std::log(error);
    n_ += 1, x_ += x, y_ += y, xx_ += x * x, xy_ += x * y;
  }
  double value() const { return (n_ * xy_ - x_ * y_) / (n_ * xx_ - x_ * x_); }

 private:
  double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

}  // namespace

TEST_CASE("the rates of the smooth motion are its derivatives", "[order]") {
  constexpr double kStep = 1e-4;
  for (int i = 0; i <= 20; ++i) {
    const double time = kSpan * i / 20.0;
    const SmoothMotion before = test::smooth_motion(time - kStep), after = test::smooth_motion(time + kStep);
    const SmoothMotion motion = test::smooth_motion(time);
    CAPTURE(time);
    Quaternion dq;
    for (size_t k = 0; k < 4; ++k) dq[k] = (after.q[k] - before.q[k]) / (2 * kStep);
    const Vector omega = test::rotate(motion.q, test::body_rate(motion.q, dq));
    CHECK(test::distance(omega, motion.omega_world) <= 1e-7);
    Vector alpha;
    for (size_t k = 0; k < 3; ++k) alpha[k] = (after.omega_world[k] - before.omega_world[k]) / (2 * kStep);
    CHECK(test::distance(alpha, motion.alpha_world) <= 1e-7);
  }
}

TEST_CASE("errors on a smooth motion fall with the orders promised", "[order]") {
  constexpr double kBelow = 0.3, kAbove = 0.5;  // above: the fit tells an order from the next one
  std::vector<Task> tasks;
  Random random(7);
  for (const size_t segments : kSegmentCounts)
    for (size_t jitter = 0; jitter < kJitters; ++jitter) tasks.push_back(make_task(random, segments));

  std::printf("\norder of accuracy                   q      |   omega    |   alpha    | largest error of q\n");
  std::printf("method, end                     found says | found says | found says | 17 and 129 knots\n");
  for (const Promise& promise : promises()) {
    Slope q, omega, alpha;
    double coarsest = 0, finest = 0;
    for (Task& task : tasks) {
      const Errors errors = largest_errors(promise, task);
      q.add(task.longest, errors.q);
      omega.add(task.longest, errors.omega);
      alpha.add(task.longest, errors.alpha);
      if (task.curve.keys.count() == 17) test::raise_to(coarsest, errors.q);
      if (task.curve.keys.count() == 129) test::raise_to(finest, errors.q);
    }
    const std::string name = promise.variant.name + (promise.inside ? ", inside" : "");
    std::printf("%-31s %5.2f %4.0f | %5.2f %4.0f | %5.2f %4.0f | %.1e %.1e\n", name.c_str(), q.value(), promise.order,
                omega.value(), promise.order - 1, alpha.value(), promise.order - 2, coarsest, finest);
    CAPTURE(name);
    const double found[] = {q.value(), omega.value(), alpha.value()};
    for (int loss = 0; loss < 3; ++loss) {
      CAPTURE(loss, found[loss]);
      CHECK(found[loss] >= promise.order - loss - kBelow);
      CHECK(found[loss] <= promise.order - loss + kAbove);
    }
  }
}
