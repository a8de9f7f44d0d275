// slerp and nlerp: what users rely on, and the singular pairs.
#include <cfloat>

#include "support/capi_handles.hpp"
#include "support/pair_functions.hpp"
#include "support/trajectory.hpp"
#include "support/wide_pair.hpp"

using pairs::kPaths;
using test::largest_difference;
using test::Quaternion;
using test::Random;

namespace {

constexpr double kPi = 3.14159265358979323846;

Quaternion interpolate(const pairs::Functions<double>& functions, const Quaternion& a, const Quaternion& b,
                       double fraction, int32_t path, qtraj_status expected = QTRAJ_OK) {
  Quaternion q;
  size_t bad_index = 7;
  const qtraj_status status = functions.one(a.data(), b.data(), &fraction, 1, path, q.data(), &bad_index);
  if (status != expected || bad_index != (expected == QTRAJ_OK ? SIZE_MAX : 0)) FAIL("status " << status);
  return q;
}
Quaternion slerp(const Quaternion& a, const Quaternion& b, double fraction, int32_t path,
                 qtraj_status expected = QTRAJ_OK) {
  return interpolate(pairs::functions(0.0)[0], a, b, fraction, path, expected);
}
Quaternion nlerp(const Quaternion& a, const Quaternion& b, double fraction, int32_t path,
                 qtraj_status expected = QTRAJ_OK) {
  return interpolate(pairs::functions(0.0)[1], a, b, fraction, path, expected);
}

Quaternion negated(const Quaternion& q) { return {-q[0], -q[1], -q[2], -q[3]}; }

double distance(const Quaternion& a, const Quaternion& b) {
  return static_cast<double>(wide::angle(wide::quaternion(a.data()), wide::quaternion(b.data())));
}

TEST_CASE("C API: slerp and nlerp begin at a / |a| and end at b / |b| or, where that is nearer, at -b / |b|",
          "[capi][pairs]") {
  Random random(11);
  for (int i = 0; i < 5000; ++i) {
    const Quaternion a = random.orientation(), b = random.orientation();
    const Quaternion a_given = test::scaled(test::hard_norm(random, 160), a);
    const Quaternion b_given = test::scaled(test::hard_norm(random, 160), b);
    const Quaternion nearer = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0 ? negated(b) : b;
    double worst = 0;
    for (const auto& functions : pairs::functions(0.0))
      for (const int32_t path : kPaths) {
        const Quaternion start = interpolate(functions, a_given, b_given, 0, path);
        const Quaternion end = interpolate(functions, a_given, b_given, 1, path);
        worst = std::max(
            {worst, largest_difference(start, a), largest_difference(end, path == QTRAJ_PATH_SHORTEST ? nearer : b)});
      }
    // each side is rounded: a itself is only unit to rounding
    if (worst > 5e-16) FAIL("off by " << worst);
  }
}

TEST_CASE("C API: at fractions 0 and 1 slerp and nlerp give the ends as qtraj_normalize does", "[capi][pairs]") {
  Random random(20);
  for (int i = 0; i < 5000; ++i) {
    const pairs::Ends ends = pairs::hard_ends(random, 160);
    for (const auto& functions : pairs::functions(0.0)) {
      const auto at = [&](const Quaternion& a, const Quaternion& b, double fraction) {
        Quaternion q;
        functions.one(a.data(), b.data(), &fraction, 1, QTRAJ_PATH_AS_GIVEN, q.data(), nullptr);
        return q;
      };
      const auto normalized = [](const Quaternion& q) {
        Quaternion unit;
        qtraj_normalize(q.data(), 1, unit.data(), nullptr);
        return unit;
      };
      REQUIRE(at(ends.a, ends.b, 0) == normalized(ends.a));
      REQUIRE(at(ends.a, ends.b, 1) == normalized(ends.b));
    }
  }
}

TEST_CASE("C API: between q and itself slerp and nlerp stay at q", "[capi][pairs]") {
  Random random(12);
  for (int i = 0; i < 2000; ++i) {
    const Quaternion q = random.orientation(), given = test::scaled(test::hard_norm(random, 160), q);
    for (const double fraction : {0.0, 0.3, 0.5, 1.0, -2.0, 1e6, -1e300, DBL_MAX}) {
      CAPTURE(i, fraction);
      REQUIRE(largest_difference(slerp(given, given, fraction, QTRAJ_PATH_AS_GIVEN), q) <= 3e-16);
      REQUIRE(largest_difference(slerp(given, negated(given), fraction, QTRAJ_PATH_SHORTEST), q) <= 3e-16);
      REQUIRE(largest_difference(nlerp(given, given, fraction, QTRAJ_PATH_AS_GIVEN), q) <= 3e-16);
    }
  }
}

TEST_CASE("C API: the rate of slerp is constant on arcs of every length", "[capi][pairs]") {
  Random random(13);
  constexpr int kSteps = 16;
  for (int i = 0; i < 3000; ++i) {
    const double angle = i % 3 == 0 ? random.uniform(0, kPi) : std::pow(10.0, random.uniform(-12, 0));
    const Quaternion a = random.orientation(), b = test::multiply(a, test::about(random.direction(), 2 * angle));
    const wide::Pair pair = wide::pair(a.data(), b.data(), false);
    const double expected = static_cast<double>(pair.angle) / kSteps;
    double worst = 0;
    for (int step = 0; step < kSteps; ++step) {
      const Quaternion from = slerp(a, b, step / double(kSteps), QTRAJ_PATH_AS_GIVEN);
      const Quaternion to = slerp(a, b, (step + 1) / double(kSteps), QTRAJ_PATH_AS_GIVEN);
      worst = std::max(worst, std::abs(distance(from, to) / expected - 1));
    }
    if (worst > 1e-14 + 4 * DBL_EPSILON / expected) FAIL("angle " << angle << ": rate off by " << worst);
  }
}

TEST_CASE("C API: slerp follows an arc of 1e-8 rad for 1e14 of its lengths", "[capi][pairs]") {
  Random random(14);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion a = random.orientation(), b = test::multiply(a, test::about(random.direction(), 2e-8));
    const wide::Pair pair = wide::pair(a.data(), b.data(), true);
    const Quaternion q = slerp(a, b, 1e14, QTRAJ_PATH_SHORTEST);
    REQUIRE(wide::error(q.data(), wide::slerp(pair, 1e14L)) <= 7e-10);
  }
}

TEST_CASE("C API: slerp and nlerp are finite and unit at any fraction", "[capi][pairs]") {
  Random random(15);
  for (int i = 0; i < 2000; ++i) {
    const pairs::Ends ends = pairs::hard_ends(random, 160);
    const double size = std::pow(10.0, random.uniform(0, 308));
    for (const double fraction : {size, -size, DBL_MAX, -DBL_MAX, 5e-324}) {
      double q[4];
      for (const auto& functions : pairs::functions(0.0)) {
        functions.one(ends.a.data(), ends.b.data(), &fraction, 1, kPaths[i % 2], q, nullptr);
        if (!(std::abs(pairs::norm_of(q) - 1) <= 4 * DBL_EPSILON)) FAIL("norm " << pairs::norm_of(q));
      }
    }
  }
}

TEST_CASE("C API: far outside nlerp goes on to the direction of the chord", "[capi][pairs]") {
  const Quaternion a = {1, 0, 0, 0}, b = {0, 1, 0, 0}, chord = {-std::sqrt(0.5), std::sqrt(0.5), 0, 0};
  for (const double fraction : {1e17, 1e200, 1e308, DBL_MAX}) {
    CHECK(largest_difference(nlerp(a, b, fraction, QTRAJ_PATH_AS_GIVEN), chord) <= 3e-16);
    CHECK(largest_difference(nlerp(a, b, -fraction, QTRAJ_PATH_AS_GIVEN), negated(chord)) <= 3e-16);
  }
  // a chord of 1e-120, 1e120 of its lengths on: as far to the side as ahead
  const double middle = std::sqrt(0.5);
  CHECK(largest_difference(nlerp(a, {1, 0, 1e-120, 0}, 1e120, QTRAJ_PATH_SHORTEST), {middle, 0, middle, 0}) <= 4e-16);
}

TEST_CASE("C API: slerp from a to -a as given is ambiguous and turns the body about its x axis", "[capi][pairs]") {
  Random random(16);
  for (int i = 0; i < 2000; ++i) {
    const Quaternion a = random.orientation();
    const double off = i % 2 == 0 ? 0.0 : 4e-15;
    const Quaternion b = test::scaled(-2, test::multiply(a, test::about(random.direction(), 2 * off)));
    for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0, -3.0, 1e3}) {
      CAPTURE(i, fraction);
      const Quaternion q = slerp(a, b, fraction, QTRAJ_PATH_AS_GIVEN, QTRAJ_E_AMBIGUOUS);
      const Quaternion expected = test::multiply(a, test::about({1, 0, 0}, 2 * kPi * fraction));
      REQUIRE(largest_difference(q, expected) <= off + 1e-15 * (1 + std::abs(fraction)));
      REQUIRE(largest_difference(slerp(a, b, fraction, QTRAJ_PATH_SHORTEST), a) <=
              3e-16 + off * (1 + std::abs(fraction)));
    }
  }
}

TEST_CASE("C API: a pair half a turn apart keeps its given signs on the shortest path", "[capi][pairs]") {
  Random random(17);
  for (int i = 0; i < 2000; ++i) {
    // orthogonal whole numbers: the tie is exact whatever rounding makes of the unit quaternions
    const auto whole = [&] { return std::floor(random.uniform(-50, 50)) + 0.5; };
    const Quaternion a = {whole(), whole(), whole(), whole()};
    const Quaternion turned[] = {{-a[1], a[0], a[3], -a[2]}, {a[2], a[3], -a[0], -a[1]}, {-a[3], a[2], -a[1], a[0]}};
    for (const Quaternion& b : turned)
      for (const double sign : {1.0, -1.0}) {
        const Quaternion given = test::scaled(sign, b);
        for (const double fraction : {0.5, 1.0, -0.3})
          REQUIRE(slerp(a, given, fraction, QTRAJ_PATH_SHORTEST) == slerp(a, given, fraction, QTRAJ_PATH_AS_GIVEN));
      }
  }
}

TEST_CASE("C API: nlerp has no direction where the chord passes within 1e-14 of 0", "[capi][pairs]") {
  Random random(18);
  const Quaternion a = random.orientation(), opposite = test::scaled(-2, a);
  for (const double off : {0.0, 1e-15, 4e-15}) {
    nlerp(a, opposite, 0.5 - off, QTRAJ_PATH_AS_GIVEN, QTRAJ_E_ZERO_NORM);
    nlerp(a, opposite, 0.5 + off, QTRAJ_PATH_AS_GIVEN, QTRAJ_E_ZERO_NORM);
  }
  for (const double off : {6e-15, 1e-12, 0.5}) {
    CHECK(largest_difference(nlerp(a, opposite, 0.5 - off, QTRAJ_PATH_AS_GIVEN), a) <= 3e-16);
    CHECK(largest_difference(nlerp(a, opposite, 0.5 + off, QTRAJ_PATH_AS_GIVEN), negated(a)) <= 3e-16);
  }
  // beside a, from -1 + 2i e-13: halfway is i
  CHECK(largest_difference(nlerp({1, 0, 0, 0}, {-1, 2e-13, 0, 0}, 0.5, QTRAJ_PATH_AS_GIVEN), {0, 1, 0, 0}) <= 1e-12);
}

TEST_CASE("C API: slerp and nlerp on the shortest path are the trajectories through the two keys", "[capi][pairs]") {
  Random random(19);
  for (int i = 0; i < 500; ++i) {
    test::Keys keys;
    keys.add(0, random.orientation());
    keys.add(1, random.orientation());
    const test::Trajectory slerped({QTRAJ_SLERP}, keys), nlerped({QTRAJ_NLERP}, keys);
    for (const double fraction : {0.0, 0.1, 0.5, 0.8, 1.0}) {
      const Quaternion a = keys.orientation(0), b = keys.orientation(1);
      REQUIRE(largest_difference(slerp(a, b, fraction, QTRAJ_PATH_SHORTEST), slerped.at(fraction)) <= 8e-16);
      REQUIRE(largest_difference(nlerp(a, b, fraction, QTRAJ_PATH_SHORTEST), nlerped.at(fraction)) <= 8e-16);
    }
  }
}

}  // namespace
