// The scalar cubic spline: its error bound, values known by hand, invariances.
#include <qtraj.h>

#include <cfloat>
#include <vector>

#include "support/catch.hpp"
#include "support/long_double.hpp"
#include "support/random.hpp"

namespace {

constexpr double kEps = DBL_EPSILON;

struct Spline {
  std::vector<double> x, y;
  size_t dim;
  int32_t start, end;

  size_t count() const { return x.size(); }
};

std::vector<double> evaluate(const Spline& spline, const std::vector<double>& queries,
                             qtraj_status expected = QTRAJ_OK) {
  std::vector<double> y(queries.size() * spline.dim);
  REQUIRE(qtraj_cubic_spline(spline.x.data(), spline.y.data(), spline.count(), spline.dim, spline.start, spline.end,
                             queries.data(), queries.size(), y.data(), nullptr) == expected);
  return y;
}

// All pairs of ends.
std::vector<std::pair<int32_t, int32_t>> all_ends() {
  const int32_t open[] = {QTRAJ_END_DEFAULT, QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT};
  std::vector<std::pair<int32_t, int32_t>> ends = {{QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC}};
  for (const int32_t start : open)
    for (const int32_t end : open) ends.emplace_back(start, end);
  return ends;
}

Spline random_spline(test::Random& random, size_t count, size_t dim, std::pair<int32_t, int32_t> ends, double decades) {
  Spline spline = {{random.uniform(-10, 10)}, {}, dim, ends.first, ends.second};
  while (spline.count() < count)
    spline.x.push_back(spline.x.back() + std::pow(10.0, random.uniform(-0.5 * decades, 0.5 * decades)));
  for (size_t i = 0; i < count * dim; ++i) spline.y.push_back(random.uniform(-1, 1));
  if (ends.first == QTRAJ_END_PERIODIC)
    std::copy_n(spline.y.begin(), dim, spline.y.end() - static_cast<ptrdiff_t>(dim));
  return spline;
}

double random_query(test::Random& random, const Spline& spline) {
  const auto segment = static_cast<size_t>(random.uniform(0, static_cast<double>(spline.count() - 1)));
  const double query = spline.x[segment] + random.uniform(0, 1) * (spline.x[segment + 1] - spline.x[segment]);
  return std::min(query, spline.x.back());
}

// One component in long double, by second derivatives and Gaussian elimination.
class Reference {
 public:
  Reference(const Spline& spline, size_t component) : x_(spline.x.begin(), spline.x.end()) {
    for (size_t i = 0; i < x_.size(); ++i) y_.push_back(spline.y[i * spline.dim + component]);
    const size_t n = x_.size() - 1;
    rows_.assign(n + 1, std::vector<wide::Real>(n + 2, 0));
    for (size_t i = 1; i < n; ++i) set_inner_row(i, i - 1, i);
    set_end_row(spline.start, 0, 1);
    set_end_row(spline.end, n, n - 1);
    if (n == 2 && spline.start == QTRAJ_END_NOT_A_KNOT && spline.end == QTRAJ_END_NOT_A_KNOT)
      rows_[2] = {0, 1, -1, 0};  // the parabola
    solve();
  }

  wide::Real operator()(double query) const {
    size_t i = 0;
    while (i + 2 < x_.size() && query >= x_[i + 1]) ++i;
    const wide::Real a = x_[i + 1] - query, b = query - x_[i], length = h(i), m0 = bend(i), m1 = bend(i + 1);
    return (m0 * a * a * a + m1 * b * b * b) / (6 * length) + (y_[i] / length - m0 * length / 6) * a +
           (y_[i + 1] / length - m1 * length / 6) * b;
  }

 private:
  wide::Real h(size_t i) const { return x_[i + 1] - x_[i]; }
  wide::Real slope(size_t i) const { return (y_[i + 1] - y_[i]) / h(i); }
  wide::Real bend(size_t i) const { return rows_[i].back(); }

  void set_inner_row(size_t knot, size_t left, size_t right) {
    rows_[knot][left] += h(left);
    rows_[knot][knot] += 2 * (h(left) + h(right));
    rows_[knot][right + 1] += h(right);
    rows_[knot].back() = 6 * (slope(right) - slope(left));
  }

  void set_end_row(int32_t end, size_t knot, size_t inner) {
    const size_t n = x_.size() - 1;
    if (n == 1 || end == QTRAJ_END_DEFAULT || end == QTRAJ_END_NATURAL) {
      rows_[knot][knot] = 1;
    } else if (end == QTRAJ_END_NOT_A_KNOT) {
      const size_t second = knot == 0 ? 2 : n - 2;
      const wide::Real near = knot == 0 ? h(0) : h(n - 1), far = knot == 0 ? h(1) : h(n - 2);
      rows_[knot][knot] += far;
      rows_[knot][inner] -= near + far;
      rows_[knot][second] += near;
    } else if (knot == 0) {
      set_inner_row(0, n - 1, 0);
    } else {
      rows_[n][n] = 1;
      rows_[n][0] = -1;
    }
  }

  void solve() {
    const size_t size = rows_.size();
    for (size_t column = 0; column < size; ++column) {
      size_t pivot = column;
      for (size_t row = column; row < size; ++row)
        if (std::abs(rows_[row][column]) > std::abs(rows_[pivot][column])) pivot = row;
      std::swap(rows_[column], rows_[pivot]);
      for (size_t row = 0; row < size; ++row) {
        if (row == column || rows_[row][column] == 0) continue;
        const wide::Real factor = rows_[row][column] / rows_[column][column];
        for (size_t k = column; k <= size; ++k) rows_[row][k] -= factor * rows_[column][k];
      }
    }
    for (size_t row = 0; row < size; ++row) rows_[row].back() /= rows_[row][row];
  }

  std::vector<wide::Real> x_, y_;
  std::vector<std::vector<wide::Real>> rows_;
};

// What the library states, relative to the largest |y|.
double stated_bound(const Spline& spline) {
  double shortest = DBL_MAX, longest = 0;
  for (size_t i = 0; i + 1 < spline.count(); ++i) {
    shortest = std::min(shortest, spline.x[i + 1] - spline.x[i]);
    longest = std::max(longest, spline.x[i + 1] - spline.x[i]);
  }
  const double swing = 1 + longest / shortest;
  const bool continued = spline.start == QTRAJ_END_NOT_A_KNOT || spline.end == QTRAJ_END_NOT_A_KNOT;
  return 4 * kEps * (continued ? swing * swing : swing);
}

TEST_CASE("C API: the cubic spline is within its bound of one solved in long double", "[capi][spline]") {
  test::Random random(51);
  const auto ends = all_ends();
  double worst = 0;
  for (int round = 0; round < 1000; ++round) {
    const size_t count = 2 + static_cast<size_t>(random.uniform(0, 16)), dim = 2;
    const double decades = random.uniform(0, 1) < 0.5 ? 0.3 : random.uniform(0, 4);
    const Spline spline = random_spline(random, count, dim, ends[static_cast<size_t>(round) % ends.size()], decades);
    std::vector<double> queries;
    for (int i = 0; i < 500; ++i) queries.push_back(random_query(random, spline));
    const std::vector<double> values = evaluate(spline, queries);
    const double bound = stated_bound(spline);
    for (size_t component = 0; component < dim; ++component) {
      const Reference reference(spline, component);
      double largest = 0;
      for (size_t i = component; i < spline.y.size(); i += dim) largest = std::max(largest, std::abs(spline.y[i]));
      for (size_t i = 0; i < queries.size(); ++i) {
        const wide::Real error = std::abs(values[i * dim + component] - reference(queries[i]));
        const double share = static_cast<double>(error) / (bound * largest);
        if (!(share <= worst)) worst = std::isnan(share) ? HUGE_VAL : share;
      }
    }
  }
  CHECK(worst <= 1);
}

TEST_CASE("C API: the cubic spline passes through its points", "[capi][spline]") {
  test::Random random(52);
  for (const auto& ends : all_ends())
    for (size_t count = 2; count < 12; ++count) {
      const Spline spline = random_spline(random, count, 3, ends, 3);
      const std::vector<double> values = evaluate(spline, spline.x);
      CHECK(values == spline.y);
    }
}

TEST_CASE("C API: a line is reproduced by every open end and a cubic by ends without a knot", "[capi][spline]") {
  test::Random random(53);
  for (const auto& ends : all_ends())
    for (size_t count = 2; count < 12; ++count) {
      CAPTURE(ends.first, ends.second, count);
      Spline spline = random_spline(random, count, 1, ends, 0.5);
      const bool closed = ends.first == QTRAJ_END_PERIODIC;
      const bool cubic = ends.first == QTRAJ_END_NOT_A_KNOT && ends.second == QTRAJ_END_NOT_A_KNOT && count > 3;
      const auto curve = [&](double x) {
        const double line = closed ? 0.7 : 0.7 - 0.3 * x;
        return cubic ? line + 0.02 * x * x - 0.001 * x * x * x : line;
      };
      for (size_t i = 0; i < count; ++i) spline.y[i] = curve(spline.x[i]);
      std::vector<double> queries;
      for (int i = 0; i < 50; ++i) queries.push_back(random_query(random, spline));
      const std::vector<double> values = evaluate(spline, queries);
      double worst = 0;
      for (size_t i = 0; i < 50; ++i) worst = std::max(worst, std::abs(values[i] - curve(queries[i])));
      CHECK(worst <= 1e-12);
    }
}

TEST_CASE("C API: the cubic spline has the values worked out by hand", "[capi][spline]") {
  // through (0, 0), (1, 1), (2, 0): natural 3/2 u - u^3/2 and its mirror; without knots 1 - (x - 1)^2
  const std::vector<double> queries = {1.5, 0.5, 0, 2};
  CHECK(evaluate({{0, 1, 2}, {0, 1, 0}, 1, 0, 0}, queries) == std::vector<double>{0.6875, 0.6875, 0, 0});
  CHECK(evaluate({{0, 1, 2}, {0, 1, 0}, 1, QTRAJ_END_NOT_A_KNOT, QTRAJ_END_NOT_A_KNOT}, queries) ==
        std::vector<double>{0.75, 0.75, 0, 0});
  // periodic: slopes 0 at all knots, 3 u^2 - 2 u^3
  const std::vector<double> closed =
      evaluate({{0, 1, 2}, {0, 1, 0}, 1, QTRAJ_END_PERIODIC, QTRAJ_END_PERIODIC}, {0.25, 0.5, 1.75});
  CHECK(closed == std::vector<double>{0.15625, 0.5, 0.15625});
  // a natural start with an end without a knot: y'' = 0 at 0 and y''' one number on both sides of 1
  const std::vector<double> mixed =
      evaluate({{0, 1, 2}, {0, 1, 8}, 1, QTRAJ_END_NATURAL, QTRAJ_END_NOT_A_KNOT}, {0.5, 1.5});
  CHECK(std::abs(mixed[0] - 0.125) <= 1e-15);
  CHECK(std::abs(mixed[1] - 3.375) <= 1e-14);
}

TEST_CASE("C API: components, their size and the queries' order change no bit of a spline", "[capi][spline]") {
  test::Random random(54);
  for (const auto& ends : all_ends()) {
    CAPTURE(ends.first, ends.second);
    const Spline together = random_spline(random, 9, 3, ends, 2);
    std::vector<double> queries;
    for (int i = 0; i < 200; ++i) queries.push_back(random_query(random, together));
    const std::vector<double> values = evaluate(together, queries);
    size_t wrong = 0;
    for (const int exponent : {0, 1000, -900}) {
      for (size_t component = 0; component < 3; ++component) {
        Spline alone = {together.x, {}, 1, ends.first, ends.second};
        for (size_t i = component; i < 27; i += 3) alone.y.push_back(std::ldexp(together.y[i], exponent));
        const std::vector<double> backwards(queries.rbegin(), queries.rend());
        const std::vector<double> one = evaluate(alone, backwards);
        for (size_t i = 0; i < 200; ++i)
          if (one[199 - i] != std::ldexp(values[3 * i + component], exponent)) ++wrong;
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("C API: a spline may be written over any of its inputs", "[capi][spline]") {
  test::Random random(55);
  Spline spline = random_spline(random, 7, 1, {QTRAJ_END_DEFAULT, QTRAJ_END_NOT_A_KNOT}, 1);
  std::vector<double> queries;
  for (int i = 0; i < 7; ++i) queries.push_back(random_query(random, spline));
  const std::vector<double> expected = evaluate(spline, queries);
  for (std::vector<double> Spline::*input : {&Spline::x, &Spline::y}) {
    Spline copy = spline;
    CHECK(qtraj_cubic_spline(copy.x.data(), copy.y.data(), 7, 1, copy.start, copy.end, queries.data(), 7,
                             (copy.*input).data(), nullptr) == QTRAJ_OK);
    CHECK(copy.*input == expected);
  }
  CHECK(qtraj_cubic_spline(spline.x.data(), spline.y.data(), 7, 1, spline.start, spline.end, queries.data(), 7,
                           queries.data(), nullptr) == QTRAJ_OK);
  CHECK(queries == expected);
}

TEST_CASE("C API: a query within 4 ulps of an end counts as that end", "[capi][spline]") {
  const double x[4] = {0, 0.1, 0.4, 0.6}, y[4] = {1, 3, 2, 5};
  double queries[4] = {6 * 0.1, 0.6, -4e-16, 0}, rows[4];
  CHECK(queries[0] > 0.6);
  REQUIRE(qtraj_cubic_spline(x, y, 4, 1, QTRAJ_END_DEFAULT, QTRAJ_END_DEFAULT, queries, 4, rows, nullptr) == QTRAJ_OK);
  CHECK(rows[0] == rows[1]);
  CHECK(rows[2] == rows[3]);
  const double outside = 0.6 + 1e-15;
  CHECK(qtraj_cubic_spline(x, y, 4, 1, QTRAJ_END_DEFAULT, QTRAJ_END_DEFAULT, &outside, 1, rows, nullptr) ==
        QTRAJ_E_TIME_RANGE);
}

}  // namespace
