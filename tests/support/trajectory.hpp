// A trajectory of the C API for tests that are not about construction: owns the handle, fails the test on any error.
#ifndef QTRAJ_TESTS_TRAJECTORY_HPP
#define QTRAJ_TESTS_TRAJECTORY_HPP

#include <qtraj.h>

#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/worst.hpp"

namespace test {

struct Settings {
  int32_t method;
  int32_t end = QTRAJ_END_DEFAULT;
  int32_t tangents = QTRAJ_TANGENT_DEFAULT;
  int32_t reference = QTRAJ_REFERENCE_DEFAULT;
  std::vector<double> reference_q = {};
};

inline qtraj_options* make_options(const Settings& settings) {
  qtraj_options* options = nullptr;
  REQUIRE(qtraj_options_create(settings.method, &options) == QTRAJ_OK);
  if (settings.end != QTRAJ_END_DEFAULT)
    REQUIRE(qtraj_options_set_ends(options, settings.end, settings.end) == QTRAJ_OK);
  if (settings.tangents != QTRAJ_TANGENT_DEFAULT)
    REQUIRE(qtraj_options_set_tangents(options, settings.tangents) == QTRAJ_OK);
  if (settings.reference != QTRAJ_REFERENCE_DEFAULT) {
    const double* q = settings.reference_q.empty() ? nullptr : settings.reference_q.data();
    REQUIRE(qtraj_options_set_reference(options, settings.reference, q) == QTRAJ_OK);
  }
  // keys come with any sign
  if (settings.method == QTRAJ_QUATERNION_HERMITE)
    REQUIRE(qtraj_options_set_turns(options, QTRAJ_TURNS_SHORTEST) == QTRAJ_OK);
  return options;
}

class Trajectory {
 public:
  Trajectory(const Settings& settings, const Keys& keys) {
    qtraj_options* options = make_options(settings);
    const qtraj_status status =
        qtraj_create_with_options(options, keys.times.data(), keys.q.data(), keys.count(), &handle_, nullptr);
    qtraj_options_destroy(options);
    REQUIRE(status == QTRAJ_OK);
  }
  explicit Trajectory(qtraj_trajectory* handle) : handle_(handle) { REQUIRE(handle != nullptr); }
  Trajectory(Trajectory&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Trajectory(const Trajectory&) = delete;
  Trajectory& operator=(const Trajectory&) = delete;
  ~Trajectory() { qtraj_destroy(handle_); }

  const qtraj_trajectory* get() const { return handle_; }

  std::vector<double> sample(const std::vector<double>& times) const {
    std::vector<double> q(4 * times.size());
    REQUIRE(qtraj_sample(handle_, times.data(), times.size(), q.data(), nullptr) == QTRAJ_OK);
    return q;
  }
  std::vector<float> sample_f32(const std::vector<double>& times) const {
    std::vector<float> q(4 * times.size());
    REQUIRE(qtraj_sample_f32(handle_, times.data(), times.size(), q.data(), nullptr) == QTRAJ_OK);
    return q;
  }
  Quaternion at(double time) const {
    Quaternion q;
    REQUIRE(qtraj_sample_at(handle_, time, nullptr, q.data()) == QTRAJ_OK);
    return q;
  }
  // q, omega and alpha of the sampled times, in a frame.
  template <class Real>
  struct Motion {
    std::vector<Real> q, omega, alpha;
  };
  Motion<double> sample_rates(int32_t frame, const std::vector<double>& times) const {
    Motion<double> m = {std::vector<double>(4 * times.size()), std::vector<double>(3 * times.size()),
                        std::vector<double>(3 * times.size())};
    REQUIRE(qtraj_sample_rates(handle_, frame, times.data(), times.size(), m.q.data(), m.omega.data(), m.alpha.data(),
                               nullptr) == QTRAJ_OK);
    return m;
  }
  Motion<float> sample_rates_f32(int32_t frame, const std::vector<double>& times) const {
    Motion<float> m = {std::vector<float>(4 * times.size()), std::vector<float>(3 * times.size()),
                       std::vector<float>(3 * times.size())};
    REQUIRE(qtraj_sample_rates_f32(handle_, frame, times.data(), times.size(), m.q.data(), m.omega.data(),
                                   m.alpha.data(), nullptr) == QTRAJ_OK);
    return m;
  }
  // Rates at one time.
  struct RatesAt {
    Quaternion q;
    Vector omega, alpha;
  };
  RatesAt rates_at(int32_t frame, double time) const {
    RatesAt at{};
    REQUIRE(qtraj_sample_rates_at(handle_, frame, time, nullptr, at.q.data(), at.omega.data(), at.alpha.data()) ==
            QTRAJ_OK);
    return at;
  }
  // Keys as used.
  Keys keys() const {
    Keys keys;
    keys.times.resize(qtraj_key_count(handle_));
    keys.q.resize(4 * keys.count());
    REQUIRE(qtraj_keys(handle_, keys.times.data(), keys.q.data()) == QTRAJ_OK);
    return keys;
  }

 private:
  qtraj_trajectory* handle_ = nullptr;
};

inline double largest_difference(const Quaternion& a, const Quaternion& b) {
  double largest = 0;
  for (size_t k = 0; k < 4; ++k) raise_to(largest, std::abs(a[k] - b[k]));
  return largest;
}

}  // namespace test

#endif
