// qtraj_screw_pairs: properties of screw motions, extreme positions, and rows and arguments at fault.
#include <cfloat>
#include <limits>

#include "support/capi_floating.hpp"
#include "support/capi_variants.hpp"

using namespace capi;

namespace {

qtraj_status screw_pairs(const double* q_a, const double* p_a, size_t a_count, const double* q_b, const double* p_b,
                         size_t b_count, const double* fraction, size_t fraction_count, size_t count, double* q,
                         double* p, size_t* bad_index) {
  return qtraj_screw_pairs(q_a, p_a, a_count, q_b, p_b, b_count, fraction, fraction_count, count, q, p, bad_index);
}
qtraj_status screw_pairs(const float* q_a, const float* p_a, size_t a_count, const float* q_b, const float* p_b,
                         size_t b_count, const float* fraction, size_t fraction_count, size_t count, float* q, float* p,
                         size_t* bad_index) {
  return qtraj_screw_pairs_f32(q_a, p_a, a_count, q_b, p_b, b_count, fraction, fraction_count, count, q, p, bad_index);
}

struct Pose {
  double q[4], p[3];
};
struct Answer {
  qtraj_status status;
  Pose pose;
};
Answer screw(const Pose& a, const Pose& b, double fraction) {
  Answer answer;
  answer.status = qtraj_screw_pairs(a.q, a.p, 1, b.q, b.p, 1, &fraction, 1, 1, answer.pose.q, answer.pose.p, nullptr);
  return answer;
}

double distance(const double (&a)[3], const double (&b)[3]) {
  double sum = 0;
  for (size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

Pose random_pose(test::Random& random, double size) {
  Pose pose;
  const test::Quaternion q = random.orientation();
  std::copy(q.begin(), q.end(), pose.q);
  for (double& component : pose.p) component = random.uniform(-size, size);
  return pose;
}

TEST_CASE("C API: a screw of a quarter turn about a line that is not through the origin", "[capi][screw]") {
  // about the vertical through (1, 0), rising by 2: from the origin to (1, -1, 2)
  const double h = std::sqrt(0.5);
  const Pose a = {{1, 0, 0, 0}, {0, 0, 0}}, b = {{h, 0, 0, h}, {1, -1, 2}};
  for (const double u : {0.25, 0.5, 0.75, 1.5, -1.0, 3.0}) {
    CAPTURE(u);
    const double angle = u * 1.5707963267948966;
    const Answer answer = screw(a, b, u);
    CHECK(answer.status == QTRAJ_OK);
    CHECK(distance(answer.pose.p, {1 - std::cos(angle), -std::sin(angle), 2 * u}) <= 1e-15 * (1 + std::abs(u)));
    CHECK(std::abs(answer.pose.q[3] - std::sin(angle / 2)) <= 1e-15);
  }
}

TEST_CASE("C API: screw motions end at their poses, go back as they came, and go on from where they are",
          "[capi][screw]") {
  test::Random random(15);
  for (int round = 0; round < 200; ++round) {
    const Pose a = random_pose(random, 10), b = random_pose(random, 10);
    const double u = random.uniform(0, 1);
    const Pose start = screw(a, b, 0).pose, end = screw(a, b, 1).pose, middle = screw(a, b, u).pose;
    CHECK(std::memcmp(start.p, a.p, sizeof a.p) == 0);
    CHECK(std::memcmp(end.p, b.p, sizeof b.p) == 0);
    CHECK(distance(middle.p, screw(b, a, 1 - u).pose.p) <= 2e-14);
    // a quarter of the way to the middle is a quarter of u
    CHECK(distance(screw(a, middle, 0.25).pose.p, screw(a, b, 0.25 * u).pose.p) <= 2e-14);
    // norms and signs of orientations do not count
    Pose negative = b;
    for (double& component : negative.q) component *= -250;
    CHECK(distance(middle.p, screw(a, negative, u).pose.p) <= 2e-14);
  }
}

TEST_CASE("C API: a screw without a turn is the straight line", "[capi][screw]") {
  const Pose a = {{0.5, 0.5, -0.5, 0.5}, {1, 2, 3}}, b = {{-2, -2, 2, -2}, {5, 2, 1}};
  for (const double u : {0.25, 0.5, 0.75, 2.0, -6.0, 1e9}) {
    const Answer answer = screw(a, b, u);
    CHECK(answer.status == QTRAJ_OK);
    CHECK(distance(answer.pose.p, {1 + 4 * u, 2, 3 - 2 * u}) == 0);
  }
}

TEST_CASE("C API: half a turn is AMBIGUOUS and the row one of the two ways", "[capi][screw]") {
  const Pose a = {{1, 0, 0, 0}, {0, 0, 0}};
  for (const double sign : {1.0, -1.0})
    for (const double cosine : {0.0, 1e-17, -1e-17}) {
      const Pose b = {{cosine, 0, 0, sign}, {2, 0, 6}};
      const Answer answer = screw(a, b, 0.5);
      CHECK(answer.status == QTRAJ_E_AMBIGUOUS);
      CHECK(distance(answer.pose.p, {1, -sign, 3}) <= 1e-15);
      CHECK(screw(a, b, 1).status == QTRAJ_E_AMBIGUOUS);
    }
  // beside it, it is not
  for (const double cosine : {2e-15, -2e-15}) {
    const Pose b = {{cosine, 0, 0, 1}, {2, 0, 6}};
    const Answer answer = screw(a, b, 0.5);
    CHECK(answer.status == QTRAJ_OK);
    CHECK(distance(answer.pose.p, {1, cosine > 0 ? -1.0 : 1.0, 3}) <= 1e-14);
  }
}

// The same motion in other units of length.
TEST_CASE("C API: positions of any magnitude follow the screw, those that overflow are NOT_FINITE", "[capi][screw]") {
  test::Random random(3);
  for (int round = 0; round < 50; ++round) {
    const Pose a = random_pose(random, 1), b = random_pose(random, 1);
    const double u = random.uniform(-2, 3);
    const Pose plain = screw(a, b, u).pose;
    for (const double unit : {0x1p-1010, 0x1p-900, 0x1p-500, 0x1p-399, 0x1p399, 0x1p700, 0x1p1000}) {
      CAPTURE(unit, u);
      Pose scaled_a = a, scaled_b = b, expected = plain;
      for (size_t k = 0; k < 3; ++k) scaled_a.p[k] *= unit, scaled_b.p[k] *= unit, expected.p[k] *= unit;
      const Answer answer = screw(scaled_a, scaled_b, u);
      CHECK(answer.status == QTRAJ_OK);
      size_t wrong = 0;
      for (size_t k = 0; k < 3; ++k)
        wrong += !(std::abs(answer.pose.p[k] - expected.p[k]) <= 4 * DBL_EPSILON * unit + 1e-323);
      CHECK(wrong == 0);
    }
  }
  const double h = std::sqrt(0.5);
  const Pose far = {{1, 0, 0, 0}, {-DBL_MAX, 0, 1}}, beyond = {{1, 0, 0, 0}, {DBL_MAX, 0, 1}},
             turned = {{h, 0, 0, h}, {DBL_MAX, 0, 1}};
  CHECK(screw(far, beyond, 0.5).status == QTRAJ_OK);
  CHECK(screw(far, beyond, 0.5).pose.p[0] == 0);
  CHECK(screw(far, beyond, 0.75).pose.p[0] == DBL_MAX / 2);
  CHECK(screw(far, turned, 0.5).status == QTRAJ_OK);
  CHECK(screw(far, turned, 1).status == QTRAJ_OK);
  for (const double u : {1.5, -3.0, 1e300, -DBL_MAX, DBL_MAX}) {
    CAPTURE(u);
    Answer answer;
    CHECK(std::string(disturbance([&] { answer = screw(far, beyond, u); })) == "nothing");
    CHECK(answer.status == QTRAJ_E_NOT_FINITE);
    CHECK((std::isnan(answer.pose.p[2]) && std::isnan(answer.pose.q[0])));
  }
}

TEST_CASE("C API: the smallest turns carry positions along the line, however many of them", "[capi][screw]") {
  const Pose a = {{1, 0, 0, 0}, {1, 2, 3}};
  for (const double half : {5e-324, 1e-300, 1e-160, 1e-140, 1e-20, 1e-12}) {
    CAPTURE(half);
    const Pose b = {{1, 0, half, 0}, {2, 4, 1}};
    const double expected[3] = {1.25, 2.5, 2.5}, backwards[3] = {-9, -18, 23};
    CHECK(distance(screw(a, b, 0.25).pose.p, expected) <= 2e-12);
    CHECK(distance(screw(a, b, -10).pose.p, backwards) <= 1e-9);
  }
}

// Four good rows, and the arrays of a call.
template <class Real>
struct Arguments {
  std::vector<Real> q_a, p_a, q_b, p_b, fraction = {Real(0.25), Real(0.5), Real(-1), Real(2)};
  std::vector<Real> q = std::vector<Real>(16, Real(7)), p = std::vector<Real>(12, Real(7));
  size_t a_count = 4, b_count = 4, fraction_count = 4, count = 4, bad_index = 12345;

  Arguments() {
    test::Random random(8);
    for (size_t row = 0; row < 4; ++row) {
      const Pose a = random_pose(random, 5), b = random_pose(random, 5);
      for (const double x : a.q) q_a.push_back(Real(x));
      for (const double x : a.p) p_a.push_back(Real(x));
      for (const double x : b.q) q_b.push_back(Real(x));
      for (const double x : b.p) p_b.push_back(Real(x));
    }
  }
  qtraj_status call() {
    return screw_pairs(q_a.data(), p_a.data(), a_count, q_b.data(), p_b.data(), b_count, fraction.data(),
                       fraction_count, count, q.data(), p.data(), &bad_index);
  }
  bool untouched() const { return q == std::vector<Real>(16, Real(7)) && p == std::vector<Real>(12, Real(7)); }
};

TEST_CASE("C API: screw_pairs refuses arguments at fault in the order NULL, COUNT, SIZE, OVERLAP",
          "[capi][screw][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    const auto check = [](qtraj_status expected, auto&& change) {
      Arguments<Real> a;
      size_t bad_index = 12345;
      CHECK(change(a, &bad_index) == expected);
      CHECK(bad_index == SIZE_MAX);
      CHECK(a.untouched());
    };
    for (int missing = 0; missing < 7; ++missing)
      check(QTRAJ_E_NULL, [&](Arguments<Real>& a, size_t* bad) {
        const auto pointer = [&](int k, std::vector<Real>& array) { return k == missing ? nullptr : array.data(); };
        return screw_pairs(pointer(0, a.q_a), pointer(1, a.p_a), 3, pointer(2, a.q_b), pointer(3, a.p_b), 4,
                           pointer(4, a.fraction), 4, 4, pointer(5, a.q), pointer(6, a.p), bad);
      });
    for (int wrong = 0; wrong < 3; ++wrong)
      check(QTRAJ_E_COUNT, [&](Arguments<Real>& a, size_t* bad) {
        a.a_count = wrong == 0 ? 3 : 4, a.b_count = wrong == 1 ? 0 : 4, a.fraction_count = wrong == 2 ? 5 : 1;
        const qtraj_status status = a.call();
        *bad = a.bad_index;
        return status;
      });
    check(QTRAJ_E_SIZE, [](Arguments<Real>& a, size_t* bad) {
      return screw_pairs(a.q_a.data(), a.p_a.data(), 1, a.q_b.data(), a.p_b.data(), 1, a.fraction.data(), 1,
                         SIZE_MAX / 8, a.q.data(), a.q.data(), bad);
    });
    check(QTRAJ_E_OVERLAP, [](Arguments<Real>& a, size_t* bad) {
      return screw_pairs(a.q_a.data(), a.p_a.data(), 4, a.q_b.data(), a.p_b.data(), 4, a.fraction.data(), 4, 4,
                         a.q.data(), a.q.data() + 4, bad);
    });
    check(QTRAJ_E_OVERLAP, [](Arguments<Real>& a, size_t* bad) {  // read as positions, written as orientations
      return screw_pairs(a.q_a.data(), a.p.data(), 3, a.q_b.data(), a.p_b.data(), 3, a.fraction.data(), 3, 3,
                         a.p.data(), a.q.data(), bad);
    });
  });
}

TEST_CASE("C API: rows of screw_pairs at fault are NaN in both outputs, all others right", "[capi][screw][errors]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();
    Arguments<Real> good;
    REQUIRE(good.call() == QTRAJ_OK);
    const auto check = [&](qtraj_status expected, auto&& change) {
      Arguments<Real> a;
      change(a);
      CHECK(a.call() == expected);
      CHECK(a.bad_index == 2);
      for (size_t row = 0; row < 4; ++row) {
        const bool same = std::memcmp(&a.q[4 * row], &good.q[4 * row], sizeof(Real[4])) == 0 &&
                          std::memcmp(&a.p[3 * row], &good.p[3 * row], sizeof(Real[3])) == 0;
        const bool is_nan = std::isnan(a.q[4 * row]) && std::isnan(a.q[4 * row + 3]) && std::isnan(a.p[3 * row]);
        CHECK((row == 2 ? is_nan : same));
      }
    };
    check(QTRAJ_E_NOT_FINITE, [&](auto& a) { a.q_a[8] = kNaN; });
    check(QTRAJ_E_NOT_FINITE, [&](auto& a) { a.p_a[7] = std::numeric_limits<Real>::infinity(); });
    check(QTRAJ_E_NOT_FINITE, [&](auto& a) { a.q_b[11] = kNaN; });
    check(QTRAJ_E_NOT_FINITE, [&](auto& a) { a.p_b[6] = -std::numeric_limits<Real>::infinity(); });
    check(QTRAJ_E_NOT_FINITE, [&](auto& a) { a.fraction[2] = kNaN; });
    check(QTRAJ_E_NOT_FINITE, [&](auto& a) { a.p_b[6] = std::numeric_limits<Real>::max(), a.fraction[2] = 1000; });
    check(QTRAJ_E_ZERO_NORM, [&](auto& a) { std::fill_n(&a.q_a[8], 4, Real(0)); });
    check(QTRAJ_E_ZERO_NORM, [&](auto& a) { std::fill_n(&a.q_b[8], 4, Real(-0.0)); });
    // not finite before norm 0
    check(QTRAJ_E_NOT_FINITE, [&](auto& a) { std::fill_n(&a.q_b[8], 4, Real(0)), a.fraction[2] = kNaN; });
  });
}

TEST_CASE("C API: poses and fractions of screw_pairs are one for all or one for each", "[capi][screw]") {
  for_double_and_float([](auto zero) {
    using Real = decltype(zero);
    for (const bool one_a : {false, true})
      for (const bool one_b : {false, true})
        for (const bool one_fraction : {false, true}) {
          CAPTURE(one_a, one_b, one_fraction);
          Arguments<Real> few, all;
          few.a_count = one_a ? 1 : 4, few.b_count = one_b ? 1 : 4, few.fraction_count = one_fraction ? 1 : 4;
          for (size_t row = 1; row < 4; ++row) {
            if (one_a) std::copy_n(&all.q_a[0], 4, &all.q_a[4 * row]), std::copy_n(&all.p_a[0], 3, &all.p_a[3 * row]);
            if (one_b) std::copy_n(&all.q_b[0], 4, &all.q_b[4 * row]), std::copy_n(&all.p_b[0], 3, &all.p_b[3 * row]);
            if (one_fraction) all.fraction[row] = all.fraction[0];
          }
          CHECK(few.call() == QTRAJ_OK);
          CHECK(all.call() == QTRAJ_OK);
          CHECK(same_bits(few.q, all.q));
          CHECK(same_bits(few.p, all.p));
        }
  });
}

}  // namespace
