#include <cmath>
#include <vector>

#include "math/cubic_spline.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using qtraj::SplineEnd;

struct Result {
  qtraj::Outcome outcome;
  std::vector<double> slopes;
};

Result slopes(const std::vector<double>& x, const std::vector<double>& y, SplineEnd start, SplineEnd end) {
  const size_t dim = y.size() / x.size();
  Result result = {{}, std::vector<double>(y.size())};
  std::vector<double> scratch(x.size() * qtraj::kSplineScratchPerKnot);
  result.outcome =
      qtraj::spline_slopes({x.data(), y.data(), x.size(), dim}, start, end, result.slopes.data(), scratch.data());
  return result;
}

// Second derivative of the cubic over interval i at its left (at = 0) or right (at = 1) knot.
double bend(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& d, size_t i,
            int at) {
  const double h = x[i + 1] - x[i], chord = (y[i + 1] - y[i]) / h;
  return at == 0 ? (6 * chord - 4 * d[i] - 2 * d[i + 1]) / h : (-6 * chord + 2 * d[i] + 4 * d[i + 1]) / h;
}
double third(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& d, size_t i) {
  return (bend(x, y, d, i, 1) - bend(x, y, d, i, 0)) / (x[i + 1] - x[i]);
}

std::vector<double> random_knots(test::Random& random, size_t count) {
  std::vector<double> x = {random.uniform(-3, 3)};
  while (x.size() < count) x.push_back(x.back() + random.uniform(0.1, 2.0));
  return x;
}
std::vector<double> random_values(test::Random& random, size_t count) {
  std::vector<double> y;
  while (y.size() < count) y.push_back(random.uniform(-1, 1));
  return y;
}

}  // namespace

TEST_CASE("the spline's second derivative is continuous and obeys its ends", "[cubic_spline]") {
  test::Random random(1);
  for (size_t count = 3; count <= 12; ++count) {
    for (const SplineEnd start : {SplineEnd::natural, SplineEnd::not_a_knot}) {
      for (const SplineEnd end : {SplineEnd::natural, SplineEnd::not_a_knot}) {
        const std::vector<double> x = random_knots(random, count), y = random_values(random, count);
        const Result result = slopes(x, y, start, end);
        REQUIRE(result.outcome.status == qtraj::Status::ok);
        const std::vector<double>& d = result.slopes;
        const size_t last = count - 2;
        CAPTURE(count);
        const double tolerance = 1e-9;
        for (size_t i = 0; i < last; ++i) CHECK(std::abs(bend(x, y, d, i, 1) - bend(x, y, d, i + 1, 0)) <= tolerance);
        if (start == SplineEnd::natural) CHECK(std::abs(bend(x, y, d, 0, 0)) <= tolerance);
        if (end == SplineEnd::natural) CHECK(std::abs(bend(x, y, d, last, 1)) <= tolerance);
        if (start == SplineEnd::not_a_knot) CHECK(std::abs(third(x, y, d, 0) - third(x, y, d, 1)) <= 1e-7);
        if (end == SplineEnd::not_a_knot) CHECK(std::abs(third(x, y, d, last) - third(x, y, d, last - 1)) <= 1e-7);
      }
    }
  }
}

TEST_CASE("a periodic spline is smooth across its seam", "[cubic_spline]") {
  test::Random random(2);
  for (size_t count = 3; count <= 12; ++count) {
    const std::vector<double> x = random_knots(random, count);
    std::vector<double> y = random_values(random, count);
    y.back() = y.front();
    const Result result = slopes(x, y, SplineEnd::periodic, SplineEnd::periodic);
    REQUIRE(result.outcome.status == qtraj::Status::ok);
    const std::vector<double>& d = result.slopes;
    CAPTURE(count);
    for (size_t i = 0; i + 2 < count; ++i) CHECK(std::abs(bend(x, y, d, i, 1) - bend(x, y, d, i + 1, 0)) <= 1e-9);
    CHECK(d.front() == d.back());
    CHECK(std::abs(bend(x, y, d, 0, 0) - bend(x, y, d, count - 2, 1)) <= 1e-9);
  }
}

TEST_CASE("a not-a-knot spline is exact for every cubic, from four knots on", "[cubic_spline]") {
  test::Random random(3);
  for (size_t count = 4; count <= 8; ++count) {
    const std::vector<double> x = random_knots(random, count), c = random_values(random, 4);
    std::vector<double> y;
    for (const double t : x) y.push_back(c[0] + t * (c[1] + t * (c[2] + t * c[3])));
    const Result result = slopes(x, y, SplineEnd::not_a_knot, SplineEnd::not_a_knot);
    for (size_t i = 0; i < count; ++i)
      CHECK(std::abs(result.slopes[i] - (c[1] + x[i] * (2 * c[2] + x[i] * 3 * c[3]))) <= 1e-10);
  }
}

TEST_CASE("two knots give a line and three without knots at the ends a parabola", "[cubic_spline][singular]") {
  const Result line = slopes({1, 3}, {2, -4}, SplineEnd::not_a_knot, SplineEnd::natural);
  CHECK(line.slopes == std::vector<double>{-3, -3});
  const Result closed = slopes({1, 3}, {2, 2}, SplineEnd::periodic, SplineEnd::periodic);
  CHECK(closed.slopes == std::vector<double>{0, 0});
  const Result parabola = slopes({0, 1, 3}, {0, 1, 9}, SplineEnd::not_a_knot, SplineEnd::not_a_knot);
  for (size_t i = 0; i < 3; ++i) CHECK(std::abs(parabola.slopes[i] - (i == 0 ? 0.0 : i == 1 ? 2.0 : 6.0)) <= 1e-14);
}

TEST_CASE("components of a vector-valued spline do not touch each other", "[cubic_spline]") {
  test::Random random(4);
  const std::vector<double> x = random_knots(random, 9), both = random_values(random, 18);
  for (const SplineEnd end : {SplineEnd::natural, SplineEnd::not_a_knot}) {
    const Result together = slopes(x, both, end, end);
    for (size_t component = 0; component < 2; ++component) {
      std::vector<double> one;
      for (size_t i = 0; i < 9; ++i) one.push_back(both[2 * i + component]);
      const Result alone = slopes(x, one, end, end);
      for (size_t i = 0; i < 9; ++i) CHECK(together.slopes[2 * i + component] == alone.slopes[i]);
    }
  }
}

TEST_CASE("knots past all reason end in a status, not in infinity", "[cubic_spline][singular]") {
  // the parabola-like continuation over the first interval would rise by 1e300
  const Result steep =
      slopes({-1e300, 0, 1e-10, 2e-10, 3e-10}, {0, 0, 1, 0, 1}, SplineEnd::not_a_knot, SplineEnd::natural);
  CHECK(steep.outcome.status == qtraj::Status::not_finite);
  CHECK(steep.outcome.index == 0);
  const Result tied = slopes({-1.0, 0, 1e-30, 1.0}, {0, 0, 1, 1}, SplineEnd::not_a_knot, SplineEnd::not_a_knot);
  CHECK(tied.outcome.status == qtraj::Status::not_finite);
}
