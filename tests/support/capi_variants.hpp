// Options for every variant of method_settings.hpp, and keyframes that all of them accept.
#ifndef QTRAJ_TESTS_CAPI_VARIANTS_HPP
#define QTRAJ_TESTS_CAPI_VARIANTS_HPP

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "support/capi_handles.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace capi {

// Options of a variant. Given rates at the ends are `rate`, rad/s, about a fixed axis, body frame.
inline Options make_options(const Variant& variant, double rate = 0.25) {
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(variant.method, &options) == QTRAJ_OK);
  Options owner(options);
  if (variant.end != QTRAJ_END_DEFAULT) REQUIRE(qtraj_options_set_ends(options, variant.end, variant.end) == QTRAJ_OK);
  if (variant.end == QTRAJ_END_GIVEN) {
    const double omega[3] = {0.6 * rate, 0, -0.8 * rate};
    REQUIRE(qtraj_options_set_end_rates(options, QTRAJ_FRAME_BODY, omega, omega) == QTRAJ_OK);
  }
  if (variant.tangents != QTRAJ_TANGENT_DEFAULT)
    REQUIRE(qtraj_options_set_tangents(options, variant.tangents) == QTRAJ_OK);
  if (variant.reference != QTRAJ_REFERENCE_DEFAULT) {
    const double q_wb[4] = {1.5, 0.2, -0.1, 0.3};
    const bool given = variant.reference == QTRAJ_REFERENCE_GIVEN;
    REQUIRE(qtraj_options_set_reference(options, variant.reference, given ? q_wb : nullptr) == QTRAJ_OK);
  }
  // keys of tests over all methods come with any sign
  if (variant.needs_tangents()) REQUIRE(qtraj_options_set_turns(options, QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
  return owner;
}

template <class Real>
struct Keyframes {
  std::vector<double> times;
  std::vector<Real> q;

  size_t count() const { return times.size(); }
};

// A closed tour on uneven knots, neither unit nor sign-continuous; count >= 3.
template <class Real>
Keyframes<Real> closed_tour(size_t count) {
  Keyframes<Real> keys;
  test::Random random(count);
  double time = -2.0;
  for (size_t key = 0; key < count; ++key) {
    const double phase = 6.283185307179586 * static_cast<double>(key) / static_cast<double>(count - 1);
    const bool closes = key + 1 == count;
    const double x = closes ? 0.0 : std::sin(phase), y = closes ? 0.0 : 1.0 - std::cos(phase);
    const double scale = (key % 3 == 1 ? -1.0 : 1.0) * (1.0 + 0.01 * static_cast<double>(key % 5));
    for (const double component : {1.0, 0.5 * x, 0.4 * y, 0.3 * x * y}) keys.q.push_back(Real(scale * component));
    keys.times.push_back(time);
    time += random.uniform(0.2, 1.5);
  }
  return keys;
}

// Rates at the keys in the body frame, tangents in R^4; empty where there are none.
template <class Real>
struct Rates {
  std::vector<Real> omega, alpha, in_tangents = {}, out_tangents = {};

  const Real* omega_or_null() const { return omega.empty() ? nullptr : omega.data(); }
  const Real* alpha_or_null() const { return alpha.empty() ? nullptr : alpha.data(); }
};

// Those that a variant needs, small enough for the tour.
template <class Real>
Rates<Real> rates_for(const Variant& variant, size_t count, double rate = 0.25) {
  Rates<Real> rates;
  for (size_t i = 0; i < 3 * count; ++i) {
    if (variant.needs_rates()) rates.omega.push_back(Real(rate * (static_cast<double>(i % 5) - 2.0) / 4.0));
    if (variant.needs_alpha()) rates.alpha.push_back(Real(rate * (static_cast<double>(i % 7) - 3.0) / 8.0));
  }
  for (size_t i = 0; variant.needs_tangents() && i < 4 * count; ++i) {
    rates.in_tangents.push_back(Real(rate * (static_cast<double>(i % 5) - 2.0) / 8.0));
    rates.out_tangents.push_back(Real(rate * (static_cast<double>(i % 7) - 3.0) / 8.0));
  }
  return rates;
}

inline Rates<double> widened(const Rates<float>& rates) {
  return {{rates.omega.begin(), rates.omega.end()},
          {rates.alpha.begin(), rates.alpha.end()},
          {rates.in_tangents.begin(), rates.in_tangents.end()},
          {rates.out_tangents.begin(), rates.out_tangents.end()}};
}

struct Built {
  qtraj_status status;
  size_t bad_index;
  Trajectory trajectory;
};

// create_with_options, or create_with_rates where there are rates, create_with_tangents where there are tangents.
template <class Real>
Built build(const qtraj_options* options, const Keyframes<Real>& keys, const Rates<Real>& rates = {},
            int32_t frame = QTRAJ_FRAME_BODY) {
  qtraj_trajectory* out = nullptr;
  size_t bad_index = 0;
  if (!rates.in_tangents.empty()) {
    const qtraj_status status =
        create_with_tangents(options, keys.times.data(), keys.q.data(), rates.in_tangents.data(),
                             rates.out_tangents.data(), keys.count(), &out, &bad_index);
    return {status, bad_index, Trajectory(out)};
  }
  const qtraj_status status =
      rates.omega.empty()
          ? create_with_options(options, keys.times.data(), keys.q.data(), keys.count(), &out, &bad_index)
          : create_with_rates(options, frame, keys.times.data(), keys.q.data(), rates.omega.data(),
                              rates.alpha_or_null(), keys.count(), &out, &bad_index);
  return {status, bad_index, Trajectory(out)};
}
template <class Real>
Trajectory must_build(const qtraj_options* options, const Keyframes<Real>& keys, const Rates<Real>& rates = {},
                      int32_t frame = QTRAJ_FRAME_BODY) {
  Built built = build(options, keys, rates, frame);
  REQUIRE(built.status == QTRAJ_OK);
  return std::move(built.trajectory);
}

// The same in the caller's memory: init, or init_with_tangents where there are tangents.
template <class Real>
qtraj_status build_in(void* memory, size_t bytes, const qtraj_options* options, const Keyframes<Real>& keys,
                      const Rates<Real>& rates, qtraj_trajectory** out, size_t* bad_index = nullptr) {
  if (!rates.in_tangents.empty())
    return init_with_tangents(memory, bytes, options, keys.times.data(), keys.q.data(), rates.in_tangents.data(),
                              rates.out_tangents.data(), keys.count(), out, bad_index);
  return init(memory, bytes, options, QTRAJ_FRAME_BODY, keys.times.data(), keys.q.data(), rates.omega_or_null(),
              rates.alpha_or_null(), keys.count(), out, bad_index);
}

template <class Real>
std::vector<Real> must_sample(const qtraj_trajectory* trajectory, const std::vector<double>& times) {
  std::vector<Real> q(4 * times.size());
  REQUIRE(sample(trajectory, times.data(), times.size(), q.data(), nullptr) == QTRAJ_OK);
  return q;
}

// q, omega and alpha of times that are all valid.
template <class Real>
struct Motion {
  std::vector<Real> q, omega, alpha;

  explicit Motion(size_t count) : q(4 * count), omega(3 * count), alpha(3 * count) {}
};
template <class Real>
Motion<Real> must_sample_rates(const qtraj_trajectory* trajectory, int32_t frame, const std::vector<double>& times) {
  Motion<Real> motion(times.size());
  REQUIRE(sample_rates(trajectory, frame, times.data(), times.size(), motion.q.data(), motion.omega.data(),
                       motion.alpha.data(), nullptr) == QTRAJ_OK);
  return motion;
}

// Knots, places between them, and, with extrapolation, times on both sides.
inline std::vector<double> times_in(const std::vector<double>& knots, size_t per_segment) {
  std::vector<double> times;
  for (size_t i = 0; i + 1 < knots.size(); ++i)
    for (size_t k = 0; k < per_segment; ++k) {
      const double u = static_cast<double>(k) / static_cast<double>(per_segment);
      times.push_back(std::min((1.0 - u) * knots[i] + u * knots[i + 1], knots[i + 1]));
    }
  times.push_back(knots.back());
  return times;
}

template <class Real>
bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0;
}
template <class Real>
bool same_bits(const Motion<Real>& a, const Motion<Real>& b) {
  return same_bits(a.q, b.q) && same_bits(a.omega, b.omega) && same_bits(a.alpha, b.alpha);
}

// Largest | |q| - 1 | of the rows in eps of their type, infinity where a row is not finite.
template <class Real>
double worst_norm_error(const std::vector<Real>& q) {
  double worst = 0;
  for (size_t i = 0; i < q.size(); i += 4) {
    double sum = 0;
    for (size_t k = i; k < i + 4; ++k) sum += static_cast<double>(q[k]) * static_cast<double>(q[k]);
    const double error = std::abs(std::sqrt(sum) - 1.0) / static_cast<double>(std::numeric_limits<Real>::epsilon());
    worst = error <= worst ? worst : error < 1e300 ? error : std::numeric_limits<double>::infinity();
  }
  return worst;
}

}  // namespace capi

#endif
