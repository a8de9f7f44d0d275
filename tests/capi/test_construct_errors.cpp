// Constructors and faulty keyframes: the status, the index at fault, and nothing built.
#include <cfloat>
#include <functional>
#include <limits>

#include "support/capi_variants.hpp"

using namespace capi;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kCount = 6;

// Every way to build a curve. `omega` is passed where the way takes rates.
template <class Real>
using Door = std::function<qtraj_status(const Keyframes<Real>&, const Rates<Real>&, qtraj_trajectory**, size_t*)>;
template <class Real>
struct NamedDoor {
  std::string name;
  bool takes_rates;
  Door<Real> open;
};

template <class Real>
Rates<Real> zero_rates() {
  const std::vector<Real> vectors(3 * kCount), tangents(4 * kCount);
  return {vectors, vectors, tangents, tangents};
}

template <class Real>
std::vector<NamedDoor<Real>> doors() {
  using Rates = capi::Rates<Real>;
  std::vector<NamedDoor<Real>> all;
  for (const int32_t method : all_methods()) {
    if (always_needs_rates(method) || needs_tangents(method)) continue;
    all.push_back({"create method " + std::to_string(method), false,
                   [method](const Keyframes<Real>& keys, const Rates&, qtraj_trajectory** out, size_t* bad_index) {
                     return create(method, keys.times.data(), keys.q.data(), keys.count(), out, bad_index);
                   }});
  }
  for (const Variant& variant : variants()) {
    if (variant.end == QTRAJ_END_PERIODIC) continue;
    const bool takes_rates = variant.needs_rates();
    all.push_back(
        {(takes_rates ? "create_with_rates " : "create_with_options ") + variant.name, takes_rates,
         [variant](const Keyframes<Real>& keys, const Rates& rates, qtraj_trajectory** out, size_t* bad_index) {
           const Options options = make_options(variant);
           if (variant.needs_tangents())
             return create_with_tangents(options.get(), keys.times.data(), keys.q.data(), rates.in_tangents.data(),
                                         rates.out_tangents.data(), keys.count(), out, bad_index);
           return variant.needs_rates()
                      ? create_with_rates(options.get(), QTRAJ_FRAME_WORLD, keys.times.data(), keys.q.data(),
                                          rates.omega.data(), variant.needs_alpha() ? rates.alpha.data() : nullptr,
                                          keys.count(), out, bad_index)
                      : create_with_options(options.get(), keys.times.data(), keys.q.data(), keys.count(), out,
                                            bad_index);
         }});
    all.push_back(
        {"init " + variant.name, takes_rates,
         [variant](const Keyframes<Real>& keys, const Rates& rates, qtraj_trajectory** out, size_t* bad_index) {
           const Options options = make_options(variant);
           std::vector<double> memory(2048);
           if (variant.needs_tangents())
             return init_with_tangents(memory.data(), memory.size() * sizeof(double), options.get(), keys.times.data(),
                                       keys.q.data(), rates.in_tangents.data(), rates.out_tangents.data(), keys.count(),
                                       out, bad_index);
           return init(memory.data(), memory.size() * sizeof(double), options.get(), QTRAJ_FRAME_WORLD,
                       keys.times.data(), keys.q.data(), variant.needs_rates() ? rates.omega.data() : nullptr,
                       variant.needs_alpha() ? rates.alpha.data() : nullptr, keys.count(), out, bad_index);
         }});
  }
  return all;
}

// A fault put into good keyframes, and what every constructor must say to it.
template <class Real>
struct Fault {
  const char* name;
  std::function<void(Keyframes<Real>&)> make;
  qtraj_status status;
  size_t index;
};

template <class Real>
void set_q(Keyframes<Real>& keys, size_t key, double value) {
  for (size_t k = 4 * key; k < 4 * key + 4; ++k) keys.q[k] = Real(value);
}

template <class Real>
std::vector<Fault<Real>> faults() {
  using K = Keyframes<Real>;
  return {
      {"NaN in the first component", [](K& k) { k.q[0] = Real(kNaN); }, QTRAJ_E_NOT_FINITE, 0},
      {"NaN in the last component", [](K& k) { k.q[4 * kCount - 1] = Real(kNaN); }, QTRAJ_E_NOT_FINITE, kCount - 1},
      {"infinity", [](K& k) { k.q[4 * 3 + 2] = Real(kInfinity); }, QTRAJ_E_NOT_FINITE, 3},
      {"-infinity", [](K& k) { k.q[4 * 2 + 1] = Real(-kInfinity); }, QTRAJ_E_NOT_FINITE, 2},
      {"all NaN", [](K& k) { set_q(k, 1, kNaN); }, QTRAJ_E_NOT_FINITE, 1},
      {"NaN time", [](K& k) { k.times[2] = kNaN; }, QTRAJ_E_NOT_FINITE, 2},
      {"first time NaN", [](K& k) { k.times[0] = kNaN; }, QTRAJ_E_NOT_FINITE, 0},
      {"first time -infinity", [](K& k) { k.times[0] = -kInfinity; }, QTRAJ_E_NOT_FINITE, 0},
      {"last time infinity", [](K& k) { k.times[kCount - 1] = kInfinity; }, QTRAJ_E_NOT_FINITE, kCount - 1},
      {"zero at the first key", [](K& k) { set_q(k, 0, 0.0); }, QTRAJ_E_ZERO_NORM, 0},
      {"negative zeros", [](K& k) { set_q(k, kCount - 1, -0.0); }, QTRAJ_E_ZERO_NORM, kCount - 1},
      {"repeated time", [](K& k) { k.times[3] = k.times[2]; }, QTRAJ_E_TIME_ORDER, 3},
      {"time goes back", [](K& k) { k.times[1] = k.times[0] - 1; }, QTRAJ_E_TIME_ORDER, 1},
      {"zero and minus zero", [](K& k) { k.times = {-1, -0.0, 0.0, 1, 2, 3}; }, QTRAJ_E_TIME_ORDER, 2},
      {"gap whose inverse square overflows", [](K& k) { k.times = {-2, -1, 0, 7.4583e-155, 1, 2}; }, QTRAJ_E_TIME_ORDER,
       3},
      {"gap whose inverse square just fits, then a repeated time",
       [](K& k) { k.times = {-2, -1, 0, 7.4584e-155, 1, 1}; }, QTRAJ_E_TIME_ORDER, 5},
      {"denormal gap", [](K& k) { k.times = {-2, -1, 0, 5e-324, 1, 2}; }, QTRAJ_E_TIME_ORDER, 3},
      {"span overflows at the last key", [](K& k) { k.times = {-DBL_MAX, -1e308, -1, 0, 1, 1e308}; }, QTRAJ_E_TIME_SPAN,
       5},
      {"a gap overflows", [](K& k) { k.times = {-DBL_MAX, DBL_MAX, 0, 0, 0, 0}; }, QTRAJ_E_TIME_SPAN, 1},
      {"span that rounds to infinity",
       [](K& k) { k.times = {-DBL_MAX / 2, -3, -2, -1, 0, std::nextafter(DBL_MAX / 2, DBL_MAX)}; }, QTRAJ_E_TIME_SPAN,
       5},
      {"NaN before zero norm, at one key", [](K& k) { set_q(k, 2, 0), k.times[2] = kNaN; }, QTRAJ_E_NOT_FINITE, 2},
      {"zero norm before time order, at one key", [](K& k) { set_q(k, 2, 0), k.times[2] = k.times[1]; },
       QTRAJ_E_ZERO_NORM, 2},
      {"zero norm before time range, at one key",
       [](K& k) { k.times = {-DBL_MAX, DBL_MAX, 0, 0, 0, 0}, set_q(k, 1, 0); }, QTRAJ_E_ZERO_NORM, 1},
      {"lowest index: time order, then NaN", [](K& k) { k.times[1] = k.times[0], k.q[4 * 5] = Real(kNaN); },
       QTRAJ_E_TIME_ORDER, 1},
      {"lowest index: zero norm, then NaN", [](K& k) { set_q(k, 1, 0), set_q(k, 2, kNaN); }, QTRAJ_E_ZERO_NORM, 1},
      {"lowest index: time range, then NaN", [](K& k) { k.times = {-DBL_MAX, 0, DBL_MAX, kNaN, 0, 0}; },
       QTRAJ_E_TIME_SPAN, 2},
      {"lowest index: NaN, then everything", [](K& k) { set_q(k, 1, kNaN), set_q(k, 2, 0), k.times[3] = k.times[2]; },
       QTRAJ_E_NOT_FINITE, 1},
  };
}

TEST_CASE("C API: every constructor names the first faulty key and its first fault", "[capi][construct][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const NamedDoor<Real>& door : doors<Real>())
      for (const Fault<Real>& fault : faults<Real>()) {
        INFO(door.name << ": " << fault.name << (sizeof(Real) == 4 ? " (float)" : ""));
        Keyframes<Real> keys = closed_tour<Real>(kCount);
        fault.make(keys);
        const Rates<Real> rates = zero_rates<Real>();
        int stale = 0;
        qtraj_trajectory* out = reinterpret_cast<qtraj_trajectory*>(&stale);
        size_t bad_index = 12345;
        CHECK(door.open(keys, rates, &out, &bad_index) == fault.status);
        CHECK(out == nullptr);
        CHECK(bad_index == fault.index);
        out = reinterpret_cast<qtraj_trajectory*>(&stale);
        CHECK(door.open(keys, rates, &out, nullptr) == fault.status);
        CHECK(out == nullptr);
      }
  });
}

TEST_CASE("C API: good keyframes give a trajectory and the index SIZE_MAX", "[capi][construct]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const NamedDoor<Real>& door : doors<Real>()) {
      if (door.name.compare(0, 4, "init") == 0) continue;  // its memory is gone here
      INFO(door.name);
      qtraj_trajectory* out = nullptr;
      size_t bad_index = 12345;
      CHECK(door.open(closed_tour<Real>(kCount), zero_rates<Real>(), &out, &bad_index) == QTRAJ_OK);
      CHECK(bad_index == SIZE_MAX);
      REQUIRE(out != nullptr);
      CHECK(qtraj_key_count(out) == kCount);
      qtraj_destroy(out);
    }
  });
}

TEST_CASE("C API: rates at the keys are checked with their key, before its norm and time",
          "[capi][construct][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const NamedDoor<Real>& door : doors<Real>()) {
      if (!door.takes_rates) continue;
      for (const double bad : {kNaN, kInfinity, -kInfinity})
        for (const size_t key : {size_t{0}, size_t{2}, kCount - 1}) {
          INFO(door.name);
          CAPTURE(bad, key);
          Keyframes<Real> keys = closed_tour<Real>(kCount);
          set_q(keys, key, 0.0);
          Rates<Real> rates = zero_rates<Real>();
          rates.omega[3 * key + 2] = Real(bad);
          qtraj_trajectory* out = nullptr;
          size_t bad_index = 0;
          CHECK(door.open(keys, rates, &out, &bad_index) == QTRAJ_E_NOT_FINITE);
          CHECK(bad_index == key);
        }
    }
  });
}

TEST_CASE("C API: rates too fast for their interval are OPTION with the index of the key",
          "[capi][construct][errors]") {
  const std::vector<double> times = {0, 1, 3, 4};
  const std::vector<double> q = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  const Variant by_key = {"", QTRAJ_SQUAD, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_GIVEN};
  // |h omega/2 - L| < 2 pi on both sides: the longer side decides
  struct Row {
    size_t key;
    double rate;
    bool fine;
  };
  constexpr double kTwoPi = 6.283185307179586;
  const Row rows[] = {{0, 2 * kTwoPi * 0.999, true},
                      {0, 2 * kTwoPi * 1.001, false},
                      {1, kTwoPi * 0.999, true},
                      {1, kTwoPi * 1.001, false},
                      {2, kTwoPi * 1.001, false},
                      {3, 2 * kTwoPi * 0.999, true},
                      {3, 2 * kTwoPi * 1.001, false},
                      {0, 1e150, false},
                      {2, DBL_MAX, false}};
  for (const Row& row : rows) {
    CAPTURE(row.key, row.rate);
    Rates<double> rates = {std::vector<double>(12), {}};
    rates.omega[3 * row.key + 1] = -row.rate;
    const Built built = build(make_options(by_key).get(), Keyframes<double>{times, q}, rates);
    CHECK(built.status == (row.fine ? QTRAJ_OK : QTRAJ_E_RATE_TOO_FAST));
    CHECK(built.bad_index == (row.fine ? SIZE_MAX : row.key));
    CHECK((built.trajectory != nullptr) == row.fine);
  }
  const Variant by_end = {"", QTRAJ_SQUAD, QTRAJ_END_GIVEN};
  for (const double rate : {14.0, 1e200, DBL_MAX}) {
    const Built built = build(make_options(by_end, rate).get(), Keyframes<double>{times, q});
    CHECK(built.status == QTRAJ_E_RATE_TOO_FAST);
    CHECK(built.bad_index == 0);
  }
}

TEST_CASE("C API: PERIODIC needs first and last key within 1e-6 rad as orientations", "[capi][construct][errors]") {
  for (const bool extrapolation : {false, true})
    for (const int32_t method : all_methods())
      for (const double sign : {1.0, -1.0})
        for (const double angle : {0.0, 0.9e-6, 1.1e-6, 0.1, 3.0}) {
          const bool has_ends = method == QTRAJ_SQUAD || method == QTRAJ_LOG_SPLINE || method == QTRAJ_ROTATION_SPLINE;
          if (!extrapolation && !has_ends) continue;
          CAPTURE(extrapolation, method, sign, angle);
          Keyframes<double> keys = closed_tour<double>(kCount);
          const double half = 0.5 * angle;
          for (size_t k = 0; k < 4; ++k) keys.q[k] = k == 0;
          const double last[4] = {sign * std::cos(half), 0, sign * std::sin(half), 0};
          std::copy(last, last + 4, keys.q.end() - 4);

          const Options owner = make_options({"", method});
          qtraj_options* const options = owner.get();
          if (extrapolation)
            REQUIRE(qtraj_options_set_extrapolation(options, QTRAJ_EXTRAPOLATE_PERIODIC, QTRAJ_EXTRAPOLATE_PERIODIC) ==
                    QTRAJ_OK);
          else
            REQUIRE(qtraj_options_set_ends(options, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC) == QTRAJ_OK);
          const Built built = build(options, keys, rates_for<double>({"", method}, kCount));
          const bool closed = angle < 1e-6;
          CHECK(built.status == (closed ? QTRAJ_OK : QTRAJ_E_NOT_CLOSED));
          CHECK(built.bad_index == (closed ? SIZE_MAX : kCount - 1));
          CHECK((built.trajectory != nullptr) == closed);
        }
}

TEST_CASE("C API: a periodic LOG_SPLINE that winds is NOT_CLOSED", "[capi][construct][errors]") {
  Keyframes<double> keys;
  for (int i = 0; i <= 8; ++i) {
    const double half = 3.141592653589793 * i / 8;  // one full turn: the last key is minus the first
    keys.times.push_back(i);
    for (const double component : {std::cos(half), 0.0, 0.0, std::sin(half)}) keys.q.push_back(component);
  }
  const Built spline = build(make_options({"", QTRAJ_LOG_SPLINE, QTRAJ_END_PERIODIC}).get(), keys);
  CHECK(spline.status == QTRAJ_E_NOT_CLOSED);
  CHECK(spline.bad_index == 8);
  CHECK(build(make_options({"", QTRAJ_SQUAD, QTRAJ_END_PERIODIC}).get(), keys).status == QTRAJ_OK);
}

TEST_CASE("C API: a mean reference that is not unique is AMBIGUOUS and no trajectory", "[capi][construct][errors]") {
  const Keyframes<double> half_turn = {{0, 1}, {1, 0, 0, 0, 0, 1, 0, 0}};
  const Variant mean = {"", QTRAJ_LOG_SPLINE, QTRAJ_END_DEFAULT, QTRAJ_TANGENT_DEFAULT, QTRAJ_REFERENCE_MEAN};
  const Built built = build(make_options(mean).get(), half_turn);
  CHECK(built.status == QTRAJ_E_AMBIGUOUS);
  CHECK(built.bad_index == SIZE_MAX);
  CHECK(built.trajectory == nullptr);
}

TEST_CASE("C API: a LOG_SPLINE thrown too far by its knots is NOT_FINITE with the index of a key",
          "[capi][construct][errors]") {
  Keyframes<double> keys = closed_tour<double>(5);
  const Variant variant = {"", QTRAJ_LOG_SPLINE, QTRAJ_END_NOT_A_KNOT};
  keys.times = {0, 1e-154, 1e100, 2e100, 3e100};
  const Built built = build(make_options(variant).get(), keys);
  CHECK(built.status == QTRAJ_E_NOT_FINITE);
  CHECK(built.bad_index < 5);
  CHECK(built.trajectory == nullptr);
}

}  // namespace
