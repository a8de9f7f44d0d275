#include <cfloat>
#include <cmath>

#include "curve/extrapolation.hpp"
#include "support/catch.hpp"

namespace {

qtraj::Trajectory knots(double first, double last, bool negate_on_wrap) {
  qtraj::Trajectory trajectory = {};
  trajectory.before.knot = first;
  trajectory.after.knot = last;
  trajectory.last_inside = std::nextafter(last, first);
  trajectory.half_period = qtraj::two_sum(0.5 * last, -0.5 * first);
  trajectory.negate_on_wrap = negate_on_wrap;
  return trajectory;
}

}  // namespace

TEST_CASE("times are wrapped by whole periods into the knots", "[extrapolation]") {
  const qtraj::Trajectory trajectory = knots(2.0, 5.0, true);
  const struct {
    double time, wrapped;
    bool negate;
  } cases[] = {{2.0, 2.0, false}, {4.5, 4.5, false},  {5.5, 2.5, true},  {8.5, 2.5, false},
               {1.0, 4.0, true},  {-2.0, 4.0, false}, {-1.0, 2.0, true}, {5.0, 2.0, true}};
  for (const auto& c : cases) {
    const qtraj::WrappedTime wrapped = qtraj::wrap_time(trajectory, c.time);
    CAPTURE(c.time);
    CHECK(wrapped.time == c.wrapped);
    CHECK(wrapped.negate == c.negate);
    CHECK_FALSE(qtraj::wrap_time(knots(2.0, 5.0, false), c.time).negate);
  }
}

TEST_CASE("wrapped times lie within the knots, however far away they were", "[extrapolation][singular]") {
  for (const auto& [first, last] : {std::pair{0.0, 1e-150},
                                    {0.1, 0.3},
                                    {-1e300, 1e300},
                                    {-8e307, 8e307},
                                    {1.7e9, 1.7e9 + 1e-6},
                                    {-DBL_MAX / 2, DBL_MAX / 2}}) {
    const qtraj::Trajectory trajectory = knots(first, last, true);
    for (const double time : {1e-300, 0.7, 1e9, 1e15, 1e300, DBL_MAX}) {
      for (const double sign : {1.0, -1.0}) {
        const double wrapped = qtraj::wrap_time(trajectory, sign * time).time;
        CAPTURE(first, last, time, sign);
        CHECK(wrapped >= first);
        CHECK(wrapped <= last);
      }
    }
  }
}

TEST_CASE("an extrapolated turn stops at its far time", "[extrapolation][singular]") {
  qtraj::Extrapolation side = {};
  side.knot = 1.0;
  side.rate = 2.0;
  side.far_time = 1.0 + 1e6;
  side.m[0] = side.e[3] = 1.0;
  double near[4], far[4], farther[4];
  qtraj::extrapolate(side, 1.25, near);
  CHECK(std::abs(near[0] - std::cos(0.5)) <= 2e-16);
  CHECK(std::abs(near[3] - std::sin(0.5)) <= 2e-16);
  qtraj::extrapolate(side, side.far_time, far);
  qtraj::extrapolate(side, DBL_MAX, farther);
  for (int k = 0; k < 4; ++k) CHECK(far[k] == farther[k]);
}
