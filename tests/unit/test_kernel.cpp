#include <cfenv>
#include <cstring>
#include <vector>

#include "arguments.hpp"
#include "curve/sample_one.hpp"
#include "support/forced_kernel.hpp"
#include "support/trajectory.hpp"
#include "targets/sampling.hpp"

namespace {

using test::Keys;
using test::Random;

constexpr double kDegree = 0.017453292519943295;

struct Case {
  test::Settings settings;
  double largest_step;  // rad
  size_t count;
};

// Every evaluator, LOG_SPLINE with |p| in each of its ranges.
std::vector<Case> all_cases() {
  return {{{QTRAJ_SLERP}, 179 * kDegree, 20},      {{QTRAJ_NLERP}, 179 * kDegree, 20},
          {{QTRAJ_SQUAD}, 120 * kDegree, 20},      {{QTRAJ_LOG_SPLINE}, 10 * kDegree, 6},
          {{QTRAJ_LOG_SPLINE}, 70 * kDegree, 6},   {{QTRAJ_LOG_SPLINE}, 110 * kDegree, 8},
          {{QTRAJ_LOG_SPLINE}, 170 * kDegree, 30}, {{QTRAJ_ROTATION_SPLINE}, 100 * kDegree, 20}};
}

std::vector<double> times_within(const Keys& keys, size_t count) {
  std::vector<double> times;
  for (size_t i = 0; i < count; ++i)
    times.push_back(keys.times.front() +
                    static_cast<double>(i) / static_cast<double>(count) * (keys.times.back() - keys.times.front()));
  return times;
}

// q of all times, then omega, then alpha.
template <class Real, class Sample>
std::vector<Real> run(Sample sample, const test::Trajectory& trajectory, const std::vector<double>& times) {
  const size_t count = times.size();
  std::vector<Real> rows(10 * count);
  const qtraj::SampleOutputs<Real> outputs = {rows.data(), &rows[4 * count], &rows[7 * count], qtraj::Frame::world};
  size_t cursor = 0;
  const qtraj::Outcome outcome =
      sample(trajectory.get()->core, qtraj::TimeSource{times.data(), 0, 0}, count, cursor, outputs);
  CHECK(outcome.status == qtraj::Status::ok);
  return rows;
}

// Of q.
template <class Real>
double largest_difference(const std::vector<Real>& a, const std::vector<Real>& b) {
  double largest = 0;
  for (size_t i = 0; i < 4 * (a.size() / 10); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(a[i] - b[i])));
  return largest;
}

template <class Real>
bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0;
}

// Sampling without vectors, as the kernels have it, but compiled here.
template <class Arithmetic>
qtraj::Status evaluate_in_double(const qtraj::Trajectory& trajectory, size_t segment, double elapsed, bool negate,
                                 const qtraj::SampleOutputs<double>& outputs, size_t row) {
  return qtraj::row_evaluator<Arithmetic, double, evaluate_in_double<Arithmetic>>(trajectory, outputs)(
      trajectory, segment, elapsed, negate, outputs, row);
}
template <class Arithmetic, class Real>
qtraj::Outcome one_by_one(const qtraj::Trajectory& trajectory, const qtraj::TimeSource& times, size_t count,
                          size_t& cursor, const qtraj::SampleOutputs<Real>& outputs) {
  return qtraj::sample_one_by_one<Arithmetic, Real, evaluate_in_double<Arithmetic>>(trajectory, times, count, cursor,
                                                                                    outputs);
}

}  // namespace

TEST_CASE("plain and fused arithmetic give the same curve to rounding", "[kernel]") {
  Random random(1);
  for (const Case& c : all_cases()) {
    for (int curve = 0; curve < 20; ++curve) {
      const Keys keys = random_walk(random, c.count, c.largest_step, 0.2, 2.0);
      const test::Trajectory trajectory(c.settings, keys);
      const std::vector<double> times = times_within(keys, 500);
      const double angle = c.settings.method == QTRAJ_LOG_SPLINE ? c.largest_step * static_cast<double>(c.count) : 3.0;
      CAPTURE(c.settings.method, c.largest_step);
      const auto plain = run<double>(one_by_one<qtraj::Plain, double>, trajectory, times);
      const auto fused = run<double>(one_by_one<qtraj::Fused, double>, trajectory, times);
      CHECK(largest_difference(plain, fused) <= 8e-16 * (1 + angle));
      const auto plain_f32 = run<float>(one_by_one<qtraj::Plain, float>, trajectory, times);
      const auto fused_f32 = run<float>(one_by_one<qtraj::Fused, float>, trajectory, times);
      CHECK(largest_difference(plain_f32, fused_f32) <= 6e-7 * (1 + angle));
    }
  }
}

TEST_CASE("every kernel has the bits of its arithmetic, sample by sample", "[kernel][bits]") {
  // here the fused template is compiled without fused instructions: each multiply_add is a call of the C library
  Random random(2);
  for (const Case& c : all_cases()) {
    const Keys keys = random_walk(random, c.count, c.largest_step, 0.2, 2.0);
    const test::Trajectory trajectory(c.settings, keys);
    std::vector<double> times = times_within(keys, 700);  // sorted, with runs; then in no order
    for (int i = 0; i < 300; ++i) times.push_back(random.uniform(keys.times.front(), keys.times.back()));
    const auto plain = run<double>(one_by_one<qtraj::Plain, double>, trajectory, times);
    const auto fused = run<double>(one_by_one<qtraj::Fused, double>, trajectory, times);
    const auto plain_f32 = run<float>(one_by_one<qtraj::Plain, float>, trajectory, times);
    const auto fused_f32 = run<float>(one_by_one<qtraj::Fused, float>, trajectory, times);
    for (const char* target : test::target_names()) {
      const test::ForcedKernel forced(target);
      if (!forced.runs_here()) continue;
      CAPTURE(c.settings.method, c.largest_step, target);
      const bool is_fused = forced.is_fused();
      CHECK(same_bits(run<double>(qtraj::sample_double_by_target[qtraj::target()], trajectory, times),
                      is_fused ? fused : plain));
      CHECK(same_bits(run<float>(qtraj::sample_float_by_target[qtraj::target()], trajectory, times),
                      is_fused ? fused_f32 : plain_f32));
    }
  }
}

TEST_CASE("cosine and sinc by doublings are right on both sides of each range", "[kernel][singular]") {
  using qtraj::Plain;
  const double quarter = 2.4674011002723395;  // (pi/2)^2
  for (const double fraction : {0.0, 1e-300, 1e-8, 0.1, 0.5, 0.999999, 1.0, 1.0000001}) {
    for (const int doublings : {0, 1, 2}) {
      const double y = fraction * quarter * (doublings == 0 ? 1 : doublings == 1 ? 4 : 16);
      const long double angle = std::sqrt(static_cast<long double>(y));
      const long double cosine = std::cos(angle), sinc = angle == 0 ? 1 : std::sin(angle) / angle;
      qtraj::CosSinc<double> f;
      qtraj::cos_sinc<Plain>(y, doublings, f);
      const auto any = qtraj::cos_sinc_any<Plain>(y);
      CAPTURE(fraction, doublings);
      CHECK(std::abs(static_cast<double>(f.c - cosine)) <= 2e-16 * (1 + 4 * doublings));
      CHECK(std::abs(static_cast<double>(f.k - sinc)) <= 2e-16 * (1 + doublings));
      qtraj::normalize_doubled<Plain>(y, f);
      CHECK(std::abs(f.c * f.c + y * f.k * f.k - 1) <= 8e-16);
      CHECK(std::abs(static_cast<double>(f.c - cosine)) <= 2e-16 * (1 + 4 * doublings));
      CHECK(std::abs(static_cast<double>(f.k - sinc)) <= 2e-16 * (1 + doublings));
      CHECK(std::abs(static_cast<double>(any.c - cosine)) <= 4e-16);
      CHECK(std::abs(static_cast<double>(any.k - sinc)) <= 3e-16);
    }
  }
}

TEST_CASE("slerp between arcs is unit at every distance, opposite points included", "[kernel][singular]") {
  using qtraj::Plain;
  const double p[4] = {1, 0, 0, 0};
  for (const double gap : {0.0, 1e-300, 1e-16, 1e-9, 1e-8, 3e-8, 1e-7, 1e-3, 1.0, 3.0, 3.14159}) {
    // c is pi - gap away from p
    const double c[4] = {-std::cos(gap), 0, std::sin(gap), 0};
    for (const double f : {0.0, 1e-9, 0.25, 0.5}) {
      double q[4];
      qtraj::slerp_points<Plain>(p, c, qtraj::half_sum_squared<Plain>(p, c), f, q);
      const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      CAPTURE(gap, f);
      CHECK(std::abs(norm - 1) <= 1e-15);
      CHECK(std::abs(q[0] - std::cos(f * (3.141592653589793 - gap))) <= 2e-8);
      const float p32[4] = {1, 0, 0, 0}, c32[4] = {static_cast<float>(c[0]), 0, static_cast<float>(c[2]), 0};
      float q32[4];
      qtraj::slerp_points<Plain>(p32, c32, qtraj::half_sum_squared<Plain>(p32, c32), static_cast<float>(f), q32);
      const float norm32 = std::sqrt(q32[0] * q32[0] + q32[1] * q32[1] + q32[2] * q32[2] + q32[3] * q32[3]);
      CHECK(std::abs(norm32 - 1) <= 5e-7f);
    }
  }
}
