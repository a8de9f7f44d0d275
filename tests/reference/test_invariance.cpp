// What must not change a curve: the axes of world and body, where time starts and how it is counted, signs of keys,
// and, where the definition is the same from both sides, the direction of time. For q and the rates in both frames, of
// every method with every end condition.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "support/curve.hpp"
#include "support/derivative.hpp"

namespace {

using test::Curve;
using test::Keys;
using test::multiply;
using test::Quaternion;
using test::Random;
using test::Trajectory;
using test::Variant;
using test::Vector;

constexpr size_t kCurves = 6, kPerSegment = 7;

Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }
Vector scaled(const Vector& v, double factor) { return {factor * v[0], factor * v[1], factor * v[2]}; }

// Keys within 70 degrees of a centre, so that the chart of LOG_SPLINE is sound whatever its reference; for the other
// methods every second curve is a walk with steps of up to 150 degrees. Times are multiples of 2^-10 s: they can be
// shifted and scaled without rounding.
Curve random_curve(const Variant& variant, uint64_t seed) {
  Random random(seed);
  const size_t count = 5 + seed % 5;
  const Quaternion centre = random.orientation();
  Curve curve = {variant, {}, seed % 4 < 2 ? QTRAJ_FRAME_BODY : QTRAJ_FRAME_WORLD, {}, {}};
  const bool walk = seed % 2 == 1 && !variant.is(QTRAJ_LOG_SPLINE);
  if (walk) {
    curve.keys = random_walk(random, count, 2.6, 0.2, 2.0);
  } else {
    double time = random.uniform(-5.0, 5.0);
    for (size_t key = 0; key < count; ++key, time += random.uniform(0.2, 2.0))
      curve.keys.add(time, multiply(centre, test::turn_within(random, 1.2)));
  }
  if (variant.is_closed()) {
    if (walk) curve.keys = random_walk(random, 4, 1.0, 0.2, 2.0);  // comes back in a step of less than half a turn
    curve.keys.add(curve.keys.times.back() + random.uniform(0.2, 2.0), curve.keys.orientation(0));
  }
  for (double& time : curve.keys.times) time = std::round(time * 1024.0) / 1024.0;
  for (size_t key = 0; key < curve.keys.count(); ++key) {
    curve.omega.push_back(scaled(random.direction(), random.uniform(0.0, 1.5)));
    curve.alpha.push_back(scaled(random.direction(), random.uniform(0.0, 1.5)));
  }
  if (variant.settings.reference == QTRAJ_REFERENCE_GIVEN)
    curve.variant.settings.reference_q.assign(centre.begin(), centre.end());
  return curve;
}

void set_orientation(Keys& keys, size_t key, const Quaternion& q) { std::copy(q.begin(), q.end(), &keys.q[4 * key]); }

// The keys and the reference replaced by a function of them.
void turn(Curve& curve, const std::function<Quaternion(const Quaternion&)>& turned) {
  for (size_t key = 0; key < curve.keys.count(); ++key)
    set_orientation(curve.keys, key, turned(curve.keys.orientation(key)));
  std::vector<double>& reference = curve.variant.settings.reference_q;
  if (reference.empty()) return;
  const Quaternion q = turned({reference[0], reference[1], reference[2], reference[3]});
  reference.assign(q.begin(), q.end());
}

void turn_rates(Curve& curve, const std::function<Vector(const Vector&)>& turned) {
  for (Vector& omega : curve.omega) omega = turned(omega);
  for (Vector& alpha : curve.alpha) alpha = turned(alpha);
}

// Times between knots: rates may jump at them, and which side is on the right depends on the direction of time.
std::vector<double> times_between(const Keys& keys) {
  std::vector<double> times;
  for (size_t i = 0; i + 1 < keys.count(); ++i)
    for (size_t k = 0; k < kPerSegment; ++k) {
      const double u = (static_cast<double>(k) + 0.5) / kPerSegment;
      times.push_back(std::round((keys.times[i] + u * (keys.times[i + 1] - keys.times[i])) * 0x1p20) / 0x1p20);
    }
  return times;
}

struct Sample {
  Quaternion q;
  Vector omega, alpha;
};
using Motion = std::vector<Sample>;

Motion motion_of(const Curve& curve, int32_t frame, const std::vector<double>& times) {
  const auto sampled = test::build(curve).sample_rates(frame, times);
  Motion motion(times.size());
  for (size_t i = 0; i < times.size(); ++i) {
    std::copy_n(&sampled.q[4 * i], 4, motion[i].q.begin());
    std::copy_n(&sampled.omega[3 * i], 3, motion[i].omega.begin());
    std::copy_n(&sampled.alpha[3 * i], 3, motion[i].alpha.begin());
  }
  return motion;
}

// Largest differences, of the rates in units of what rounding is measured by: the largest |omega|, and the larger of
// |alpha| and |omega|/h.
struct Difference {
  double q = 0, omega = 0, alpha = 0;
};
Difference difference(const Motion& a, const Motion& b, const Keys& keys) {
  double shortest = keys.times[1] - keys.times[0], fastest = 0, hardest = 0;
  for (size_t key = 1; key < keys.count(); ++key) shortest = std::min(shortest, keys.times[key] - keys.times[key - 1]);
  Difference worst;
  for (size_t i = 0; i < a.size(); ++i) {
    test::raise_to(fastest, test::length(a[i].omega));
    test::raise_to(hardest, test::length(a[i].alpha));
    test::raise_to(worst.q, test::distance(a[i].q, b[i].q));
    test::raise_to(worst.omega, test::distance(a[i].omega, b[i].omega));
    test::raise_to(worst.alpha, test::distance(a[i].alpha, b[i].alpha));
  }
  worst.omega /= fastest;
  worst.alpha /= std::max(hardest, fastest / shortest);
  return worst;
}

bool same_bits(const Motion& a, const Motion& b) {
  static_assert(sizeof(Sample) % sizeof(double) == 0);
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Sample)) == 0;
}

// How times of a changed curve come from those of the first one, and what must become of its samples.
struct Change {
  std::function<double(double)> time = [](double t) { return t; };
  std::function<Sample(int32_t frame, const Sample&)> sample = [](int32_t, const Sample& s) { return s; };
};

// The samples that a changed curve must have, and those that it has.
std::array<Motion, 2> expected_and_found(const Curve& curve, const Curve& changed, int32_t frame,
                                         const Change& change) {
  std::vector<double> times = times_between(curve.keys);
  Motion expected = motion_of(curve, frame, times);
  for (Sample& sample : expected) sample = change.sample(frame, sample);
  for (double& time : times) time = change.time(time);
  return {expected, motion_of(changed, frame, times)};
}

void check_close(const Curve& curve, const Curve& changed, const Change& change, double tolerance) {
  for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
    const auto [expected, found] = expected_and_found(curve, changed, frame, change);
    const Difference worst = difference(expected, found, changed.keys);
    CAPTURE(frame);
    CHECK(worst.q <= tolerance);
    CHECK(worst.omega <= tolerance);
    CHECK(worst.alpha <= tolerance);
  }
}

void check_same_bits(const Curve& curve, const Curve& changed, const Change& change) {
  for (const int32_t frame : {QTRAJ_FRAME_BODY, QTRAJ_FRAME_WORLD}) {
    const auto [expected, found] = expected_and_found(curve, changed, frame, change);
    CAPTURE(frame);
    CHECK(same_bits(expected, found));
  }
}

// check(curve) for random curves of every variant.
void for_curves(const std::function<void(const Curve&)>& check) {
  uint64_t seed = 0;
  for (const Variant& variant : test::all_variants())
    for (size_t i = 0; i < kCurves && !variant.is(QTRAJ_STEP); ++i) {  // whose rates, 0, are no measure
      const Curve curve = random_curve(variant, ++seed);
      CAPTURE(variant.name, seed);
      check(curve);
    }
}

// A curve with times multiplied by `unit`, and what that does to its samples.
Curve in_units(Curve curve, double unit) {
  for (double& time : curve.keys.times) time *= unit;
  for (Vector& omega : curve.omega) omega = scaled(omega, 1 / unit);
  for (Vector& alpha : curve.alpha) alpha = scaled(alpha, 1 / unit / unit);
  return curve;
}
Change unit_change(double unit) {
  Change change;
  change.time = [=](double t) { return unit * t; };
  change.sample = [=](int32_t, const Sample& s) -> Sample {
    return {s.q, scaled(s.omega, 1 / unit), scaled(s.alpha, 1 / unit / unit)};
  };
  return change;
}

// From these, a curve from the last key to the first is the same curve.
bool is_reversible(const Variant& variant) {
  const int32_t reference = variant.settings.reference;
  if (variant.is(QTRAJ_LOG_SPLINE)) return reference == QTRAJ_REFERENCE_MEAN || reference == QTRAJ_REFERENCE_GIVEN;
  return variant.is(QTRAJ_SLERP) || variant.is(QTRAJ_NLERP) || variant.is(QTRAJ_SQUAD) ||
         variant.is(QTRAJ_QUATERNION_QUINTIC) || variant.is(QTRAJ_QUATERNION_HERMITE);
}

// Rounding, grown by the equations and by 150-degree steps of the walks; 1.3e-14 was met.
constexpr double kRounding = 1e-13;

}  // namespace

TEST_CASE("world axes can be chosen freely: P q turns world rates by P and leaves body rates", "[invariance]") {
  Random random(11);
  for_curves([&](const Curve& curve) {
    const Quaternion p = random.orientation();
    Curve changed = curve;
    turn(changed, [&](const Quaternion& q) { return multiply(p, q); });
    if (curve.frame == QTRAJ_FRAME_WORLD) turn_rates(changed, [&](const Vector& v) { return test::rotate(p, v); });
    Change change;
    change.sample = [&](int32_t frame, const Sample& s) -> Sample {
      if (frame == QTRAJ_FRAME_BODY) return {multiply(p, s.q), s.omega, s.alpha};
      return {multiply(p, s.q), test::rotate(p, s.omega), test::rotate(p, s.alpha)};
    };
    check_close(curve, changed, change, kRounding);
  });
}

TEST_CASE("body axes can be chosen freely: q P turns body rates by P* and leaves world rates", "[invariance]") {
  Random random(12);
  for_curves([&](const Curve& curve) {
    // judges components in the body frame one by one
    if (curve.variant.settings.tangents == QTRAJ_TANGENT_REST) return;
    const Quaternion p = random.orientation(), back = conjugate(p);
    Curve changed = curve;
    turn(changed, [&](const Quaternion& q) { return multiply(q, p); });
    if (curve.frame == QTRAJ_FRAME_BODY) turn_rates(changed, [&](const Vector& v) { return test::rotate(back, v); });
    Change change;
    change.sample = [&](int32_t frame, const Sample& s) -> Sample {
      if (frame == QTRAJ_FRAME_WORLD) return {multiply(s.q, p), s.omega, s.alpha};
      return {multiply(s.q, p), test::rotate(back, s.omega), test::rotate(back, s.alpha)};
    };
    check_close(curve, changed, change, kRounding);
  });
}

TEST_CASE("a shift of time that rounds nothing changes no bit", "[invariance]") {
  for_curves([&](const Curve& curve) {
    Change change;
    change.time = [](double t) { return t + 4096.0; };
    Curve changed = curve;
    for (double& time : changed.keys.times) time = change.time(time);
    check_same_bits(curve, changed, change);
  });
}

TEST_CASE("any shift of time changes a curve by the rounding of its times", "[invariance]") {
  Random random(13);
  for_curves([&](Curve curve) {
    // off the grid, or nothing would be rounded
    for (double& time : curve.keys.times) time *= 0.7312345;
    const double shift = random.uniform(-1e5, 1e5);
    Change change;
    change.time = [&](double t) { return t + shift; };
    Curve changed = curve;
    for (double& time : changed.keys.times) time = change.time(time);
    // half an ulp of time, of intervals of at least 0.2 s, grown by the equations
    check_close(curve, changed, change, 1e3 * 0x1p-53 * std::abs(shift) + kRounding);
  });
}

TEST_CASE("a power of two as the unit of time changes the rates by its powers and no bit else", "[invariance]") {
  for_curves([&](const Curve& curve) {
    for (const double unit : {0x1p-12, 0x1p9}) {
      CAPTURE(unit);
      check_same_bits(curve, in_units(curve, unit), unit_change(unit));
    }
  });
}

TEST_CASE("any unit of time will do", "[invariance]") {
  Random random(14);
  for_curves([&](const Curve& curve) {
    const double unit = std::exp(random.uniform(-7.0, 7.0));
    CAPTURE(unit);
    check_close(curve, in_units(curve, unit), unit_change(unit), kRounding);
  });
}

TEST_CASE("signs of keys change no number, but for the sign of all samples, which is that of the first key",
          "[invariance]") {
  Random random(15);
  for_curves([&](const Curve& curve) {
    const bool flips_first = random.uniform(0.0, 1.0) < 0.5;
    Curve changed = curve;
    for (size_t key = 0; key < curve.keys.count(); ++key) {
      const Quaternion q = curve.keys.orientation(key);
      if (key == 0 ? flips_first : random.uniform(0.0, 1.0) < 0.5)
        set_orientation(changed.keys, key, {-q[0], -q[1], -q[2], -q[3]});
    }
    Change change;
    change.sample = [&](int32_t, const Sample& s) -> Sample {
      return {flips_first ? Quaternion{-s.q[0], -s.q[1], -s.q[2], -s.q[3]} : s.q, s.omega, s.alpha};
    };
    check_same_bits(curve, changed, change);
  });
}

TEST_CASE("SLERP, NLERP, SQUAD, the methods of quaternions and LOG_SPLINE without FIRST are the same backwards",
          "[invariance]") {
  for_curves([&](const Curve& curve) {
    if (!is_reversible(curve.variant)) return;
    Curve changed = curve;
    const Keys keys = test::build(curve).keys();  // the last one with the sign it has on the curve
    for (size_t key = 0; key < keys.count(); ++key) {
      const size_t other = keys.count() - 1 - key;
      changed.keys.times[key] = -keys.times[other];
      set_orientation(changed.keys, key, keys.orientation(other));
      changed.omega[key] = scaled(curve.omega[other], -1.0);
      changed.alpha[key] = curve.alpha[other];
    }
    Change change;
    change.time = [](double t) { return -t; };
    change.sample = [](int32_t, const Sample& s) -> Sample { return {s.q, scaled(s.omega, -1.0), s.alpha}; };
    check_close(curve, changed, change, kRounding);
  });
}
