// The curves of the golden hashes: every method with several settings through keys of every kind. Keys and times are
// made of integers, + and * only: no library function can change a bit of them.
#ifndef QTRAJ_TESTS_GOLDEN_CURVES_HPP
#define QTRAJ_TESTS_GOLDEN_CURVES_HPP

#include <algorithm>
#include <vector>

#include "support/capi_handles.hpp"

namespace golden {

// splitmix64 (Vigna).
class Integers {
 public:
  explicit Integers(uint64_t seed) : state_(seed) {}

  uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  size_t below(size_t bound) { return static_cast<size_t>(bits() % bound); }
  // A multiple of 1/1024 in [-1, 1].
  double signed_fraction() { return (static_cast<double>(below(2049)) - 1024.0) / 1024.0; }

 private:
  uint64_t state_;
};

struct Keys {
  std::vector<double> times, q, omega, alpha, in_tangents, out_tangents;
};

// A walk of steps (1, v), |v_k| <= `size`: up to 2 atan(|v|) each. Norms grow, every third sign is turned.
inline Keys walk(uint64_t seed, size_t count, double size, bool over_six_decades) {
  Integers random(seed);
  Keys keys;
  double q[4] = {3, 1, -2, 0.5}, time = -2.5;
  for (size_t key = 0; key < count; ++key) {
    keys.times.push_back(time);
    for (const double component : q) keys.q.push_back(key % 3 == 1 ? -component : component);
    const double x = size * random.signed_fraction(), y = size * random.signed_fraction(),
                 z = size * random.signed_fraction();
    const double next[4] = {q[0] - q[1] * x - q[2] * y - q[3] * z, q[1] + q[0] * x + q[2] * z - q[3] * y,
                            q[2] + q[0] * y - q[1] * z + q[3] * x, q[3] + q[0] * z + q[1] * y - q[2] * x};
    std::copy(next, next + 4, q);
    const double gap = static_cast<double>(205 + random.below(1024)) / 1024.0;
    time += over_six_decades ? gap / static_cast<double>(1u << random.below(21)) : gap;
  }
  return keys;
}

// Around one orientation and back to minus the first key.
inline Keys closed(uint64_t seed, size_t count) {
  Integers random(seed);
  Keys keys;
  for (size_t key = 0; key < count; ++key) {
    keys.times.push_back(1.0 + static_cast<double>(key) + 0.375 * random.signed_fraction());
    keys.q.push_back(2.0);
    for (int k = 0; k < 3; ++k) keys.q.push_back(random.signed_fraction());
  }
  for (size_t k = 0; k < 4; ++k) keys.q[4 * count - 4 + k] = -keys.q[k];
  return keys;
}

inline void add_rates(Keys& keys, uint64_t seed) {
  Integers random(seed);
  for (size_t i = 0; i < 3 * keys.times.size(); ++i) {
    keys.omega.push_back(random.signed_fraction());
    keys.alpha.push_back(0.5 * random.signed_fraction());
  }
  for (size_t i = 0; i < keys.q.size(); ++i) {
    keys.in_tangents.push_back(random.signed_fraction());
    keys.out_tangents.push_back(random.signed_fraction());
  }
}

struct Outside {
  int32_t before, after;
};
constexpr Outside kOutside[] = {{QTRAJ_EXTRAPOLATE_ERROR, QTRAJ_EXTRAPOLATE_HOLD},
                                {QTRAJ_EXTRAPOLATE_CONSTANT_RATE, QTRAJ_EXTRAPOLATE_ERROR},
                                {QTRAJ_EXTRAPOLATE_HOLD, QTRAJ_EXTRAPOLATE_CONSTANT_RATE}};
constexpr Outside kWrapped = {QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC};

struct Curve {
  capi::Variant setting;
  Outside outside;
  Keys keys;
};

// Two sets, each with a hash of its own, so that a method that is added leaves the first as it is.
enum class Set { first, added };
inline Set set_of(const capi::Variant& setting) {
  const bool is_added =
      setting.needs_tangents() || setting.tangents == QTRAJ_TANGENT_REST || setting.method == QTRAJ_STEP;
  return is_added ? Set::added : Set::first;
}

inline std::vector<Curve> curves(Set set) {
  Keys open[] = {walk(1, 5, 0.04, false), walk(2, 8, 0.5, false), walk(3, 30, 2.0, false), walk(4, 24, 0.5, true)};
  Keys tour = closed(5, 12);
  for (Keys& keys : open) add_rates(keys, 6);
  add_rates(tour, 7);
  std::vector<Curve> all;
  for (const capi::Variant& setting : capi::variants()) {
    if (set_of(setting) != set) continue;
    all.push_back({setting, kWrapped, tour});
    all.push_back({setting, kOutside[all.size() % 3], tour});
    if (setting.end == QTRAJ_END_PERIODIC) continue;
    for (const Keys& keys : open) all.push_back({setting, kOutside[all.size() % 3], keys});
  }
  return all;
}

}  // namespace golden

#endif
