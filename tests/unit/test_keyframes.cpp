#include <cfloat>
#include <cmath>
#include <vector>

#include "base/times.hpp"
#include "methods/key_rates.hpp"
#include "methods/keyframes.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace {

using qtraj::Status;

// Room for the cleaned keyframes of `count` keys.
struct Storage {
  explicit Storage(size_t count) : times(count), q(4 * count), remainder(4 * count) {}
  qtraj::Keyframes keys() {
    return {times.data(), reinterpret_cast<double(*)[4]>(q.data()), reinterpret_cast<double(*)[4]>(remainder.data()),
            times.size()};
  }
  std::vector<double> times, q, remainder;
};

qtraj::KeyframeInput input_of(const test::Keys& keys) {
  const size_t count = keys.count();
  const double* none = nullptr;
  return {keys.times.data(),
          qtraj::input<4>(keys.q.data(), count),
          qtraj::input<3>(none, count),
          qtraj::input<3>(none, count),
          nullptr,
          count};
}

}  // namespace

TEST_CASE("cleaning makes signs continuous, a tie keeps its sign, the first key keeps its own", "[keyframes]") {
  test::Keys given;
  given.add(0, {-1, 0, 0, 0});
  given.add(1, {0, 2, 0, 0});                         // tie
  given.add(2, {0, -1, 0, 1e-3});                     // flipped
  given.add(3, {0, 0, 0, -1});                        // against the one before as it was used: kept
  given.add(4, {1, 0, 0, std::nextafter(0.0, 1.0)});  // below 0 by a hair: flipped
  Storage storage(given.count());
  qtraj::KeyframeReport report;
  const qtraj::Keyframes keys = storage.keys();
  REQUIRE(qtraj::clean_keyframes(input_of(given), false, keys, report).status == Status::ok);
  CHECK(keys[0].value == qtraj::Quaternion(-1, 0, 0, 0));
  CHECK(keys[1].value == qtraj::Quaternion(0, 1, 0, 0));
  CHECK(keys[2].value[1] > 0.99);
  CHECK(keys[3].value == qtraj::Quaternion(0, 0, 0, -1));
  CHECK(keys[4].value[0] == -1.0);
  CHECK(report.sign_flips == 2);
  CHECK(report.least_dot == 0.0);
  CHECK(report.worst_norm_error == 1.0);
}

TEST_CASE("knots are judged in the order of the contract", "[knots]") {
  const double tiny = 7.4e-155;   // 1/h^2 overflows
  const double small = 7.6e-155;  // and just does not
  const struct {
    double before, at;
    Status expected;
  } cases[] = {{0.0, 1.0, Status::ok},
               {1.0, 1.0, Status::time_order},
               {1.0, 0.5, Status::time_order},
               {0.0, tiny, Status::time_order},
               {0.0, small, Status::ok},
               {0.0, 5e-324, Status::time_order},
               {-1e308, 1e308, Status::time_span},
               {-8e307, 8e307, Status::ok},
               {-DBL_MAX, 0.0, Status::ok}};
  for (const auto& c : cases) {
    const double times[] = {c.before, c.at};
    CAPTURE(c.before, c.at);
    CHECK(qtraj::check_knot(times, 0) == Status::ok);
    CHECK(qtraj::check_knot(times, 1) == c.expected);
  }
}

TEST_CASE("shares of intervals neither overflow nor vanish together", "[knots]") {
  for (const auto& [before, after] :
       {std::pair{1.0, 3.0}, {1e-154, 1e308}, {DBL_MAX / 2, DBL_MAX / 2}, {DBL_MAX, 1e-154}}) {
    const qtraj::IntervalShares shares = qtraj::interval_shares(before, after);
    CHECK(std::abs(shares.left + shares.right - 1.0) <= 2.3e-16);
    CHECK(shares.left >= 0);
    CHECK(shares.right >= 0);
  }
  CHECK(qtraj::interval_shares(1.0, 3.0).left == 0.25);
}

TEST_CASE("closing needs the last key within 1e-6 rad of plus or minus the first", "[keyframes]") {
  test::Random random(1);
  for (const double angle : {0.0, 0.9e-6, 1.1e-6}) {
    for (const double sign : {1.0, -1.0}) {
      test::Keys given = random_walk(random, 3, 0.4, 1.0, 1.0);
      test::Quaternion last = test::multiply(given.orientation(0), test::about(random.direction(), angle));
      for (double& component : last) component *= sign;
      given.add(given.times.back() + 1, last);
      Storage storage(given.count());
      qtraj::KeyframeReport report;
      qtraj::Keyframes keys = storage.keys();
      REQUIRE(qtraj::clean_keyframes(input_of(given), false, keys, report).status == Status::ok);
      const qtraj::Outcome outcome = qtraj::close_keyframes(1e-6, false, keys, report);
      CAPTURE(angle, sign);
      CHECK(outcome.status == (angle < 1e-6 ? Status::ok : Status::not_closed));
      CHECK(outcome.index == (angle < 1e-6 ? qtraj::kNoIndex : 3));
      if (angle < 1e-6) CHECK((keys[3].value == keys[0].value || keys[3].value == -keys[0].value));
    }
  }
}

TEST_CASE("an end rate is estimated from as many keys as its weights allow", "[end_rate]") {
  const test::Vector axis = {0, 0, 1};
  const auto estimate = [&](const std::vector<double>& times, qtraj::Side side, size_t most) {
    test::Keys given;
    for (const double time : times) given.add(time, test::about(axis, 0.25 * time * time * time));
    Storage storage(given.count());
    qtraj::KeyframeReport report;
    REQUIRE(qtraj::clean_keyframes(input_of(given), false, storage.keys(), report).status == Status::ok);
    return qtraj::estimated_end_rate(storage.keys(), side, most, DBL_EPSILON)[2];
  };
  // three neighbours are exact for a cubic angle
  CHECK(std::abs(estimate({1.0, 1.2, 1.5, 1.9}, qtraj::Side::start, 3) - 0.75) <= 1e-13);
  CHECK(std::abs(estimate({0.1, 0.5, 0.8, 1.0}, qtraj::Side::end, 3) - 0.75) <= 1e-13);
  // two keys: the chord
  CHECK(std::abs(estimate({1.0, 1.5}, qtraj::Side::start, 3) - 0.25 * (1.5 * 1.5 * 1.5 - 1) / 0.5) <= 1e-13);
  // the second neighbour too close to the first for its weight: the chord again
  const double ragged = estimate({1.0, 1.5, 1.51, 2.0}, qtraj::Side::start, 3);
  CHECK(std::abs(ragged - 0.25 * (1.5 * 1.5 * 1.5 - 1) / 0.5) <= 1e-13);
}
