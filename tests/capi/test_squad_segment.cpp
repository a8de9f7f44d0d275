// squad_segment: its bound, its ends, singular arcs, faulty arguments and rows.
#include <cfloat>
#include <cstring>
#include <string>

#include "support/capi_floating.hpp"
#include "support/catch.hpp"
#include "support/pair_functions.hpp"
#include "support/wide_pair.hpp"

using test::Quaternion;
using test::Random;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

struct Segment {
  Quaternion q0, q1, a, b;
};
struct Sampled {
  qtraj_status status;
  size_t bad_index;
  std::vector<double> q;
};
Sampled sample(const Segment& segment, const std::vector<double>& fractions) {
  Sampled sampled{QTRAJ_OK, 77, std::vector<double>(4 * fractions.size(), 7.0)};
  sampled.status = qtraj_squad_segment(segment.q0.data(), segment.q1.data(), segment.a.data(), segment.b.data(),
                                       fractions.data(), fractions.size(), sampled.q.data(), &sampled.bad_index);
  return sampled;
}

// Keys at a hard angle, controls within an eighth of a turn of them, all of any norm.
Segment hard_segment(Random& random) {
  const Quaternion q0 = test::hard_orientation(random), q1 = test::hard_neighbour(random, q0);
  const auto near = [&](const Quaternion& q) { return test::multiply(q, test::turn_within(random, 0.8)); };
  const auto norm = [&] { return test::hard_norm(random, 160); };
  return {test::scaled(norm(), q0), test::scaled(norm(), q1), test::scaled(norm(), near(q0)),
          test::scaled(norm(), near(q1))};
}

TEST_CASE("C API: squad_segment stays within its bound on random and singular segments", "[capi][squad_segment]") {
  Random random(51);
  double worst = 0, worst_norm = 0;
  size_t sampled_rows = 0;
  for (int i = 0; i < 170000; ++i) {  // of six fractions each
    const Segment segment = hard_segment(random);
    const std::vector<double> fractions = {0,
                                           1,
                                           random.uniform(0, 1),
                                           0.5 + std::pow(10.0, random.uniform(-17, -1)),
                                           random.uniform(-3, 4),
                                           std::pow(10.0, random.uniform(0, 3)) * (i % 2 == 0 ? 1 : -1)};
    const Sampled sampled = sample(segment, fractions);
    const wide::Pair keys = wide::pair(segment.q0.data(), segment.q1.data(), false);
    const wide::Pair controls = wide::pair(segment.a.data(), segment.b.data(), false);
    if (std::min(keys.supplement, controls.supplement) < 1.1e-14L) continue;
    for (size_t k = 0; k < fractions.size(); ++k) {
      worst_norm = std::max(worst_norm, std::abs(pairs::norm_of(&sampled.q[4 * k]) - 1));
      const wide::Real u = fractions[k], f = 2 * u * (1 - u);
      const wide::Quaternion p = wide::slerp(keys, u), c = wide::slerp(controls, u);
      const wide::Pair between = wide::pair(p.data(), c.data(), false);
      if (between.supplement < 1.1e-14L) continue;
      ++sampled_rows;
      const wide::Real phi =
          std::max({std::abs(u) * keys.angle, std::abs(u) * controls.angle, std::abs(f) * between.angle});
      const wide::Real bound = 1e-15L * (1 + phi) * (1 + std::abs(f) / std::sin(between.supplement / 2));
      worst = std::max(worst, wide::error(&sampled.q[4 * k], wide::slerp(between, f)) / static_cast<double>(bound));
    }
  }
  CAPTURE(worst, worst_norm);
  CHECK(worst <= 1);
  CHECK(worst_norm <= 4 * DBL_EPSILON);
  CHECK(sampled_rows > 700000);
}

TEST_CASE("C API: squad_segment begins and ends at its keys", "[capi][squad_segment]") {
  Random random(52);
  for (int i = 0; i < 2000; ++i) {
    const Segment segment = {random.orientation(), random.orientation(), random.orientation(), random.orientation()};
    const Sampled sampled = sample(segment, {0.0, 1.0});
    REQUIRE(sampled.status == QTRAJ_OK);
    REQUIRE(sampled.bad_index == SIZE_MAX);
    for (size_t k = 0; k < 4; ++k) {
      REQUIRE(std::abs(sampled.q[k] - segment.q0[k]) <= 1e-15);
      REQUIRE(std::abs(sampled.q[4 + k] - segment.q1[k]) <= 1e-15);
    }
  }
}

TEST_CASE("C API: a segment whose controls are its keys is the slerp between them", "[capi][squad_segment]") {
  Random random(53);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion q0 = random.orientation(), q1 = random.orientation();
    const std::vector<double> fractions = {0, 0.3, 0.5, 0.9, 1, -2, 3};
    const Sampled sampled = sample({q0, q1, q0, q1}, fractions);
    std::vector<double> slerped(4 * fractions.size());
    qtraj_slerp(q0.data(), q1.data(), fractions.data(), fractions.size(), QTRAJ_PATH_AS_GIVEN, slerped.data(), nullptr);
    for (size_t k = 0; k < slerped.size(); ++k) REQUIRE(std::abs(sampled.q[k] - slerped[k]) <= 4e-16);
  }
}

TEST_CASE("C API: a segment with an arc between opposite ends is ambiguous and turns about the body x axis",
          "[capi][squad_segment]") {
  const Quaternion one = {1, 0, 0, 0}, minus_one = {-1, 0, 0, 0}, k = {0, 0, 0, 1};
  // each arc in turn; the third is i to -i at u = 1/2, half of whose way, f = 1/2, is i exp((pi/2) i) = -1
  const Quaternion up = {0.6, 0.8, 0, 0}, down = {-0.6, 0.8, 0, 0};
  const Quaternion low = {0.6, -0.8, 0, 0}, back = {-0.6, -0.8, 0, 0};
  const struct {
    Segment segment;
    Quaternion middle;
  } cases[] = {{{one, minus_one, one, minus_one}, {0, 1, 0, 0}}, {{up, down, low, back}, {-1, 0, 0, 0}}};
  for (const auto& at : cases) {
    const Sampled sampled = sample(at.segment, {0.5});
    CHECK(sampled.status == QTRAJ_E_AMBIGUOUS);
    CHECK(sampled.bad_index == 0);
    for (size_t i = 0; i < 4; ++i) CHECK(std::abs(sampled.q[i] - at.middle[i]) <= 1e-15);
  }
  CHECK(sample({k, k, one, minus_one}, {0.25}).status == QTRAJ_E_AMBIGUOUS);
  CHECK(sample({one, minus_one, k, k}, {0.25}).status == QTRAJ_E_AMBIGUOUS);
  // only the row where the third arc is
  const Sampled rows = sample({up, down, low, back}, {0.25, 0.5, 0.75});
  CHECK(rows.status == QTRAJ_E_AMBIGUOUS);
  CHECK(rows.bad_index == 1);
}

TEST_CASE("C API: squad_segment judges arguments in order and then leaves outputs alone",
          "[capi][squad_segment][errors]") {
  const double ends[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0.1, 0, 0}, {0.1, 1, 0, 0}};
  const double fractions[3] = {0.2, 0.4, 0.6};
  const std::vector<double> untouched(24, 7.0);
  std::vector<double> q = untouched;
  const auto check = [&](qtraj_status expected, const double* const(&end)[4], const double* u, size_t count,
                         double* out) {
    size_t bad_index = 7;
    CHECK(qtraj_squad_segment(end[0], end[1], end[2], end[3], u, count, out, &bad_index) == expected);
    CHECK(bad_index == SIZE_MAX);
    CHECK(qtraj_squad_segment(end[0], end[1], end[2], end[3], u, count, out, nullptr) == expected);
    CHECK(q == untouched);
  };
  const double* all[4] = {ends[0], ends[1], ends[2], ends[3]};
  const double* none[4] = {};
  check(QTRAJ_OK, none, nullptr, 0, nullptr);
  for (const double*& end : all) {
    const double* const kept = end;
    end = nullptr;
    check(QTRAJ_E_NULL, all, fractions, 3, q.data());
    check(QTRAJ_E_NULL, all, fractions, SIZE_MAX, q.data());
    end = q.data() + 9;
    check(QTRAJ_E_OVERLAP, all, fractions, 3, q.data());
    end = kept;
  }
  check(QTRAJ_E_NULL, all, nullptr, 3, q.data());
  check(QTRAJ_E_NULL, all, fractions, 3, nullptr);
  check(QTRAJ_E_OVERLAP, all, q.data() + 11, 3, q.data());
  for (const size_t count : {SIZE_MAX, SIZE_MAX / 4 + 2, size_t{PTRDIFF_MAX} / 32 + 1})
    check(QTRAJ_E_SIZE, all, q.data(), count, q.data());
  // one row may be written over an end
  std::copy_n(ends[2], 4, q.begin());
  CHECK(qtraj_squad_segment(all[0], all[1], q.data(), all[3], fractions, 1, q.data(), nullptr) == QTRAJ_OK);
  CHECK(std::abs(pairs::norm_of(q.data()) - 1) <= 4 * DBL_EPSILON);
}

TEST_CASE("C API: faults of squad_segment: of an end in every row, of a fraction in its own",
          "[capi][squad_segment][errors]") {
  const Segment good = {{1, 0, 0, 0}, {0.5, 1, 0, 0}, {1, 0.1, 0, 0}, {0.1, 1, 0, 0.3}};
  const std::vector<double> fractions = {0.25, 0.5, 0.75};
  const Sampled expected = sample(good, fractions);
  double signalling;
  capi::set_signalling_nan(signalling);
  const auto check = [&](const Segment& segment, const std::vector<double>& u, qtraj_status status, size_t bad_index,
                         std::vector<size_t> nan_rows) {
    Sampled found{};
    CHECK(capi::disturbance([&] { found = sample(segment, u); }) == std::string("nothing"));
    CHECK(found.status == status);
    CHECK(found.bad_index == bad_index);
    for (size_t k = 0; k < 12; ++k) {
      const bool is_nan = std::find(nan_rows.begin(), nan_rows.end(), k / 4) != nan_rows.end();
      CHECK((is_nan ? std::isnan(found.q[k]) : found.q[k] == expected.q[k]));
    }
  };
  for (Quaternion Segment::*end : {&Segment::q0, &Segment::q1, &Segment::a, &Segment::b}) {
    Segment segment = good;
    for (const double* value : {&kNaN, &kInfinity, static_cast<const double*>(&signalling)}) {
      std::memcpy(&(segment.*end)[2], value, sizeof(double));
      check(segment, fractions, QTRAJ_E_NOT_FINITE, 0, {0, 1, 2});
    }
    segment.*end = {0, -0.0, 0, 0};
    check(segment, fractions, QTRAJ_E_ZERO_NORM, 0, {0, 1, 2});
    check(segment, {kNaN, 0.5, 0.75}, QTRAJ_E_NOT_FINITE, 0, {0, 1, 2});
    segment.*(end == &Segment::q0 ? &Segment::b : &Segment::q0) = {kNaN, 0, 0, 0};
    check(segment, fractions, QTRAJ_E_NOT_FINITE, 0, {0, 1, 2});
  }
  for (const double value : {kNaN, kInfinity, -kInfinity}) check(good, {0.25, value, 0.75}, QTRAJ_E_NOT_FINITE, 1, {1});
}

TEST_CASE("C API: squad_segment takes any ends at any fraction without raising anything",
          "[capi][squad_segment][floating]") {
  Random random(54);
  const std::vector<double> fractions = {5e-324, 1e3, -1e8, 1e100, -1e160, 1e300, DBL_MAX, -DBL_MAX};
  for (int i = 0; i < 5000; ++i) {
    const Segment segment = hard_segment(random);
    Sampled sampled{};
    const std::string found = capi::disturbance([&] { sampled = sample(segment, fractions); });
    if (found != "nothing") FAIL(found);
    for (size_t row = 0; row < fractions.size(); ++row)
      if (!(std::abs(pairs::norm_of(&sampled.q[4 * row]) - 1) <= 4 * DBL_EPSILON))
        FAIL("norm " << pairs::norm_of(&sampled.q[4 * row]));
  }
}

}  // namespace
