// QUATERNION_HERMITE is CUBICSPLINE of glTF 2.0 (appendix C.5 of the specification): its formula in plain double gives
// the same orientations to rounding, and in long double, with its derivatives, the same rates, on the keys of a glTF
// animation with tangents of several kinds.
#include <cfloat>

#include "support/recording.hpp"
#include "support/trajectory.hpp"
#include "support/worst.hpp"

namespace {

// A channel as files have it: times, keys and tangents are floats.
struct Channel {
  std::vector<double> times;
  std::vector<float> q, in_tangents, out_tangents;
};

enum class Tangents { central, one_sided, stepped };

// Slope between two keys.
float slope(const Channel& channel, size_t from, size_t to, size_t k) {
  if (from == to) return 0.0f;
  const double rise = static_cast<double>(channel.q[4 * to + k]) - static_cast<double>(channel.q[4 * from + k]);
  return static_cast<float>(rise / (channel.times[to] - channel.times[from]));
}

Channel channel_of(const test::Keys& keys, Tangents tangents) {
  Channel channel;
  for (const double time : keys.times) channel.times.push_back(static_cast<double>(static_cast<float>(time)));
  for (const double component : keys.q) channel.q.push_back(static_cast<float>(component));
  const size_t last = keys.count() - 1;
  for (size_t key = 0; key <= last; ++key) {
    const size_t before = key == 0 ? 0 : key - 1, after = key == last ? last : key + 1;
    for (size_t k = 0; k < 4; ++k) {
      const bool central = tangents == Tangents::central;
      channel.in_tangents.push_back(slope(channel, before, central ? after : key, k));
      channel.out_tangents.push_back(slope(channel, central ? before : key, after, k));
      if (tangents == Tangents::stepped && key % 3 == 1) channel.in_tangents.back() = channel.out_tangents.back() = 0;
    }
  }
  return channel;
}

test::Trajectory build(const Channel& channel, bool both_given) {
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(QTRAJ_QUATERNION_HERMITE, &options) == QTRAJ_OK);
  qtraj_trajectory* handle = nullptr;
  const qtraj_status status = qtraj_create_with_tangents_f32(
      options, channel.times.data(), channel.q.data(), channel.in_tangents.data(),
      both_given ? channel.out_tangents.data() : nullptr, channel.times.size(), &handle, nullptr);
  qtraj_options_destroy(options);
  REQUIRE(status == QTRAJ_OK);
  return test::Trajectory(handle);
}

// The polynomial and its derivatives at a time, by the specification:
//   (2t^3 - 3t^2 + 1) v_k + td (t^3 - 2t^2 + t) b_k + (-2t^3 + 3t^2) v_k+1 + td (t^3 - t^2) a_k+1.
template <class Real>
struct Spline {
  Real p[4], dp[4], ddp[4];
  // of the segment: its length, the larger norm of its keys, the largest of the step and td times the tangents
  double td = 0, largest_norm = 0, change = 0;

  Spline(const Channel& channel, double time) {
    size_t k = 0;
    while (k + 2 < channel.times.size() && channel.times[k + 1] <= time) ++k;
    td = channel.times[k + 1] - channel.times[k];
    measure(channel, k);
    const Real t = (Real(time) - Real(channel.times[k])) / Real(td);
    const Real t2 = t * t, t3 = t2 * t;
    const Real value[4] = {2 * t3 - 3 * t2 + 1, Real(td) * (t3 - 2 * t2 + t), -2 * t3 + 3 * t2, Real(td) * (t3 - t2)};
    const Real first[4] = {6 * t2 - 6 * t, Real(td) * (3 * t2 - 4 * t + 1), -6 * t2 + 6 * t,
                           Real(td) * (3 * t2 - 2 * t)};
    const Real second[4] = {12 * t - 6, Real(td) * (6 * t - 4), -12 * t + 6, Real(td) * (6 * t - 2)};
    for (size_t c = 0; c < 4; ++c) {
      const Real data[4] = {Real(channel.q[4 * k + c]), Real(channel.out_tangents[4 * k + c]),
                            Real(channel.q[4 * k + 4 + c]), Real(channel.in_tangents[4 * k + 4 + c])};
      p[c] = dp[c] = ddp[c] = 0;
      for (size_t i = 0; i < 4; ++i) {
        p[c] += value[i] * data[i];
        dp[c] += first[i] * data[i] / Real(td);
        ddp[c] += second[i] * data[i] / (Real(td) * Real(td));
      }
    }
  }

  void measure(const Channel& channel, size_t k) {
    double squares[5] = {0, 0, 0, 0, 0};
    for (size_t c = 4 * k; c < 4 * k + 4; ++c) {
      const double from = static_cast<double>(channel.q[c]), to = static_cast<double>(channel.q[c + 4]);
      const double out = td * static_cast<double>(channel.out_tangents[c]),
                   in = td * static_cast<double>(channel.in_tangents[c + 4]);
      const double parts[5] = {from, to, to - from, out, in};
      for (size_t part = 0; part < 5; ++part) squares[part] += parts[part] * parts[part];
    }
    largest_norm = std::sqrt(std::max(squares[0], squares[1]));
    change = std::sqrt(std::max({squares[2], squares[3], squares[4]}));
  }

  Real norm() const { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]); }
};

using Number = long double;
void imaginary(const Number (&a)[4], const Number (&b)[4], Number (&result)[3]) {  // Im(a* b)
  result[0] = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
  result[1] = a[0] * b[2] + a[1] * b[3] - a[2] * b[0] - a[3] * b[1];
  result[2] = a[0] * b[3] - a[1] * b[2] + a[2] * b[1] - a[3] * b[0];
}

// omega = 2 Im(p* p')/|p|^2 and its derivative, body frame.
struct Rates {
  Number omega[3], alpha[3];
  explicit Rates(const Spline<Number>& at) {
    const Number square = at.norm() * at.norm();
    Number change = 0;
    for (size_t c = 0; c < 4; ++c) change += 2 * at.p[c] * at.dp[c];
    imaginary(at.p, at.dp, omega);
    imaginary(at.p, at.ddp, alpha);
    for (size_t k = 0; k < 3; ++k) {
      omega[k] *= 2 / square;
      alpha[k] = 2 * alpha[k] / square - omega[k] * change / square;
    }
  }
};

std::vector<double> times_in(const Channel& channel) {
  std::vector<double> times;
  for (size_t k = 0; k + 1 < channel.times.size(); ++k)
    for (int i = 0; i < 16; ++i)
      times.push_back(channel.times[k] + (channel.times[k + 1] - channel.times[k]) * i / 16.0);
  times.push_back(channel.times.back());
  return times;
}

}  // namespace

TEST_CASE("CUBICSPLINE by the formula of glTF, in plain double, agrees to rounding", "[reference][gltf]") {
  for (const Tangents tangents : {Tangents::central, Tangents::one_sided, Tangents::stepped}) {
    double worst = 0, worst_norm = 0;
    for (const test::Recording& joint : test::read_joints("fox_run_gltf.csv")) {
      const Channel channel = channel_of(joint.keys, tangents);
      const test::Trajectory trajectory = build(channel, true);
      const std::vector<double> times = times_in(channel), q = trajectory.sample(times);
      std::vector<double> p(4 * times.size());
      REQUIRE(qtraj_sample_unnormalized(trajectory.get(), times.data(), times.size(), p.data(), nullptr, nullptr,
                                        nullptr) == QTRAJ_OK);
      for (size_t i = 0; i < times.size(); ++i) {
        const Spline<double> at(channel, times[i]);
        for (size_t c = 0; c < 4; ++c) {
          test::raise_to(worst, std::abs(q[4 * i + c] - at.p[c] / at.norm()));
          test::raise_to(worst_norm, std::abs(p[4 * i + c] - at.p[c]));
        }
      }
    }
    CAPTURE(static_cast<int>(tangents), worst, worst_norm);
    CHECK(worst <= 6e-16);
    CHECK(worst_norm <= 6e-16);
  }
}

TEST_CASE("its rates are the derivatives of the formula of glTF", "[reference][gltf]") {
  for (const Tangents tangents : {Tangents::central, Tangents::one_sided, Tangents::stepped}) {
    double worst_omega = 0, worst_alpha = 0;
    for (const test::Recording& joint : test::read_joints("fox_run_gltf.csv")) {
      const Channel channel = channel_of(joint.keys, tangents);
      const std::vector<double> times = times_in(channel);
      const auto motion = build(channel, true).sample_rates(QTRAJ_FRAME_BODY, times);
      Number fastest = 0, hardest = 0, shortest = 1e300L, omega_error = 0, alpha_error = 0;
      for (size_t i = 0; i + 1 < times.size(); ++i) {  // at a knot the right-hand values
        const Rates at{Spline<Number>(channel, times[i])};
        for (size_t k = 0; k < 3; ++k) {
          fastest = std::max(fastest, std::abs(at.omega[k]));
          hardest = std::max(hardest, std::abs(at.alpha[k]));
          omega_error = std::max(omega_error, std::abs(Number(motion.omega[3 * i + k]) - at.omega[k]));
          alpha_error = std::max(alpha_error, std::abs(Number(motion.alpha[3 * i + k]) - at.alpha[k]));
        }
      }
      REQUIRE(fastest > 0);
      for (size_t k = 1; k < channel.times.size(); ++k)
        shortest = std::min(shortest, Number(channel.times[k] - channel.times[k - 1]));
      hardest = std::max(hardest, fastest / shortest);
      test::raise_to(worst_omega, static_cast<double>(omega_error / fastest));
      test::raise_to(worst_alpha, static_cast<double>(alpha_error / hardest));
    }
    CAPTURE(static_cast<int>(tangents), worst_omega, worst_alpha);
    CHECK(worst_omega <= 1e-13);
    CHECK(worst_alpha <= 1e-13);
  }
}

TEST_CASE("the curve in R^4 and its derivatives keep to their bounds", "[reference][gltf]") {
  double worst[3] = {0, 0, 0};
  for (const Tangents tangents : {Tangents::central, Tangents::one_sided, Tangents::stepped})
    for (const test::Recording& joint : test::read_joints("fox_run_gltf.csv"))
      for (const float norm : {1.0f, 0.01f, 300.0f}) {
        Channel channel = channel_of(joint.keys, tangents);
        for (std::vector<float>* rows : {&channel.q, &channel.in_tangents, &channel.out_tangents})
          for (float& number : *rows) number *= norm;
        const test::Trajectory trajectory = build(channel, true);
        const std::vector<double> times = times_in(channel);
        std::vector<double> p(4 * times.size()), dp(4 * times.size()), ddp(4 * times.size());
        REQUIRE(qtraj_sample_unnormalized(trajectory.get(), times.data(), times.size(), p.data(), dp.data(), ddp.data(),
                                          nullptr) == QTRAJ_OK);
        for (size_t i = 0; i < times.size(); ++i) {
          const Spline<Number> at(channel, times[i]);
          const double size = at.change / at.td, eps = DBL_EPSILON;
          for (size_t c = 0; c < 4; ++c) {
            const auto off = [&](double found, Number expected) {
              return static_cast<double>(std::abs(found - expected));
            };
            test::raise_to(worst[0], off(p[4 * i + c], at.p[c]) / (2 * eps * (at.largest_norm + at.change)));
            test::raise_to(worst[1], off(dp[4 * i + c], at.dp[c]) / (12 * eps * size));
            test::raise_to(worst[2], off(ddp[4 * i + c], at.ddp[c]) / (120 * eps * size / at.td));
          }
        }
      }
  CAPTURE(worst[0], worst[1], worst[2]);
  for (const double ratio : worst) CHECK(ratio <= 1);
}

TEST_CASE("one array of tangents serves both sides", "[reference][gltf]") {
  const Channel channel = channel_of(test::read_joints("fox_run_gltf.csv")[4].keys, Tangents::central);
  const std::vector<double> times = times_in(channel);
  Channel twice = channel;
  twice.out_tangents = channel.in_tangents;
  CHECK(build(channel, false).sample(times) == build(twice, true).sample(times));
}
