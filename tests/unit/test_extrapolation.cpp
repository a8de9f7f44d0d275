#include <cfloat>
#include <cmath>

#include "curve/extrapolation.hpp"
#include "support/catch.hpp"

TEST_CASE("an extrapolated turn stops at its far time", "[extrapolation][singular]") {
  qtraj::GreatCircle side = {};
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
