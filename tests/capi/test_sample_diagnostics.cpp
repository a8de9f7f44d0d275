// Diagnostics of samples against formulas in long double: their error bounds.
#include <cfloat>

#include "support/capi_samples.hpp"
#include "support/long_double.hpp"
#include "support/worst.hpp"

using namespace capi;

namespace {

constexpr double kEps = DBL_EPSILON;

// The same by formulas in long double, the products of the keys to twice its digits.
// Source: T. Ogita, S. M. Rump, S. Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26 (2005), Dot2.
struct Doubled {
  wide::Real value = 0, error = 0;

  void add(double a, double b, int sign) {
    const wide::Real x = sign * wide::Real(a), y = b, product = x * y;
    constexpr wide::Real kSplit = 4294967297.0L;
    const wide::Real x_high = kSplit * x - (kSplit * x - x), y_high = kSplit * y - (kSplit * y - y);
    const wide::Real x_low = x - x_high, y_low = y - y_high;
    const wide::Real rest = ((x_high * y_high - product) + x_high * y_low + x_low * y_high) + x_low * y_low;
    const wide::Real sum = value + product, part = sum - value;
    error += (value - (sum - part)) + (product - part) + rest;
    value = sum;
  }
  wide::Real sum() const { return value + error; }
};

// a* b, body, or b a*, world, not normalised.
wide::Quaternion relative(const double* a, const double* b, int32_t frame) {
  constexpr int kIndex[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  constexpr int kSign[4][4] = {{1, 1, 1, 1}, {1, -1, -1, 1}, {1, 1, -1, -1}, {1, -1, 1, -1}};  // of a_k b_l in a* b
  wide::Quaternion product;
  for (size_t component = 0; component < 4; ++component) {
    Doubled sum;
    for (size_t k = 0; k < 4; ++k) {
      const bool is_cross_term = component > 0 && k > 0 && k != component;
      const int world = frame == QTRAJ_FRAME_WORLD && is_cross_term ? -1 : 1;
      sum.add(a[k], b[kIndex[component][k]], world * kSign[component][k]);
    }
    product[component] = sum.sum();
  }
  return product;
}

wide::Vector expected_rate(const test::Keys& samples, size_t k, int32_t frame) {
  wide::Quaternion turn = relative(&samples.q[4 * k], &samples.q[4 * k + 4], frame);
  if (turn[0] < 0) turn = wide::scaled(-1, turn);
  const wide::Vector v = wide::vector_part(turn);
  const wide::Real sine = wide::norm(v), h = wide::Real(samples.times[k + 1]) - samples.times[k];
  return sine == 0 ? v : wide::scaled(2 * std::atan2(sine, turn[0]) / sine / h, v);
}

wide::Real allowed_error(const test::Keys& samples, size_t k, const wide::Vector& rate) {
  return 6 * kEps * wide::norm(rate) + 1e-30L / (samples.times[k + 1] - samples.times[k]);
}

// Samples at steps of every size, down to 1e-150 rad, of every norm and sign, at intervals of 1 us to 1000 s.
test::Keys hard_samples(test::Random& random, size_t count, double decades) {
  test::Keys samples;
  test::Quaternion q = random.orientation();
  double time = random.uniform(-1000, 1000);
  while (samples.count() < count) {
    const double kind = random.uniform(0, 1);
    const double norm = (random.uniform(0, 1) < 0.3 ? -1 : 1) * test::hard_norm(random, decades);
    samples.add(time, test::scaled(norm, q));
    time += std::pow(10.0, random.uniform(-6, 3));
    if (kind < 0.5) {
      q = test::hard_neighbour(random, q);
    } else if (kind < 0.7) {
      for (double& component : q) component *= 1.0 + kEps * std::floor(random.uniform(-4, 5));
    } else {
      // from an axis by a step that rounding does not touch
      q = {0, 0, 0, 0};
      const auto axis = static_cast<size_t>(random.uniform(0, 4));
      q[axis] = random.uniform(0, 1) < 0.5 ? 1 : -1;
      samples.add(time, q);
      time += 0.25;
      const double tiny = std::pow(10.0, random.uniform(-150, -8));
      for (size_t k = 0; k < 4; ++k)
        if (k != axis) q[k] = tiny * random.uniform(-1, 1);
    }
  }
  return samples;
}

TEST_CASE("C API: estimated rates are within 6 eps at any angle, in both frames", "[capi][sample_diagnostics]") {
  test::Random random(31);
  double worst = 0, worst_time = 0;
  for (int round = 0; round < 100; ++round) {
    const int32_t frame = kFrames[round % 2];
    const test::Keys samples = hard_samples(random, 10000, 160);
    const EstimatedRates rates = estimate(samples, frame);
    REQUIRE((rates.status == QTRAJ_OK || rates.status == QTRAJ_E_AMBIGUOUS));
    for (size_t k = 0; k + 1 < samples.count(); ++k) {
      const wide::Vector expected = expected_rate(samples, k, frame);
      const double* omega = &rates.omega[3 * k];
      double error = wide::error(omega, expected);
      // half a turn to rounding: either direction
      if (error > 1e-3 * static_cast<double>(wide::norm(expected)))
        error = std::min(error, wide::error(omega, wide::scaled(-1, expected)));
      test::raise_to(worst, error / allowed_error(samples, k, expected));
      const long double middle = 0.5L * samples.times[k] + 0.5L * samples.times[k + 1];
      test::raise_to(worst_time, std::abs(rates.t_mid[k] - middle) / (1e-300L + std::abs(middle)));
    }
  }
  CHECK(worst <= 1);
  CHECK(worst_time <= 0.51 * kEps);
}

TEST_CASE("C API: velocity jumps are differences of the estimated rates, whatever the knots' order",
          "[capi][sample_diagnostics]") {
  test::Random random(34);
  for (int round = 0; round < 20; ++round) {
    const int32_t frame = kFrames[round % 2];
    const test::Keys samples = hard_samples(random, 50, 160);
    const EstimatedRates rates = estimate(samples, frame);
    std::vector<double> knots;
    for (const double time : samples.times) {
      knots.insert(knots.begin(), time);
      knots.push_back(std::nextafter(time, DBL_MAX));
      knots.push_back(random.uniform(samples.times.front() - 1, samples.times.back() + 1));
    }
    knots.insert(knots.end(), {-DBL_MAX, DBL_MAX});
    std::vector<double> jumps(3 * knots.size());
    qtraj_estimate_jumps(frame, samples.times.data(), samples.q.data(), samples.count(), knots.data(), knots.size(),
                         jumps.data(), nullptr);
    size_t wrong = 0, outside = 0;
    for (size_t i = 0; i < knots.size(); ++i) {
      size_t after = samples.count() - 1, before = after;  // none
      for (size_t k = samples.count() - 1; k-- > 0;)
        if (samples.times[k] >= knots[i]) after = k;
      for (size_t k = 0; k + 1 < samples.count(); ++k)
        if (samples.times[k + 1] <= knots[i]) before = k;
      const bool exists = after + 1 < samples.count() && before + 1 < samples.count();
      if (!exists) ++outside;
      for (size_t k = 0; k < 3; ++k) {
        const double jump = jumps[3 * i + k];
        const bool right = exists ? jump == rates.omega[3 * after + k] - rates.omega[3 * before + k] : std::isnan(jump);
        if (!right) ++wrong;
      }
    }
    CHECK(wrong == 0);
    CHECK(outside >= 4);
  }
}

TEST_CASE("C API: the energy is that of rates within 6 eps of theirs", "[capi][sample_diagnostics]") {
  test::Random random(35);
  double worst = 0;
  for (int round = 0; round < 2000; ++round) {
    const int32_t frame = kFrames[round % 2];
    const test::Keys samples = round % 4 < 2
                                   ? test::random_walk(random, 100, std::pow(10.0, random.uniform(-9, 0)), 0.001, 10)
                                   : hard_samples(random, 3 + static_cast<size_t>(round % 50), 160);
    double energy = 0;
    const qtraj_status status =
        qtraj_estimate_energy(frame, samples.times.data(), samples.q.data(), samples.count(), &energy, nullptr);
    if (status == QTRAJ_E_AMBIGUOUS) continue;
    REQUIRE(status == QTRAJ_OK);
    wide::Real expected = 0, allowed = 0;
    wide::Vector last = expected_rate(samples, 0, frame);
    for (size_t k = 1; k + 1 < samples.count(); ++k) {
      const wide::Vector rate = expected_rate(samples, k, frame);
      const wide::Real between = (wide::Real(samples.times[k + 1]) - samples.times[k - 1]) / 2;
      const wide::Vector change = wide::sum(rate, wide::scaled(-1, last));
      const wide::Real size = wide::norm(change);
      const wide::Real off = allowed_error(samples, k, rate) + allowed_error(samples, k - 1, last);
      expected += size * size / between;
      allowed += (2 * size * off + off * off + 8 * kEps * size * size) / between;
      last = rate;
    }
    test::raise_to(worst, std::abs(energy - expected) / (allowed + 1e-300L));
  }
  CHECK(worst <= 1);
}

TEST_CASE("C API: keyframe errors are within 0.75 eps of the angle to the nearest sample",
          "[capi][sample_diagnostics]") {
  test::Random random(36);
  double worst = 0;
  size_t wrong_index = 0;
  for (int round = 0; round < 1000; ++round) {
    const test::Keys samples = hard_samples(random, 8, 160);
    test::Keys keys;
    for (int i = 0; i < 1000; ++i) {
      const auto near = static_cast<size_t>(random.uniform(0, static_cast<double>(samples.count())));
      test::Quaternion q = samples.orientation(near);
      if (i % 3 == 0) q = test::hard_orientation(random);
      if (i % 3 == 1) q = test::hard_neighbour(random, q);
      const double at = samples.times[near];
      keys.add(i % 2 ? at : random.uniform(samples.times.front() - 1, samples.times.back() + 1), q);
    }
    std::vector<double> errors(1000);
    std::vector<size_t> index(1000);
    REQUIRE(qtraj_keyframe_errors(keys.times.data(), keys.q.data(), 1000, samples.times.data(), samples.q.data(),
                                  samples.count(), errors.data(), index.data(), nullptr) == QTRAJ_OK);
    for (size_t i = 0; i < 1000; ++i) {
      size_t nearest = 0;
      const auto distance = [&](size_t k) { return std::abs(wide::Real(keys.times[i]) - samples.times[k]); };
      for (size_t k = 1; k < samples.count(); ++k)
        if (distance(k) < distance(nearest)) nearest = k;
      if (index[i] != nearest) ++wrong_index;
      const wide::Quaternion turn = relative(&keys.q[4 * i], &samples.q[4 * nearest], QTRAJ_FRAME_BODY);
      const wide::Real angle = 2 * std::atan2(wide::norm(wide::vector_part(turn)), std::abs(turn[0]));
      test::raise_to(worst, std::abs(errors[i] - angle) / (0.75L * kEps * angle + 1e-30L));
      if (!(errors[i] >= 0 && errors[i] <= 3.141592653589793)) ++wrong_index;
    }
  }
  CHECK(wrong_index == 0);
  CHECK(worst <= 1);
}

TEST_CASE("C API: the nearest sample is the earlier one in an exact tie only", "[capi][sample_diagnostics]") {
  const std::vector<double> times = {-DBL_MAX / 2, -1, 0, 1, 1 + 4 * kEps, 2e-3 + 1, DBL_MAX / 2};
  const std::vector<double> key_times = {-DBL_MAX,     DBL_MAX,
                                         -0.5,         std::nextafter(-0.5, 0.0),
                                         0.5,          std::nextafter(0.5, 1.0),
                                         1 + 2 * kEps, 1 + 3 * kEps,
                                         0.0,          -1e300,
                                         1e-320,       1.0005};
  const std::vector<size_t> expected = {0, 6, 1, 2, 2, 3, 3, 4, 2, 1, 2, 4};
  std::vector<double> q(4 * times.size()), key_q(4 * key_times.size()), errors(key_times.size());
  for (size_t k = 0; k < times.size(); ++k) q[4 * k] = 1;
  for (size_t k = 0; k < key_times.size(); ++k) key_q[4 * k + 1] = -3;
  std::vector<size_t> index(key_times.size());
  const auto call = [&](size_t* index_out) {
    return qtraj_keyframe_errors(key_times.data(), key_q.data(), key_times.size(), times.data(), q.data(), times.size(),
                                 errors.data(), index_out, nullptr);
  };
  CHECK(call(index.data()) == QTRAJ_OK);
  CHECK(index == expected);
  CHECK(errors == std::vector<double>(key_times.size(), 3.141592653589793));
  CHECK(call(nullptr) == QTRAJ_OK);
}

TEST_CASE("C API: the nearest sample is told by exact distances, not by rounded ones", "[capi][sample_diagnostics]") {
  const double far = 9007199254740992;  // 2^53: both distances round to 2^53 + 2
  const double q[8] = {1, 0, 0, 0, 0, 1, 0, 0}, times[2] = {-far, far + 4};
  const double key_times[3] = {2.5, 2, 1.5}, key_q[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  double errors[3];
  size_t index[3];
  CHECK(qtraj_keyframe_errors(key_times, key_q, 3, times, q, 2, errors, index, nullptr) == QTRAJ_OK);
  CHECK(index[0] == 1);
  CHECK(index[1] == 0);
  CHECK(index[2] == 0);
}

TEST_CASE("C API: the energy of a million samples is as good as that of three", "[capi][sample_diagnostics]") {
  // to and fro between two orientations: every change of rate is the same
  constexpr size_t kCount = 1000000;
  test::Keys samples;
  for (size_t k = 0; k < kCount; ++k)
    samples.add(0.25 * static_cast<double>(k), k % 2 ? test::Quaternion{1, 0.3, 0, 0} : test::Quaternion{1, 0, 0, 0.1});
  double three = 0, all = 0;
  REQUIRE(qtraj_estimate_energy(QTRAJ_FRAME_BODY, samples.times.data(), samples.q.data(), 3, &three, nullptr) ==
          QTRAJ_OK);
  REQUIRE(qtraj_estimate_energy(QTRAJ_FRAME_BODY, samples.times.data(), samples.q.data(), kCount, &all, nullptr) ==
          QTRAJ_OK);
  CHECK(std::abs(all / (kCount - 2) - three) <= 8 * kEps * three);
}

}  // namespace
