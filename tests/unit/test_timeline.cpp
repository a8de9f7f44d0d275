#include <cfloat>
#include <cmath>

#include "curve/timeline.hpp"
#include "support/catch.hpp"

namespace {

qtraj::Timeline repeated(double first, double last) {
  qtraj::Timeline timeline = {};
  timeline.before = {qtraj::Extrapolate::periodic, first, first};
  timeline.after = {qtraj::Extrapolate::periodic, last, last};
  timeline.last_inside = std::nextafter(last, first);
  timeline.half_period = qtraj::two_sum(0.5 * last, -0.5 * first);
  return timeline;
}

}  // namespace

TEST_CASE("times are wrapped by whole periods into the knots", "[timeline]") {
  const qtraj::Timeline timeline = repeated(2.0, 5.0);
  const struct {
    double time, wrapped;
    bool is_odd;
  } cases[] = {{5.0, 2.0, true},  {5.5, 2.5, true},   {8.5, 2.5, false}, {1.0, 4.0, true},
               {-1.0, 2.0, true}, {-2.0, 4.0, false}, {8.0, 2.0, false}, {1.5, 4.5, true}};
  for (const auto& c : cases) {
    CAPTURE(c.time);
    const qtraj::Place place = qtraj::place_outside(timeline, c.time);
    CHECK(place.time == c.wrapped);
    CHECK(place.is_odd_round == c.is_odd);
    CHECK(place.beyond == nullptr);
    CHECK(place.has_value);
  }
}

TEST_CASE("wrapped times lie within the knots, however far away they were", "[timeline][singular]") {
  for (const auto& [first, last] : {std::pair{0.0, 1e-150},
                                    {0.1, 0.3},
                                    {-1e300, 1e300},
                                    {-8e307, 8e307},
                                    {1.7e9, 1.7e9 + 1e-6},
                                    {-DBL_MAX / 2, DBL_MAX / 2}}) {
    const qtraj::Timeline timeline = repeated(first, last);
    for (const double time : {1e-300, 0.7, 1e9, 1e15, 1e300, DBL_MAX}) {
      for (const double sign : {1.0, -1.0}) {
        if (qtraj::is_inside(timeline, sign * time)) continue;
        const double wrapped = qtraj::place_outside(timeline, sign * time).time;
        CAPTURE(first, last, time, sign);
        CHECK(wrapped >= first);
        CHECK(wrapped <= last);
      }
    }
  }
}

TEST_CASE("an end without value, one that goes on, and a last key that stands apart", "[timeline]") {
  qtraj::Timeline timeline = repeated(2.0, 5.0);
  timeline.before = {qtraj::Extrapolate::error, 2.0, 1.75};
  timeline.after = {qtraj::Extrapolate::hold, 5.0, 5.25};
  timeline.last_inside = 5.0;
  CHECK_FALSE(qtraj::place_outside(timeline, 1.5).has_value);
  CHECK(qtraj::place_outside(timeline, 1.875).time == 2.0);
  CHECK(qtraj::place_outside(timeline, 1.875).beyond == nullptr);
  CHECK(qtraj::place_outside(timeline, 5.125).beyond == nullptr);
  CHECK(qtraj::place_outside(timeline, 6.0).beyond == &timeline.after);
  CHECK(qtraj::place_outside(timeline, 6.0).has_value);

  timeline.last_inside = std::nextafter(5.0, 2.0);
  timeline.after.rule = qtraj::Extrapolate::error;
  CHECK(qtraj::place_outside(timeline, 5.125).beyond == &timeline.after);
  CHECK(qtraj::place_outside(timeline, 5.125).time == 5.0);
  CHECK(qtraj::place_outside(timeline, 5.125).has_value);
  CHECK_FALSE(qtraj::place_outside(timeline, 6.0).has_value);
}
