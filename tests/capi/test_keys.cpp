// Keys made ready: norms, signs and the order of components.
#include <cfloat>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"
#include "support/hard_inputs.hpp"
#include "support/long_double.hpp"

using namespace capi;

namespace {

template <class Real>
constexpr Real kEps = std::numeric_limits<Real>::epsilon();

// A key of any norm the type has, now and then with components of very different size.
template <class Real>
void set_hard_key(test::Random& random, Real* q) {
  const bool is_single = sizeof(Real) == sizeof(float);
  const double kind = random.uniform(0, 1);
  const test::Quaternion unit = kind < 0.5 ? test::hard_orientation(random) : random.orientation();
  const double norm = test::hard_norm(random, is_single ? 30 : 160);
  for (size_t k = 0; k < 4; ++k) {
    double component = norm * unit[k];
    if (kind > 0.9)
      component = unit[k] * std::pow(10.0, is_single ? random.uniform(-44, 38) : random.uniform(-323, 307));
    q[k] = static_cast<Real>(component);
  }
  if (kind > 0.99) q[static_cast<size_t>(random.uniform(0, 4))] = std::numeric_limits<Real>::max();
  if (q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0) q[2] = -std::numeric_limits<Real>::denorm_min();
}

TEST_CASE("C API: normalized components are rounded once, and the norm is 1 to an eps", "[capi][keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    constexpr size_t kBlock = 1000;
    const long double relative = 0.51L * kEps<Real>, absolute = sizeof(Real) == sizeof(float) ? 1e-45L : 1e-200L;
    std::vector<Real> q(4 * kBlock), unit(4 * kBlock);
    test::Random random(11);
    double worst_norm = 0;
    size_t wrong = 0;
    for (int block = 0; block < 1000; ++block) {
      for (size_t i = 0; i < kBlock; ++i) set_hard_key(random, &q[4 * i]);
      REQUIRE(normalize(q.data(), kBlock, unit.data(), nullptr) == QTRAJ_OK);
      worst_norm = std::max(worst_norm, worst_norm_error(unit));
      for (size_t i = 0; i < 4 * kBlock; i += 4) {
        const wide::Quaternion expected = wide::normalized(wide::quaternion(&q[i]));
        for (size_t k = 0; k < 4; ++k) {
          const long double error = std::abs(static_cast<long double>(unit[i + k]) - expected[k]);
          const bool good = error <= relative * std::abs(expected[k]) + absolute &&
                            std::signbit(unit[i + k]) == std::signbit(q[i + k]);
          if (!good) ++wrong;
        }
      }
    }
    CHECK(wrong == 0);
    CHECK(worst_norm <= 2);  // an eps, and the rounding of the sum of squares that measures it
  });
}

TEST_CASE("C API: the largest and the smallest numbers of the type are normalized like any other", "[capi][keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Real largest = std::numeric_limits<Real>::max(), smallest = std::numeric_limits<Real>::denorm_min();
    for (const Real size : {largest, smallest, std::numeric_limits<Real>::min()}) {
      const Real q[8] = {size, -size, size, -size, 0, -Real(0), -size, 0};
      const Real expected[8] = {0.5, -0.5, 0.5, -0.5, 0, 0, -1, 0};
      Real unit[8];
      CHECK(normalize(q, 2, unit, nullptr) == QTRAJ_OK);
      for (size_t k = 0; k < 8; ++k) CHECK(unit[k] == expected[k]);
      CHECK(std::signbit(unit[5]));
      CHECK(!std::signbit(unit[4]));
    }
  });
}

TEST_CASE("C API: keys are normalized, made continuous and reordered in place as elsewhere", "[capi][keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    test::Random random(12);
    std::vector<Real> q(4 * 60), apart(q.size());
    for (size_t i = 0; i < q.size(); i += 4) set_hard_key(random, &q[i]);
    const auto check = [&](auto&& call) {
      std::vector<Real> in_place = q;
      REQUIRE(call(q.data(), apart.data()) == QTRAJ_OK);
      REQUIRE(call(in_place.data(), in_place.data()) == QTRAJ_OK);
      CHECK(same_bits(in_place, apart));
    };
    check([](const Real* from, Real* to) { return normalize(from, 60, to, nullptr); });
    check([](const Real* from, Real* to) { return make_continuous(from, 3, 20, to, nullptr, nullptr); });
    check([](const Real* from, Real* to) { return wxyz_from_xyzw(from, 60, to); });
    check([](const Real* from, Real* to) { return xyzw_from_wxyz(from, 60, to); });
  });
}

// Keys of whole numbers times a power of two: their dot products are known exactly.
struct WholeKeys {
  std::vector<std::array<int64_t, 4>> numbers;
  std::vector<int> exponents;

  int64_t dot(size_t i, size_t j) const {
    int64_t sum = 0;
    for (size_t k = 0; k < 4; ++k) sum += numbers[i][k] * numbers[j][k];
    return sum;
  }
  template <class Real>
  std::vector<Real> q() const {
    std::vector<Real> all;
    for (size_t i = 0; i < numbers.size(); ++i)
      for (size_t k = 0; k < 4; ++k) all.push_back(std::ldexp(static_cast<Real>(numbers[i][k]), exponents[i]));
    return all;
  }
};

// A key b with <a, b> equal to the greatest common divisor of a_0 and a_1, which rounded products cannot tell from 0;
// or `otherwise`, where such a key has numbers beyond the limit.
std::array<int64_t, 4> nearly_orthogonal(const std::array<int64_t, 4>& a, double limit,
                                         const std::array<int64_t, 4>& otherwise) {
  // Euclid: rest = a_0 u + a_1 v in every step
  int64_t rest = a[0], u = 1, v = 0, next_rest = a[1], next_u = 0, next_v = 1;
  while (next_rest != 0) {
    const int64_t quotient = rest / next_rest;
    rest -= quotient * next_rest;
    u -= quotient * next_u;
    v -= quotient * next_v;
    std::swap(rest, next_rest);
    std::swap(u, next_u);
    std::swap(v, next_v);
  }
  const std::array<int64_t, 4> b = {u - a[1], v + a[0], -a[3], a[2]};
  const bool fits =
      std::all_of(b.begin(), b.end(), [&](int64_t number) { return std::abs(static_cast<double>(number)) < limit; });
  return fits ? b : otherwise;
}

// Neighbours in any position, most of them orthogonal or next to it: products of 2 bits digits that cancel.
WholeKeys whole_keys(test::Random& random, size_t count, int bits, int least_exponent, int largest_exponent) {
  const double limit = std::ldexp(1.0, bits);
  const auto whole = [&](double low, double high) {
    return static_cast<int64_t>(std::floor(random.uniform(low, high)));
  };
  WholeKeys keys;
  while (keys.numbers.size() < count) {
    std::array<int64_t, 4> next;
    for (int64_t& number : next) number = whole(1 - limit, limit);
    if (!keys.numbers.empty() && random.uniform(0, 1) < 0.8) {
      const std::array<int64_t, 4>& last = keys.numbers.back();
      next = {-last[1], last[0], -last[3], last[2]};
      if (random.uniform(0, 1) < 0.5) next = {last[2], last[3], -last[0], -last[1]};
      for (int64_t& number : next)
        if (random.uniform(0, 1) < 0.3 && std::abs(number) < (int64_t{1} << bits) - 1) number += whole(-1, 2);
    }
    if (!keys.numbers.empty() && random.uniform(0, 1) < 0.2) next = nearly_orthogonal(keys.numbers.back(), limit, next);
    if (random.uniform(0, 1) < 0.3) next[static_cast<size_t>(whole(0, 4))] = whole(-2, 3);
    if (next == std::array<int64_t, 4>{0, 0, 0, 0}) continue;
    keys.numbers.push_back(next);
    keys.exponents.push_back(static_cast<int>(whole(least_exponent, largest_exponent)));
  }
  return keys;
}

TEST_CASE("C API: make_continuous goes by the exact sign of dot products at any norm", "[capi][keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const bool is_single = sizeof(Real) == sizeof(float);
    test::Random random(13);
    size_t wrong = 0, ties = 0, close = 0;
    for (int round = 0; round < 2000; ++round) {
      constexpr size_t kSeries = 4, kLength = 125, kCount = kSeries * kLength;
      const WholeKeys keys =
          is_single ? whole_keys(random, kCount, 24, -149, 100) : whole_keys(random, kCount, 30, -1074, 990);
      const std::vector<Real> q = keys.q<Real>();
      std::vector<Real> continuous(q.size());
      size_t flips = 12345, expected_flips = 0;
      REQUIRE(make_continuous(q.data(), kSeries, kLength, continuous.data(), &flips, nullptr) == QTRAJ_OK);
      bool flipped = false;
      for (size_t i = 0; i < kCount; ++i) {
        const int64_t dot = i % kLength == 0 ? 1 : (flipped ? -1 : 1) * keys.dot(i - 1, i);
        flipped = dot < 0;
        if (flipped) ++expected_flips;
        if (dot == 0) ++ties;
        if (dot != 0 && std::abs(dot) < 1000) ++close;
        for (size_t k = 4 * i; k < 4 * i + 4; ++k) {
          const Real expected = flipped ? -q[k] : q[k];
          if (std::memcmp(&continuous[k], &expected, sizeof expected) != 0) ++wrong;
        }
      }
      if (flips != expected_flips) ++wrong;
    }
    CHECK(wrong == 0);
    CHECK(ties > 50000);
    CHECK(close > 10000);
  });
}

// Products down to 2^-2148 beside larger ones that cancel, or are 0.
TEST_CASE("C API: make_continuous goes by the exact sign where products underflow", "[capi][keys]") {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min(), kMost = std::numeric_limits<double>::max();
  const struct {
    double a[4], b[4];
    bool negative;
  } cases[] = {
      {{0, 0, 3, 0}, {3e125, 8, -6e-266, -2}, true},
      {{0, 0, 3, 0}, {3e125, 8, 6e-266, -2}, false},
      {{1, 0, 1e-200, 0}, {0, 1, -1e-200, 0}, true},
      {{1, 0, kLeast, 0}, {0, 1, -kLeast, 0}, true},
      {{1, 0, kLeast, 0}, {0, 1, kLeast, 0}, false},
      {{kMost, kMost, kLeast, 0}, {kMost, -kMost, -kLeast, 1}, true},
      {{kMost, kMost, kLeast, kLeast}, {kMost, -kMost, -kLeast, kLeast}, false},
      {{kMost, kMost, kLeast, kLeast}, {kMost, -kMost, -kLeast, 3 * kLeast}, false},
      {{kMost, kMost, 3 * kLeast, kLeast}, {kMost, -kMost, -kLeast, kLeast}, true},
      {{kMost, 1, kLeast, 0}, {kLeast, -1, -kMost, 0}, true},
      {{kMost, 1e-160, kLeast, 0}, {kLeast, -1e-160, -kMost, 0}, true},
      {{kMost, 1e-160, kLeast, 0}, {kLeast, 1e-160, -kMost, 0}, false},
  };
  for (const auto& pair : cases)
    for (const double sign : {1.0, -1.0})
      for (const bool swapped : {false, true}) {
        double q[8];
        for (int k = 0; k < 4; ++k) {
          q[k] = swapped ? pair.b[k] : pair.a[k];
          q[4 + k] = sign * (swapped ? pair.a[k] : pair.b[k]);
        }
        size_t flips = 7;
        CAPTURE(&pair - cases, sign, swapped);
        REQUIRE(make_continuous(q, 1, 2, q, &flips, nullptr) == QTRAJ_OK);
        const bool tie = &pair - cases == 6;  // a dot product of 0
        CHECK(flips == (!tie && pair.negative == (sign > 0) ? 1 : 0));
      }
}

TEST_CASE("C API: the first key of each series keeps its sign and what is continuous stays", "[capi][keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const std::vector<Real> q = {1, 0, 0, 0, -1, 0, 0, 0, 0, 2, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0, Real(-1e-3), -3, 0, 0};
    std::vector<Real> out(q.size());
    size_t flips = 0;
    REQUIRE(make_continuous(q.data(), 2, 3, out.data(), &flips, nullptr) == QTRAJ_OK);
    // a tie at the third key; the second series begins with -1
    CHECK(out ==
          std::vector<Real>{1, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, Real(-1e-3), -3, 0, 0});
    CHECK(flips == 2);
    std::vector<Real> again(q.size());
    REQUIRE(make_continuous(out.data(), 2, 3, again.data(), &flips, nullptr) == QTRAJ_OK);
    CHECK(same_bits(again, out));
    CHECK(flips == 0);
    REQUIRE(make_continuous(q.data(), 6, 1, out.data(), &flips, nullptr) == QTRAJ_OK);
    CHECK(same_bits(out, q));
    CHECK(flips == 0);
  });
}

TEST_CASE("C API: component orders move numbers bit by bit, signalling NaN included", "[capi][keys]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const Real infinity = std::numeric_limits<Real>::infinity();
    std::vector<Real> wxyz = {1, 2, 3, 4, -infinity, infinity, -Real(0), std::numeric_limits<Real>::denorm_min()};
    wxyz.resize(12);
    for (size_t k = 8; k < 12; ++k) {
      set_signalling_nan(wxyz[k]);
      unsigned char* bytes = reinterpret_cast<unsigned char*>(&wxyz[k]);
      bytes[0] = static_cast<unsigned char>(k);  // payloads of their own
    }
    std::vector<Real> xyzw(12), back(12);
    REQUIRE(xyzw_from_wxyz(wxyz.data(), 3, xyzw.data()) == QTRAJ_OK);
    REQUIRE(wxyz_from_xyzw(xyzw.data(), 3, back.data()) == QTRAJ_OK);
    for (size_t row = 0; row < 12; row += 4)
      for (size_t k = 0; k < 4; ++k) CHECK(std::memcmp(&xyzw[row + k], &wxyz[row + (k + 1) % 4], sizeof(Real)) == 0);
    CHECK(same_bits(back, wxyz));
  });
}

}  // namespace
