// slerp and nlerp, double and float, as one list, and pairs and fractions that are hard for them.
#ifndef QTRAJ_TESTS_PAIR_FUNCTIONS_HPP
#define QTRAJ_TESTS_PAIR_FUNCTIONS_HPP

#include <qtraj.h>

#include <vector>

#include "support/hard_inputs.hpp"

namespace pairs {

constexpr int32_t kPaths[] = {QTRAJ_PATH_SHORTEST, QTRAJ_PATH_AS_GIVEN};

// A function of one pair at many fractions and its twin pair by pair.
template <class Real>
struct Functions {
  qtraj_status (*one)(const Real*, const Real*, const Real*, size_t, int32_t, Real*, size_t*);
  qtraj_status (*many)(const Real*, size_t, const Real*, size_t, const Real*, size_t, size_t, int32_t, Real*, size_t*);
};
inline std::vector<Functions<double>> functions(double) {
  return {{qtraj_slerp, qtraj_slerp_pairs}, {qtraj_nlerp, qtraj_nlerp_pairs}};
}
inline std::vector<Functions<float>> functions(float) {
  return {{qtraj_slerp_f32, qtraj_slerp_pairs_f32}, {qtraj_nlerp_f32, qtraj_nlerp_pairs_f32}};
}

// Ends at a hard angle with norms within these decades; one in eight a true arc far below the rounding of its ends.
struct Ends {
  test::Quaternion a, b;
};
inline Ends hard_ends(test::Random& random, double decades) {
  if (random.uniform(0, 1) < 0.125) {
    const test::Vector v = test::hard_direction(random);
    const double sine = std::pow(10.0, random.uniform(-290.0, -1.0)), sign = random.uniform(0, 1) < 0.5 ? 1.0 : -1.0;
    return {{1, 0, 0, 0}, {sign, sine * v[0], sine * v[1], sine * v[2]}};
  }
  const test::Quaternion a = test::hard_orientation(random), b = test::hard_neighbour(random, a);
  return {test::scaled(test::hard_norm(random, decades), a), test::scaled(test::hard_norm(random, decades), b)};
}

// Fractions at the ends, between them, at the middle, outside, and up to 1e6 rad away on an arc of this angle.
using Fractions = std::array<double, 8>;
inline Fractions hard_fractions(test::Random& random, double angle) {
  const auto signed_power = [&](double low, double high) {
    return std::pow(10.0, random.uniform(low, high)) * (random.uniform(0, 1) < 0.5 ? 1.0 : -1.0);
  };
  const double per_radian = 1.0 / std::max(angle, 1e-300);
  return {0,
          1,
          random.uniform(0, 1),
          random.uniform(0, 1),
          0.5 + signed_power(-17, -1),
          random.uniform(-3, 4),
          signed_power(-3, 0) * per_radian,
          signed_power(0, 6) * per_radian};
}

// Rows of pairs with a fraction each.
template <class Real>
struct Batch {
  std::vector<Real> a, b, fractions;

  size_t count() const { return fractions.size(); }
};
template <class Real>
Batch<Real> hard_batch(uint64_t seed, size_t count) {
  test::Random random(seed);
  Batch<Real> batch;
  for (size_t i = 0; i < count; ++i) {
    const Ends ends = hard_ends(random, sizeof(Real) == sizeof(double) ? 160 : 30);
    for (const double component : ends.a) batch.a.push_back(static_cast<Real>(component));
    for (const double component : ends.b) batch.b.push_back(static_cast<Real>(component));
    batch.fractions.push_back(static_cast<Real>(hard_fractions(random, 1.0)[i % 8]));
  }
  return batch;
}

// Norm of a row, to long double's digits; rows whose squares would overflow a double are fine.
template <class Real>
double norm_of(const Real* q) {
  long double sum = 0;
  for (size_t k = 0; k < 4; ++k) sum += static_cast<long double>(q[k]) * q[k];
  return static_cast<double>(std::sqrt(sum));
}

}  // namespace pairs

#endif
